// Elastic deformations in two parts, as tmodes/analysis/quasistatic.py: T_st, which the present forces would hold
// statically with the motors where they are and no deflection moving, and T_to, the oscillation about it.

import { inertiaForces } from "./linear_model";
import { affine } from "./live_scene";
import { wrenchesOf } from "./wrench";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { inverted, product } from "./linear";
import type { Blocks } from "./map";
import { difference, rowsOf, shaped, type SeriesOf } from "./series";
import type { Schedule } from "./signals";

const STEP = 1e-6; // of the differences that make the tangent: Newton's method needs it only about right
const SMALL = 1e-11;
const LONGEST = 0.5;
const STEPS = 40;
const STALE = 0.1; // ratio of two changes above which another tangent is needed
const TOGETHER = 24; // samples that share a tangent

/** What is to be held at each of n samples. */
interface Held {
  engine: Engine;
  blocks: Blocks;
  free: number[];
  size: number; // coordinates
  places: number; // numbers of the wrenches of a sample
  weight: Float64Array;
  q: Float64Array;
  rates: Float64Array;
  gains: Float64Array;
  wrenches: Float64Array;
}

/**
 * Both parts of a run's series; none where its arm has nothing elastic. `pause`: called between samples, to let others
 * work.
 */
export async function splitOf(
  engine: Engine,
  bundle: Bundle,
  blocks: Blocks,
  schedule: Schedule,
  times: Float64Array,
  series: SeriesOf,
  pause: () => Promise<void>,
): Promise<SeriesOf> {
  const free = bundle.yields;
  if (!free.length) return {};
  const count = times.length;
  const size = series.q.shape[1];
  const moved = (name: string) => affine(blocks.gross, series[name].data, count);
  const wrenches = wrenchesOf(bundle, blocks, schedule, times, series);
  const held: Held = {
    engine,
    blocks,
    free,
    size,
    places: wrenches.length / count,
    weight: blocks.weight,
    q: series.q.data.slice(),
    rates: moved("v"),
    gains: moved("a"),
    wrenches,
  };
  const present = series.deformation.data;
  let compliance: Float64Array | null = null;
  for (let start = 0; start < count; start += TOGETHER) {
    const rows = Array.from({ length: Math.min(TOGETHER, count - start) }, (_, k) => start + k);
    if (start)
      guess(held, present, affine(blocks.deflections, held.q.subarray((start - 1) * size, start * size), 1), rows);
    compliance = settled(held, series.q.data, rows, compliance);
    if (!compliance) return {};
    await pause();
  }
  const stationary = affine(blocks.deflections, held.q, count);
  return {
    deformation_stationary: shaped(stationary, count, free.length),
    deformation_oscillatory: shaped(difference(present, stationary), count, free.length),
  };
}

/** Samples begin with the deflections that the sample before them has. */
function guess(held: Held, present: Float64Array, before: Float64Array, rows: number[]): void {
  const m = held.free.length;
  for (const row of rows)
    held.free.forEach((k, i) => {
      held.q[row * held.size + k] += before[i] - present[row * m + i];
    });
}

/** Forces along the free coordinates that nothing holds [rows, free], at coordinates q [rows, size]. */
function unbalanced(held: Held, q: Float64Array, rows: number[]): Float64Array {
  const { engine, blocks, free, size } = held;
  const inputs = {
    q, v: rowsOf(held.rates, size, rows), a: rowsOf(held.gains, size, rows), base: held.weight,
    wrenches: rowsOf(held.wrenches, held.places, rows),
  };
  const inertia = inertiaForces(engine, blocks, inputs, rows.length);
  const elastic = engine.sample("elastic", blocks.chain, inputs, rows.length).forces;
  return Float64Array.from({ length: rows.length * free.length }, (_, k) => {
    const place = Math.floor(k / free.length) * size + free[k % free.length];
    return inertia[place] + elastic[place];
  });
}

/** How the free coordinates give way at a sample, at coordinates q [size]; null where they do without any force. */
function complianceAt(held: Held, q: Float64Array, row: number): Float64Array | null {
  const { free, size } = held;
  const m = free.length;
  const many = new Float64Array((m + 1) * size);
  for (let k = 0; k <= m; k += 1) many.set(q, k * size);
  free.forEach((coordinate, k) => { many[k * size + coordinate] += STEP; });
  const forces = unbalanced(held, many, new Array<number>(m + 1).fill(row));
  return inverted(
    Float64Array.from(
      { length: m * m },
      (_, k) => (forces[(k % m) * m + Math.floor(k / m)] - forces[m * m + Math.floor(k / m)]) / STEP,
    ),
    m,
  );
}

/** Finds the held shapes of some samples; returns a compliance that serves for those after them, null without one. */
function settled(held: Held, start: Float64Array, rows: number[], known: Float64Array | null): Float64Array | null {
  const at = (row: number) => held.q.subarray(row * held.size, (row + 1) * held.size);
  const fresh = (some: number[]) => complianceAt(held, at(some[some.length >> 1]), some[some.length >> 1]);
  let compliance = known ?? fresh(rows);
  if (!compliance) return null;
  let open = newton(held, rows, compliance, STEPS);
  if (open.length) compliance = fresh(open) ?? compliance;
  open = newton(held, open, compliance, STEPS);
  for (const row of open) {
    let [tries, left] = [STEPS, [row]];
    for (; left.length && tries; tries -= 1) {
      const own = complianceAt(held, at(row), row);
      left = own ? newton(held, left, own, 3) : left;
    }
    if (left.length) linear(held, start, row);
  }
  return compliance;
}

/** Steps of Newton's method by one compliance; returns the samples for which that converges too slowly. */
function newton(held: Held, rows: number[], compliance: Float64Array, steps: number): number[] {
  const { free, size, q } = held;
  const m = free.length;
  const slow: number[] = [];
  const before = new Map<number, number>();
  let open = rows;
  for (let step = 0; step < steps && open.length; step += 1) {
    const forces = unbalanced(held, rowsOf(q, size, open), open);
    open = open.filter((row, k) => {
      const change = product(compliance, forces.subarray(k * m, (k + 1) * m), m, m, 1);
      const most = change.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);
      const share = most > LONGEST ? LONGEST / most : 1;
      if (!Number.isFinite(most)) return slow.push(row) && false;
      free.forEach((coordinate, i) => { q[row * size + coordinate] -= share * change[i]; });
      if (most < SMALL) return false;
      const stale = most > STALE * (before.get(row) ?? Infinity);
      before.set(row, most);
      return stale ? slow.push(row) && false : true;
    });
  }
  return [...slow, ...open];
}

/** Where the loads cannot be held: what the arm would do that is linear about its present shape. */
function linear(held: Held, start: Float64Array, row: number): void {
  const present = start.slice(row * held.size, (row + 1) * held.size);
  const compliance = complianceAt(held, present, row);
  held.q.set(present, row * held.size);
  if (!compliance) return;
  const m = held.free.length;
  const change = product(compliance, unbalanced(held, present, [row]), m, m, 1);
  held.free.forEach((coordinate, i) => { held.q[row * held.size + coordinate] -= change[i]; });
}
