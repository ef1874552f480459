// Files in and out: studies of the working folder, reports and data to keep.

import { button, make, ownId, save } from "../dom";
import { api, Refused, type SheetInfo, type Wish, type Wrong } from "./api";
import type { Runner } from "./runner";

export interface FilesHost {
  wish(): Wish | null;
  name(): string;
  runner: Runner;
  load(info: SheetInfo, from: string): void;
  wrong(errors: Wrong[]): void;
  right(): void;
  say(text: string): void;
}

/** Save the study into the working folder, or load one from it. */
export function studyControls(host: FilesHost): HTMLElement {
  const [opened, named] = [ownId("studies"), ownId("study")];
  const list = make("select", { id: opened });
  const name = make("input", { id: named, type: "text", size: "14", spellcheck: "false", placeholder: "study.yaml" });
  const replace = button("Replace", () => void keep(true), { hidden: true, class: "warn" });
  const refresh = () => attempt(host, async () => {
    const info = await api.studies();
    list.replaceChildren(
      make("option", { value: "", text: `open from ${info.folder}/ …` }),
      ...info.studies.map((one) => make("option", { value: one, text: one })),
    );
  });
  const keep = (overwrite: boolean) => attempt(host, async () => {
    const wish = host.wish();
    if (!wish) return;
    const wanted = name.value.trim() || `${host.name().replace(/[^\w.-]+/g, "_")}.yaml`;
    const file = /\.ya?ml$/i.test(wanted) ? wanted : `${wanted}.yaml`;
    name.value = file;
    try {
      const info = await api.save(file, wish.sheet, wish.looks, overwrite);
      host.right();
      host.say(`Saved as ${info.saved}.`);
      replace.hidden = true;
    } catch (error) {
      replace.hidden = !(error instanceof Refused && error.errors.some((one) => one.kind === "exists"));
      throw error;
    }
    await refresh();
  });
  name.addEventListener("input", () => { replace.hidden = true; });
  name.addEventListener("keydown", (event) => { if (event.key === "Enter") void keep(false); });
  list.addEventListener("change", () => void attempt(host, async () => {
    const chosen = list.value;
    if (chosen === "") return;
    host.load(await api.study(chosen), chosen);
    name.value = /\.ya?ml$/i.test(chosen) ? chosen : "";
    list.value = "";
  }));
  void refresh();
  return make(
    "span",
    { class: "pick" },
    make("label", { for: opened, class: "hidden", text: "Open a study" }),
    list,
    make("label", { for: named, class: "hidden", text: "Name of the study" }),
    name,
    button("Save", () => void keep(false), { title: "Save the study as YAML into the working folder" }),
    replace,
  );
}

/** The run as a report, as data, and the study as YAML, to be kept anywhere. */
export function exportControls(host: FilesHost): HTMLElement {
  const stem = () => host.name().replace(/[^\w.-]+/g, "_") || "robot";
  const file = (product: "report" | "data", ending: string, type: string) => attempt(host, async () => {
    const wish = host.wish();
    if (!wish) return;
    host.say(`Making the ${product} …`);
    const bytes = await host.runner.file(product, wish, (job) =>
      host.say(`Making the ${product}: ${job.stage || job.state} …`),
    );
    if (!bytes) return host.say(`The ${product} was ended before it was made.`);
    give(bytes, `${stem()}${ending}`, type);
    host.right();
    host.say(`The ${product} is among your downloads.`);
  });
  return make(
    "span",
    { class: "pick", role: "group", "aria-label": "Export" },
    once("Report", () => file("report", ".html", "text/html"), "This run as one page that needs no network"),
    once("Data", () => file("data", ".nc", "application/x-netcdf"), "All series of this run as NetCDF (result.nc)"),
    button(
      "YAML",
      () =>
        void attempt(host, async () => {
          const wish = host.wish();
          if (wish) save((await api.yaml(wish.sheet)).yaml, `${stem()}.yaml`, "application/yaml");
        }),
      { title: "The study as a data sheet" },
    ),
  );
}

/** A button that can be pressed again when what it began has ended; who pressed it by a key still stands there. */
function once(text: string, act: () => Promise<void>, title: string): HTMLButtonElement {
  const pressed = async () => {
    const held = document.activeElement === it;
    it.disabled = true;
    await act().finally(() => { it.disabled = false; });
    if (held && document.activeElement === document.body) it.focus();
  };
  const it = button(text, () => void pressed(), { title });
  return it;
}

function give(bytes: Uint8Array, name: string, type: string): void {
  const address = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

export async function attempt(host: Pick<FilesHost, "wrong">, act: () => Promise<void>): Promise<void> {
  try {
    await act();
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    host.wrong(error.errors);
  }
}
