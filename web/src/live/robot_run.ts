// A run of the 2010 robot in the page: from values of the sliders to all that a page shows of it, as simulate.py does.

import type { LinePanel } from "../contract";
import type { LiveRun } from "../contract_parts";
import { doubles, framesOf, type RobotBundle } from "./bundle";
import type { Engine, Samples } from "./engine";
import { integrate, type RunResult, type Watch } from "./engine_run";
import { brokenOff } from "./facts";
import type { Kept } from "./kept";
import { numbersOf, type Blocks } from "./map";
import { colours, linesAt, placesAt, roots, stacked, type Lines } from "./robot_line";
import { largestMoment, robotFacts, withoutSettling } from "./robot_facts";
import { staticRoots } from "./robot_static";
import { beside, columns, difference, energyBalance, range, rowsOf, shaped, sizes, type SeriesOf } from "./series";
import * as signals from "./signals";

/** Numbers of a state: coordinates, rates, works. */
export const STATE = 17;
const THETA = [1, 0, 1, 0, 0, 1];
const QUANTITIES = [
  { id: "deflection", label: "Deflection", unit: "m" },
  { id: "slope", label: "Slope", unit: "rad" },
  { id: "bending_moment", label: "Bending moment", unit: "N m" },
  { id: "shear_force", label: "Shear force", unit: "N" },
];

/** One robot in motion: its numbers, its run, and what is observed of its first samples. */
export interface Regime {
  name: string;
  numbers: Blocks;
  schedule: signals.Schedule;
  run: RunResult;
}

/** Both robots in motion, and what is observed of the real one at the `count` samples that both reached. */
export interface Pair {
  reference: Regime;
  real: Regime;
  seen: Samples;
  count: number;
}

/**
 * The run but for what takes longer (robot_later.ts); raises an error where it cannot start. `kept`: the reference run
 * before; `moving` hears both motions.
 */
export async function runRobot(
  engine: Engine, bundle: RobotBundle, values: readonly number[], watch: Watch, kept: Kept<Regime>,
  moving: (pair: Pair) => void = () => undefined,
): Promise<LiveRun> {
  const began = performance.now();
  const half = (from: number): Watch => ({ ...watch, progress: (share) => watch.progress?.(from + share / 2) });
  const numbers = (name: string) => numbersOf(bundle.map, values, name);
  const known = numbers("reference");
  const reference = await kept.of(known, () => moved(engine, bundle, known, "reference", half(0)));
  const real = await moved(engine, bundle, numbers("real"), "real", half(0.5));
  const count = Math.min(reference.run.times.length, real.run.times.length);
  const seconds = (performance.now() - began) / 1000;
  const [seen, planned] = [observed(engine, real, count), observed(engine, reference, count)];
  moving({ reference, real, seen, count });
  const times = real.run.times.subarray(0, count);
  const series = seriesOf(bundle, real, reference, seen, planned, count);
  const states = real.run.states.subarray(0, count * STATE);
  const motion = beside(count, columns(states, STATE, range(0, 12)), seen.acceleration, seen.contact_force);
  const frames = framesOf(bundle, count);
  const lineOf = (which: Float64Array, stations: Float64Array) =>
    linesAt(engine, real.numbers.parameters, which, stations);
  const lines = lineOf(rowsOf(motion, 21, frames), doubles(bundle.stations));
  const moment = largestMoment(times, lines, (stations) => lineOf(motion, stations));
  const failed = [reference, real].find((regime) => regime.run.status !== "finished");
  const name = failed === reference ? "reference" : "real robot";
  const facts = robotFacts(times, series, moment, real.numbers.end[0]);
  const end = known.end[0];
  return {
    status: failed ? failed.run.status : "finished",
    message: failed ? `${name}: ${failed.run.message}` : real.run.message,
    seconds, times, series,
    ...picture(engine, bundle, real, lines, series, frames),
    span: [bundle.steady[0] * end, bundle.steady[1] * end],
    facts: failed ? brokenOff(facts) : withoutSettling(facts),
  };
}

async function moved(
  engine: Engine,
  bundle: RobotBundle,
  numbers: Blocks,
  name: string,
  watch: Watch,
): Promise<Regime> {
  const { settings } = bundle;
  const schedule = signals.until(signals.schedule(numbers.knots, numbers.coefficients), settings.duration);
  const run = await integrate(
    engine,
    {
      loop: `${name}.${settings.method}`,
      parameters: numbers.parameters,
      knots: schedule.knots,
      rows: signals.rowsOf(schedule),
      state: atRest(engine, bundle, name, numbers),
      times: doubles(bundle.times),
      settings,
    },
    watch,
  );
  return { name, numbers, schedule, run };
}

function atRest(engine: Engine, bundle: RobotBundle, name: string, numbers: Blocks): Float64Array {
  const { angles, found } = staticRoots(
    engine,
    bundle,
    `${name}.rest`,
    numbers.parameters,
    numbers.start,
    new Float64Array(5),
    1,
  );
  if (!found[0])
    throw new Error(
      `${name}: no static equilibrium; expected a link that carries its own load: raise a stiffness or lower a load`,
    );
  const state = new Float64Array(STATE);
  for (let i = 0; i < 6; i += 1) {
    state[i] = numbers.start[0] * THETA[i];
    for (let j = 0; j < 5; j += 1) state[i] += bundle.basis.data[5 * i + j] * angles[j];
  }
  return state;
}

/** What is observed of the first samples. */
export function observed(engine: Engine, regime: Regime, count: number): Samples {
  const time = regime.run.times.subarray(0, count);
  const state = regime.run.states.subarray(0, count * STATE);
  const row = signals.rowsAt(regime.schedule, time);
  return engine.sample(`${regime.name}.observe`, regime.numbers.parameters, { time, state, row }, count);
}

/** Coordinates [n, 6] of the robot without any elasticity whose motor is where that of `phi` [n, 6] is. */
function rigidOf(phi: Float64Array): Float64Array {
  return Float64Array.from({ length: phi.length }, (_, k) => phi[6 * Math.floor(k / 6) + 5] * THETA[k % 6]);
}

/** th11q, th12d, th11m, th12e, xi of states [n, 17]. */
export function deformations(states: Float64Array): Float64Array {
  const count = states.length / STATE;
  const found = new Float64Array(count * 5);
  for (let k = 0; k < count; k += 1) {
    const [q, delta, gamma, vt, e, theta] = states.subarray(k * STATE, k * STATE + 6);
    found.set([q - gamma, delta - (q - gamma) / 2, vt, e - vt / 2, gamma - theta], 5 * k);
  }
  return found;
}

function seriesOf(
  bundle: RobotBundle, real: Regime, reference: Regime, seen: Samples, planned: Samples, count: number,
): SeriesOf {
  const [states, wanted] = [real, reference].map((regime) => regime.run.states.subarray(0, count * STATE));
  const [q, v, work] = [range(0, 6), range(6, 12), range(12, 17)].map((which) => columns(states, STATE, which));
  const series: SeriesOf = {
    q: shaped(q, count, 6),
    v: shaped(v, count, 6),
    q_reference: shaped(columns(wanted, STATE, range(0, 6)), count, 6),
    v_reference: shaped(columns(wanted, STATE, range(6, 12)), count, 6),
    theta_wanted: shaped(seen.wanted, count),
    voltage: shaped(seen.voltage, count),
    current: shaped(seen.current, count),
    tip: shaped(seen.tip, count, 3),
    tip_velocity: shaped(seen.tip_velocity, count, 3),
    tip_reference: shaped(planned.tip, count, 3),
    deviation: shaped(sizes(difference(seen.tip, planned.tip), 3), count),
    deformation: shaped(deformations(states), count, 5),
    deformation_reference: shaped(deformations(wanted), count, 5),
    gear_torque: shaped(seen.gear_torque, count),
    gear_torque_reference: shaped(planned.gear_torque, count),
    energy: shaped(seen.energy, count, 4),
    work: shaped(work, count, 5),
    energy_balance: shaped(energyBalance(seen.energy, work, count, 1), count),
  };
  if (!bundle.contact) return series;
  return {
    ...series,
    contact_force: shaped(seen.contact_force, count, 3),
    contact_force_radial: shaped(seen.radial_force, count),
    contact_force_radial_reference: shaped(planned.radial_force, count),
  };
}

/** Scene and line panel at the display frames, where the lines are. */
function picture(
  engine: Engine, bundle: RobotBundle, real: Regime, lines: Lines, series: SeriesOf, frames: number[],
): Pick<LiveRun, "scene" | "line"> {
  const { parameters } = real.numbers;
  const at = (name: string) =>
    rowsOf(
      series[name].data,
      series[name].shape.slice(1).reduce((a, b) => a * b, 1),
      frames,
    );
  const points = lines.stations.length;
  const phi = at("q");
  const wanted = at("q_reference");
  const line = stacked(lines, "line");
  const [rigid, reference, referenceRigid] = [rigidOf(phi), wanted, rigidOf(wanted)].map((one) =>
    placesAt(engine, parameters, one, lines.stations),
  );
  const numbers = (name: string) => ({ data: at(name), shape: [frames.length, ...series[name].shape.slice(1)] });
  const places = {
    data: Float64Array.from(
      { length: 2 * points },
      (_, k) => bundle.lengths[Math.floor(k / points)] * lines.stations[k % points],
    ),
    shape: [2, points],
  };
  const panel: LinePanel = {
    links: ["Mode 1", "Mode 2"],
    places,
    quantities: QUANTITIES.map((one) => ({
      ...one,
      planes: ["horizontal", "vertical"],
      values: stacked(lines, one.id),
    })),
  };
  return {
    scene: {
      times: { data: rowsOf(real.run.times, 1, frames), shape: [frames.length] },
      line,
      rigid,
      reference,
      referenceRigid,
      roots: roots(phi),
      tip: numbers("tip"),
      tipReference: numbers("tip_reference"),
      colours: colours(lines, line, rigid),
      contact: bundle.contact ? { force: numbers("contact_force"), at: numbers("tip") } : null,
    },
    line: panel,
  };
}
