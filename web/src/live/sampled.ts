// Motions of what is sampled: K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapter 2.

import type { Complex, Motions } from "./eigen";
import { product } from "./linear";

const GONE = 1e-8; // a factor over a period below this is of a state that each sample overwrites, no motion
const TERMS = 18; // of an exponential of a matrix below 1/2

/** Samples within their common period [s]: how long each time is up to the next, and which states are set there. */
export interface Sampled {
  period: number;
  steps: { length: number; due: number[] }[];
}

/**
 * Of x' = `first` x between samples, which set what follows n coordinates and their rates by `held`: the factors from
 * after the samples at the begin of the period to after those at its end.
 */
export function overPeriod(
  first: Float64Array, held: Float64Array, { steps }: Sampled, coordinates: number,
): Float64Array {
  const n = Math.sqrt(first.length);
  let whole: Float64Array = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  const known = new Map<number, Float64Array>();
  for (const { length, due } of steps) {
    if (!known.has(length)) known.set(length, exponential(first.map((value) => value * length), n));
    whole = product(known.get(length)!, whole, n, n, n);
    const before = whole.slice();
    for (const row of due)
      whole.set(product(held.subarray(row * n, (row + 1) * n), before, 1, n, n), (2 * coordinates + row) * n);
  }
  return whole;
}

/** exp(a) by scaling and squaring. */
function exponential(a: Float64Array, n: number): Float64Array {
  const norm = Math.sqrt(a.reduce((sum, value) => sum + value * value, 0));
  const halvings = Math.max(0, Math.ceil(Math.log2(norm || 1)) + 1);
  const small = a.map((value) => value / 2 ** halvings);
  let term: Float64Array = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  let sum: Float64Array = term;
  for (let k = 1; k <= TERMS; k += 1) {
    term = product(term, small, n, n, n).map((value) => value / k);
    sum = sum.map((value, at) => value + term[at]);
  }
  for (let k = 0; k < halvings; k += 1) sum = product(sum, sum, n, n, n);
  return sum;
}

/** Motions [1/s] whose factors over a period [s] are the values, less states that each sample overwrites. */
export function betweenSamples(
  { count, values, shapes }: Motions, rates: Complex, period: number, n: number,
): Motions {
  const kept = Array.from({ length: count }, (_, k) => k).filter((k) => Math.hypot(values.re[k], values.im[k]) > GONE);
  const found = kept.map((k): [number, number] => {
    const [growth, angle] = [Math.log(Math.hypot(values.re[k], values.im[k])), Math.atan2(values.im[k], values.re[k])];
    let [guess, size] = [0, 1e-300]; // of the angle: a logarithm knows it but for whole turns
    for (let i = 0; i < n; i += 1) {
      const at = i * count + k;
      guess += shapes.re[at] * rates.im[at] - shapes.im[at] * rates.re[at];
      size += shapes.re[at] ** 2 + shapes.im[at] ** 2;
    }
    const turned = (guess / size) * period;
    const turns = Math.abs(turned) < Math.PI ? 0 : Math.round((turned - angle) / (2 * Math.PI));
    return [growth / period, (angle + 2 * Math.PI * turns) / period];
  });
  const [re, im] = [0, 1].map((part) => Float64Array.from(found, (value) => value[part]));
  const columns = (matrix: Float64Array) => matrix.filter((_, k) => kept.includes(k % count));
  return { count: kept.length, values: { re, im }, shapes: { re: columns(shapes.re), im: columns(shapes.im) } };
}
