// What the run comes to: the sentence, its numbers, and the error cut into causes, which the picture shows one by one.

import { colour } from "../charts/look";
import type { Clock } from "../clock";
import type { Page, Run, Verdict } from "../contract";
import type { LiveRun, SceneView } from "../contract_parts";
import { button, make, put } from "../dom";
import { damping, digits, info } from "../format";
import { isEarly } from "./early";

export interface VerdictView {
  /** That of the live model for the first run, or that it is being computed; null: the page's own. */
  show(live: LiveRun | null): void;
  /** What lessens the error most, as buttons that apply it, or why that is not known; null: it is being computed. */
  advise(found: Advice[] | string | null): void;
  dispose(): void;
}

export interface Advice {
  text: string;
  apply(): void;
}

type Culprit = Verdict["culprits"][number];

const LESSENS = "Lessens the largest error most:";
const NONE = "No setting within its range lessens the largest error by 1 % or more.";
const NO_ERROR = 1e-9; // m, of rounding: nothing is to be lessened
const MOST = 6; // causes that are named
const FIGURES = 3;
const AFTER: (keyof Verdict)[] = ["settling", "residual"]; // of a run that reached its end

/** One number of the strip: its name, the fields of the verdict on which it rests, and itself. */
const NUMBERS: [string, (keyof Verdict)[], (verdict: Verdict) => string][] = [
  ["Largest error", ["largest_m"], ({ largest_m, time_s }) =>
    largest_m === null ? "" : `${length(largest_m)} at ${written(time_s, "s")}`],
  ["Final error", ["final_m"], ({ final_m }) => (final_m === null ? "" : length(final_m))],
  ["Settling after the move", ["settling"], ({ settling: { time_s, within_m, reason } }) =>
    time_s === null ? reason && "not seen" : `${written(time_s, "s")} (${reason || `within ${length(within_m)}`})`],
  ["Residual vibration", ["residual"], ({ residual }) => residual === null ? "" :
    [length(residual.amplitude_m), written(residual.frequency_Hz, "Hz"),
      `${damping(residual.damping)} damping`].join(", ")],
  ["Nearest limit", ["limits"], ({ limits: [first] }) => first ?
    `${first.quantity} ${first.element} ${digits(100 * first.share, 4)} % of ${written(first.limit, first.unit)}` : ""],
]; // prettier-ignore

export function mountVerdict(element: HTMLElement, page: Page, clock: Clock, scene: SceneView): VerdictView {
  let chosen: { run: number; key: string } | null = null;
  let before = 0; // s, where the clock was
  let advised = Boolean(page.live);
  const rows = page.runs.map((run, k) => rowOf(run, page.runs.length > 1, (culprit) => choose(k, culprit)));
  const leads = make("span", { text: LESSENS });
  const advice = make("div", { class: "advice computing", hidden: true }, leads);
  rows[0].element.append(advice);
  element.append(...rows.map((row) => row.element));
  const fold = () => {
    element.hidden = rows.every((row) => row.verdict === null);
    advice.hidden = !advised || !(Number(rows[0].verdict?.largest_m) > NO_ERROR);
  };
  fold();

  function choose(run: number, culprit: Culprit | null): void {
    const { verdict } = rows[run];
    const again = culprit && chosen?.run === run && chosen.key === keyOf(culprit);
    if (!culprit || !verdict || again) return end();
    if (!chosen) before = clock.time;
    chosen = { run, key: keyOf(culprit) };
    clock.pause();
    clock.seek(verdict.time_s ?? clock.time);
    explain();
  }

  function explain(): void {
    if (!chosen) return;
    const { run, key } = chosen;
    const { verdict } = rows[run];
    const lit = verdict?.culprits.find((one) => keyOf(one) === key);
    if (!verdict || !lit) return end();
    scene.explain({
      run,
      element: lit.element,
      label: `${nameOf(lit)}: ${length(lit.value_m)} of ${length(verdict.largest_m)}`,
      parts: verdict.culprits.map((one) => ({ value: one.value_m, colour: colour(propertyOf(one)), lit: one === lit })),
    });
    rows.forEach((row, k) => row.press(k === run ? key : ""));
  }

  function end(): void {
    if (!chosen) return;
    chosen = null;
    rows.forEach((row) => row.press(""));
    clock.seek(before);
    scene.explain(null);
  }

  const keys = (event: KeyboardEvent) => {
    if (event.key === "Escape" && !event.defaultPrevented && !document.querySelector(":popover-open")) end();
  };
  document.addEventListener("keydown", keys);
  return {
    show(live) {
      rows[0].show(live);
      fold();
      if (chosen?.run === 0 && rows[0].verdict) explain();
    },
    advise(found) {
      advised = true;
      fold();
      advice.classList.toggle("computing", found === null);
      if (found === null) return advice.querySelectorAll("button").forEach((one) => { one.disabled = true; });
      const known = typeof found !== "string";
      put(leads, known ? (found.length ? LESSENS : NONE) : `Which setting lessens the error is not known: ${found}.`);
      advice.replaceChildren(leads, ...(known ? found.map(({ text, apply }) => button(text, apply)) : []));
    },
    dispose() {
      document.removeEventListener("keydown", keys);
      element.replaceChildren();
    },
  };
}

interface Row {
  element: HTMLElement;
  /** That is shown; null: there is none. */
  readonly verdict: Verdict | null;
  show(live: LiveRun | null): void;
  /** The culprit of this key is shown alone. */
  press(key: string): void;
}

function rowOf(run: Run, several: boolean, choose: (culprit: Culprit) => void): Row {
  const sentence = make("p", { class: "verdict-sentence" });
  const numbers = make("dl", { class: "verdict-numbers" });
  const bar = make("div", { class: "culprit-bar", "aria-hidden": "true" });
  const names = make("div", { class: "culprits", role: "group", "aria-label": "Causes of the largest error" });
  const parts = make("div", { class: "verdict-parts" }, bar, names);
  const native = make("p", { class: "note native", hidden: true });
  const title = several ? make("h3", { text: run.name }) : make("h3", { class: "offscreen", text: "Verdict" });
  const element = make("div", { class: "verdict" }, title, sentence, native, numbers, parts);
  let verdict = run.verdict ?? null;
  let shown = "";

  /** `state`: why it is not of what is shown; empty where it is. */
  function fill(pending: string[], state: string): void {
    element.hidden = verdict === null;
    if (!verdict) return;
    element.classList.toggle("computing", state !== "");
    element.dataset.level = state ? "neutral" : verdict.level;
    sentence.dataset.state = state || (pending.includes("settling") ? " computing …" : "");
    put(sentence, verdict.sentence);
    numbers.replaceChildren(...NUMBERS.flatMap(([name, fields, text]) => {
      if (!run.success && AFTER.some((field) => fields.includes(field))) return [];
      const late = fields.some((field) => pending.includes(field));
      const value = late ? "computing" : text(verdict!);
      return value ? [make("div", { class: late ? "computing" : undefined },
        make("dt", { text: name }), make("dd", { text: value }))] : [];
    }));
    cut(verdict);
  }

  /** The bar and its names, made again where the causes have changed. */
  function cut({ culprits }: Verdict): void {
    const key = JSON.stringify(culprits);
    parts.hidden = culprits.length === 0;
    if (key === shown) return;
    shown = key;
    const total = culprits.reduce((sum, { value_m }) => sum + Math.abs(value_m), 0) || 1;
    const focus = [...names.children].indexOf(document.activeElement ?? names);
    bar.replaceChildren(...culprits.map((one) => {
      const piece = make("i", { title: wordsOf(one), class: one.value_m < 0 ? "against" : undefined });
      piece.style.flexGrow = String((100 * Math.abs(one.value_m)) / total); // below 1 in all it would not fill the bar
      piece.style.backgroundColor = `var(${propertyOf(one)})`;
      piece.addEventListener("click", () => choose(one));
      return piece;
    }));
    names.replaceChildren(...culprits.slice(0, MOST).map((one) => {
      const swatch = make("i", { "aria-hidden": "true" });
      swatch.style.backgroundColor = `var(${propertyOf(one)})`;
      const title = "Show this cause alone in the picture; again or Escape: back";
      const found = button("", () => choose(one), { title, "aria-pressed": "false", "data-key": keyOf(one) });
      found.append(swatch, wordsOf(one));
      return found;
    }));
    const others = culprits.slice(MOST);
    const sum = others.reduce((total, { value_m }) => total + value_m, 0);
    if (others.length) names.append(make("span", { text: `${others.length} others ${length(sum)}` }));
    (names.children[focus] as HTMLElement | undefined)?.focus();
  }

  fill(run.pending ?? [], "");
  return {
    element,
    get verdict() {
      return verdict;
    },
    show(live) {
      put(native, live?.native ?? "");
      native.hidden = !live?.native;
      if (live?.verdict ?? !live) verdict = live?.verdict ?? run.verdict ?? null;
      const known = live === null || live.verdict !== undefined;
      fill((live ?? run).pending ?? [], known ? "" : isEarly(live) ? " computing …" : " (of the run as it was)");
    },
    press(key) {
      for (const one of names.querySelectorAll<HTMLElement>("[data-key]"))
        one.setAttribute("aria-pressed", String(one.dataset.key === key));
    },
  };
}

function keyOf({ cause, element }: Culprit): string {
  return `${cause} ${element ?? ""}`;
}

function nameOf({ cause, element }: Culprit): string {
  return element ? `${cause} ${element}` : cause;
}

function wordsOf(culprit: Culprit): string {
  return `${nameOf(culprit)} ${length(culprit.value_m)}`.replace(" -", " −");
}

/** Of several causes together that of the first. */
function propertyOf({ cause }: Culprit): string {
  return `--of-${cause.split(",")[0].replace(/s$/, "").replaceAll(" ", "-")}`;
}

function length(value: number | null): string {
  return written(value, "m");
}

function written(value: number | null, unit: string): string {
  return info(value, unit, FIGURES);
}
