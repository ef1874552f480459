// Rows of numbers as a module's functions read and write them, from arrays by name and back.

import { EngineError, expect } from "./engine_error";

/** Arrays of samples by name, each row-major [count, size]; one row alone stands for all samples. */
export type Samples = Record<string, Float64Array>;

/** How many numbers a row has. */
export function total(sizes: Record<string, number>): number {
  return Object.values(sizes).reduce((sum, size) => sum + size, 0);
}

/** How far rows of an input are apart: not at all where one row stands for all samples, or there is but one. */
function stride(label: string, size: number, given: Float64Array | undefined, count: number): number {
  if (given === undefined) throw new EngineError(`${label}: got nothing; expected ${size} numbers for each sample`);
  if (given.length === count * size) return size;
  expect(label, given.length, size);
  return 0;
}

/** Rows of all inputs one after the other; of several sides: the rows of a sample follow each other. */
export function packRows(into: Float64Array, sizes: Record<string, number>, sides: Samples[], count: number): void {
  const width = total(sizes);
  const row = sides.length * width;
  const varying: [Float64Array, number, number][] = [];
  let start = 0;
  for (const side of sides) {
    for (const [label, size] of Object.entries(sizes)) {
      if (stride(label, size, side[label], count)) varying.push([side[label], start, size]);
      else into.set(side[label], start);
      start += size;
    }
  }
  if (varying.length < Object.keys(sizes).length * sides.length) repeated(into, row, count);
  for (const [from, place, size] of varying) copied(from, size, 0, into, row, place, size, count);
}

/** What the first of `count` rows holds in all of them. */
function repeated(into: Float64Array, row: number, count: number): void {
  for (let filled = row; filled < count * row; filled *= 2)
    into.copyWithin(filled, 0, Math.min(filled, count * row - filled));
}

/** Parts of rows by name; `every`: how many rows each sample has, of which the first is taken. */
export function parted(
  sizes: Record<string, number>, out: Float64Array, count: number, every: number,
  wanted: readonly string[] = Object.keys(sizes),
): Samples {
  const width = every * total(sizes);
  const parts: Samples = {};
  let start = 0;
  for (const [label, size] of Object.entries(sizes)) {
    if (wanted.includes(label)) {
      parts[label] = new Float64Array(count * size);
      copied(out, width, start, parts[label], size, 0, size, count);
    }
    start += size;
  }
  return parts;
}

/** Copy `size` numbers of each of `count` rows; of both sides: how far rows are apart, and where in a row to begin. */
function copied(
  from: Float64Array, fromRow: number, fromStart: number,
  into: Float64Array, intoRow: number, intoStart: number, size: number, count: number,
): void {
  if (fromRow === size && intoRow === size) {
    into.set(from.subarray(fromStart, fromStart + count * size), intoStart);
    return;
  }
  for (let k = 0; k < count; k++) {
    const source = k * fromRow + fromStart;
    const target = k * intoRow + intoStart;
    for (let j = 0; j < size; j++) into[target + j] = from[source + j];
  }
}
