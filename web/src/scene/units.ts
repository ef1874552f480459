// Numbers as people read them: a prefix that suits the largest, and few digits.

export interface Unit {
  factor: number;
  name: string;
}

const PREFIXES: Record<string, [number, number, string][]> = {
  // below this size, times this, in this unit
  m: [[1e-4, 1e6, "µm"], [0.5, 1e3, "mm"]],
  Pa: [[1e3, 1, "Pa"], [1e6, 1e-3, "kPa"], [Infinity, 1e-6, "MPa"]],
  rad: [[0.1, 1e3, "mrad"]],
  "N m": [[0.1, 1e3, "mN m"], [1e4, 1, "N m"], [Infinity, 1e-3, "kN m"]],
  N: [[0.1, 1e3, "mN"], [1e4, 1, "N"], [Infinity, 1e-3, "kN"]],
  "1": [[1e-2, 1e6, "µm/m"], [Infinity, 1e2, "%"]],
};

/** The unit in which values up to `largest` (in `unit`) read well. */
export function readable(unit: string, largest: number): Unit {
  const found = (PREFIXES[unit] ?? []).find(([below]) => Math.abs(largest) < below);
  return found === undefined || largest === 0
    ? { factor: 1, name: unit === "1" ? "" : unit }
    : { factor: found[1], name: found[2] };
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
