// Motion of a bending link's sections: the steps of the model from root to tip, as tmodes/analysis/line/strain.py.

import { addMoved, FRAME, GAIN, PLACE, RATE, TURNING } from "./frame";
import { add, addCross, addTurned, copy, type Reals } from "./space";

/** A bending link as tmodes/live/loads.py reports it; numbers of tables say where in the vector these begin. */
export interface BeamInfo {
  first: number;
  /** Component of curvature (0 twist, 1 about y, 2 about z) of each function that turns sections. */
  directions: number[];
  stretches: number;
  points: number;
  rotary: number;
  terms: number;
  /** Steps from root to tip; where after them the points and the stations are. */
  edges: number;
  pointEdges: number[];
  stations: { edge: number; last: number; body: number }[];
  march: number;
  reach: number;
  /** The section of the model before each place. */
  before: number[];
  toPoints: number;
  toPlaces: number;
  toEnds: number;
  stretch: number;
  outboard: number;
  levers: number;
  turning: number;
  length: number;
  stress: number;
}

/** Coordinates, rates and accelerations of all samples, and where in each those of the sample at hand begin. */
export interface Motion {
  q: Reals;
  v: Reals;
  a: Reals;
  start: number;
}

const ROWS = 3;

/** A bending link at one sample: `frames` of its root and of every section of the model. */
export class Strain {
  readonly frames: Reals;
  /** Where the points are, from the root, and how they accelerate [g, 3]. */
  readonly points: Reals;
  readonly gains: Reals;
  private readonly line: Reals;
  private readonly moved: Reals;
  private readonly sums = new Float64Array(18);
  private readonly turns: number;

  constructor(readonly info: BeamInfo, private readonly numbers: Reals) {
    this.frames = new Float64Array((info.edges + 1) * FRAME);
    [this.points, this.gains, this.line, this.moved] = Array.from(
      { length: 4 },
      () => new Float64Array(info.points * 3),
    );
    this.turns = info.directions.length;
  }

  /** From the frame of the root on; stations and tip are whole frames then, other sections have no place. */
  march(motion: Motion, root: Reals, at: number): void {
    const { info, frames } = this;
    copy(frames, 0, root, at, FRAME);
    for (let k = 0; k < info.edges; k += 1) {
      this.sum(motion, info.march + k * (2 * this.turns + ROWS), true);
      stepped(frames, (k + 1) * FRAME, frames, k * FRAME, this.sums, info.terms, true);
    }
    this.tangents(motion);
    this.weighted(this.points, info.toPoints, this.line);
    this.weighted(this.gains, info.toPoints, this.moved);
    for (let k = 0; k < info.points; k += 1) add(this.gains, 3 * k, frames, GAIN);
    for (let k = 0; k <= info.stations.length; k += 1) {
      const frame = FRAME * (k < info.stations.length ? info.stations[k].edge : info.edges);
      copy(frames, frame + PLACE, frames, PLACE);
      copy(frames, frame + GAIN, frames, GAIN);
      this.along(frames, frame + PLACE, info.toEnds + k * info.points, this.line);
      this.along(frames, frame + GAIN, info.toEnds + k * info.points, this.moved);
    }
  }

  /** Axes and place, from the root, of the place `k`: rotation, then position. */
  place(motion: Motion, k: number, into: Reals): void {
    const { info } = this;
    this.sum(motion, info.reach + k * (2 * this.turns + ROWS), false);
    stepped(into, 0, this.frames, info.before[k] * FRAME, this.sums, info.terms, false);
    into.fill(0, PLACE, PLACE + 3);
    this.along(into, PLACE, info.toPlaces + k * info.points, this.line);
  }

  /** What a step turns, where asked with its derivatives by time: integrals and moments, one after the other. */
  private sum(motion: Motion, row: number, moving: boolean): void {
    const { sums, numbers, turns } = this;
    const { q, v, a, start } = motion;
    const first = start + this.info.first;
    sums.fill(0);
    for (let j = 0; j < turns; j += 1) {
      const c = this.info.directions[j];
      const whole = numbers[row + j];
      const about = numbers[row + turns + j];
      sums[c] += whole * q[first + j];
      sums[3 + c] += about * q[first + j];
      if (!moving) continue;
      sums[6 + c] += whole * v[first + j];
      sums[9 + c] += about * v[first + j];
      sums[12 + c] += whole * a[first + j];
      sums[15 + c] += about * a[first + j];
    }
    for (let c = 0; c < 3; c += 1) sums[c] += numbers[row + 2 * turns + c];
  }

  /** Derivative of the place by x at the points, and its second derivative by time. */
  private tangents({ q, v, a, start }: Motion): void {
    const { info, frames, numbers, line, moved } = this;
    const first = start + info.first + this.turns;
    moved.fill(0);
    for (let k = 0; k < info.points; k += 1) {
      let longer = 1;
      let speed = 0;
      let gain = 0;
      for (let j = 0; j < info.stretches; j += 1) {
        const value = numbers[info.stretch + k * info.stretches + j];
        longer += value * q[first + j];
        speed += value * v[first + j];
        gain += value * a[first + j];
      }
      const frame = info.pointEdges[k] * FRAME;
      for (let i = 0; i < 3; i += 1) tangent[i] = frames[frame + 3 * i];
      for (let i = 0; i < 3; i += 1) line[3 * k + i] = longer * tangent[i];
      addMoved(moved, 3 * k, frames, frame, line, 3 * k);
      addCross(moved, 3 * k, frames, frame + RATE, tangent, 0, 2 * speed);
      add(moved, 3 * k, tangent, 0, gain);
    }
  }

  private weighted(into: Reals, weights: number, values: Reals): void {
    into.fill(0);
    for (let k = 0; k < this.info.points; k += 1) this.along(into, 3 * k, weights + k * this.info.points, values);
  }

  private along(into: Reals, at: number, weights: number, values: Reals): void {
    const { numbers } = this;
    let x = 0;
    let y = 0;
    let z = 0;
    for (let k = 0; k < this.info.points; k += 1) {
      const weight = numbers[weights + k];
      x += weight * values[3 * k];
      y += weight * values[3 * k + 1];
      z += weight * values[3 * k + 2];
    }
    into[at] += x;
    into[at + 1] += y;
    into[at + 2] += z;
  }
}

const tangent = new Float64Array(3);
const work = new Float64Array(54);
const [TURN, SPEED, BOOST, TWISTED, INNER, ONCE, TWICE, SPREAD, GAINED] = [0, 3, 6, 9, 12, 15, 24, 33, 42];
const coefficients = new Map<number, { values: Reals[]; slopes: Reals[] }>();

/**
 * The fourth-order Magnus step from the section at `from`; `sums`: integral a and moment b of what turns, with their
 * first and second derivatives. Without `moving` the rotation alone.
 */
function stepped(into: Reals, at: number, old: Reals, from: number, sums: Reals, terms: number, moving: boolean): void {
  work.fill(0);
  add(work, TURN, sums, 0);
  addCross(work, TURN, sums, 0, sums, 3);
  const z = work[TURN] ** 2 + work[TURN + 1] ** 2 + work[TURN + 2] ** 2;
  const { values, slopes } = series(terms);
  const f1 = horner(values[0], z);
  const f2 = horner(values[1], z);
  const f3 = horner(values[2], z);
  for (let row = 0; row < 9; row += 3) addCross(work, ONCE + row, old, from + row, work, TURN);
  for (let row = 0; row < 9; row += 3) addCross(work, TWICE + row, work, ONCE + row, work, TURN);
  for (let i = 0; i < 9; i += 1) into[at + i] = old[from + i] + f1 * work[ONCE + i] + f2 * work[TWICE + i];
  if (!moving) return;
  for (let i = 0; i < 9; i += 1) work[SPREAD + i] = old[from + i] + f2 * work[ONCE + i] + f3 * work[TWICE + i];
  add(work, SPEED, sums, 6);
  addCross(work, SPEED, sums, 6, sums, 3);
  addCross(work, SPEED, sums, 0, sums, 9);
  add(work, BOOST, sums, 12);
  addCross(work, BOOST, sums, 12, sums, 3);
  addCross(work, BOOST, sums, 0, sums, 15);
  addCross(work, BOOST, sums, 6, sums, 9, 2);
  addTurned(work, GAINED, work, SPREAD, work, SPEED);
  addCross(work, TWISTED, work, TURN, work, SPEED);
  const share = 2 * (work[TURN] * work[SPEED] + work[TURN + 1] * work[SPEED + 1] + work[TURN + 2] * work[SPEED + 2]);
  add(work, INNER, work, TWISTED, share * horner(slopes[0], z));
  addCross(work, INNER, work, TURN, work, TWISTED, share * horner(slopes[1], z));
  addCross(work, INNER, work, SPEED, work, TWISTED, f3);
  copy(into, at + TURNING, old, from + TURNING);
  addCross(into, at + TURNING, old, from + RATE, work, GAINED);
  addTurned(into, at + TURNING, old, from, work, INNER);
  addTurned(into, at + TURNING, work, SPREAD, work, BOOST);
  copy(into, at + RATE, old, from + RATE);
  add(into, at + RATE, work, GAINED);
}

/** Of sum (-z)^k/(2k + first)!, from the last term on: for first 1, 2, 3, and their derivatives by z for 2 and 3. */
function series(terms: number): { values: Reals[]; slopes: Reals[] } {
  const kept = coefficients.get(terms);
  if (kept) return kept;
  const factorial = (n: number) => Array.from({ length: n }, (_, k) => k + 1).reduce((a, b) => a * b, 1);
  const powers = Array.from({ length: terms }, (_, k) => terms - 1 - k);
  const made = {
    values: [1, 2, 3].map((first) => Float64Array.from(powers, (k) => (-1) ** k / factorial(2 * k + first))),
    slopes: [2, 3].map((first) =>
      Float64Array.from(powers.slice(0, -1), (k) => (k * (-1) ** k) / factorial(2 * k + first)),
    ),
  };
  coefficients.set(terms, made);
  return made;
}

function horner(from: Reals, z: number): number {
  let value = 0;
  for (let k = 0; k < from.length; k += 1) value = value * z + from[k];
  return value;
}
