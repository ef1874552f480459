// What the studio says: how a run ended and how long it took, progress, and what is wrong and where.

import { button, make, put } from "../dom";
import type { Job, StudioChange, StudioPage, Wrong } from "./api";

export interface Messages {
  element: HTMLElement;
  say(text: string): void;
  loaded(from: string, warnings: string[]): void;
  progress(stage: string, share: number): void;
  done(page: StudioPage | StudioChange, job: Job, milliseconds: number): void;
  /** What of the robot's looks cannot be shown. */
  unseen(notices: Wrong[], go: (notice: Wrong) => void): void;
  /** Whether the server is away, in words. */
  away(text: string | null): void;
  wrong(errors: Wrong[], go: (error: Wrong) => void): void;
  /** What was wrong with a file is fixed; what is wrong at fields stays. */
  right(): void;
  /** The button that ends a run: it is there while one takes long. */
  cancel(button: HTMLElement): void;
  /** What can be done about what the line says; null: nothing. */
  offer(button: HTMLElement | null): void;
}

export function messages(): Messages {
  const line = make("p", { class: "line", role: "status", "aria-live": "polite" });
  const bar = make("progress", { max: "1", "aria-label": "Progress of the run", hidden: true });
  const errors = make("div", { class: "errors", role: "alert", hidden: true });
  const notices = make("div", { class: "notices", hidden: true });
  const offered = make("span", {});
  const gone = make("p", { class: "gone", role: "alert", hidden: true });
  const element = make("div", { class: "messages" }, make("div", { class: "now" }, bar, line, offered), gone, errors,
    notices);
  let stop: HTMLElement | null = null;
  let odd: HTMLElement[] = [];
  let atFields = false;

  const info = (one: Wrong, go: (one: Wrong) => void) => {
    const place = [one.where, one.path].filter(Boolean).join(" · ");
    const title = one.steps
      ? button(place, () => go(one), { class: "place", title: "Go to the field" })
      : make("strong", { text: place });
    const hint =
      one.hint && !one.message.includes(one.hint) ? make("span", { class: "hint", text: ` ${one.hint}` }) : null;
    return make("p", {}, title, make("span", { text: ` ${one.message}${hint ? "." : ""}` }), hint);
  };
  const notice = (more: HTMLElement[]) => {
    notices.hidden = odd.length + more.length === 0;
    notices.replaceChildren(...odd, ...more);
  };

  const busy = (yes: boolean) => {
    bar.hidden = !yes;
    if (stop) stop.hidden = !yes;
  };
  const say = (text: string) => {
    busy(false);
    put(line, text);
  };
  return {
    element,
    say,
    cancel: (button) => { stop = button; },
    offer: (button) => offered.replaceChildren(...(button ? [button] : [])),
    loaded(from, warnings) {
      say(`${from}: loaded.`);
      errors.hidden = true;
      odd = warnings.map((text) => make("p", { text: `Looks odd: ${text}` }));
      notice([]);
    },
    progress(stage, share) {
      busy(true);
      bar.value = share;
      line.textContent = `${stage || "starting"}: ${Math.round(100 * share)} %`;
    },
    done(page, job, milliseconds) {
      errors.hidden = true;
      const run = page.runs[0];
      const seconds = Object.entries(job.info.seconds ?? {}).filter(([name]) => name !== "loops");
      const server = seconds.reduce((sum, [, value]) => sum + value, 0);
      const warnings = run.warnings.length
        ? ` ${run.warnings.length === 1 ? "One warning" : `${run.warnings.length} warnings`}: ${run.warnings.join(" ")}`
        : "";
      if (job.info.offer?.length) return say("At rest: nothing moves this robot yet.");
      say(
        `${run.success ? "" : `${run.status}: ${run.message} `}New curves after ${Math.round(milliseconds)} ms, ` +
          `of which the server took ${Math.round(1000 * server)} ms.${warnings}`,
      );
    },
    away(text) {
      gone.hidden = text === null;
      gone.textContent = text ?? "";
      if (text !== null) busy(false);
    },
    unseen: (list, go) => notice(list.map((one) => info(one, go))),
    right: () => { if (!atFields) errors.hidden = true; },
    wrong(list, go) {
      say("");
      atFields = list.some((one) => one.steps !== null);
      errors.hidden = false;
      errors.replaceChildren(...list.map((error) => info(error, go)));
    },
  };
}
