// How a run starts under its controllers: in the equilibrium of the closed loop at its first setpoints.

import { doubles, type BalanceInfo, type RunInfo } from "./bundle";
import type { Engine } from "./engine";
import { solveInPlace } from "./linear";
import type { Blocks } from "./map";
import { isSmall, LITTLE, LONGEST, SHORTEST, STEP, STEPS, STRAY } from "./rest";
import { rowsAt, type Schedule } from "./signals";

const STANDS = 1e-11; // first step, over 1 + |q|, of a state that is in balance already

/** The row of signals that stay at their first values, without noise. */
function stillRow(signals: Schedule, noise: readonly number[]): Float64Array {
  const row = rowsAt(signals, new Float64Array(1));
  const width = signals.degree + 1;
  for (let k = 0; k < signals.signals; k += 1) {
    row.fill(0, 1 + k * width + (noise.includes(k) ? 0 : 1), 1 + (k + 1) * width);
  }
  return row;
}

/** The equations of rest of one closed loop at given numbers. */
class ClosedLoop {
  private inputs: Record<string, Float64Array>;
  private weighs: Float64Array;

  constructor(
    private engine: Engine, private info: BalanceInfo, private run: string, private parameters: Float64Array,
    signals: Schedule,
  ) {
    this.inputs = { time: new Float64Array(1), row: stillRow(signals, info.noise), step: new Float64Array(1) };
    this.weighs = doubles(info.weighs);
  }

  /** Rates of some states, row by row. */
  rates(states: Float64Array): Float64Array {
    const { function: name, size } = this.info;
    const inputs = { ...this.inputs, state: states };
    return this.engine.sample(`${this.run}.${name}`, this.parameters, inputs, states.length / size).rate;
  }

  /** What must vanish at a state. */
  left(at: Float64Array): Float64Array {
    const rates = this.rates(at);
    return Float64Array.from(this.info.equations, (place) => rates[place]);
  }

  /** The step of Newton's method off a state at which so much is `left`; null where there is none. */
  step(at: Float64Array, left: (i: number) => number): Float64Array | null {
    const { unknown, equations, size } = this.info;
    const n = unknown.length;
    const states = new Float64Array((n + 1) * size);
    for (let row = 0; row <= n; row += 1) states.set(at, row * size);
    unknown.forEach((place, j) => (states[(j + 1) * size + place] += STEP));
    const rates = this.rates(states);
    const matrix = new Float64Array(n * n);
    for (let i = 0; i < n; i += 1)
      for (let j = 0; j < n; j += 1)
        matrix[i * n + j] = (rates[(j + 1) * size + equations[i]] - rates[equations[i]]) / STEP;
    const right = Float64Array.from(equations, (place, i) => rates[place] - left(i));
    return solveInPlace(matrix, right) ? right : null;
  }

  /** How far a step moves coordinates [rad, m]. */
  length(step: Float64Array | null): number {
    return step ? step.reduce((most, value, i) => Math.max(most, Math.abs(value * this.weighs[i])), 0) : NaN;
  }

  /** The state at which so much is `left`, near by and on the same branch; null where there is none. */
  near(from: Float64Array, left: (i: number) => number): Float64Array | null {
    const at = from.slice();
    let [first, corrected, before] = [0, 0, Infinity];
    for (let k = 0; k < STEPS; k += 1) {
      const step = this.step(at, left);
      const length = this.length(step);
      if (!step || !Number.isFinite(length)) return null;
      if (k === 0) first = length;
      else corrected += length;
      if (first > LITTLE && (corrected > STRAY * first || first > LONGEST)) return null;
      this.info.unknown.forEach((place, i) => (at[place] -= step[i]));
      if (isSmall(length, before)) return at;
      before = length;
    }
    return null;
  }
}

/**
 * A state of a run, whose motors are held, in the equilibrium of its closed loop, as simulation/balance.py: at once, or
 * by letting go of the motors in steps. Itself where it is one; null where there is none.
 */
export function balanced(
  engine: Engine, info: BalanceInfo | null, blocks: Blocks, run: string, signals: Schedule, state: Float64Array,
): Float64Array | null {
  if (!info) return state;
  const loop = new ClosedLoop(engine, info, run, blocks.parameters, signals);
  const reach = 1 + info.places.reduce((most, [, place]) => Math.max(most, Math.abs(state[place])), 0);
  let here: Float64Array = new Float64Array(info.size);
  for (const [own, place] of info.places) here[own] = state[place];
  const held = loop.left(here);
  if (!(loop.length(loop.step(here, () => 0)) > STANDS * reach)) return state;
  for (let [share, step] = [0, 1]; share < 1; ) {
    const next = Math.min(1, share + step);
    const there = loop.near(here, (i) => (1 - next) * held[i]);
    if (there) [here, share, step] = [there, next, 2 * step];
    else if (step > SHORTEST) step /= 2;
    else return null;
  }
  const found = state.slice();
  for (const [own, place] of info.places) found[place] = here[own];
  return found;
}

/** Set the commands that are held to those that hold the robot where it starts: accelerations are affine in them. */
function hold(
  engine: Engine, info: RunInfo, blocks: Blocks, run: string, row: Float64Array, state: Float64Array,
): void {
  const [commands, size, { v }] = [info.sampledCommands, state.length, info.state];
  const n = commands.length;
  for (const [, places] of commands) for (const place of places) state[place] = 0;
  const states = new Float64Array((n + 1) * size);
  for (let k = 0; k <= n; k += 1) {
    states.set(state, k * size);
    states.fill(0, k * size + v[0], k * size + v[1]);
    if (k) states[k * size + commands[k - 1][1][0]] = 1;
  }
  const inputs = { time: new Float64Array(1), state: states, row, step: new Float64Array(1) };
  const { rate } = engine.sample(`${run}.rate`, blocks.parameters, inputs, n + 1);
  const at = (k: number, i: number) => rate[k * size + v[0] + commands[i][0]];
  const matrix = new Float64Array(n * n);
  for (let i = 0; i < n; i += 1) for (let j = 0; j < n; j += 1) matrix[i * n + j] = at(j + 1, i) - at(0, i);
  const efforts = Float64Array.from(commands, (_, i) => -at(0, i));
  if (!solveInPlace(matrix, efforts)) return;
  commands.forEach(([, places], k) => { for (const place of places) state[place] = efforts[k]; });
}

/** A first state with the outputs that are held before the first sample, as simulation/balance.py. */
export function begun(
  engine: Engine, info: RunInfo, blocks: Blocks, run: string, signals: Schedule, state: Float64Array, still: boolean,
): Float64Array {
  const [row, width] = [stillRow(signals, info.noise), signals.degree + 1];
  for (const k of info.late) row.fill(0, 1 + k * width, 1 + (k + 1) * width);
  let found = state.slice();
  for (let k = 0; k < info.samples; k += 1) {
    const inputs = { time: new Float64Array(1), state: found, row, step: new Float64Array(1) };
    const after = engine.sample(`${run}.sampled`, blocks.parameters, inputs, 1).state;
    found = state.slice();
    for (const place of info.held) found[place] = after[place];
  }
  if (info.samples && !still) hold(engine, info, blocks, run, row, found);
  return found;
}
