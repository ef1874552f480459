// How a run starts: at rest under its loads, found by Newton's method, or as its sheet says.

import { doubles, type Bundle } from "./bundle";
import type { Engine } from "./engine";
import { solveInPlace } from "./linear";
import { numbersOf, type Blocks } from "./map";

export const STEPS = 40;
const SMALL = 1e-12;
export const LONGEST = 0.5;
export const STEP = 1e-6; // of the differences that make the tangent [rad]
// correction after a step, as a share of it: beyond it another branch may be caught, as analysis/equilibrium_path.py
export const STRAY = 0.5;
export const LITTLE = 1e-3; // a step that is too short to leave a branch [rad, m]
export const SHORTEST = 1 / 128; // step on the way from the unchanged numbers

/** Accelerations of the free coordinates and their derivatives by them, by differences: Newton needs no better. */
function slopes(
  engine: Engine, blocks: Blocks, state: Float64Array, free: number[], matrix: Float64Array, right: Float64Array,
): void {
  const [rows, size, n] = [free.length + 1, state.length, blocks.rotors.length];
  const states = new Float64Array(rows * size);
  for (let row = 0; row < rows; row += 1) {
    states.set(state, row * size);
    if (row) states[row * size + free[row - 1]] += STEP;
  }
  const inputs = { time: new Float64Array(1), state: states, row: blocks.rest_row, step: new Float64Array(1) };
  const { rate } = engine.sample("rest.rate", blocks.rest, inputs, rows);
  for (let i = 0; i < free.length; i += 1) {
    right[i] = rate[n + free[i]];
    for (let j = 0; j < free.length; j += 1)
      matrix[i * free.length + j] = (rate[(j + 1) * size + n + free[i]] - right[i]) / STEP;
  }
}

/**
 * Coordinates at which nothing accelerates under `blocks`, from those near; null where none are found, or where they
 * may be of another branch.
 */
function rest(
  engine: Engine, bundle: Bundle, blocks: Blocks, near: Float64Array, start: number,
): Float64Array | null {
  const held = (engine.layout as unknown as { held: number[] }).held;
  const n = near.length;
  const free = Array.from({ length: n }, (_, k) => k).filter((k) => !held.includes(k));
  const state = new Float64Array(bundle.restSize);
  state.set(near);
  for (const k of held) state[k] = blocks.start[start + k];
  const matrix = new Float64Array(free.length ** 2);
  const right = new Float64Array(free.length);
  let before = Infinity;
  let [first, corrected] = [0, 0];
  for (let step = 0; step < STEPS && free.length; step += 1) {
    slopes(engine, blocks, state, free, matrix, right);
    if (!solveInPlace(matrix, right)) return null;
    const size = stepped(state, free, right);
    if (!Number.isFinite(size)) return null;
    if (step === 0) first = size;
    else corrected += size;
    if (first > LITTLE && corrected > STRAY * first) return null;
    if (isSmall(size, before)) return state.slice(0, n);
    before = size;
  }
  return free.length ? null : state.slice(0, n);
}

/** Takes a step of Newton's method, not too long, off the free coordinates of a state; returns its size. */
export function stepped(state: Float64Array, free: readonly number[], step: Float64Array): number {
  const size = step.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const share = Math.min(1, LONGEST / size);
  for (let i = 0; i < free.length; i += 1) state[free[i]] -= share * step[i];
  return size;
}

/** Whether a step says that the root is found. */
export function isSmall(size: number, before: number): boolean {
  return size < SMALL || (size < 1e-9 && size >= before / 2);
}

/**
 * A rest for values of the sliders by what finds it `at` them: from the unchanged rest at once or, where that is too
 * far, step by step.
 */
export function restFor(
  bundle: Bundle, values: readonly number[], run: string, near: Float64Array,
  at: (set: readonly number[], from: Float64Array) => Float64Array | null,
): Float64Array {
  const first = bundle.sliders.map((slider) => slider.value);
  const between = (share: number) =>
    share === 1 ? values : values.map((value, j) => first[j] + (value - first[j]) * share);
  let [here, step, found] = [0, 1, near];
  while (here < 1) {
    const next = Math.min(1, here + step);
    const there = at(between(next), found);
    if (there) [here, step, found] = [next, 2 * step, there];
    else if (step > SHORTEST) step /= 2;
    else
      throw new Error(
        `${run}: no static equilibrium; expected links and gears that carry their loads: ` +
          "raise a stiffness or lower a load",
      );
  }
  return found;
}

/** The first state of a run. */
export function firstState(
  engine: Engine, bundle: Bundle, values: readonly number[], run: "reference" | "real", blocks: Blocks,
): Float64Array {
  const info = bundle.runs[run]!;
  const state = blocks.start.slice();
  const [q] = info.state.q;
  if (bundle.atRest) {
    const at = (set: readonly number[], from: Float64Array) =>
      rest(engine, bundle, numbersOf(bundle.map, set, run), from, q);
    const found = restFor(bundle, values, run, doubles(info.start).slice(...info.state.q), at);
    for (let k = 0; k < found.length; k += 1) if (!info.info.includes(k)) state[q + k] = found[k];
  }
  return state;
}
