// The loads along a robot's links over a run: what is largest of all samples, and all of it at the frames that are
// shown.

import { FRAME, GAIN, PLACE } from "./frame";
import { Balance, type Carried, type NodeInfo, type PointInfo } from "./balance";
import { fibreOf, stressed, type Fibre, type Stress } from "./stress";
import { WRENCH, wrenchAt, type LoadInfo } from "./wrench";
import { doubles, type Bundle } from "./bundle";
import type { Numbers } from "../pack";
import type { SeriesOf } from "./series";
import type { Schedule } from "./signals";
import type { Reals } from "./space";

/** As tmodes/live/loads.py reports it; numbers say where in the block `carried` a table begins. */
export interface LoadsInfo {
  places: Numbers;
  /** How many the result keeps: `places` are some of them where these are very many. */
  kept: number;
  /** Which of the places are the stations of the picture. */
  shown: Numbers;
  nodes: NodeInfo[];
  points: (PointInfo & { point: number })[];
  loads: (LoadInfo & { place: number; wrench: number })[];
  /** Which of the points is on a surface; -1: none. */
  touched: number;
  strengths: Record<string, number>;
  limits: LimitInfo[];
}

/** A joint's limits; null: there is none. `range`: its middle and half its width. */
export interface LimitInfo {
  joint: string;
  coordinate: number;
  drive: number;
  unit: string;
  effortUnit: string;
  speed: number | null;
  effort: number | null;
  range: [number, number] | null;
}

/** The largest size of a quantity of a link: at which place (0 root, 1 tip), at which sample. */
export interface Largest {
  link: string;
  value: number;
  s: number;
  sample: number;
}

export type Quantity = "deflection" | "moment" | "stress";

/**
 * One link that bends: its load at the shown places of all frames, one after the other; what was largest in the run.
 */
export interface LinkLoads extends Carried {
  name: string;
  length: number;
  stress: Stress | null;
  largest: Record<Quantity, Largest | null>;
}

export interface Loads {
  links: LinkLoads[];
  /** How many samples were looked at: of all, or of every so manieth. */
  every: number;
}

const MOST_PLACES = 400_000; // places at samples that are looked at: more take too long while a slider moves

interface Link {
  carried: Carried;
  fibre: Fibre | null;
  stress: Stress | null;
  info: LinkLoads;
}

/** All loads of a run; `numbers`: the block `carried`. */
export function loadsOf(
  bundle: Bundle,
  numbers: Reals,
  series: SeriesOf,
  times: Reals,
  schedule: Schedule,
  frames: number[],
): Loads {
  const { carried: info } = bundle;
  const places = doubles(info.places);
  const balance = new Balance(info.nodes, info.points, numbers, standing(bundle), places.length);
  const links = info.nodes.flatMap((node, k) =>
    node.beam
      ? [linkOf(node, balance.carried[k]!, numbers, places.length, frames.length * info.shown.data.length)]
      : [],
  );
  const every = Math.max(1, Math.ceil((times.length * links.length * places.length) / MOST_PLACES));
  const wrenches = new Float64Array(WRENCH * info.points.length);
  const width = series.q.shape[1];
  let frame = 0;
  for (let k = 0; links.length > 0 && k < times.length; k += 1) {
    const shown = frames[frame] === k;
    if (!shown && k % every) continue;
    push(bundle, numbers, series, schedule, times[k], k, wrenches);
    balance.find({ q: series.q.data, v: series.v.data, a: series.a.data, start: k * width }, wrenches);
    for (const link of links) {
      if (link.fibre && link.stress) stressed(link.fibre, link.carried, link.stress);
      watch(link, places, k);
      if (shown) keep(link, frame, info.shown.data);
    }
    if (shown) frame += 1;
  }
  return { links: links.map((link) => link.info), every };
}

/** The frame on which the first joints stand: at rest, and held against gravity. */
function standing({ base, gravity }: Bundle): Reals {
  const frame = new Float64Array(FRAME);
  frame.set(Array.from(base.data).slice(9, 18));
  frame.set(Array.from(base.data).slice(18, 21), PLACE);
  for (let i = 0; i < 3; i += 1) frame[GAIN + i] = -gravity.data[i];
  return frame;
}

function linkOf(node: NodeInfo, carried: Carried, numbers: Reals, places: number, kept: number): Link {
  const beam = node.beam!;
  const fibre = beam.stress < 0 ? null : fibreOf(numbers, beam.stress, places);
  const stress = (count: number) =>
    fibre ? { strain: new Float64Array(count), mises: new Float64Array(count) } : null;
  const [two, three] = [2 * kept, 3 * kept];
  const own = {
    deflection: new Float64Array(two), slope: new Float64Array(two), moment: new Float64Array(three),
    shear: new Float64Array(two), axial: new Float64Array(kept),
  };
  const info = {
    ...own,
    name: node.name,
    length: numbers[beam.length],
    stress: stress(kept),
    largest: { deflection: null, moment: null, stress: null },
  };
  return { carried, fibre, stress: stress(places), info };
}

/** Force and moment on each pushed point at a sample, world axes. */
function push(
  { carried: info }: Bundle,
  numbers: Reals,
  series: SeriesOf,
  schedule: Schedule,
  time: number,
  k: number,
  into: Reals,
): void {
  into.fill(0);
  for (const load of info.loads) {
    const own = numbers.subarray(load.wrench, load.wrench + WRENCH);
    const point = k * series.rotation.shape[1] + info.points[load.place].point;
    const wrench = wrenchAt(load, own, schedule, time, series.rotation.data, 9 * point);
    for (let i = 0; i < WRENCH; i += 1) into[WRENCH * load.place + i] += wrench[i];
  }
  if (info.touched >= 0)
    for (let i = 0; i < 3; i += 1) into[WRENCH * info.touched + i] -= series.contact_force.data[3 * k + i];
}

function watch({ carried, stress, info }: Link, places: Reals, sample: number): void {
  const last = places.length - 1;
  see(
    info,
    "deflection",
    Math.sqrt(carried.deflection[2 * last] ** 2 + carried.deflection[2 * last + 1] ** 2),
    places[last],
    sample,
  );
  for (let p = 0; p <= last; p += 1) {
    see(info, "moment", Math.sqrt(carried.moment[3 * p + 1] ** 2 + carried.moment[3 * p + 2] ** 2), places[p], sample);
    if (stress) see(info, "stress", stress.mises[p], places[p], sample);
  }
}

function see({ name, largest }: LinkLoads, quantity: Quantity, value: number, s: number, sample: number): void {
  const before = largest[quantity];
  if (!before || value > before.value) largest[quantity] = { link: name, value, s, sample };
}

function keep({ carried, stress, info }: Link, frame: number, shown: ArrayLike<number>): void {
  const count = shown.length;
  const put = (from: Reals, into: Reals, width: number) => {
    for (let s = 0; s < count; s += 1) {
      for (let i = 0; i < width; i += 1) into[(frame * count + s) * width + i] = from[shown[s] * width + i];
    }
  };
  put(carried.deflection, info.deflection, 2);
  put(carried.slope, info.slope, 2);
  put(carried.moment, info.moment, 3);
  put(carried.shear, info.shear, 2);
  put(carried.axial, info.axial, 1);
  if (!stress || !info.stress) return;
  put(stress.strain, info.stress.strain, 1);
  put(stress.mises, info.stress.mises, 1);
}
