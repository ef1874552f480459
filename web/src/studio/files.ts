// Files in and out: uploads of robots, studies of the working folder, reports and data to keep.

import { button, make, ownId, save } from "../dom";
import { api, Refused, type SheetTold, type Wrong } from "./api";
import type { Runner } from "./runner";
import type { Sheet } from "./sheet";

export interface FilesHost {
  sheet(): Sheet | null;
  name(): string;
  runner: Runner;
  load(told: SheetTold, from: string): void;
  wrong(errors: Wrong[]): void;
  say(text: string): void;
}

const MOST_UPLOADED = 16 * 1024 * 1024; // as the server has it
const ACCEPT = ".yaml,.yml,.urdf,.xacro,.xml,.stl,.obj,.dae";

/** Robots of one's own: a URDF with its elasticity file and meshes. */
export function uploadControl(host: FilesHost): HTMLElement {
  const id = ownId("upload");
  const input = make("input", { id, type: "file", multiple: true, accept: ACCEPT, class: "upload" });
  const send = async (files: FileList | null) => {
    if (!files?.length) return;
    const size = [...files].reduce((sum, file) => sum + file.size, 0);
    if (size > MOST_UPLOADED) {
      const [got, expected, mend] = [`${(size / 1e6).toFixed(0)} MB`, `at most ${(MOST_UPLOADED / 1e6).toFixed(0)} MB`, "leave out what is not needed"];
      host.wrong([{ path: "files", message: `files: got ${got}; expected ${expected}. Mend: ${mend}`, got, expected, mend, where: "", steps: null }]);
      return;
    }
    host.say(`Reading ${files.length === 1 ? files[0].name : `${files.length} files`} …`);
    await attempt(host, async () => host.load(await api.upload(await Promise.all([...files].map(encoded))), [...files].map((file) => file.name).join(", ")));
    input.value = "";
  };
  input.addEventListener("change", () => void send(input.files));
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    void send(event.dataTransfer?.files ?? null);
  });
  return make("span", { class: "pick" }, make("label", { for: id, text: "Upload", class: "button", title: "A data sheet, or a URDF with its elasticity file (.yaml) and meshes; files can be dropped here too" }), input);
}

async function encoded(file: File): Promise<{ name: string; content: string }> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = "";
  for (let k = 0; k < bytes.length; k += 0x8000) text += String.fromCharCode(...bytes.subarray(k, k + 0x8000));
  return { name: file.name, content: btoa(text) };
}

/** Save the study into the working folder, or load one from it. */
export function studyControls(host: FilesHost): HTMLElement {
  const [opened, named] = [ownId("studies"), ownId("study")];
  const list = make("select", { id: opened });
  const name = make("input", { id: named, type: "text", size: "14", spellcheck: "false", placeholder: "study.yaml" });
  const replace = button("Replace", () => void keep(true), { hidden: true, class: "warn" });
  const refresh = () => attempt(host, async () => {
    const told = await api.studies();
    list.replaceChildren(make("option", { value: "", text: `open from ${told.folder}/ …` }), ...told.studies.map((one) => make("option", { value: one, text: one })));
  });
  const keep = (overwrite: boolean) => attempt(host, async () => {
    const sheet = host.sheet();
    if (!sheet) return;
    const wanted = name.value.trim() || `${host.name().replace(/[^\w.-]+/g, "_")}.yaml`;
    const file = /\.ya?ml$/i.test(wanted) ? wanted : `${wanted}.yaml`;
    name.value = file;
    try {
      const told = await api.save(file, sheet, overwrite);
      host.say(`Saved as ${told.saved}.`);
      replace.hidden = true;
    } catch (error) {
      replace.hidden = !(error instanceof Refused && error.status === 409);
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
  return make("span", { class: "pick" }, make("label", { for: opened, class: "hidden", text: "Open a study" }), list,
    make("label", { for: named, class: "hidden", text: "Name of the study" }), name, button("Save", () => void keep(false), { title: "Save the study as YAML into the working folder" }), replace);
}

/** The run as a report, as data, and the study as YAML, to be kept anywhere. */
export function exportControls(host: FilesHost): HTMLElement {
  const stem = () => host.name().replace(/[^\w.-]+/g, "_") || "robot";
  const file = (product: "report" | "data", ending: string, type: string) => attempt(host, async () => {
    const sheet = host.sheet();
    if (!sheet) return;
    host.say(`Making the ${product} …`);
    const bytes = await host.runner.file(product, sheet, (job) => host.say(`Making the ${product}: ${job.stage || job.state} …`));
    give(bytes, `${stem()}${ending}`, type);
    host.say(`The ${product} is among your downloads.`);
  });
  return make("span", { class: "pick", role: "group", "aria-label": "Export" },
    button("Report", () => void file("report", ".html", "text/html"), { title: "This run as one page that needs no network" }),
    button("Data", () => void file("data", ".nc", "application/x-netcdf"), { title: "All series of this run as NetCDF (result.nc)" }),
    button("YAML", () => void attempt(host, async () => {
      const sheet = host.sheet();
      if (sheet) save((await api.yaml(sheet)).yaml, `${stem()}.yaml`, "application/yaml");
    }), { title: "The study as a data sheet" }));
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
