// The studio: choose a robot, change its numbers, and see it move and ring at once.

import { button, make, ownId } from "./dom";
import { forPaper } from "./paper";
import { adviser } from "./studio/advice";
import { watch } from "./studio/alive";
import { api, type Job, type SheetInfo, type StudioChange, type StudioPage, type Wrong } from "./studio/api";
import { attempt, exportControls, studyControls, type FilesHost } from "./studio/files";
import { Form } from "./studio/form";
import { messages } from "./studio/messages";
import { Runner } from "./studio/runner";
import { Forms } from "./studio/schema";
import { Shown } from "./studio/shown";
import { mountSliders, type SlidersView } from "./studio/sliders";
import { Tree, type Node } from "./studio/tree";
import { uploadControl } from "./studio/upload";

const WAIT = 300;
const NOT_MADE = "this run was not made";

async function main(): Promise<void> {
  if (location.search) history.replaceState(null, "", location.pathname); // the token is in a cookie now
  const formPlace = make("form", { class: "sheet", "aria-label": "Data sheet" });
  const sliderPlace = make("div", { class: "sliders", role: "group", "aria-label": "Sliders" });
  const view = make("main", { class: "view", id: "main" });
  const robots = make("select", { id: ownId("robots") });
  const info = messages();
  let current: SheetInfo | null = null;
  let form: Form | null = null;
  let sliders: SlidersView | null = null;
  let slow = 0;
  let listed = "";
  let choice = 0;
  formPlace.addEventListener("submit", (event) => event.preventDefault());

  const treePlace = make("div", { class: "tree", role: "group", "aria-label": "Structure" });
  const tree = new Tree(treePlace, (node) => choosePart(node));
  const shown = new Shown(view, (element) => choosePart(tree.named(element)));

  /** A part of the robot, from the tree or the picture: its fields come into sight, its element is marked. */
  function choosePart(node: Node | null): void {
    if (!node) return;
    form?.focus(node.steps);
    aim(node);
  }

  function aim(node: Node | null): void {
    tree.mark(node);
    shown.highlight(node?.element ?? null);
  }

  for (const place of [formPlace, sliderPlace])
    place.addEventListener("focusin", ({ target }) => {
      const group = (target as HTMLElement).closest<HTMLElement>("[data-path], [data-slider]");
      aim(tree.about((group?.dataset.path ?? group?.dataset.slider ?? "").split(".")));
    });

  const runner = new Runner({
    begun() {
      advice.forget();
      clearTimeout(slow);
      slow = window.setTimeout(() => info.progress("waiting", 0), WAIT);
    },
    progress: (job, milliseconds) => { if (milliseconds > WAIT) info.progress(job.stage, job.share); },
    upon: () => shown.upon,
    done(page, job, milliseconds) {
      ended(page, job, milliseconds);
      shown.show(page, job);
    },
    changed(change, job, milliseconds) {
      ended(change, job, milliseconds);
      shown.change(change, job);
    },
    whole(page) {
      shown.complete(page);
      if (current) advice.ask(current);
    },
    wrong,
    cancelled() {
      clearTimeout(slow);
      info.say(shown.empty ? "Cancelled: nothing is shown yet." : "Cancelled: what is shown is the run before.");
      view.classList.add("stale");
      shown.advise(NOT_MADE);
    },
  });
  const advice = adviser(runner.client, (found) => shown.advise(found), () => {
    sliders?.refresh();
    form?.refresh();
    if (current) runner.want(current);
  });

  function ended(page: StudioPage | StudioChange, job: Job, milliseconds: number): void {
    clearTimeout(slow);
    info.done(page, job, milliseconds);
    mark([], job.info.unseen);
    info.unseen(job.info.unseen ?? [], go);
    const drives = job.info.offer ?? [];
    info.offer(drives.length ? button("Add a move", () => form?.give(["drives"], drives)) : null);
    view.classList.remove("stale");
  }

  function go(to: Wrong): void {
    if (to.steps) form?.focus(to.steps);
  }

  /** A run was refused: what is shown is that of another sheet. */
  function wrong(errors: Wrong[]): void {
    clearTimeout(slow);
    info.offer(null);
    info.wrong(errors, go);
    mark(errors);
    view.classList.add("stale");
    shown.advise(NOT_MADE);
    const first = errors.find((one) => one.steps)?.steps;
    const typing = document.activeElement?.getAttribute("aria-invalid") === "true";
    if (first && !typing) form?.reveal(first);
  }

  function mark(errors: Wrong[], unseen?: Wrong[]): void {
    form?.mark(errors, unseen);
    sliders?.mark(errors);
  }

  /** A file or a robot was refused: what is shown is still the run of the sheet. */
  function refused(errors: Wrong[]): void {
    info.wrong(errors, go);
    if (errors.some((one) => one.steps)) mark(errors);
  }

  function changed(structure: boolean): void {
    if (!current) return;
    sliders?.refresh();
    if (structure) void look(current);
    if (structure) tree.show(current.sheet);
    runner.want(current);
  }

  /** A sheet whose structure changed has other sliders. */
  async function look(of: SheetInfo): Promise<void> {
    const fresh = await api.check(of.sheet).catch(() => null);
    if (!fresh || current !== of) return;
    form?.tell(fresh.units);
    sliders = slidersOf({ ...fresh, sheet: of.sheet, looks: of.looks });
  }

  function slidersOf(of: SheetInfo): SlidersView {
    return mountSliders(sliderPlace, of.sliders, of.sheet, () => {
      form?.refresh();
      runner.want(of);
    });
  }

  /** `named`: what it is called in the list of robots, nothing for a file's own. */
  async function load(loaded: SheetInfo, from: string, named = ""): Promise<void> {
    const schema = await api.schema();
    current = loaded;
    robots.value = listed = named;
    shown.forget();
    form = new Form(formPlace, new Forms(schema), loaded.sheet, loaded.units, changed);
    sliders = slidersOf(loaded);
    tree.show(loaded.sheet);
    info.offer(null);
    view.classList.remove("stale");
    document.title = `${loaded.name} – tmodes studio`;
    info.loaded(from, loaded.warnings);
    runner.want(loaded);
  }

  const host: FilesHost = {
    wish: () => current,
    name: () => current?.name ?? "robot",
    runner,
    load(one, from) {
      choice += 1; // a robot that is still on its way comes too late
      void attempt(host, () => load(one, from));
    },
    wrong: refused,
    right: info.right,
    say: info.say,
  };
  const choose = async (name: string) => {
    const mine = ++choice;
    await attempt(host, async () => {
      const info = name.startsWith("./") ? await api.study(name.slice(2)) : await api.robot(name);
      if (mine === choice) await load(info, name.replace("./", ""), name); // else another was chosen meanwhile
    });
    if (mine === choice) robots.value = listed; // also where that one was refused
  };
  robots.addEventListener("change", () => { if (robots.value) void choose(robots.value); });
  const cancel = button("Cancel", () => void runner.cancel(), { class: "warn", hidden: true });
  info.cancel(cancel);

  const bar = make(
    "header",
    { class: "bar top" },
    make("h1", { text: "tmodes studio", class: "brand" }),
    make("span", { class: "pick" }, make("label", { for: robots.id, text: "Robot" }), robots),
    uploadControl(host),
    studyControls(host),
    exportControls(host),
    button("Keep as ghost", () => { if (!shown.keep() && current) runner.want(current); }, {
      title: "Compare the runs to come with the one that is shown",
    }),
    cancel,
  );
  const head = make("div", { class: "head" }, bar, info.element);
  const measure = () => document.documentElement.style.setProperty("--head", `${head.offsetHeight}px`);
  new ResizeObserver(measure).observe(head);
  const skip = make("a", { href: "#main", class: "skip", text: "Skip to the view" });
  document.body.append(
    skip,
    head,
    make(
      "div",
      { class: "studio" },
      make(
        "aside",
        { class: "controls", "aria-label": "Numbers" },
        make("h2", { text: "Drag" }),
        sliderPlace,
        make("h2", { text: "Structure" }),
        treePlace,
        make("h2", { text: "Data sheet" }),
        formPlace,
      ),
      view,
    ),
  );

  watch({ away: info.away, back: () => { if (current) runner.want(current); } });
  const first = document.body.dataset.first ?? "";
  await attempt(host, async () => {
    const list = (await api.robots()).robots;
    robots.replaceChildren(
      make("option", { value: "", text: "from a file", disabled: true, hidden: true }),
      ...(first.startsWith("./") ? [make("option", { value: first, text: first.slice(2) })] : []),
      ...list.map((one) => make("option", { value: one.name, text: one.name, title: one.title })),
    );
    const wanted = first || list[0].name;
    robots.value = wanted;
    await choose(wanted);
  });
}

forPaper(".view details");
void main();
