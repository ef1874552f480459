// Numbers as people read them: a prefix that suits the largest, and few digits.

import { readable as usual } from "../format";

/** The unit in which values up to `largest` (in `unit`) read well; strains in µm/m or in percent. */
export function readable(unit: string, largest: number): { factor: number; name: string } {
  if (unit !== "1" || largest === 0) return usual(unit, Math.abs(largest));
  return Math.abs(largest) < 1e-2 ? { factor: 1e6, name: "µm/m" } : { factor: 1e2, name: "%" };
}

/** A number in three digits. */
export function digits(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e5 || size < 1e-3)) return value.toExponential(2).replace("-", "−");
  const places = size === 0 ? 0 : Math.max(0, 2 - Math.floor(Math.log10(size)));
  return String(Number(value.toFixed(places))).replace("-", "−");
}

/** The largest of 1, 2, 5, 10, 20, … that is not above `value`. */
export function round125(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}
