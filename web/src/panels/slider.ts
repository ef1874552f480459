// One number that can be changed: a slider, the number itself, and the way back.

import type { Slider } from "../contract";
import { button, make, ownId, put } from "../dom";
import { digits, pretty, readable } from "../format";

export interface SliderRow {
  readonly element: HTMLElement;
  readonly slider: Slider;
  /** What one per cent of it does, in words. */
  readonly effect: HTMLElement;
  value: number;
  /** Says at the field why its number is refused; empty: it is not. */
  refuse(reason: string): void;
}

const STEPS = 1000;
const LARGE = 1e7;
const TINY = 1e-300; // that is next to zero, which is refused
const [SMALL, BIG] = [1e-3, 4e4]; // ends of sliders whose numbers read better with a prefix
const SHORT = 0.3; // lengths [m], likewise
const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
const BEGUN = /^[-+]?\d*\.?\d*(e[-+]?)?$/i; // what may become a number as it is typed
const SHOWN = 40; // letters of what was typed that a refusal repeats

/** `changed` is called whenever the user gave another value: within the slider's ends, typed within the sheet's. */
export function makeSlider(slider: Slider, changed: () => void): SliderRow {
  const name = ownId("slider");
  const { factor, name: unit } = unitOf(slider);
  const range = make("input", { type: "range", id: name, min: "0", max: String(STEPS), step: "1" });
  const number = make("input", { // a number field drops what it does not know: 1,5 becomes 15
    type: "text", inputmode: "decimal", class: "number", autocomplete: "off", spellcheck: "false",
    "aria-label": `${slider.label}${unit ? `, in ${unit}` : ""}`,
  });
  const reason = make("p", { class: "note refused", role: "alert", hidden: true });
  const back = button("↺", undo, {
    class: "tool",
    "aria-label": `${slider.label}: back to ${digits(factor * slider.value, 6)} ${unit}`,
    title: "back to the run's own",
  });
  const effect = make("span", { class: "effect" });
  let value = slider.value;

  function tell(typing = false): void {
    range.value = String(Math.round(STEPS * shareOf(slider, value)));
    range.setAttribute("aria-valuetext", `${digits(factor * value, 5)} ${unit}`);
    if (!typing) number.value = typed(factor * value);
    back.disabled = value === slider.value;
    element.classList.toggle("changed", value !== slider.value);
  }

  function give(wanted: number, typing = false): void {
    const { least = -Infinity, most = Infinity } = slider;
    const beyond = wanted < least ? ["at least", least] as const : wanted > most ? ["at most", most] as const : null;
    const above = beyond?.[1] && beyond[1] < TINY;
    const end = beyond && (above ? "a number above 0" : `${beyond[0]} ${digits(factor * beyond[1])} ${unit}`.trim());
    refuse(end ? `Got ${`${digits(factor * wanted)} ${unit}`.trim()}; the data sheet takes ${end}.` : "");
    if (beyond) return;
    const moved = wanted !== value;
    value = wanted;
    tell(typing);
    if (moved) changed();
  }

  /** Takes what is typed as far as it is a number; `whole`: no more of it follows. */
  function read(whole: boolean): void {
    const text = number.value.trim().replace("\u2212", "-");
    const wanted = NUMBER.test(text) ? Number(text) / factor : NaN;
    refuse("");
    if (Number.isFinite(wanted)) give(wanted, true);
    else if (text && (whole || !BEGUN.test(text))) refuse(`Got ${text.slice(0, SHOWN)}; expected ${expected(text)}.`);
  }

  function refuse(why: string): void {
    put(reason, why);
    reason.hidden = !why;
    number.setAttribute("aria-invalid", String(Boolean(why)));
  }

  /** The button that was pressed is of no more use then: the keyboard continues at the slider. */
  function undo(): void {
    give(slider.value);
    range.focus();
  }

  range.addEventListener("input", () => give(Number(digits(valueOf(slider, Number(range.value) / STEPS), 4))));
  number.addEventListener("input", () => read(false));
  number.addEventListener("change", () => {
    read(true);
    if (reason.hidden) tell();
  });
  const words = make(
    "label",
    { for: name, title: slider.path },
    make("span", { text: slider.label }),
    make("i", { text: slider.symbol ? ` ${slider.symbol}` : "" }),
    effect,
  );
  const element = make("div", { class: "slider", "data-path": slider.path }, words,
    make("div", { class: "slider-row" }, range, number, make("span", { class: "unit", text: unit }), back),
    reason, make("code", { class: "path", text: slider.path, title: "--set PATH=VALUE" }));
  tell();
  return {
    element,
    slider,
    effect,
    refuse,
    get value() {
      return value;
    },
    set value(wanted) {
      value = wanted;
      refuse("");
      tell();
    },
  };
}

/** What stands for a text that is no number. */
function expected(text: string): string {
  if (NUMBER.test(text)) return "a finite number";
  const pointed = text.replace(",", ".");
  return NUMBER.test(pointed) ? `a decimal point: ${pointed}` : "a number, such as 0.25 or 1e-3";
}

/** Its unit, with a prefix where its numbers would be long: GPa, mm. */
export function unitOf({ unit, min, max }: Pick<Slider, "unit" | "min" | "max">): { factor: number; name: string } {
  const size = Math.max(Math.abs(min), Math.abs(max));
  const small = size < (unit === "m" ? SHORT : SMALL);
  return (small || size >= BIG) && !unit.startsWith("kg") ? readable(unit, size) : { factor: 1, name: pretty(unit) };
}

/** As a field of numbers takes it: a modulus in Pa has more zeros than fit. */
function typed(value: number): string {
  const few = Number(value.toPrecision(6));
  return Math.abs(few) < LARGE ? String(few) : few.toExponential().replace("+", "");
}

function shareOf(slider: Slider, value: number): number {
  const { min, max } = slider;
  if (max <= min) return 0;
  return slider.log && min > 0 && value > 0 ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
}

function valueOf(slider: Slider, share: number): number {
  const { min, max } = slider;
  return slider.log && min > 0 ? min * (max / min) ** share : min + share * (max - min);
}
