// A run of an arm in the page: from values of the sliders to all that a page shows of it, as motion/simulate.py does.

import type { LiveRun } from "../contract";
import { firstState } from "./arm_rest";
import { limitFact, loadFacts } from "./arm_load_facts";
import { linePanel, loadColours } from "./arm_load_picture";
import { loadsOf } from "./arm_loads";
import { affine, armScene } from "./arm_scene";
import { doubles, framesOf, type ArmBundle, type ArmRunTold } from "./bundle";
import type { Engine, Samples } from "./engine";
import { integrate, type RunResult, type Watch } from "./engine_run";
import { brokenOff, energyFacts, figures, meanOverTime, trackingFacts, type Facts } from "./facts";
import type { Kept } from "./kept";
import { numbersOf, type Blocks } from "./map";
import { columns, difference, energyBalance, range, shaped, sizes, worst, type SeriesOf } from "./series";
import * as signals from "./signals";

type Name = "reference" | "real";

/** One arm in motion, and what is observed of it. */
export interface Regime {
  name: Name;
  told: ArmRunTold;
  blocks: Blocks;
  schedule: signals.Schedule;
  run: RunResult;
}

/** What is known of the samples of a regime: what its model tells, and the motion and energies of its chain. */
interface Seen {
  model: Samples;
  points: Float64Array; // [n, points, 24]
  energy: Float64Array; // [n, 4]
}

const POINT = 24;
const FEWEST = 32; // samples of a spectrum

/**
 * The whole run; raises an error where it cannot start. `kept`: the reference run before; `moving` hears the real arm's
 * motion.
 */
export async function runArm(
  engine: Engine, bundle: ArmBundle, values: readonly number[], watch: Watch, kept: Kept<Regime>,
  moving: (real: Regime) => void = () => undefined,
): Promise<LiveRun> {
  const began = performance.now();
  const names: Name[] = bundle.runs.reference ? ["reference", "real"] : ["real"];
  const regimes: Regime[] = [];
  for (const [k, name] of names.entries()) {
    const part: Watch = { ...watch, progress: (share) => watch.progress?.((k + share) / names.length) };
    const blocks = numbersOf(bundle.map, values, name);
    const make = () => moved(engine, bundle, values, name, blocks, part);
    regimes.push(await (name === "reference" ? kept.of(blocks, make) : make()));
  }
  const real = regimes[regimes.length - 1];
  moving(real);
  const seconds = (performance.now() - began) / 1000;
  const count = Math.min(...regimes.map((regime) => regime.run.times.length));
  const [own, planned] = [real, ...regimes.slice(0, -1)].map((regime) => seenOf(engine, bundle, regime, count));
  const times = real.run.times.subarray(0, count);
  const series = { ...seriesOf(bundle, real, own, count), ...(planned ? compared(bundle, own, planned, count) : {}) };
  const frames = framesOf(bundle, count);
  const end = moveEnd(real.schedule);
  const failed = regimes.find((regime) => regime.run.status !== "finished");
  const loads = loadsOf(bundle, real.blocks.carried, series, times, real.schedule, frames);
  const facts: Facts = {
    ...factsOf(bundle, times, series, end),
    ...loadFacts(loads, bundle.carried, times),
    ...limitFact(bundle.carried.limits, series),
  };
  const colours = loadColours(bundle, loads.links, frames.length);
  return {
    status: failed ? failed.run.status : "finished",
    message: failed ? `${failed === real ? "real arm" : "reference"}: ${failed.run.message}` : real.run.message,
    seconds,
    times,
    series,
    scene: armScene(engine, bundle, real.blocks, series, times, frames, colours),
    line: linePanel(bundle, loads.links, frames.length),
    span: spanOf(times, end),
    facts: failed ? brokenOff(facts) : facts,
  };
}

/** The time after the move, where the run goes on long enough, else the whole run, as tmodes/report/spectra.py. */
function spanOf(times: Float64Array, end: number | null): [number, number] {
  const last = times[times.length - 1];
  const first = end === null ? -1 : times.findIndex((time) => time >= end * (1 + 1e-9));
  return [first >= 0 && times.length - first >= FEWEST ? times[first] : times[0], last];
}

async function moved(
  engine: Engine, bundle: ArmBundle, values: readonly number[], name: Name, blocks: Blocks, watch: Watch,
): Promise<Regime> {
  const { settings } = bundle;
  const told = bundle.runs[name]!;
  const each = range(0, told.signals).map((k) =>
    signals.until(signals.schedule(blocks[`knots.${k}`], blocks[`coefficients.${k}`]), settings.duration),
  );
  const schedule = signals.merged(each);
  if (!each.length) schedule.knots[1] = settings.duration;
  const run = await integrate(
    engine,
    {
      loop: `${name}.${settings.method}`,
      parameters: blocks.parameters,
      knots: schedule.knots,
      rows: signals.rowsOf(schedule),
      state: firstState(engine, bundle, values, name, schedule),
      times: doubles(bundle.times),
      settings,
    },
    watch,
  );
  return { name, told, blocks, schedule, run };
}

function seenOf(engine: Engine, bundle: ArmBundle, regime: Regime, count: number): Seen {
  const time = regime.run.times.subarray(0, count);
  const state = regime.run.states.subarray(0, count * (regime.run.states.length / regime.run.times.length));
  const row = signals.rowsAt(regime.schedule, time);
  const inputs = { time, state, row, step: new Float64Array(1) };
  const model = engine.sample(`${regime.name}.observe`, regime.blocks.parameters, inputs, count);
  const { q, v, a } = model;
  const base = doubles(bundle.base);
  const { chain, rotors } = regime.blocks;
  const { points } = engine.sample("inertia", chain, { q, v, a, base }, count);
  const still = new Float64Array(rotors.length);
  const momentum = engine.sample("inertia", chain, { q, v: still, a: v, base }, count);
  const elastic = engine.sample("elastic", chain, { q, v, base }, count).energies;
  return { model, points, energy: energiesOf(bundle, v, rotors, momentum, elastic, count) };
}

/** Kinetic, of gravity, of gears, of links [n, 4]. */
function energiesOf(
  bundle: ArmBundle,
  v: Float64Array,
  rotors: Float64Array,
  momentum: Samples,
  elastic: Float64Array,
  count: number,
): Float64Array {
  const n = rotors.length;
  const each = elastic.length / count;
  const energy = new Float64Array(4 * count);
  for (let k = 0; k < count; k += 1) {
    for (let j = 0; j < n; j += 1) {
      const rate = v[k * n + j];
      energy[4 * k] += ((momentum.forces[k * n + j] + rotors[j] * rate) * rate) / 2;
    }
    for (let j = 0; j < 3; j += 1) energy[4 * k + 1] -= momentum.moment[3 * k + j] * bundle.gravity.data[j];
    for (let j = 0; j < each; j += 1) energy[4 * k + 2 + (j % 2)] += elastic[k * each + j];
  }
  return energy;
}

function seriesOf(bundle: ArmBundle, real: Regime, { model, points, energy }: Seen, count: number): SeriesOf {
  const n = model.q.length / count;
  const drives = model.gear.length / count;
  const places = points.length / count / POINT;
  const width = real.run.states.length / real.run.times.length;
  const work = columns(real.run.states.subarray(0, count * width), width, range(...real.told.state.works));
  const drive = (which: number) =>
    shaped(
      columns(
        model.drives,
        4 * drives,
        range(0, drives).map((k) => 4 * k + which),
      ),
      count,
      drives,
    );
  const vectors = (start: number) =>
    columns(
      points,
      places * POINT,
      range(0, places).flatMap((k) => range(0, 3).map((i) => k * POINT + start + i)),
    );
  const axes = columns(points, places * POINT, range(0, places).flatMap((k) => range(k * POINT, k * POINT + 9)));
  const series: SeriesOf = {
    q: shaped(model.q, count, n), v: shaped(model.v, count, n), a: shaped(model.a, count, n),
    deformation: shaped(affine(bundle.deflections, model.q, count), count, bundle.deformations.length),
    position: shaped(vectors(9), count, places, 3), velocity: shaped(vectors(12), count, places, 3),
    acceleration: shaped(vectors(18), count, places, 3), rotation: shaped(axes, count, places, 3, 3),
    tip: shaped(columns(points, places * POINT, [9, 10, 11]), count, 3),
    tip_velocity: shaped(columns(points, places * POINT, [12, 13, 14]), count, 3),
    energy: shaped(energy, count, 4), work: shaped(work, count, work.length / count),
    energy_balance: shaped(energyBalance(energy, work, count, 3), count),
  };
  if (drives)
    Object.assign(series, { wanted: drive(3), effort: drive(0), gear_torque: shaped(model.gear, count, drives) });
  if (drives && bundle.electric) Object.assign(series, { voltage: drive(1), current: drive(2) });
  if (bundle.contactPoint < 0) return series;
  const contact = (which: number[]) => columns(model.contact, 6, which);
  return {
    ...series, contact_force: shaped(contact([0, 1, 2]), count, 3), contact_force_normal: shaped(contact([3]), count),
    penetration: shaped(contact([4]), count),
  };
}

function compared(bundle: ArmBundle, own: Seen, planned: Seen, count: number): SeriesOf {
  const n = planned.model.q.length / count;
  const places = planned.points.length / count / POINT;
  const [tip, wanted] = [own, planned].map(({ points }) => columns(points, places * POINT, [9, 10, 11]));
  const series: SeriesOf = {
    q_reference: shaped(planned.model.q, count, n),
    v_reference: shaped(planned.model.v, count, n),
    deformation_reference: shaped(
      affine(bundle.deflections, planned.model.q, count),
      count,
      bundle.deformations.length,
    ),
    gear_torque_reference: shaped(planned.model.gear, count, planned.model.gear.length / count),
    tip_reference: shaped(wanted, count, 3),
    deviation: shaped(sizes(difference(tip, wanted), 3), count),
  };
  if (bundle.contactPoint >= 0)
    series.contact_force_normal_reference = shaped(columns(planned.model.contact, 6, [3]), count);
  return series;
}

/** When the last signal stops changing [s]; null where one never does. */
function moveEnd(all: signals.Schedule): number | null {
  const pieces = all.knots.length - 1;
  const width = all.degree + 1;
  for (let piece = pieces - 1; piece >= 0; piece -= 1) {
    for (let signal = 0; signal < all.signals; signal += 1) {
      const own = all.coefficients.subarray(
        (piece * all.signals + signal) * width,
        (piece * all.signals + signal + 1) * width,
      );
      const length = all.knots[piece + 1] - all.knots[piece];
      const size = Math.max(
        ...range(0, pieces).map((k) => Math.abs(all.coefficients[(k * all.signals + signal) * width])),
        1e-12,
      );
      const changes = own.some((value, power) => power > 0 && Math.abs(value) * length ** power > 1e-9 * size);
      if (changes) return piece === pieces - 1 ? null : all.knots[piece + 1];
      const before = piece && signals.valueAt(all, signal, all.knots[piece] - 1e-9 * length);
      if (piece && Math.abs(own[0] - before) > 1e-6 * size) return all.knots[piece];
    }
  }
  return 0;
}

function factsOf(bundle: ArmBundle, times: Float64Array, series: SeriesOf, end: number | null): Facts {
  const facts: Facts = { ...trackingFacts(times, series, end), ...energyFacts(series, times.length) };
  const every = bundle.deformations.flatMap((name, k) => (name.endsWith(".gear") ? [k] : []));
  const turning = every.filter((k) => bundle.turning.includes(bundle.deformations[k].replace(/\.gear$/, "")));
  const gears = turning.length ? turning : every; // as the page's own fact: radians and meters are not compared
  if (gears.length) {
    const angles = columns(series.deformation.data, bundle.deformations.length, gears);
    const k = worst(angles);
    const name = bundle.deformations[gears[k % gears.length]].replace(/\.gear$/, "");
    facts["gear.max"] = {
      value: Math.abs(angles[k]),
      note: `${name}, at ${figures(times[Math.floor(k / gears.length)])} s`,
    };
  }
  const force = series.contact_force_normal?.data;
  if (force) {
    const [least, most] = [force.reduce((a, b) => Math.min(a, b)), force.reduce((a, b) => Math.max(a, b))];
    facts["contact.mean"] = {
      value: meanOverTime(times, force),
      note: `from ${figures(least, 4)} to ${figures(most, 4)} N`,
    };
  }
  return facts;
}
