// What of a page can be taken along: the data sheet of each run, a picture, a film, an address that leads back here.

import type { Clock } from "../clock";
import type { Page } from "../contract";
import type { SceneView } from "../contract_parts";
import { button, menu, put, save, savePicture } from "../dom";

export function mountSave(element: HTMLElement, page: Page): void {
  for (const run of page.runs) {
    if (!run.sheet) continue;
    const words = page.runs.length > 1 ? `Save the YAML of ${run.name}` : "Save the YAML of this run";
    element.append(
      button(words, () => save(run.sheet, `${fileName(run.name)}.yaml`, "application/yaml"), { class: "save-yaml" }),
    );
  }
}

/** A menu for the picture's bar; `address` gives the one that leads back to what is shown. */
export function saveMenu(name: string, scene: SceneView, clock: Clock, address: () => string): HTMLElement {
  const link = button("Copy a link to this view", () => {
    location.replace(address());
    const copied = navigator.clipboard?.writeText(location.href) ?? Promise.reject(new Error("no clipboard"));
    copied.then(() => put(link, "Link copied"), () => put(link, "The link is in the address bar"));
  }, { class: "copy-link" });
  const film = button("Record the run (WebM)", () => clock.duration / clock.speed > LEAST
    ? record(name, scene, clock, film) : put(film, "Too short for a film: choose a lower speed"), {
    hidden: typeof MediaRecorder === "undefined",
  });
  const found = menu("Save", button("Save the picture (PNG)", () => savePicture(scene.picture(), name)), film, link);
  found.classList.add("save-menu");
  return found;
}

const FRAMES = 30; // a second
const LEAST = 2 / FRAMES; // s, of a film

/** Play the run once from its start, and save what was seen; pressed again it ends earlier. */
function record(name: string, scene: SceneView, clock: Clock, control: HTMLButtonElement): void {
  if (control.getAttribute("aria-pressed") === "true") return clock.pause();
  const words = control.textContent ?? "";
  const canvas = scene.picture();
  const recorder = new MediaRecorder(canvas.captureStream(FRAMES), { mimeType: "video/webm" });
  const parts: Blob[] = [];
  const { loop } = clock;
  recorder.ondataavailable = ({ data }) => parts.push(data);
  recorder.onstop = () => save(new Blob(parts), `${name}.webm`, "video/webm");
  recorder.start();
  clock.pause();
  clock.loop = false;
  clock.seek(0);
  clock.play();
  control.setAttribute("aria-pressed", "true");
  put(control, "Stop recording");
  const end = clock.subscribe(() => {
    scene.picture(canvas);
    if (clock.playing) return;
    end();
    clock.loop = loop;
    control.setAttribute("aria-pressed", "false");
    put(control, words);
    recorder.stop();
  });
}

/** A name that every file system takes. */
export function fileName(name: string): string {
  return name.replace(/[^\p{L}\p{N}._-]+/gu, "_").replace(/^[._]+/, "").slice(0, 80) || "run";
}
