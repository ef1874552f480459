// The series of a run, from the outputs of its model and its chain at the samples.

import type { Regime } from "./regime";
import { affine } from "./live_scene";
import type { Bundle } from "./bundle";
import type { Engine, Samples } from "./engine";
import { columns, difference, energyBalance, range, shaped, sizes, type SeriesOf } from "./series";
import { rowsAt } from "./signals";

/** What is known of the samples of a regime: what its model reports, and the motion of its chain. */
export interface Seen {
  regime: Regime;
  model: Samples;
  tip: Float64Array; // [n, 3]
}

/** The same with the motion of all points. */
export interface Moving extends Seen {
  points: Float64Array; // [n, points, 24]
}

const POINT = 24;

/** What a regime's model reports of the first `count` samples. */
function observed(engine: Engine, regime: Regime, count: number): Samples {
  const time = regime.run.times.subarray(0, count);
  const state = regime.run.states.subarray(0, count * (regime.run.states.length / regime.run.times.length));
  const inputs = { time, state, row: rowsAt(regime.schedule, time), step: new Float64Array(1) };
  return engine.sample(`${regime.name}.observe`, regime.blocks.parameters, inputs, count);
}

/** What is known of the first `count` samples of the actual robot. */
export function seenOf(engine: Engine, regime: Regime, count: number): Moving {
  const model = observed(engine, regime, count);
  const { q, v, a } = model;
  const { points } = engine.sample("points", regime.blocks.chain, { q, v, a, base: regime.blocks.base }, count);
  return { regime, model, points, tip: columns(points, points.length / count, [9, 10, 11]) };
}

/** The same of the nominal one. */
export function plannedOf(engine: Engine, regime: Regime, count: number): Seen {
  const model = observed(engine, regime, count);
  return { regime, model, tip: tipAt(engine, regime, model.q, count) };
}

/** What is known of the first `count` of all samples. */
export function firstOf(seen: Seen, all: number, count: number): Seen {
  if (count === all) return seen;
  const first = (values: Float64Array) => values.subarray(0, (values.length / all) * count);
  const model = Object.fromEntries(Object.entries(seen.model).map(([name, values]) => [name, first(values)]));
  return { ...seen, model, tip: first(seen.tip) };
}

/** Where the tip [n, 3] is at coordinates q [n, nq]. */
export function tipAt(engine: Engine, { blocks }: Regime, q: Float64Array, count: number): Float64Array {
  const still = new Float64Array(q.length / count);
  return engine.sample("tip", blocks.chain, { q, v: still, a: still, base: blocks.base }, count).tip;
}

/** Kinetic, of gravity, of gears, of links [n, 4]. */
function energiesOf(engine: Engine, { regime, model: { q, v } }: Seen, count: number): Float64Array {
  const { chain, rotors, base, gravity } = regime.blocks;
  const n = rotors.length;
  const still = new Float64Array(n);
  const momentum = engine.sample("inertia", chain, { q, v: still, a: v, base }, count, ["forces", "moment"]);
  const elastic = engine.sample("elastic", chain, { q, v, base }, count, ["energies"]).energies;
  const each = elastic.length / count;
  const energy = new Float64Array(4 * count);
  for (let k = 0; k < count; k += 1) {
    for (let j = 0; j < n; j += 1) {
      const rate = v[k * n + j];
      energy[4 * k] += ((momentum.forces[k * n + j] + rotors[j] * rate) * rate) / 2;
    }
    for (let j = 0; j < 3; j += 1) energy[4 * k + 1] -= momentum.moment[3 * k + j] * gravity[j];
    for (let j = 0; j < each; j += 1) energy[4 * k + 2 + (j % 2)] += elastic[k * each + j];
  }
  return energy;
}

/** The series that the actual robot has by itself. */
export function seriesOf(engine: Engine, bundle: Bundle, real: Regime, own: Moving, count: number): SeriesOf {
  const { model, points, tip } = own;
  const energy = energiesOf(engine, own, count);
  const n = model.q.length / count;
  const drives = model.gear.length / count;
  const places = points.length / count / POINT;
  const width = real.run.states.length / real.run.times.length;
  const work = columns(real.run.states.subarray(0, count * width), width, range(...real.info.state.works));
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
    deformation: shaped(affine(real.blocks.deflections, model.q, count), count, bundle.deformations.length),
    position: shaped(vectors(9), count, places, 3), velocity: shaped(vectors(12), count, places, 3),
    acceleration: shaped(vectors(18), count, places, 3), rotation: shaped(axes, count, places, 3, 3),
    tip: shaped(tip, count, 3),
    tip_velocity: shaped(columns(points, places * POINT, [12, 13, 14]), count, 3),
    energy: shaped(energy, count, 4), work: shaped(work, count, work.length / count),
    energy_balance: shaped(energyBalance(energy, work, count, 3), count),
  };
  if (drives)
    Object.assign(series, { wanted: drive(3), effort: drive(0), gear_torque: shaped(model.gear, count, drives) });
  if (drives && bundle.electric) Object.assign(series, { voltage: drive(1), current: drive(2) });
  const states = range(...real.info.state.controls);
  if (states.length) {
    const before = columns(real.run.states.subarray(0, count * width), width, states);
    const controls = model.controls ?? before; // after the samples of each instant, where there are any
    series.controller_states = shaped(controls, count, states.length);
  }
  if (bundle.contactPoint < 0) return series;
  const contact = (which: number[]) => columns(model.contact, 6, which);
  return {
    ...series, contact_force: shaped(contact([0, 1, 2]), count, 3), contact_force_normal: shaped(contact([3]), count),
    penetration: shaped(contact([4]), count),
  };
}

/** Those that need the nominal run: what it does, and how far the actual robot is from it. */
export function compared(bundle: Bundle, own: Seen, planned: Seen, count: number): SeriesOf {
  const n = planned.model.q.length / count;
  const series: SeriesOf = {
    q_nominal: shaped(planned.model.q, count, n),
    v_nominal: shaped(planned.model.v, count, n),
    deformation_nominal: shaped(
      affine(planned.regime.blocks.deflections, planned.model.q, count),
      count,
      bundle.deformations.length,
    ),
    gear_torque_nominal: shaped(planned.model.gear, count, planned.model.gear.length / count),
    tip_nominal: shaped(planned.tip, count, 3),
    deviation: shaped(sizes(difference(own.tip, planned.tip), 3), count),
  };
  if (bundle.contactPoint >= 0)
    series.contact_force_normal_nominal = shaped(columns(planned.model.contact, 6, [3]), count);
  return series;
}
