// What if: the robot's own numbers changed in the page, the run made again, everything follows.

import type { Fact, LiveBundle } from "../contract";
import type { Live, LiveRun } from "../contract_parts";
import { button, make, put, save } from "../dom";
import { digits, info } from "../format";
import { spare } from "../spare";
import type { Settings } from "./address";
import { adviceOf, byKind, effects, lessening, nameOf } from "./effects";
import { makeSlider, type SliderRow } from "./slider";
import type { Advice } from "./verdict";

export interface SlidersOptions {
  /** Starts the live model; `openLive` of live/live.ts. */
  open(bundle: LiveBundle): Promise<Live>;
  /** Shows another run everywhere; null: the page's own. */
  show(live: LiveRun | null): void;
  /** Shows what lessens the error most, or why that is not known; null: another run comes. */
  advise(found: Advice[] | string | null): void;
  /** Of the file with a changed data sheet, without its ending. */
  fileName: string;
  /** The page's numbers. */
  facts: Fact[];
}

const LEADING = 5; // settings that are shown at first
const RANKED = 16; // settings whose effect is measured: the most useful ones, which come first
const PATIENCE = 300; // ms after which a bar shows how far a run is
const PICTURES = 250; // ms that a picture may wait for newer curves

export function mountSliders(
  element: HTMLElement, bundle: LiveBundle, options: SlidersOptions,
): Settings & { dispose(): void } {
  const status = make("p", { class: "note", role: "status", "aria-live": "polite", text: "starts …" });
  const bar = make("progress", { max: "1", value: "0", hidden: true, "aria-label": "Progress of the simulation" });
  const reset = button("reset all", () => {
    give(null);
    rows[0]?.element.querySelector("input")?.focus(); // the button itself has nothing to do now
  }, { disabled: true });
  const keep = button(
    "Save YAML",
    () => live && save(live.sheet(values()), `${options.fileName}.yaml`, "application/yaml"),
    { disabled: true },
  );
  const rows = bundle.sliders.map((slider) => makeSlider(slider, changed));
  let live: Live | null = null;
  let closed = false;
  let asked = 0;
  let scheduled = 0;
  let patience = 0;
  let busy = false;
  let began = 0; // when the run that is under way was asked for [ms]
  let heard = false; // whether its curves are shown, and its picture where the last one is old
  let pictured = 0; // when a run's picture was shown last [ms]

  const values = () => rows.map((row) => row.value);
  const unchanged = () => rows.every((row) => row.value === row.slider.value);

  function changed(): void {
    options.advise(null);
    reset.disabled = unchanged();
    if (!busy || heard || unchanged()) void simulate();
    else if (!scheduled) scheduled = requestAnimationFrame(again);
  }

  /** A newer run ends an older one, but not before it was seen, unless it is long in coming. */
  function again(): void {
    if (busy && !heard && performance.now() - began < PATIENCE) scheduled = requestAnimationFrame(again);
    else void simulate();
  }

  function give(wanted: number[] | null): void {
    rows.forEach((row, k) => { row.value = wanted ? wanted[k] : row.slider.value; });
    changed();
  }

  async function simulate(): Promise<void> {
    cancelAnimationFrame(scheduled);
    scheduled = 0;
    if (!live) return;
    const own = (asked += 1);
    if (unchanged()) {
      ended();
      options.show(null);
      status.textContent = "The run as it was.";
      status.classList.remove("warned");
      void live.run(values()).catch(() => undefined); // ends what may still be running
      ranking.ask();
      return;
    }
    [busy, began, heard] = [true, performance.now(), false];
    for (const row of rows) {
      row.element.classList.remove("warned");
      row.refuse("");
    }
    if (!patience) patience = window.setTimeout(() => { bar.hidden = false; }, PATIENCE);
    try {
      const progress = (share: number) => { if (own === asked) bar.value = share; };
      if (shown(await live.run(values(), progress, (early) => shown(early, own)), own)) {
        ended();
        ranking.ask();
      }
    } catch (error) {
      if (own !== asked || closed || (error instanceof Error && error.name === "Superseded")) return;
      ended();
      options.show(null); // what was shown belongs to other numbers
      const why = (error instanceof Error ? error.message : String(error)).replace(/\.$/, "");
      status.textContent = `This could not be simulated: ${why}; shown is the run as it was.`;
      status.classList.add("warned");
      for (const row of rows.filter(({ slider }) => why.includes(`${slider.path} = `))) {
        row.element.classList.add("warned");
        row.refuse(`Got ${row.value}; ${why.slice(why.indexOf(": ") + 2)}.`);
      }
    }
  }

  /** Shows a run, all of it or what is known early, if it is still the one that is wanted. */
  function shown(run: LiveRun, own: number): boolean {
    if (own !== asked || closed) return false;
    const now = performance.now();
    if (run.scene) pictured = now;
    heard = now - pictured < PICTURES;
    options.show(run);
    const how = run.status === "finished" ? "Simulated" : `${run.status}: ${run.message}; simulated`;
    status.textContent = `${how} in ${info(run.seconds, "s")}; the run as it was is pale.`;
    status.classList.toggle("warned", run.status !== "finished");
    return true;
  }

  function ended(): void {
    busy = false;
    clearTimeout(patience);
    patience = 0;
    bar.hidden = true;
    bar.value = 0;
  }

  const first = make("div", { class: "leading" });
  const rest = make("div");
  const order = make("p", { class: "note", hidden: true });
  const find = make("input", { type: "search", placeholder: "find a setting", "aria-label": "Find a setting" });
  find.hidden = rows.length <= RANKED;
  find.addEventListener("input", () => rows.filter((row) => rest.contains(row.element)).forEach((row) => {
    row.element.hidden = !`${row.slider.label} ${row.slider.path}`.toLowerCase().includes(find.value.toLowerCase());
  }));
  const more = make("details", {}, make("summary", { text: `All settings (${rows.length})` }), order, find, rest);
  more.hidden = rows.length <= LEADING;
  more.append(...notes(bundle));

  function place(leading: SliderRow[]): void {
    first.replaceChildren(...leading.map((row) => row.element));
    rest.replaceChildren(...grouped(rows.filter((row) => !leading.includes(row))));
  }

  /** What each setting does, and which lessen the error; the most effective first, as long as nobody uses them. */
  async function rank(opened: Live): Promise<void> {
    if (!rows.length) return options.advise("no number of this robot can be changed in the page");
    const own = asked;
    const wanted = () => asked === own && !busy && !closed;
    const found = wanted() ? await effects(opened, rows, RANKED, wanted) : null;
    if (found === null || !wanted()) return;
    order.hidden = false;
    if (typeof found === "string") {
      options.advise(found);
      return put(order, `Ordered by kind, not by effect: ${found}.`);
    }
    const { number, shares } = found;
    rows.slice(0, RANKED).forEach((row, k) => {
      const share = Math.abs(shares[k] ?? 0);
      row.effect.textContent = share ? `${digits(100 * share, 2)} %` : "";
      row.effect.title = "change for 1 % of this setting";
    });
    put(order, `Behind each setting: the change of the ${nameOf(number, options.facts)} for 1 % of it.`);
    if (asked === 0 && !element.contains(document.activeElement) && !element.matches(":hover")) {
      const size = (row: SliderRow) => Math.abs(shares[rows.indexOf(row)] ?? 0);
      place([...rows].sort((one, other) => size(other) - size(one)).slice(0, LEADING));
    }
    const less = await lessening(opened, rows, found, wanted);
    if (less && wanted()) options.advise(less.map((one) => adviceOf(one, () => {
      one.row.value = one.value;
      changed();
    })));
  }

  const ranking = spare(() => live && rank(live).catch(() => undefined)); // it fails where somebody wants a run
  place(byKind(rows.slice(0, RANKED), LEADING));
  element.append(make("div", { class: "bar" }, make("h3", { text: "What if" }), reset, keep), status, bar, first, more);
  void options.open(bundle).then(
    (opened) => {
      if (closed) return opened.close();
      live = opened;
      keep.disabled = false;
      status.textContent = "Move a slider to run the simulation again in this page.";
      if (!unchanged()) changed();
      else ranking.ask();
    },
    (error: unknown) => {
      const info = error instanceof Error ? error.message : String(error);
      status.textContent = `Nothing can be changed here, the robot's equations could not be started: ${info}`;
      rows.forEach((row) => row.element.remove());
      reset.remove();
    },
  );
  return {
    changed: () =>
      Object.fromEntries(
        rows.filter((row) => row.value !== row.slider.value).map((row) => [row.slider.path, row.value]),
      ),
    give: (wanted) => give(rows.map(({ slider }) => wanted[slider.path] ?? slider.value)),
    dispose() {
      closed = true;
      cancelAnimationFrame(scheduled);
      ended();
      ranking.end();
      live?.close();
      element.replaceChildren();
    },
  };
}

function grouped(rows: SliderRow[]): HTMLElement[] {
  const groups = [...new Set(rows.map((row) => row.slider.group))];
  return groups.map((group) => make("fieldset", {}, make("legend", { text: group }),
    ...rows.filter((row) => row.slider.group === group).map((row) => row.element)));
}

/** What the live model does otherwise than the run did, and what it leaves out. */
function notes(bundle: LiveBundle): HTMLElement[] {
  const settings = bundle.settings as { note?: unknown } | undefined;
  const left = Array.isArray(bundle.leftOut) ? (bundle.leftOut as { path?: unknown; reason?: unknown }[]) : [];
  const reasons = [...new Set(left.map(({ reason }) => String(reason)))];
  const paths = (why: string): string => left.filter(({ reason }) => String(reason) === why)
    .map(({ path }) => String(path)).join(", ");
  const words = [
    ...(typeof settings?.note === "string" && settings.note ? [settings.note] : []),
    ...reasons.map((why) => `Not offered: ${paths(why)} (${why}).`),
  ];
  return words.map((text) => make("p", { class: "note", text }));
}
