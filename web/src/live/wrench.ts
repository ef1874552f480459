// What a load does to its named point of a robot at a time: force and moment in world axes.

import type { Bundle } from "./bundle";
import type { Blocks } from "./map";
import type { SeriesOf } from "./series";
import { valueAt, type Schedule } from "./signals";

/** Force and moment on a point, one after the other. */
export const WRENCH = 6;

/** A load: whether it turns with its point, and the signal it is multiplied by (-1: it is constant). */
export interface LoadInfo {
  follower: boolean;
  signal: number;
}

/** The wrench of a load at a time [s]; `own` as its sheet says, at `at` of `rotations` [9] that of its point. */
export function wrenchAt(
  { follower, signal }: LoadInfo, own: Float64Array, schedule: Schedule, time: number, rotations: Float64Array,
  at: number,
): Float64Array {
  const factor = signal < 0 ? 1 : valueAt(schedule, signal, time);
  return (follower ? inWorld(rotations, at, own) : own).map((value) => factor * value);
}

function inWorld(r: Float64Array, at: number, wrench: Float64Array): Float64Array {
  return wrench.map((_, i) => {
    const [row, first] = [at + 3 * (i % 3), i < 3 ? 0 : 3];
    return r[row] * wrench[first] + r[row + 1] * wrench[first + 1] + r[row + 2] * wrench[first + 2];
  });
}

/** Force and moment on each point at each sample [n, points, 6]: of the loads, and of the surface. */
export function wrenchesOf(
  bundle: Bundle,
  blocks: Blocks,
  schedule: Schedule,
  times: Float64Array,
  series: SeriesOf,
): Float64Array {
  const points = series.position.shape[1];
  const found = new Float64Array(times.length * points * WRENCH);
  times.forEach((time, k) => {
    bundle.loads.forEach((load, which) => {
      const place = k * points + load.point;
      const own = blocks.loads.subarray(WRENCH * which, WRENCH * (which + 1));
      const wrench = wrenchAt(load, own, schedule, time, series.rotation.data, 9 * place);
      for (let i = 0; i < WRENCH; i += 1) found[WRENCH * place + i] += wrench[i];
    });
    if (bundle.contactPoint < 0) return;
    for (let i = 0; i < 3; i += 1)
      found[WRENCH * (k * points + bundle.contactPoint) + i] -= series.contact_force.data[3 * k + i];
  });
  return found;
}
