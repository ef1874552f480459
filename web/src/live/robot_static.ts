// Static equations of the 2010 robot, solved by Newton's method as tmodes/model.py does: rest, and what loads would
// hold.

import type { RobotBundle } from "./bundle";
import type { Engine } from "./engine";
import { solveInPlace } from "./linear";

const STEPS = 30;
const ANGLES = 5;

/** Angles [n, 5] rad, and whether each sample's were found; where not, its first step is given. */
export interface Roots {
  angles: Float64Array;
  found: boolean[];
}

/**
 * The angles at which a static residual (`REGIME.rest`, `REGIME.quasistatic`) vanishes at `count` samples, from those
 * `near`.
 */
export function staticRoots(
  engine: Engine, bundle: RobotBundle, name: string, parameters: Float64Array, loads: Float64Array, near: Float64Array,
  count: number,
): Roots {
  const { free } = bundle;
  const held = [0, 1, 2, 3, 4].filter((angle) => !free.includes(angle));
  const angles = near.slice();
  for (let k = 0; k < count; k += 1) for (const angle of held) angles[k * ANGLES + angle] = 0;
  const first = angles.slice();
  const found = new Array<boolean>(count).fill(false);
  const before = new Float64Array(count).fill(Infinity);
  let open = Array.from({ length: count }, (_, k) => k);
  for (let step = 0; step < STEPS && open.length; step += 1) {
    const change = newtonStep(engine, name, parameters, loads, angles, open, free);
    for (let place = 0; place < open.length; place += 1) {
      const k = open[place];
      let [size, scale] = [0, 0];
      for (let j = 0; j < ANGLES; j += 1) {
        const by = change[place * ANGLES + j];
        const now = (angles[k * ANGLES + j] -= by);
        if (step === 0) first[k * ANGLES + j] = now;
        size = Math.max(size, Math.abs(by));
        scale = Math.max(scale, Math.abs(now));
      }
      const still = size <= 1e-14 + 1e-12 * scale || (size <= 1e-9 * scale && size >= before[k] / 2);
      found[k] = still && scale < Math.PI;
      before[k] = still ? -1 : size;
    }
    open = open.filter((k) => before[k] >= 0);
  }
  for (let k = 0; k < count; k += 1) {
    if (!found[k]) angles.set(first.subarray(k * ANGLES, (k + 1) * ANGLES), k * ANGLES);
  }
  return { angles, found };
}

function newtonStep(
  engine: Engine, name: string, parameters: Float64Array, loads: Float64Array, angles: Float64Array, open: number[],
  free: number[],
): Float64Array {
  const [, [load, width]] = Object.entries(engine.layout.samples[name].inputs);
  const inputs = { angles: chosen(angles, ANGLES, open), [load]: chosen(loads, width, open) };
  const { residual, slope } = engine.sample(name, parameters, inputs, open.length);
  const m = free.length;
  const [matrix, right] = [new Float64Array(m * m), new Float64Array(m)];
  const change = new Float64Array(open.length * ANGLES);
  for (let k = 0; k < open.length; k += 1) {
    for (let i = 0; i < m; i += 1) {
      right[i] = residual[k * ANGLES + free[i]];
      for (let j = 0; j < m; j += 1) matrix[i * m + j] = slope[k * ANGLES * ANGLES + free[j] * ANGLES + free[i]];
    }
    if (solveInPlace(matrix, right)) for (let i = 0; i < m; i += 1) change[k * ANGLES + free[i]] = right[i];
    else change.fill(1, k * ANGLES, (k + 1) * ANGLES); // lost: never taken for found
  }
  return change;
}

function chosen(values: Float64Array, width: number, rows: number[]): Float64Array {
  const part = new Float64Array(rows.length * width);
  for (let k = 0; k < rows.length; k += 1) {
    for (let j = 0; j < width; j += 1) part[k * width + j] = values[rows[k] * width + j];
  }
  return part;
}
