// Weight and inertia of the rigid bodies that are fixed to a frame of a robot, as a load on it.

import { addMoved, GAIN, RATE, TURNING } from "./frame";
import { add, addCross, addTurned, along, type Reals } from "./space";

const vectors = new Float64Array(9);
const inner = new Float64Array(3);

/**
 * into += weight and inertia of bodies about the origin of the frame they are fixed to: force and moment. Their mass,
 * first moment and inertia begin at `body` of the numbers; -1: there are none.
 */
export function addBodies(
  into: Reals, at: number, numbers: Reals, body: number, frames: Reals, frame: number,
): void {
  if (body < 0) return;
  vectors.fill(0);
  addTurned(vectors, 0, frames, frame, numbers, body + 1); // first moment
  add(vectors, 3, frames, frame + GAIN, numbers[body]);
  addMoved(vectors, 3, frames, frame, vectors, 0);
  add(into, at, vectors, 3, -1);
  addCross(into, at + 3, vectors, 0, frames, frame + GAIN, -1);
  inertial(into, at + 3, numbers, body + 4, frames, frame, TURNING);
  vectors.fill(0, 6);
  inertial(vectors, 6, numbers, body + 4, frames, frame, RATE);
  addCross(into, at + 3, frames, frame + RATE, vectors, 6); // both are negative of the inertia's moment
}

/** into -= R J R^T x, J of six numbers: xx, yy, zz, xy, xz, yz; x at `which` of the frame. */
function inertial(
  into: Reals,
  at: number,
  numbers: Reals,
  six: number,
  frames: Reals,
  frame: number,
  which: number,
): void {
  const x = along(frames, frame, 0, frames, frame + which);
  const y = along(frames, frame, 1, frames, frame + which);
  const z = along(frames, frame, 2, frames, frame + which);
  inner[0] = numbers[six] * x + numbers[six + 3] * y + numbers[six + 4] * z;
  inner[1] = numbers[six + 3] * x + numbers[six + 1] * y + numbers[six + 5] * z;
  inner[2] = numbers[six + 4] * x + numbers[six + 5] * y + numbers[six + 2] * z;
  addTurned(into, at, frames, frame, inner, 0, -1);
}
