// What of a page can be taken along: the data sheet of each run.

import type { Page } from "../contract";
import { button, save } from "../dom";

export function mountSave(element: HTMLElement, page: Page): void {
  for (const run of page.runs) {
    if (!run.sheet) continue;
    const words = page.runs.length > 1 ? `Save the YAML of ${run.name}` : "Save the YAML of this run";
    element.append(
      button(words, () => save(run.sheet, `${fileName(run.name)}.yaml`, "application/yaml"), { class: "save-yaml" }),
    );
  }
}

/** A name that every file system takes. */
export function fileName(name: string): string {
  return name.replace(/[^\p{L}\p{N}._-]+/gu, "_").replace(/^[._]+/, "").slice(0, 80) || "run";
}
