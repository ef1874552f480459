// Robots of one's own: files that are chosen or dropped, or a folder with all that is in it.

import { make, ownId } from "../dom";
import { api, Refused, type Wrong } from "./api";
import { attempt, type FilesHost } from "./files";

const MOST_UPLOADED = 16 * 1024 * 1024; // as the server has it
const ENDINGS = [".yaml", ".yml", ".urdf", ".xacro", ".xml", ".stl", ".obj", ".dae"];

interface Sent {
  /** With the folders below the one that was chosen. */
  name: string;
  file: File;
}

/** A URDF with its elasticity file and meshes, or any data sheet. */
export function uploadControl(host: FilesHost): HTMLElement {
  const send = (chosen: Sent[] | Promise<Sent[]>) => attempt(host, async () => {
    const sent = await chosen;
    if (!sent.length || refused(host, sent)) return;
    const names = sent.length <= 3 ? sent.map(({ name }) => name).join(", ") : `${sent.length} files`;
    host.say(`Reading ${names} …`);
    host.load(await api.upload(await Promise.all(sent.map(encoded))), names);
  });
  const chooser = (text: string, title: string, folder: boolean) => {
    const id = ownId("upload");
    const input = make("input", {
      id,
      type: "file",
      multiple: true,
      accept: folder ? undefined : ENDINGS.join(),
      class: "upload",
      webkitdirectory: folder,
    });
    input.addEventListener("change", () => {
      const chosen = [...(input.files ?? [])].map((file) => ({ name: file.webkitRelativePath || file.name, file }));
      void send(folder ? chosen.filter(ours) : chosen).finally(() => { input.value = ""; });
    });
    return make("span", { class: "pick" }, input, make("label", { for: id, text, class: "button", title }));
  };
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer) void send(dropped(event.dataTransfer));
  });
  return make(
    "span",
    { class: "pick" },
    chooser(
      "Upload",
      "A data sheet, or a URDF with its elasticity file (.yaml) and meshes, chosen together; " +
        "they can be dropped here too",
      false,
    ),
    chooser("Folder", "A folder with a URDF, its elasticity file and meshes", true),
  );
}

function refused(host: FilesHost, sent: Sent[]): boolean {
  const size = sent.reduce((sum, { file }) => sum + file.size, 0);
  if (size <= MOST_UPLOADED) return false;
  const [got, expected, hint] = [
    `${(size / 1e6).toFixed(0)} MB`,
    `at most ${(MOST_UPLOADED / 1e6).toFixed(0)} MB`,
    "leave out what is not needed",
  ];
  host.wrong([wrong("files", `got ${got}; expected ${expected}`, hint, got, expected)]);
  return true;
}

function wrong(path: string, message: string, hint: string, got = "", expected = ""): Wrong {
  return { path, message, got, expected, hint, where: "", steps: null };
}

/** What the browser reads of a file or folder; it may be gone by now. */
async function reading<T>(name: string, read: Promise<T>): Promise<T> {
  try {
    return await read;
  } catch (error) {
    const why = error instanceof DOMException ? ` (${error.name})` : "";
    const got = `it cannot be read${why}: it was changed, moved or taken away, or may not be read`;
    throw new Refused([wrong(name, got, "choose it again")], 0);
  }
}

/** Whether a file of a whole folder may belong to a robot. */
function ours({ name }: Sent): boolean {
  return (
    ENDINGS.some((ending) => name.toLowerCase().endsWith(ending)) &&
    !name.split("/").some((part) => part.startsWith("."))
  );
}

/** What was dropped; of folders all that may belong to a robot. */
async function dropped(given: DataTransfer): Promise<Sent[]> {
  const entries = [...given.items].map((item) => item.webkitGetAsEntry()); // all at once: they are gone after a wait
  const plain = [...given.files].map((file) => ({ name: file.name, file }));
  if (!entries.some((entry) => entry?.isDirectory)) return plain;
  const found = await Promise.all(entries.map((entry) => (entry ? within(entry) : [])));
  return found.flat();
}

async function within(entry: FileSystemEntry): Promise<Sent[]> {
  if (entry.isFile) {
    const file = await reading(
      entry.name,
      new Promise<File>((done, failed) => (entry as FileSystemFileEntry).file(done, failed)),
    );
    const sent = { name: entry.fullPath.replace(/^\//, ""), file };
    return ours(sent) ? [sent] : [];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const inner: FileSystemEntry[] = [];
  for (;;) { // a reader reports about a hundred at a time
    const some = await reading(
      entry.name,
      new Promise<FileSystemEntry[]>((done, failed) => reader.readEntries(done, failed)),
    );
    if (!some.length) break;
    inner.push(...some);
  }
  return (await Promise.all(inner.map(within))).flat();
}

async function encoded({ name, file }: Sent): Promise<{ name: string; content: string }> {
  const bytes = new Uint8Array(await reading(name, file.arrayBuffer()));
  let text = "";
  for (let k = 0; k < bytes.length; k += 0x8000) text += String.fromCharCode(...bytes.subarray(k, k + 0x8000));
  return { name, content: btoa(text) };
}
