// The vibration of a motion that comes to rest, about its slowly moving mean: as tmodes/analysis/vibration.py finds it,
// with its constants.

import { powersOf } from "../charts/spectrum";
import { columns, sizes as sizesOf } from "./series";
import {
  envelopeOf, fitted, largestOf, modesOf, polesOf, sumOf, windowsOf, type Complex, type Complexes, type Oscillation,
  type Signals, type VibrationRules,
} from "./exponentials";

/** A vibration, as `Residual` there. */
export interface Residual {
  amplitude: number | null;
  modes: Oscillation[];
  reason: string;
  largest: number;
  along: number[];
  unexplained: number;
  slow: Complex[];
  span: number;
}

export const ENDS = "the run ends with the move";
const NO_SUM = "the motion after the move is not a sum of decaying vibrations";

/** Nothing known, or nothing there, with the reason. */
export function none(amplitude: number | null, reason: string, span = 0): Residual {
  return { amplitude, modes: [], reason, largest: 0, along: [], unexplained: 0, slow: [], span };
}

/** The largest size along each axis. */
function alongAxes(rows: Float64Array): number[] {
  return [0, 1, 2].map((c) => largestOf(columns(rows, 3, [c]).map(Math.abs)));
}


function lessMean(values: Float64Array, of = values): Float64Array {
  const mean = [0, 0, 0];
  of.forEach((value, k) => { mean[k % 3] += (3 * value) / of.length; });
  return values.map((value, k) => value - mean[k % 3]);
}

/** Of evenly spaced samples [n, 3] of a motion that nothing drives, from `since` [s] on; `pause`: between pieces. */
export async function residualVibration(
  rules: VibrationRules, times: Float64Array, values: Float64Array, since: number, pause: () => Promise<void>,
): Promise<Residual> {
  const n = times.length;
  if (n < rules.FEWEST) return none(null, ENDS);
  const ranges = [0, 1, 2].map((c) => {
    const column = columns(values, 3, [c]);
    return column.reduce((a, b) => Math.max(a, b)) - column.reduce((a, b) => Math.min(a, b));
  });
  if (Math.max(...ranges) <= rules.STANDS * largestOf(values.map(Math.abs))) return none(0, rules.AT_REST);
  const after = times.map((time) => time - since);
  for (const part of rules.WINDOWS) {
    const count = Math.floor(n / part);
    if (count < rules.FEWEST) continue;
    const found = await ofWindow(rules, after.subarray(0, count), values.subarray(0, 3 * count), pause);
    if (found) return found;
  }
  return byPeriod(rules, after, values);
}

/** The vibration in some samples; null where they are no sum of decaying exponentials. */
async function ofWindow(
  rules: VibrationRules, times: Float64Array, values: Float64Array, pause: () => Promise<void>,
): Promise<Residual | null> {
  const stride = strideOf(rules, values);
  const count = Math.min(Math.ceil(times.length / stride), rules.MOST_SAMPLES);
  const t = Float64Array.from({ length: count }, (_, k) => times[k * stride]);
  const kept = Float64Array.from({ length: 3 * count }, (_, k) => values[3 * stride * Math.floor(k / 3) + (k % 3)]);
  const y = lessMean(kept);
  await pause();
  const windows = windowsOf(y);
  const inside = times.filter((time) => time <= t[count - 1]);
  const whole = lessMean(values.subarray(0, 3 * inside.length), kept);
  const fits = rules.RANKS.flatMap((rank) => {
    const terms = windows.sizes.filter((size) => size > rank * windows.sizes[0]).length;
    return 0 < terms && terms <= Math.min(rules.MOST_TERMS, windows.width - 1) ? [terms] : [];
  }).map((terms) => once(() => fitOf(rules, t, y, polesOf(windows, terms, t[1] - t[0]))));
  for (const wrong of rules.WRONG)
    for (const fit of fits) {
      await pause();
      const found = checked(rules, t, y, fit(), wrong, inside, whole);
      if (found) return found;
    }
  return null;
}

function once<T>(make: () => T): () => T {
  let made: T | undefined;
  return () => (made ??= make());
}

function strideOf(rules: VibrationRules, values: Float64Array): number {
  const count = values.length / 3;
  if (count <= rules.MOST_SAMPLES) return 1;
  const [x, y, z] = powersOf(values);
  const sizes = x.map((value, k) => Math.sqrt(Math.max(value, y[k], z[k])));
  const least = rules.STRONG * largestOf(sizes);
  const highest = sizes.reduce((last, size, k) => (size > least ? k : last), -1);
  const enough = Math.floor(count / (4 * (highest < 0 ? 1 : highest)));
  return Math.max(1, Math.min(Math.ceil(count / rules.MOST_SAMPLES), enough));
}

interface Fit {
  poles: Complex[];
  parts: Complexes[];
  /** Which ring at all, and which are fast enough for a whole period to be seen. */
  rings: boolean[];
  fast: boolean[];
  sum: Float64Array;
}

function fitOf(rules: VibrationRules, t: Float64Array, y: Float64Array, found: Complex[]): Fit {
  const length = t[t.length - 1] - t[0];
  const poles = found.map(([re, im]): Complex => [Math.min(re, 1 / length), im]);
  const rings = poles.map(([re, im]) => im !== 0 && -re < rules.RINGS * Math.hypot(re, im));
  const fast = poles.map(([, im], k) => rings[k] && Math.abs(im) * length >= 2 * Math.PI);
  const parts = fitted(t, y, poles);
  return { poles, parts, rings, fast, sum: sumOf(t, poles, parts)[0] };
}

/** The vibration by these rates; null where their sum is not the motion. `values`: the same at all `times`. */
function checked(
  rules: VibrationRules, t: Float64Array, y: Float64Array, { poles, parts, rings, fast, sum }: Fit, limit: number,
  times: Float64Array, values: Float64Array,
): Residual | null {
  const [length, size] = [t[t.length - 1] - t[0], largestOf(y.map(Math.abs))];
  const wrong = Math.sqrt(sum.reduce((total, value, k) => total + (value - y[k]) ** 2, 0) / t.length);
  const some = <T>(all: readonly T[], which: (k: number) => boolean) => all.filter((_, k) => which(k));
  const slow = (k: number) => !fast[k];
  const mean = sumOf(t, some(poles, slow), some(parts, slow))[0];
  const apart = y.map((value, k) => value - mean[k]);
  const quick = (k: number) => fast[k];
  const vibration = largestOf(sizesOf(sumOf(t, some(poles, quick), some(parts, quick))[0], 3));
  const width = diameter(y);
  if (wrong > Math.max(limit * vibration, rules.NOTHING * size) || vibration > width) return null;
  const one = (k: number) => fast[k] && poles[k][1] > 0;
  const doubled = some(parts, one).map(([re, im]): Complexes => [re.map((x) => 2 * x), im.map((x) => 2 * x)]);
  const signals: Signals = { times: Float64Array.of(0, ...t), poles: some(poles, one), parts: doubled };
  const amplitude = largestOf(envelopeOf(signals, signals.poles.map((_, k) => k)));
  const sizes = parts.map(([re, im], k) => (poles[k][1] > 0 ? 2 * Math.hypot(...re, ...im) : 0));
  const partial = sizes.reduce((most, own, k) => (rings[k] && !fast[k] ? Math.max(most, own) : most), 0);
  if (partial > Math.max(amplitude, wrong, rules.NOTHING * size))
    return none(null, "less than one period of a vibration is seen until it is at rest, or the run ends");
  const modes = modesOf(rules, signals, apart, length, Math.max(wrong, 1e-9 * size))
    .map((mode) => ({ ...mode, amplitude: Math.min(mode.amplitude, width) }));
  if (!modes.length) return none(0, calm(rules, poles.filter((_, k) => sizes[k] > rules.NOTHING * size)), length);
  const slowly = sumOf(times, some(poles, slow), some(parts, slow))[0];
  const seen = values.map((value, k) => value - slowly[k]);
  return {
    amplitude: Math.min(amplitude, width), modes, reason: "", largest: largestOf(sizesOf(seen, 3)),
    along: alongAxes(seen), unexplained: Math.max(1 - modes.reduce((total, mode) => total + mode.share, 0), 0),
    slow: some(poles, slow), span: length,
  };
}

function calm({ RINGS }: VibrationRules, turning: Complex[]): string {
  const ratio = turning.reduce((least, [re, im]) => Math.min(least, -re / Math.hypot(re, im)), Infinity);
  return RINGS <= ratio && ratio < 1
    ? `it is damped too strongly to ring: damping ratio ${Number(ratio.toPrecision(2))}, ${RINGS} or more`
    : "nothing oscillates about the slowly moving mean";
}

/** The largest distance of two samples. */
function diameter(y: Float64Array): number {
  let most = 0;
  for (let i = 0; i < y.length; i += 3)
    for (let j = 0; j < i; j += 3)
      most = Math.max(most, (y[i] - y[j]) ** 2 + (y[i + 1] - y[j + 1]) ** 2 + (y[i + 2] - y[j + 2]) ** 2);
  return Math.sqrt(most);
}

/** The distance from a mean over one period, of a motion that has one; without its modes. */
function byPeriod(rules: VibrationRules, times: Float64Array, values: Float64Array): Residual {
  const n = times.length;
  const [x, y, z] = powersOf(values);
  const power = x.map((value, k) => value + y[k] + z[k]);
  const peak = power.indexOf(largestOf(power));
  const sum = (some: Float64Array) => some.reduce((total, value) => total + value, 0);
  const about = sum(power.subarray(Math.floor(peak / 2), 2 * peak));
  if (peak < 2 || about < rules.PERIODIC * sum(power) || peak > Math.floor(n / 8)) return none(null, NO_SUM);
  const count = (n / peak) % 1 === 0.5 ? 2 * Math.round(n / peak / 2) : Math.round(n / peak); // as Python rounds
  const first = Math.floor((count - 1) / 2);
  const apart = new Float64Array(3 * (n - count + 1));
  for (let k = 0; k < apart.length; k += 1) {
    let mean = 0;
    for (let j = 0; j < count; j += 1) mean += values[k + 3 * j] / count;
    apart[k] = values[k + 3 * first] - mean;
  }
  const largest = largestOf(sizesOf(apart, 3));
  const reason = `${NO_SUM}: its distance from a mean over one period`;
  return { ...none(largest, reason), largest, along: alongAxes(apart), unexplained: 1 };
}
