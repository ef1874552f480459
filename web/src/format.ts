// Numbers with units as a person reads them; tmodes/report/markup.py writes the same.

const PREFIXES: [number, number, string][] = [
  [1e10, 1e-9, "G"],
  [1e7, 1e-6, "M"],
  [1e4, 1e-3, "k"],
  [0.1, 1, ""],
  [1e-4, 1e3, "m"],
  [1e-7, 1e6, "µ"],
  [1e-11, 1e9, "n"],
];
const [LEAST, LARGE] = [1e-11, 1e7]; // sizes with a prefix from; powers of ten from
const NEVER_LARGE = ["m", "rad", "s", "gain"];
const PLAIN = ["Hz", "%", "rad/s"];
/** One unit for what is compared, but for tiny sizes: below this size the factor on the SI value and its name. */
const FIXED: Record<string, [number, number, string]> = { m: [10, 1e3, "mm"], rad: [1, 1e3, "mrad"], s: [1, 1, "s"] };
const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** `N*m` and `N m` as `N·m`; no unit is empty. */
export function pretty(unit: string): string {
  const written = unit.trim().replace(/[* ]/g, "·").replace("^2", "²").replace("^3", "³").replace("ohm", "Ω");
  return ["-", "1", "–"].includes(written) ? "" : written;
}

/** To so many digits that tell, without zeros at the end. */
export function digits(value: number, count = 4): string {
  return value === 0 ? "0" : String(Number(value.toPrecision(count)));
}

const BEFORE_UNIT = /([\d⁰¹²³⁴-⁹]) (?=(?:[nµmkMG]?(?:m|s|g|N|Pa|Hz|rad|V|A|J|W|Ω)|%|°|deg)(?![A-Za-z0-9_]))/g;

/** Text whose numbers no end of a line parts from their units, as `bound` of tmodes/io/printed.py. */
export function bound(text: string): string {
  return text.replace(BEFORE_UNIT, "$1\u00a0").replace(/(\d) × (?=10)/g, "$1\u00a0×\u00a0");
}

export function powerOfTen(value: number): string {
  if (value === 0) return "0";
  const [number, power] = value.toExponential(1).split("e");
  const raised = [...String(Number(power))]
    .map((letter) => (letter === "-" ? "⁻" : SUPERSCRIPT[Number(letter)]))
    .join("");
  return `${number}\u00a0×\u00a010${raised}`;
}

/** The prefix in which a value of this size [SI] reads well: factor on the SI value, and name of the unit. */
export function readable(unit: string, size: number): { factor: number; name: string } {
  const name = pretty(unit);
  const fixed = FIXED[unit];
  if (fixed) return size < fixed[0] ? { factor: fixed[1], name: fixed[2] } : { factor: 1, name };
  if (!name || PLAIN.includes(unit) || !(size > 0)) return { factor: 1, name };
  return prefixed(name, size, NEVER_LARGE.includes(unit.split("/")[0]));
}

function prefixed(name: string, size: number, never = true): { factor: number; name: string } {
  const found = PREFIXES.find(([least, factor]) => size >= least && (factor >= 1 || !never));
  return found ? { factor: found[1], name: found[2] + name } : { factor: 1, name };
}

/** A damping ratio in per cent: tenths where it is small, and no more of what is rounding. */
export function damping(ratio: number): string {
  return info(Number((100 * ratio).toFixed(ratio < 0.0995 ? 1 : 0)) + 0, "%", 2);
}

/** `4.041 mm`. */
export function info(value: number | null, unit: string, count = 4): string {
  if (value === null || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const small = unit in FIXED && size >= LEAST && size * FIXED[unit][1] < 1e-3;
  const { factor, name } = small ? prefixed(pretty(unit), size) : readable(unit, size);
  const shown = size * factor;
  const power = size > 0 && !small && (factor === 1 || unit in FIXED ? shown < 1e-3 || shown >= LARGE : size < LEAST);
  const written = power ? powerOfTen(unit in FIXED ? value * factor : value) : digits(value * factor, count);
  return `${written}\u00a0${name}`.trimEnd();
}

/** A number on an axis or in a legend, without a unit. */
export function plain(value: number): string {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return powerOfTen(value);
  return digits(value);
}
