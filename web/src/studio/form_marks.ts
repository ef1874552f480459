// The notes at fields of a form that are wrong or uncertain.

import { make, ownId } from "../dom";
import type { Wrong } from "./api";
import type { Step } from "./sheet";

export class Marks {
  private marked: (() => void)[] = [];
  private notices: Wrong[] = [];

  /** `find`: the field at steps, its groups opened if wanted, or the nearest group around it. */
  constructor(private readonly find: (steps: Step[], open: boolean) => HTMLElement | null) {}

  /**
   * Mark the fields that are wrong, and the uncertain ones; what has no field is marked at the group around it.
   */
  show(errors: Wrong[], notices = this.notices): void {
    this.marked.forEach((end) => end());
    this.marked = [];
    errors.forEach((error) => this.note(error, "wrong"));
    const places = (of: Wrong[]) => of.map(({ path }) => path).join();
    const fresh = places(notices) !== places(this.notices); // groups open once for them, not at each run
    notices.forEach((notice) => this.note(notice, "notice", fresh));
    this.notices = notices;
  }

  private note(error: Wrong, kind: "wrong" | "notice", open = true): void {
    const input = error.steps ? this.find(error.steps, open) : null;
    if (!input) return;
    const id = ownId(kind);
    const note = make("p", { class: kind, id, text: `${error.message}. ${error.hint}` });
    (input.closest(".field") ?? input).after(note);
    if (kind === "wrong") input.setAttribute("aria-invalid", "true");
    input.setAttribute("aria-describedby", id);
    this.marked.push(() => {
      note.remove();
      input.removeAttribute("aria-invalid");
      input.removeAttribute("aria-describedby");
    });
  }
}
