// The data sheet of a run as YAML: the template that tmodes/live/template.py made, with the sliders' numbers in it.

import type { Place, SheetPart } from "./bundle";

/** The text of the sheet for values of the sliders. */
export function sheetText(template: readonly SheetPart[], values: readonly number[]): string {
  const shown = template.map((part) => typeof part === "object" && "parts" in part && isShown(part.optional, values));
  const anyOptional = template.some(
    (part, k) => shown[k] && typeof part === "object" && "optional" in part && part.optional >= 0,
  );
  return template
    .map((part, k) => {
      if (typeof part === "string") return part;
      if ("header" in part) return anyOptional ? part.header : "";
      return shown[k]
        ? part.parts.map((piece) => (typeof piece === "string" ? piece : filled(piece, values))).join("")
        : "";
    })
    .join("");
}

function isShown(optional: number, values: readonly number[]): boolean {
  return optional < 0 || values[optional] !== 1;
}

function filled(place: Place, values: readonly number[]): string {
  return yamlNumber(place.sliders.reduce((value, k) => value * values[k], place.base));
}

/** All digits; with a point, so that readers of YAML 1.1 see a number too. */
export function yamlNumber(value: number): string {
  const [digits, power] = String(value).split("e");
  const whole = digits.includes(".") ? digits : `${digits}.0`;
  return power === undefined ? whole : `${whole}e${power}`;
}
