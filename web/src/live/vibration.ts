// Small vibrations of a robot about its rest, as tmodes/analysis/modes/ finds them.

import { linearAtRest, type Linear } from "./linear_model";
import { restFor } from "./rest";
import { poseOf } from "./live_scene";
import { doubles, type Bundle } from "./bundle";
import { damped, undamped } from "./eigen";
import type { Engine } from "./engine";
import { feedbackAbout, moved, type Feedback } from "./feedback";
import type { Facts } from "./facts";
import { numbersOf, type Blocks } from "./map";
import { motionOf, ringing, info, type Found } from "./modes";
import type { Vibration } from "../contract_parts";
import { bestPartners, likeness } from "./partners";
import { LOADS, namedAsSeen, type SeenMode } from "./vibrating";
import type { LiveRun } from "../contract_parts";
import type { Regime } from "./regime";
import { valueAt, type Schedule } from "./signals";

const ROUNDING = 1e-13;
const SAME = 1e-6; // relative difference of |pole| and the undamped frequency below which they are the same number
const NOTHING = 1e-13;
const FREE = "whole arm, free";

/** Modes, marks (by what was `seen` of them) and the first frequency; a sentence where there are none. */
export function vibrationOf(
  engine: Engine, bundle: Bundle, values: readonly number[], { blocks, schedule, info: own }: Regime, run: LiveRun,
  seen: SeenMode[],
): { vibration: Vibration | string; facts: Facts } {
  if (!bundle.modes) return { vibration: bundle.noModes, facts: {} };
  try {
    const about = aboutRest(engine, bundle, values, schedule, doubles(bundle.modes.rest));
    const modes = ({ rest: q, linear }: ReturnType<typeof aboutRest>, state: string, of: number[]) => {
      const loop = state === "controlled" ? feedbackAbout(engine, bundle, blocks, q) : null;
      return modesOf(bundle, blocks, linear, loop, of);
    };
    const cases = Object.fromEntries(
      bundle.modes.cases.map(({ name: state, moving: of }) => [state, modes(about, state, of)]),
    );
    const { name, moving } = bundle.modes.cases.find((one) => one.name === "controlled" && one.moving.length) ??
      bundle.modes.cases.find((one) => one.name === "locked")!;
    const end = endOf(bundle, own, schedule, run);
    const ending = end && aboutRest(engine, bundle, values, schedule, end, run.times[run.times.length - 1]);
    const marked = ending ? namedAsSeen(modes(ending, name, moving), seen) : [];
    return info(cases, marked, about.rest, (q, count) => poseOf(engine, bundle, blocks, q, count).line);
  } catch (problem) {
    return { vibration: problem instanceof Error ? problem.message : String(problem), facts: {} };
  }
}

function aboutRest(
  engine: Engine, bundle: Bundle, values: readonly number[], schedule: Schedule, near: Float64Array, time = 0,
): { rest: Float64Array; linear: Linear } {
  let last: ReturnType<typeof linearAtRest> = null;
  const { state: { q: [start] } } = bundle.runs.real;
  restFor(bundle, values, "real", near, (set, from) => {
    const blocks = numbersOf(bundle.map, set, "real");
    const held = (k: number) => !time && !bundle.modes!.free.includes(k);
    const first = from.map((value, k) => (held(k) ? blocks.start[start + k] : value));
    last = linearAtRest(engine, bundle, blocks, schedule, first, time);
    return last && last.rest;
  });
  return last!;
}

/** Near the rest in which a run ends: driven coordinates at their setpoints, or where it left them; null: no rest. */
function endOf(bundle: Bundle, own: Regime["info"], schedule: Schedule, run: LiveRun): Float64Array | null {
  if (!bundle.modes!.end) return null;
  const end = doubles(bundle.modes!.end).slice();
  const [time, last] = [run.times[run.times.length - 1], run.series.q.data.subarray(-end.length)];
  const signals = new Map(own.commanded);
  for (let k = 0; k < end.length; k += 1) {
    const signal = signals.get(k);
    if (!bundle.modes!.free.includes(k)) end[k] = signal === undefined ? last[k] : valueAt(schedule, signal, time);
  }
  return end;
}

function modesOf(
  bundle: Bundle, blocks: Blocks, linear: Linear, loop: Feedback | null, moving: number[],
): Found[] {
  const whole = Math.sqrt(linear.mass.length);
  const m = moving.length;
  if (!m) return [];
  const part = (matrix: Float64Array) =>
    Float64Array.from({ length: m * m }, (_, k) => matrix[moving[Math.floor(k / m)] * whole + moving[k % m]]);
  const [mass, damping, stiffness] = [part(linear.mass), part(linear.damping), part(linear.stiffness)];
  const own = loop && moved(loop, whole, moving);
  own?.stiffness.forEach((value, k) => { stiffness[k] += value; });
  own?.damping.forEach((value, k) => { damping[k] += value; });
  const held = loop && bundle.modes!.servos.map(({ coordinate }) => loop.springs[coordinate * (whole + 1)]);
  const still = undamped(mass, stiffness, m);
  const motions = damped(mass, damping, stiffness, m, still, own?.further);
  const partners = bestPartners(likeness(still, motions, m, mass), motions, m);
  const zero = NOTHING * m * still.squares.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return Array.from({ length: m }, (_, k) => {
    const shape = new Float64Array(whole);
    moving.forEach((coordinate, i) => { shape[coordinate] = still.shapes[i * m + k]; });
    const stored = storedIn(bundle, blocks, linear.elastic, shape, held);
    const motion = motionOf(motions, partners[k], whole, m, (c, i) => (moving[i] === c ? 1 : 0));
    const square = still.squares[k];
    const total = stored.reduce((sum, { energy }) => sum + energy, 0);
    if (Math.abs(square) <= zero && total <= zero)
      return { frequency: 0, rings: null, damping: 0, element: FREE, ...motion };
    const { size, rings, damping: ratio } = ringing(motions, partners[k]);
    const natural = Math.sqrt(Math.max(square, 0));
    const frequency = (Math.abs(size - natural) > SAME * size ? size : natural) / (2 * Math.PI);
    const most = stored.reduce((a, b) => (b.energy > a.energy ? b : a), stored[0]);
    return {
      frequency: rings === null ? 0 : frequency,
      rings,
      damping: Math.abs(ratio) > ROUNDING ? ratio : 0,
      element: total > zero && most ? most.element : LOADS,
      ...motion,
    };
  });
}

/** Twice the energy of a shape in each spring, and in the controllers of such stiffness. */
export function storedIn(
  bundle: Bundle, blocks: Blocks, elastic: Float64Array, shape: Float64Array, held: number[] | null,
): { element: string; energy: number }[] {
  const n = shape.length;
  const force = (row: number) => {
    let sum = 0;
    for (let j = 0; j < n; j += 1) sum += elastic[row * n + j] * shape[j];
    return sum;
  };
  const { springs, servos } = bundle.modes!;
  const found = springs.map(({ element, rows, gear, parallel: place }) => {
    const parallel = place < 0 ? 0 : blocks.chain[place];
    if (!gear && place >= 0) return { element, energy: parallel * shape[rows[0]] ** 2 };
    if (!gear) return { element, energy: rows.reduce((sum, row) => sum + shape[row] * force(row), 0) };
    const own = elastic[rows[0] * (n + 1)] - parallel;
    return { element, energy: own ? (force(rows[0]) - parallel * shape[rows[0]]) ** 2 / own : 0 };
  });
  return found.concat((held ?? []).map((stiffness, k) => (
    { element: servos[k].element, energy: Math.max(0, stiffness) * shape[servos[k].coordinate] ** 2 }
  )));
}
