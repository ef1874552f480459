// Controllers in small motions about a rest, own states, motor currents and samples included: as
// tmodes/analysis/modes/closed_loop.py has them.

import type { Bundle } from "./bundle";
import type { Further } from "./eigen";
import type { Engine } from "./engine";
import { inverted, product } from "./linear";
import type { Blocks } from "./map";
import type { Sampled } from "./sampled";

/** Of the function `servos.slopes`: coordinates that drives move, and further states: `currents` of motors first. */
export interface LoopInfo extends Sampled {
  own: number[];
  currents: number;
  start: number[];
  /** The further states whose rates it gives, and those that samples set. */
  rated: number[];
  sampled: number[];
}

/** Rows by coordinates, rates and k further states [.., n + n + k]; `springs` [n, n]: as stiffness, currents steady. */
export interface Feedback {
  springs: Float64Array;
  effort: Float64Array;
  by: Float64Array;
  held: Float64Array;
  samples: Sampled | null;
}

/** Part of a matrix, whose rows are so wide. */
function part(matrix: Float64Array, width: number, rows: readonly number[], columns: readonly number[]): Float64Array {
  return Float64Array.from(rows.flatMap((row) => columns.map((column) => matrix[row * width + column])));
}

const places = (from: number, count: number) => Array.from({ length: count }, (_, k) => from + k);

/** Of all servos about the rest q [n], their wanted values there. */
export function feedbackAbout(engine: Engine, bundle: Bundle, blocks: Blocks, q: Float64Array): Feedback {
  const { servos, loop } = bundle.modes!;
  const [n, k] = [q.length, loop?.start.length ?? 0];
  const width = 2 * n + k;
  const [effort, by, held] = [n, k, k].map((rows) => new Float64Array(rows * width));
  if (!loop) {
    servos.forEach(({ coordinate: c }, s) => {
      effort[c * width + c] = -blocks.servos[2 * s];
      effort[c * width + n + c] = -blocks.servos[2 * s + 1];
    });
    const springs = effort.filter((_, at) => at % width < n).map((value) => -value);
    return { springs, effort, by, held, samples: null };
  }
  const units = (from: number, count: number) =>
    Float64Array.from({ length: width * count }, (_, at) => (Math.floor(at / count) === from + (at % count) ? 1 : 0));
  const setpoints = Float64Array.from(loop.own.flatMap((c) => [q[c], 0, 0]));
  const given = { q, v: new Float64Array(n), further: Float64Array.from(loop.start), setpoints };
  const along = { q: units(0, n), v: units(n, n), further: units(2 * n, k) };
  const inputs = { ...given, still: new Float64Array(3) };
  const { slopes } = engine.slopes("servos.slopes", blocks.loop, inputs, along, width);
  const put = (rows: number[], columns: Float64Array, into: Float64Array) =>
    rows.forEach((row, r) => {
      for (let c = 0; c < width; c += 1) into[row * width + c] += columns[c * rows.length + r];
    });
  put(loop.own, slopes.effort, effort);
  put(loop.rated, slopes.rates, by);
  put(loop.sampled, slopes.samples, held);
  return { springs: springsOf(loop, n, effort, by, held), effort, by, held, samples: loop.period ? loop : null };
}

/** With sampled controllers as if they worked at all times, and with steady currents. */
function springsOf(
  { start, currents: m }: LoopInfo, n: number, effort: Float64Array, by: Float64Array, held: Float64Array,
): Float64Array {
  const [k, width] = [start.length, 2 * n + start.length];
  const [rows, all] = [places(0, n), places(2 * n, k)];
  const wound = places(2 * n, m);
  const winding = inverted(part(by, width, places(0, m), wound), m)!;
  const steady = product(winding, by.subarray(0, m * width), m, m, width).map((value) => -value);
  const flow = product(part(effort, width, rows, wound), steady, n, m, width);
  const drive = part(effort.map((value, at) => value + flow[at]), width, rows, all);
  const sampled = product(drive, part(held, width, places(0, k), rows), n, k, n);
  return sampled.map((value, at) => {
    const place = Math.floor(at / n) * width + (at % n);
    return -effort[place] - flow[place] - value;
  });
}

/** Of the coordinates that move: stiffness, damping, and what else acts. */
export function moved(
  { springs, effort, by, held, samples }: Feedback, n: number, moving: readonly number[],
): { stiffness: Float64Array; damping: Float64Array; further: Further } {
  const [width, m] = [effort.length / n, moving.length];
  const count = width - 2 * n;
  const rates = moving.map((c) => n + c);
  const columns = [...moving, ...rates, ...places(2 * n, count)];
  const stiffness = part(springs, n, moving, moving);
  return {
    stiffness,
    damping: part(effort, width, moving, rates).map((value) => -value),
    further: {
      count,
      springs: part(effort, width, moving, moving).map((value, k) => value + stiffness[k]),
      drive: part(effort, width, moving, columns.slice(2 * m)),
      by: part(by, width, places(0, count), columns),
      held: part(held, width, places(0, count), columns),
      samples,
    },
  };
}
