// What a load does to its named point of a robot at a time: force and moment in world axes.

import { valueAt, type Schedule } from "./signals";
import type { Reals } from "./space";

/** Force and moment on a point, one after the other. */
export const WRENCH = 6;

/** A load: whether it turns with its point, and the signal it is multiplied by (-1: it is constant). */
export interface LoadInfo {
  follower: boolean;
  signal: number;
}

/** The wrench of a load at a time [s]; `own` as its sheet says, at `at` of `rotations` [9] that of its point. */
export function wrenchAt(
  { follower, signal }: LoadInfo, own: Reals, schedule: Schedule, time: number, rotations: Reals, at: number,
): Reals {
  const factor = signal < 0 ? 1 : valueAt(schedule, signal, time);
  return (follower ? inWorld(rotations, at, own) : own).map((value) => factor * value);
}

function inWorld(r: Reals, at: number, wrench: Reals): Reals {
  return wrench.map((_, i) => {
    const [row, first] = [at + 3 * (i % 3), i < 3 ? 0 : 3];
    return r[row] * wrench[first] + r[row + 1] * wrench[first + 1] + r[row + 2] * wrench[first + 2];
  });
}
