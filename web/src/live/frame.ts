// A frame in the world, and how a joint carries the next one, as tmodes/analysis/line/walk.py.

import { add, addCross, addTurned, copy, product, rotationAbout, type Reals } from "./space";

/**
 * Numbers of a frame: rotation, then at these places position, rate, angular acceleration, acceleration less gravity.
 */
export const FRAME = 21;
export const [PLACE, RATE, TURNING, GAIN] = [9, 12, 15, 18];

export type JointKind = "revolute" | "prismatic" | "fixed";

const scratch = new Float64Array(24);
const [ARM, SPEED, AXIS, TURN] = [0, 3, 6, 9];

/**
 * The root of the link that a joint on the frame at `from` carries. `numbers`: from `joint` on its placement (rotation,
 * position) and its axis; `motion`: angle or shift, its rate and its acceleration.
 */
export function jointed(
  into: Reals,
  at: number,
  before: Reals,
  from: number,
  kind: JointKind,
  numbers: Reals,
  joint: number,
  motion: readonly number[],
): void {
  const [angle, speed, gain] = motion;
  scratch.fill(0, 0, TURN);
  product(into, at, before, from, numbers, joint);
  addTurned(scratch, ARM, before, from, numbers, joint + 9);
  addTurned(scratch, AXIS, into, at, numbers, joint + 12);
  add(scratch, SPEED, scratch, AXIS, speed);
  copy(into, at + PLACE, before, from + PLACE, FRAME - PLACE);
  if (kind === "revolute") {
    rotationAbout(scratch, TURN, numbers, joint + 12, angle);
    copy(spare, 0, into, at, 9);
    product(into, at, spare, 0, scratch, TURN);
    add(into, at + TURNING, scratch, AXIS, gain);
    addCross(into, at + TURNING, before, from + RATE, scratch, SPEED);
    add(into, at + RATE, scratch, SPEED);
  } else if (kind === "prismatic") {
    add(scratch, ARM, scratch, AXIS, angle);
    addCross(into, at + GAIN, before, from + RATE, scratch, SPEED, 2);
    add(into, at + GAIN, scratch, AXIS, gain);
  }
  add(into, at + PLACE, scratch, ARM);
  addMoved(into, at + GAIN, before, from, scratch, ARM);
}

const spare = new Float64Array(9);
const spin = new Float64Array(3);

/** into += acceleration by turning of what is at `arm` from a frame's origin and stands in it. */
export function addMoved(into: Reals, at: number, frame: Reals, from: number, arm: Reals, i: number): void {
  addCross(into, at, frame, from + TURNING, arm, i);
  spin.fill(0);
  addCross(spin, 0, frame, from + RATE, arm, i);
  addCross(into, at, frame, from + RATE, spin, 0);
}
