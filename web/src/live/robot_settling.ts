// How long the tip still strays after the move: both runs are carried on until it is known, as analysis/settling.py.

import { doubles, type RobotBundle } from "./bundle";
import { damped, undamped } from "./eigen";
import type { Engine } from "./engine";
import { Cancelled, integrate, type Watch } from "./engine_run";
import { BAND, figures, settled, type Facts } from "./facts";
import { product } from "./linear";
import { addControl } from "./robot_modes";
import { observed, STATE, type Pair, type Regime } from "./robot_run";
import { difference, sizes } from "./series";
import type { Schedule } from "./signals";

const N = 6;
const HORIZON = 30; // s
const DECAYS = 4;
const SAMPLES = 6000;
const STILL = 1e-9; // imaginary over absolute value of an eigenvalue below which its motion does not ring
const FIXED_STEP = ["rk4", "midpoint"];
const [MOTOR, MOTOR_RATE] = [5, 11];

/** The headline number; `deviation` [n] is that of the run. Raises Cancelled. */
export async function settlingFact(
  engine: Engine,
  bundle: RobotBundle,
  { reference, real }: Pair,
  deviation: Float64Array,
  watch: Watch,
): Promise<Facts> {
  try {
    return await settling(engine, bundle, reference, real, deviation, { ...watch, progress: () => undefined });
  } catch (problem) {
    if (problem instanceof Cancelled) throw problem;
    return unseen(problem instanceof Error ? problem.message : String(problem));
  }
}

async function settling(
  engine: Engine, bundle: RobotBundle, reference: Regime, real: Regime, deviation: Float64Array, watch: Watch,
): Promise<Facts> {
  const times = real.run.times;
  const end = real.numbers.end[0];
  const last = times[times.length - 1];
  if (last < end * (1 - 1e-9))
    return unseen(`the run ends before the move does, at ${figures(end, 6)} s: simulate longer`);
  if (FIXED_STEP.includes(bundle.settings.method)) return unseen("the page carries no run on by steps of one length");
  const decays = [
    slowestDecay(engine, bundle, reference, "locked"),
    slowestDecay(engine, bundle, real, "controlled"),
  ].filter(Number.isFinite);
  const slowest = Math.max(decays.length ? Math.min(...decays) : 1, 1e-9);
  const horizon = Math.min(HORIZON, DECAYS / slowest);
  const carried: Regime[] = [];
  for (const [regime, held] of [
    [reference, true],
    [real, false],
  ] as const)
    carried.push(await carriedOn(engine, bundle, regime, held, horizon, watch));
  const lost = carried.find((regime) => regime.run.status !== "finished");
  if (lost) return unseen(`continued beyond its end, the run did not come far: ${lost.run.message}`);
  const [wanted, own] = carried.map((regime) => observed(engine, regime, SAMPLES + 1).tip);
  const afterwards = sizes(difference(own, wanted), 3).subarray(1);
  const whole = {
    times: joined(
      times,
      carried[1].run.times.subarray(1).map((time) => last + time),
    ),
    deviation: joined(deviation, afterwards),
  };
  const { value, limit, strayed } = settled(whole.times, whole.deviation, end);
  if (strayed > whole.times[whole.times.length - 1] - BAND * horizon)
    return unseen(
      `the deviation is still ${figures(whole.deviation[whole.deviation.length - 1])} m ` +
        `${figures(horizon)} s after the end of the run`,
    );
  return { settling: { value, note: limit } };
}

function unseen(why: string): Facts {
  return { settling: { value: null, note: `not seen: ${why}` } };
}

function joined(first: Float64Array, second: Float64Array): Float64Array {
  return Float64Array.from([...first, ...second]);
}

/** Smallest decay rate [1/s] of the vibrations about rest that ring; infinite where none does. */
function slowestDecay(engine: Engine, bundle: RobotBundle, { name, numbers, run }: Regime, state: string): number {
  const free = bundle.modes.cases.find((one) => one.name === state);
  if (!free) return Infinity;
  const columns = doubles(free.columns);
  const m = columns.length / N;
  if (!m) return Infinity;
  const { linear } = engine.sample(`${name}.linear`, numbers.parameters, { phi: run.states.slice(0, N) }, 1);
  const matrices = [0, 1, 2].map((k) => linear.slice(k * N * N, (k + 1) * N * N));
  if (state === "controlled") addControl(bundle, numbers.parameters, matrices);
  const [mass, damping, stiffness] = matrices.map((matrix) =>
    product(columns, product(matrix, columns, N, N, m), m, N, m, true),
  );
  const { re, im } = damped(mass, damping, stiffness, m, undamped(mass, stiffness, m)).values;
  const decays = Array.from(re, (value, k) => (Math.abs(im[k]) > STILL * Math.hypot(value, im[k]) ? -value : Infinity));
  return Math.min(...decays);
}

/** The regime from where it ended, its wanted motor angle at rest; `held`: its motor is where it is wanted. */
async function carriedOn(
  engine: Engine,
  bundle: RobotBundle,
  regime: Regime,
  held: boolean,
  horizon: number,
  watch: Watch,
): Promise<Regime> {
  const { name, numbers, run } = regime;
  const [goal] = numbers.goal;
  const state = run.states.slice(-STATE);
  if (held) [state[MOTOR], state[MOTOR_RATE]] = [goal, 0];
  const { signals, degree } = regime.schedule;
  const schedule: Schedule = {
    knots: Float64Array.of(0, horizon),
    coefficients: new Float64Array(degree + 1),
    signals,
    degree,
  };
  schedule.coefficients[0] = goal;
  const times = Float64Array.from({ length: SAMPLES + 1 }, (_, k) => (k * horizon) / SAMPLES);
  const settings = { ...bundle.settings, duration: horizon };
  const rows = Float64Array.from([0, ...schedule.coefficients]);
  const loop = `${name}.${settings.method}`;
  const onward = await integrate(
    engine,
    { loop, parameters: numbers.parameters, knots: schedule.knots, rows, state, times, settings },
    watch,
  );
  return { ...regime, schedule, run: onward };
}
