// Series of a run by name, as a result has them, and what they are put together from.

import type { LiveRun } from "../contract_parts";

export type SeriesOf = LiveRun["series"];

/** Some columns of rows of a width [n, columns.length]. */
export function columns(rows: Float64Array, width: number, which: readonly number[]): Float64Array {
  const count = rows.length / width;
  const found = new Float64Array(count * which.length);
  for (let k = 0; k < count; k += 1) {
    for (let j = 0; j < which.length; j += 1) found[k * which.length + j] = rows[k * width + which[j]];
  }
  return found;
}

/** Whole numbers from `start` to before `end`. */
export function range(start: number, end: number): number[] {
  return Array.from({ length: end - start }, (_, k) => start + k);
}

/** Some rows of a width. */
export function rowsOf(values: Float64Array, width: number, which: ArrayLike<number>): Float64Array {
  const found = new Float64Array(which.length * width);
  for (let k = 0; k < which.length; k += 1) {
    for (let j = 0; j < width; j += 1) found[k * width + j] = values[which[k] * width + j];
  }
  return found;
}

/** a - b. */
export function difference(a: Float64Array, b: Float64Array): Float64Array {
  return a.map((value, k) => value - b[k]);
}

/** Sizes of vectors of a width [n]. */
export function sizes(vectors: Float64Array, width: number): Float64Array {
  const found = new Float64Array(vectors.length / width);
  for (let k = 0; k < found.length; k += 1) {
    let square = 0;
    for (let j = 0; j < width; j += 1) square += vectors[k * width + j] ** 2;
    found[k] = Math.sqrt(square);
  }
  return found;
}

/** Energy less its start, less what came in, plus what went out [n]: the first `broughtIn` works come in. */
export function energyBalance(
  energy: Float64Array,
  work: Float64Array,
  count: number,
  broughtIn: number,
): Float64Array {
  const kinds = energy.length / count;
  const works = work.length / count;
  const found = new Float64Array(count);
  let start = 0;
  for (let k = 0; k < count; k += 1) {
    let total = 0;
    for (let j = 0; j < kinds; j += 1) total += energy[k * kinds + j];
    if (k === 0) start = total;
    found[k] = total - start;
    for (let j = 0; j < works; j += 1) found[k] += (j < broughtIn ? -1 : 1) * work[k * works + j];
  }
  return found;
}

/** Share of the largest size from which on another one is as large, as tmodes/analysis/worst.py. */
export const AS_LARGE = 1 - 1e-9;

/** The first place whose size is that of the largest value to nine digits: rounding does not decide. */
export function worst(values: Float64Array): number {
  const most = values.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
  return Math.max(values.findIndex((value) => Math.abs(value) >= most * AS_LARGE), 0);
}

/** A series of given trailing dimensions. */
export function shaped(
  data: Float64Array,
  count: number,
  ...trailing: number[]
): { data: Float64Array; shape: number[] } {
  return { data, shape: [count, ...trailing] };
}
