// What every section of a robot carries at one sample: the balance of all that is outboard of it, d'Alembert's forces
// and given wrenches, as tmodes/analysis/line/loads.py. Loads are reported as the outboard part acts on the inboard
// one.

import { addBodies } from "./bodies";
import { FRAME, jointed, PLACE, RATE, TURNING, type JointKind } from "./frame";
import { Strain, type BeamInfo, type Motion } from "./strain";
import { add, addCross, addTurned, along, copy, type Reals } from "./space";

export interface NodeInfo {
  name: string;
  parent: number;
  kind: JointKind;
  angle: number;
  joint: number;
  tip: number;
  beam: BeamInfo | null;
}

/** A point that is pushed: of which node, at which of its stations (-1: its tip), where from there. */
export interface PointInfo {
  node: number;
  station: number;
  offset: number;
}

/** A link that bends, at one sample and S places: in section axes, but for the shape, which is in axes of the root. */
export interface Carried {
  deflection: Reals; // [S, 2]
  slope: Reals; // [S, 2]
  moment: Reals; // [S, 3]
  shear: Reals; // [S, 2]
  axial: Reals; // [S]
}

/** Force and moment, one after the other, by place in the arrays here. */
const LOAD = 6;
const SECTION = PLACE + 3;

export class Balance {
  /** By node; null for those that do not bend. */
  readonly carried: (Carried | null)[];
  private readonly frames: Reals; // of roots, then of tips
  private readonly hung: Reals;
  private readonly beams: (Strain | null)[];
  private readonly section = new Float64Array(SECTION);
  private readonly load = new Float64Array(LOAD);
  private readonly pairs: Reals;
  private readonly spins: Reals;

  /** `base`: the frame on which the first joints stand; `places`: how many are reported along each link. */
  constructor(
    private readonly nodes: NodeInfo[],
    private readonly points: PointInfo[],
    private readonly numbers: Reals,
    private readonly base: Reals,
    private readonly places: number,
  ) {
    this.frames = new Float64Array(2 * nodes.length * FRAME);
    this.hung = new Float64Array(nodes.length * LOAD);
    this.beams = nodes.map(({ beam }) => beam && new Strain(beam, numbers));
    this.carried = nodes.map(({ beam }) => beam && carriedAt(places));
    const most = Math.max(0, ...nodes.map(({ beam }) => beam?.points ?? 0));
    this.pairs = new Float64Array((3 * most * (most + 1)) / 2);
    this.spins = new Float64Array(9 * most);
  }

  /** Loads of all links; `wrenches` [points, 6]: force and moment on each pushed point, world axes. */
  find(motion: Motion, wrenches: Reals): void {
    const { nodes, frames, base } = this;
    nodes.forEach(({ parent, kind, angle, joint }, k) => {
      const turned = angle < 0 ? STILL : [motion.q, motion.v, motion.a].map((part) => part[motion.start + angle]);
      const [before, from] = parent < 0 ? [base, 0] : [frames, this.tip(parent)];
      jointed(frames, this.root(k), before, from, kind, this.numbers, joint, turned);
      this.beams[k]?.march(motion, frames, this.root(k));
      const beam = this.beams[k];
      if (beam) copy(frames, this.tip(k), beam.frames, beam.info.edges * FRAME, FRAME);
      else copy(frames, this.tip(k), frames, this.root(k), FRAME);
    });
    this.hung.fill(0);
    for (let k = nodes.length - 1; k >= 0; k -= 1) this.balanced(k, motion, wrenches);
  }

  private root(node: number): number {
    return node * FRAME;
  }

  private tip(node: number): number {
    return (this.nodes.length + node) * FRAME;
  }

  /** All that a node carries, handed on to the one that holds it. */
  private balanced(k: number, motion: Motion, wrenches: Reals): void {
    const { frames, hung, load } = this;
    const beam = this.beams[k];
    const root = this.root(k);
    addBodies(hung, k * LOAD, this.numbers, this.nodes[k].tip, frames, this.tip(k));
    this.pushed(hung, k * LOAD, k, -1, frames, this.tip(k), wrenches);
    if (beam)
      this.along(k, beam, this.carried[k]!, motion, wrenches); // leaves the load of its root in `load`
    else copy(load, 0, hung, k * LOAD, LOAD);
    const parent = this.nodes[k].parent;
    if (parent >= 0) addLoad(hung, parent * LOAD, load, 0, frames, root + PLACE, frames, this.tip(parent) + PLACE);
  }

  private pushed(
    into: Reals,
    at: number,
    node: number,
    station: number,
    frames: Reals,
    frame: number,
    wrenches: Reals,
  ): void {
    this.points.forEach((point, p) => {
      if (point.node !== node || point.station !== station) return;
      vectors.fill(0, 0, 3);
      addTurned(vectors, 0, frames, frame, this.numbers, point.offset);
      for (let i = 0; i < LOAD; i += 1) into[at + i] += wrenches[p * LOAD + i];
      addCross(into, at + 3, vectors, 0, wrenches, p * LOAD);
    });
  }

  /** Of a bending link; from the places at its tip to the root. */
  private along(k: number, beam: Strain, carried: Carried, motion: Motion, wrenches: Reals): void {
    const { frames, hung, load, section } = this;
    const root = this.root(k);
    const stations = beam.info.stations.map((station, number) => {
      const own = new Float64Array(LOAD);
      addBodies(own, 0, this.numbers, station.body, beam.frames, station.edge * FRAME);
      this.pushed(own, 0, k, number, beam.frames, station.edge * FRAME, wrenches);
      return own;
    });
    this.spread(beam);
    for (let p = this.places - 1; p >= 0; p -= 1) {
      beam.place(motion, p, section);
      shaped(carried, p, frames, root, section);
      add(section, PLACE, frames, root + PLACE);
      load.fill(0);
      addLoad(load, 0, hung, k * LOAD, frames, this.tip(k) + PLACE, section, PLACE);
      beam.info.stations.forEach(({ edge, last }, number) => {
        if (p <= last) addLoad(load, 0, stations[number], 0, beam.frames, edge * FRAME + PLACE, section, PLACE);
      });
      this.outboard(beam, p, load, frames, root);
      for (let c = 0; c < 3; c += 1) carried.moment[3 * p + c] = along(section, 0, c, load, 3);
      for (let c = 0; c < 2; c += 1) carried.shear[2 * p + c] = along(section, 0, c + 1, load, 0);
      carried.axial[p] = along(section, 0, 0, load, 0);
    }
  }

  /** Levers of the points times their pushes, both ways of each pair; and what turns their sections. */
  private spread({ info, points, gains, frames }: Strain): void {
    const { pairs, spins } = this;
    pairs.fill(0);
    let pair = 0;
    for (let j = 0; j < info.points; j += 1) {
      for (let k = j; k < info.points; k += 1, pair += 3) {
        addCross(pairs, pair, points, 3 * j, gains, 3 * k, -1);
        if (k > j) addCross(pairs, pair, points, 3 * k, gains, 3 * j, -1);
      }
    }
    spins.fill(0, 0, 3 * info.rotary * info.points);
    for (let axis = 0; axis < info.rotary; axis += 1) {
      for (let k = 0; k < info.points; k += 1) {
        const frame = info.pointEdges[k] * FRAME;
        for (let i = 0; i < 3; i += 1) vectors[i] = frames[frame + 3 * i + axis];
        const at = 3 * (axis * info.points + k);
        addCross(spins, at, frames, frame + RATE, vectors, 0, along(frames, frame, axis, frames, frame + RATE));
        add(spins, at, vectors, 0, along(frames, frame, axis, frames, frame + TURNING));
      }
    }
  }

  /** Weight and inertia of the link's own mass outboard of a place, about it; its section is at hand. */
  private outboard({ info, gains }: Strain, p: number, into: Reals, frames: Reals, root: number): void {
    const { numbers, pairs, spins, section } = this;
    const g = info.points;
    vectors.fill(0, 0, 6);
    addWeighted(vectors, 0, gains, numbers, info.outboard + p * g, g, -1);
    add(vectors, 3, section, PLACE);
    add(vectors, 3, frames, root + PLACE, -1);
    add(into, 0, vectors, 0);
    addCross(into, 3, vectors, 3, vectors, 0, -1);
    const count = (g * (g + 1)) / 2;
    addWeighted(into, 3, pairs, numbers, info.levers + p * count, count, 1);
    addWeighted(into, 3, spins, numbers, info.turning + p * info.rotary * g, info.rotary * g, -1);
  }
}

const STILL = [0, 0, 0];
const vectors = new Float64Array(9);
const inner = new Float64Array(6);

function carriedAt(places: number): Carried {
  const [deflection, slope, moment, shear, axial] = [2, 2, 3, 2, 1].map((width) => new Float64Array(width * places));
  return { deflection, slope, moment, shear, axial };
}

/** into += factor times the sum of vectors [count, 3], each times its weight. */
function addWeighted(
  into: Reals,
  at: number,
  values: Reals,
  weights: Reals,
  first: number,
  count: number,
  factor: number,
): void {
  let x = 0;
  let y = 0;
  let z = 0;
  for (let k = 0; k < count; k += 1) {
    const weight = weights[first + k];
    x += weight * values[3 * k];
    y += weight * values[3 * k + 1];
    z += weight * values[3 * k + 2];
  }
  into[at] += factor * x;
  into[at + 1] += factor * y;
  into[at + 2] += factor * z;
}

/** into += a load about `from`, about `to`. */
function addLoad(into: Reals, at: number, load: Reals, i: number, from: Reals, j: number, to: Reals, k: number): void {
  for (let c = 0; c < LOAD; c += 1) into[at + c] += load[i + c];
  for (let c = 0; c < 3; c += 1) inner[c] = from[j + c] - to[k + c];
  addCross(into, at + 3, inner, 0, load, i);
}

/** How the line bends: away from the root's tangent, and its slope against it; `section` from the root. */
function shaped({ deflection, slope }: Carried, p: number, frames: Reals, root: number, section: Reals): void {
  for (let i = 0; i < 3; i += 1) inner[i] = section[3 * i];
  const ahead = along(frames, root, 0, inner, 0);
  for (let c = 0; c < 2; c += 1) {
    deflection[2 * p + c] = along(frames, root, c + 1, section, PLACE);
    slope[2 * p + c] = Math.atan2(along(frames, root, c + 1, inner, 0), ahead);
  }
}
