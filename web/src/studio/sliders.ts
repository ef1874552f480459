// The row of sliders: the numbers of a sheet that are dragged most, as the server finds them.

import { make, ownId } from "../dom";
import { digits } from "../format";
import { unitOf } from "../panels/slider";
import type { Knob, Wrong } from "./api";
import { read } from "./field";
import { at, put, type Sheet } from "./sheet";

const STEPS = 1000;

export interface SlidersView {
  /** Show what the sheet says now. */
  refresh(): void;
  /** Mark the sliders of what is wrong, and no others. */
  mark(errors: Wrong[]): void;
}

/** `changed` is called after each move. */
export function mountSliders(element: HTMLElement, knobs: Knob[], sheet: Sheet, changed: () => void): SlidersView {
  const rows = knobs.map((knob) => slider(knob, sheet, changed));
  element.replaceChildren(...rows.map((row) => row.element));
  element.hidden = rows.length === 0;
  return {
    refresh: () => rows.forEach((row) => row.refresh()),
    mark: (errors) => {
      const wrong = new Set(errors.flatMap(({ steps }) => (steps ? [steps.join(".")] : [])));
      for (const { element: row } of rows)
        row.querySelector(".number")?.setAttribute("aria-invalid", String(wrong.has(row.dataset.slider ?? "")));
    },
  };
}

function slider(knob: Knob, sheet: Sheet, changed: () => void): { element: HTMLElement; refresh(): void } {
  const id = ownId("slider");
  const range = make("input", { id, type: "range", min: "0", max: String(STEPS), step: "1" });
  const typed = make("input", {
    type: "text",
    inputmode: "decimal",
    class: "number",
    "aria-label": `${knob.label}, typed`,
    autocomplete: "off",
  });
  const { factor, name: unit } = knob.together ? { factor: 1, name: "×" } : unitOf(knob);
  const label = make("label", { for: id }, document.createTextNode(knob.label));
  if (knob.symbol && knob.symbol !== "-") label.append(make("span", { class: "symbol", text: ` ${knob.symbol}` }));
  const info = make("span", { class: "unit", text: unit });

  const refresh = () => {
    const value = valueOf(knob, sheet);
    if (document.activeElement !== typed) typed.value = value === null ? "" : digits(factor * value);
    if (value !== null) range.value = String(Math.round(STEPS * shareOf(knob, value)));
    range.disabled = value === null;
    range.setAttribute("aria-valuetext", value === null ? "not a number" : `${digits(factor * value)} ${unit}`);
  };
  range.addEventListener("input", () => {
    apply(knob, sheet, placed(knob, Number(range.value) / STEPS));
    refresh();
    changed();
  });
  typed.addEventListener("change", () => {
    const value = read(typed.value);
    if (typeof value === "number") apply(knob, sheet, value / factor);
    else if (value !== undefined && !knob.together)
      put(sheet, knob.targets[0].steps, value); // perhaps with a unit: the server reads it
    else typed.value = digits(factor * (valueOf(knob, sheet) ?? 1));
    changed();
    refresh();
  });
  refresh();
  return {
    element: make(
      "div",
      { class: "slider", "data-slider": knob.targets[0].steps.join(".") },
      label,
      range,
      typed,
      info,
      make("code", { class: "path", text: knob.path, title: "--set PATH=VALUE" }),
    ),
    refresh,
  };
}

/** The value at which a slider stands: that of its number, or the factor on all of them. */
export function valueOf(knob: Knob, sheet: Sheet): number | null {
  const [first] = knob.targets;
  const value = at(sheet, first.steps) ?? (first.steps[0] === "real" ? 1 : null); // a factor that is not given is 1
  if (typeof value !== "number") return null;
  return knob.together ? value / first.base : value;
}

/** Puts a value where a slider's numbers are. */
export function apply(knob: Knob, sheet: Sheet, value: number): void {
  for (const target of knob.targets) put(sheet, target.steps, knob.together ? target.base * value : value);
}

function shareOf(knob: Knob, value: number): number {
  const share = knob.log
    ? Math.log(value / knob.min) / Math.log(knob.max / knob.min)
    : (value - knob.min) / (knob.max - knob.min);
  return Math.min(Math.max(Number.isFinite(share) ? share : 0, 0), 1);
}

/** The value at a share of the way, with the digits that a hand can choose. */
function placed(knob: Knob, share: number): number {
  const value = knob.log ? knob.min * (knob.max / knob.min) ** share : knob.min + (knob.max - knob.min) * share;
  return Number(value.toPrecision(4));
}
