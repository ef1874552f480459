// Modes of vibration of a live run as a page shows them: as tmodes/report/data.py, drafts.py and facts.py tell
// them.

import type { Mode } from "../contract";
import type { Vibration } from "../contract_parts";
import type { Numbers } from "../pack";
import type { Motions } from "./eigen";
import { figures, type Facts } from "./facts";

/** One mode; `re`, `im`: its motion in all coordinates, as the damped robot moves. */
export interface Found {
  frequency: number; // natural, |pole|/2 pi [Hz]; 0: it does not ring
  /** As it rings [Hz]; null: it does not. */
  rings: number | null;
  damping: number;
  element: string;
  re: Float64Array;
  im: Float64Array;
}

/** Coordinates [m, nq] to the lines of all links [m, L, S, 3] m. */
export type Lines = (q: Float64Array, count: number) => Numbers;

const MOST = 8; // modes that are shown of each case
const STEP = 1e-5; // of the largest coordinate, by which a line's motion is found
const NO_PEAK = Math.SQRT1_2; // damping from which on a response has no peak
const RINGS = 1e-9;

/** What the page shows of the modes of each case about `rest` [nq], of those `marked`, and the headline number. */
export function info(
  cases: Record<string, Found[]>, marked: readonly Found[], rest: Float64Array, lines: Lines,
): { vibration: Vibration; facts: Facts } {
  const vibrating = Object.entries(cases).flatMap(([name, found]) =>
    found
      .filter((mode) => mode.frequency > 0)
      .slice(0, MOST)
      .map((mode): [string, Found] => [name, mode]),
  );
  const modes = shown(vibrating, rest, lines);
  const marks = marked.flatMap((mode) =>
    mode.rings && mode.damping < NO_PEAK ? [{ at: mode.rings, label: mode.element }] : [],
  );
  return { vibration: { modes, marks: marks.sort((a, b) => a.at - b.at) }, facts: frequencyFact(cases) };
}

function frequencyFact({ controlled, locked }: Record<string, Found[] | undefined>): Facts {
  if (!controlled) return {};
  const lowest = (modes: Found[]) =>
    modes.reduce(
      (least: number | null, { rings, frequency }) => (rings && frequency < (least ?? Infinity) ? frequency : least),
      null,
    );
  const [value, held] = [lowest(controlled), lowest(locked ?? [])];
  const note =
    value === null
      ? "no vibration under control"
      : held === null
        ? ""
        : `${figures(held, 4)} Hz with the motors locked`;
  return { "frequency.first": { value, note } };
}

/** Modes with the lines of the rest and their displacements, all found in one go. */
function shown(modes: [string, Found][], rest: Float64Array, lines: Lines): Mode[] {
  const n = rest.length;
  const ends = new Float64Array((1 + 4 * modes.length) * n);
  ends.set(rest);
  modes.forEach(([, { re, im }], place) => {
    const size = re.reduce((most, value, k) => Math.max(most, Math.hypot(value, im[k])), 0);
    for (let k = 0; k < n; k += 1) {
      const [real, imaginary] = [(STEP * re[k]) / size, (STEP * im[k]) / size];
      [real, imaginary, -real, -imaginary].forEach((away, row) => {
        ends[(1 + 4 * place + row) * n + k] = rest[k] + away;
      });
    }
  });
  const { data, shape } = lines(ends, 1 + 4 * modes.length);
  const each = data.length / (1 + 4 * modes.length);
  const slope = (row: number) =>
    Float64Array.from({ length: each }, (_, k) => (data[row * each + k] - data[(row + 2) * each + k]) / (2 * STEP));
  const numbers = (values: ArrayLike<number>) => ({ data: Float32Array.from(values), shape: shape.slice(1) });
  return modes.map(([name, mode], place) => {
    const [real, imaginary] = turned(slope(1 + 4 * place), slope(2 + 4 * place));
    return {
      case: name, frequency: mode.frequency, damping: mode.damping, element: mode.element,
      rest: numbers(data.subarray(0, each)), real: numbers(real), imaginary: numbers(imaginary),
    };
  });
}

/** The largest displacement of size 1 and phase 0. */
function turned(re: Float64Array, im: Float64Array): [Float64Array, Float64Array] {
  let [place, most] = [0, 0];
  for (let k = 0; k < re.length; k += 3) {
    const length = Math.hypot(...re.subarray(k, k + 3), ...im.subarray(k, k + 3));
    if (length > most) [place, most] = [k, length];
  }
  if (!most) return [re, im];
  const sizes = [0, 1, 2].map((i) => Math.hypot(re[place + i], im[place + i]));
  const lead = place + sizes.indexOf(Math.max(...sizes));
  const whole = Math.hypot(re[lead], im[lead]) * most;
  const [c, s] = [re[lead] / whole, -im[lead] / whole];
  return [re.map((value, k) => c * value - s * im[k]), re.map((value, k) => s * value + c * im[k])];
}

/** Size of an eigenvalue [1/s], its frequency where it rings [Hz], and its damping ratio. */
export function ringing(motions: Motions, k: number): { size: number; rings: number | null; damping: number } {
  const [re, im] = [motions.values.re[k], motions.values.im[k]];
  const size = Math.hypot(re, im);
  return { size, rings: im > RINGS * size ? im / (2 * Math.PI) : null, damping: size ? -re / size : 0 };
}

/**
 * A column of the motions, in all coordinates: `place(i)` reports what moves there for unit `i` of those that are free.
 */
export function motionOf(
  motions: Motions,
  k: number,
  n: number,
  free: number,
  share: (coordinate: number, i: number) => number,
): Pick<Found, "re" | "im"> {
  const part = (columns: Float64Array) =>
    Float64Array.from({ length: n }, (_, c) => {
      let sum = 0;
      for (let i = 0; i < free; i += 1) sum += share(c, i) * columns[i * motions.count + k];
      return sum;
    });
  return { re: part(motions.shapes.re), im: part(motions.shapes.im) };
}
