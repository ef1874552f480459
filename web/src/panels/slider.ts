// One number that can be changed: a slider, the number itself, and the way back.

import type { Slider } from "../contract";
import { button, make, ownId } from "../dom";
import { digits, pretty } from "../format";

export interface SliderRow {
  readonly element: HTMLElement;
  readonly slider: Slider;
  /** What one per cent of it does, in words. */
  readonly effect: HTMLElement;
  value: number;
}

const STEPS = 1000;
const LARGE = 1e7;

/** `changed` is called whenever the user gave another value, within the slider's bounds. */
export function makeSlider(slider: Slider, changed: () => void): SliderRow {
  const name = ownId("slider");
  const unit = pretty(slider.unit);
  const range = make("input", { type: "range", id: name, min: "0", max: String(STEPS), step: "1" });
  const number = make("input", {
    type: "number",
    "aria-label": `${slider.label}${unit ? `, in ${unit}` : ""}`,
    step: "any",
    min: String(slider.min),
    max: String(slider.max),
  });
  const back = button("↺", undo, {
    class: "tool",
    "aria-label": `${slider.label}: back to ${digits(slider.value, 6)} ${unit}`,
    title: "back to the run's own",
  });
  const effect = make("span", { class: "effect" });
  let value = slider.value;

  function tell(typing = false): void {
    range.value = String(Math.round(STEPS * shareOf(slider, value)));
    range.setAttribute("aria-valuetext", `${digits(value, 5)} ${unit}`);
    if (!typing) number.value = typed(value);
    back.disabled = value === slider.value;
    element.classList.toggle("changed", value !== slider.value);
  }

  function give(wanted: number, typing = false): void {
    const bounded = Math.min(Math.max(wanted, slider.min), slider.max);
    if (bounded === value) return tell(typing);
    value = bounded;
    tell(typing);
    changed();
  }

  /** The button that was pressed is of no more use then: the keyboard continues at the slider. */
  function undo(): void {
    give(slider.value);
    range.focus();
  }

  range.addEventListener("input", () => give(Number(digits(valueOf(slider, Number(range.value) / STEPS), 4))));
  number.addEventListener("input", () => {
    if (number.value !== "" && Number.isFinite(number.valueAsNumber)) give(number.valueAsNumber, true);
  });
  number.addEventListener("change", () => tell());
  const words = make(
    "label",
    { for: name, title: slider.path },
    make("span", { text: slider.label }),
    make("i", { text: slider.symbol ? ` ${slider.symbol}` : "" }),
    effect,
  );
  const element = make("div", { class: "slider", "data-path": slider.path }, words,
    make("div", { class: "slider-row" }, range, number, make("span", { class: "unit", text: unit }), back),
    make("code", { class: "path", text: slider.path, title: "--set PATH=VALUE" }));
  tell();
  return {
    element,
    slider,
    effect,
    get value() {
      return value;
    },
    set value(wanted) {
      value = wanted;
      tell();
    },
  };
}

/** As a field of numbers takes it: a modulus in Pa has more zeros than fit. */
function typed(value: number): string {
  const few = Number(value.toPrecision(6));
  return Math.abs(few) < LARGE ? String(few) : few.toExponential().replace("+", "");
}

function shareOf(slider: Slider, value: number): number {
  const { min, max } = slider;
  if (max <= min) return 0;
  return slider.log && min > 0 ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
}

function valueOf(slider: Slider, share: number): number {
  const { min, max } = slider;
  return slider.log && min > 0 ? min * (max / min) ** share : min + share * (max - min);
}
