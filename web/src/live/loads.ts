// The loads along an arm's links over a run: what is largest of all samples, and all of it at the frames that are
// shown. They are computed by the module's function `line`, as tmodes/equations/line/schedule.py states it.

import type { Bundle } from "./bundle";
import type { Engine, Samples } from "./engine";
import type { Blocks } from "./map";
import type { Numbers } from "../pack";
import { AS_LARGE, rowsOf, type SeriesOf } from "./series";
import type { Schedule } from "./signals";
import { wrenchesOf } from "./wrench";

/** As tmodes/live/places.py writes it. */
export interface LoadsInfo {
  places: Numbers;
  /** How many the result keeps: `places` are some of them where these are very many. */
  kept: number;
  /** Which of the places are the stations of the picture. */
  shown: Numbers;
  lines: LineInfo[];
  strengths: Record<string, number>;
  limits: LimitInfo[];
}

/** A link that bends: `width` numbers of each place, and where in them each quantity begins and ends. */
export interface LineInfo {
  name: string;
  width: number;
  at: Record<string, [number, number]>;
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

/** One link: its loads at the shown places of all frames, one after the other; what was largest in the run. */
export interface LinkLoads {
  name: string;
  length: number;
  deflection: Float64Array; // [S, 2]
  slope: Float64Array; // [S, 2]
  moment: Float64Array; // [S, 3]
  shear: Float64Array; // [S, 2]
  axial: Float64Array; // [S]
  stress: { strain: Float64Array; mises: Float64Array } | null;
  largest: Record<Quantity, Largest | null>;
  /** Each larger than all before it, from those on that are as large as the last. */
  records: Record<Quantity, Largest[]>;
}

export interface Loads {
  links: LinkLoads[];
  /** How many samples were looked at: of all, or of every so manieth. */
  every: number;
}

const MOST_PLACES = 400_000; // places at samples that are looked at: more take too long while a slider moves
const TOGETHER = 500_000; // numbers that are computed at once: they stay in memory

/** All loads of a run. */
export function loadsOf(
  engine: Engine,
  bundle: Bundle,
  blocks: Blocks,
  series: SeriesOf,
  times: Float64Array,
  schedule: Schedule,
  frames: number[],
): Loads {
  const { places, lines, shown } = bundle.carried;
  const S = places.data.length;
  const links = lines.map((line, l) => linkOf(line, blocks.lengths[l], frames.length * shown.data.length));
  const every = Math.max(1, Math.ceil((times.length * lines.length * S) / MOST_PLACES));
  if (!lines.length) return { links, every };
  const frameOf = new Map(frames.map((sample, frame) => [sample, frame]));
  const looked = Array.from(times.keys()).filter((k) => k % every === 0 || frameOf.has(k));
  const all: Record<string, Float64Array> = { q: series.q.data, v: series.v.data, a: series.a.data };
  if ("wrenches" in engine.layout.samples.line.inputs)
    all.wrenches = wrenchesOf(bundle, blocks, schedule, times, series);
  const rows = Object.entries(all).map(([name, data]) => [name, rowsOf(data, data.length / times.length, looked)]);
  const inputs: Samples = { ...Object.fromEntries(rows), base: blocks.weight };
  linesAt(engine, blocks, inputs, looked.length, (found, k) => {
    const frame = frameOf.get(looked[k]);
    lines.forEach((line, l) => {
      const own = found(line.name, sizeOf(bundle, line));
      watch(links[l], line, own, places.data, looked[k]);
      if (frame !== undefined) keep(links[l], line, own, frame, shown.data);
    });
  });
  return { links, every };
}

/** The first `size` numbers of a link at one sample: they stand in the module's memory, and only during the visit. */
export type Found = (name: string, size: number) => Float64Array;

/**
 * The function `line` at `count` samples, some at a time: `visit` gets what was found at each. Without wrenches there
 * are none on the points.
 */
export function linesAt(
  engine: Engine, blocks: Blocks, given: Samples, count: number, visit: (found: Found, sample: number) => void,
): void {
  const { inputs, outputs } = engine.layout.samples.line;
  const together = Math.max(1, Math.floor(TOGETHER / Object.values(outputs).reduce((sum, size) => sum + size, 1)));
  for (let first = 0; first < count; first += together) {
    const many = Math.min(together, count - first);
    const part: Samples = {};
    for (const [name, size] of Object.entries(inputs)) {
      const rows = given[name] ?? new Float64Array(size);
      part[name] = rows.length === size ? rows : rows.subarray(first * size, (first + many) * size);
    }
    const { all, width, starts } = engine.rows("line", blocks.line, part, many);
    for (let row = 0; row < many; row += 1) {
      const found = (name: string, size: number) => {
        const start = row * width + starts[name];
        return all.subarray(start, start + size);
      };
      visit(found, first + row);
    }
  }
}

/** The numbers of one link: of its places, or of a rigid one (no info) its axes, its root and its end. */
export function sizeOf(bundle: Bundle, info: LineInfo | null): number {
  return info ? bundle.carried.places.data.length * info.width : 15;
}

function linkOf({ name, at }: LineInfo, length: number, kept: number): LinkLoads {
  const numbers = (width: number) => new Float64Array(width * kept);
  return {
    name, length, deflection: numbers(2), slope: numbers(2), moment: numbers(3), shear: numbers(2), axial: numbers(1),
    stress: at.mises_stress ? { strain: numbers(1), mises: numbers(1) } : null,
    largest: { deflection: null, moment: null, stress: null }, records: { deflection: [], moment: [], stress: [] },
  };
}

function watch(
  link: LinkLoads, { width, at }: LineInfo, own: Float64Array, places: ArrayLike<number>, sample: number,
): void {
  const last = places.length - 1;
  const bent = last * width + at.deflection[0];
  see(link, "deflection", Math.sqrt(own[bent] ** 2 + own[bent + 1] ** 2), places[last], sample);
  for (let p = 0; p <= last; p += 1) {
    const moment = p * width + at.moment[0];
    see(link, "moment", Math.sqrt(own[moment + 1] ** 2 + own[moment + 2] ** 2), places[p], sample);
    if (link.stress) see(link, "stress", own[p * width + at.mises_stress[0]], places[p], sample);
  }
}

function see(
  { name, largest, records }: LinkLoads, quantity: Quantity, value: number, s: number, sample: number,
): void {
  const own = records[quantity];
  if (own.length && !(value > own[own.length - 1].value)) return;
  own.push({ link: name, value, s, sample });
  own.splice(0, own.findIndex((one) => one.value >= value * AS_LARGE));
  largest[quantity] = own[0];
}

function keep(
  link: LinkLoads, { width, at }: LineInfo, own: Float64Array, frame: number, shown: ArrayLike<number>,
): void {
  const put = (name: string, into: Float64Array) => {
    const [start, stop] = at[name];
    const size = stop - start;
    for (let s = 0; s < shown.length; s += 1) {
      for (let i = 0; i < size; i += 1)
        into[(frame * shown.length + s) * size + i] = own[shown[s] * width + start + i];
    }
  };
  for (const name of ["deflection", "slope", "moment", "shear", "axial"] as const) put(name, link[name]);
  if (!link.stress) return;
  put("strain", link.stress.strain);
  put("mises_stress", link.stress.mises);
}
