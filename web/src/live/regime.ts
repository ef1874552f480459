// One robot in motion, the nominal (reference) or the actual one: its numbers, its signals and its run.

import { balanced, begun } from "./balance";
import { firstState } from "./rest";
import { doubles, type Bundle, type RunInfo } from "./bundle";
import type { Engine } from "./engine";
import { integrate, type RunResult, type Watch } from "./engine_run";
import type { Blocks } from "./map";
import { range } from "./series";
import * as signals from "./signals";

export type Name = "reference" | "real";

/** One arm in motion, and what is observed of it. */
export interface Regime {
  name: Name;
  info: RunInfo;
  blocks: Blocks;
  /** Its signals one by one, as far as they are known, and together up to the end of the run. */
  each: signals.Schedule[];
  schedule: signals.Schedule;
  run: RunResult;
  /** It starts with held motors, which its drives do not hold: that is no equilibrium. */
  off: boolean;
}

const MOST_SWITCHES = 100;

/** A first state after all that sticks, slips or touches has switched, as simulation/loop.py; works begin at zero. */
function settled(
  engine: Engine, bundle: Bundle, name: Name, blocks: Blocks, schedule: signals.Schedule, state: Float64Array,
): Float64Array {
  const time = new Float64Array(1);
  const inputs = { time, row: signals.rowsAt(schedule, time), step: new Float64Array(1) };
  for (let k = 0; `${name}.switched` in engine.layout.samples && k < MOST_SWITCHES; k += 1) {
    const before = state;
    state = engine.sample(`${name}.switched`, blocks.parameters, { ...inputs, state }, 1).state;
    if (state.every((value, i) => value === before[i])) break;
  }
  return state.fill(0, ...bundle.runs[name]!.state.works);
}

/** Its run from a first state. */
export function runFrom(
  engine: Engine, { settings, times }: Bundle, { name, blocks, schedule }: Pick<Regime, "name" | "blocks" | "schedule">,
  state: Float64Array, watch: Watch,
): Promise<RunResult> {
  return integrate(engine, {
    loop: `${name}.${settings.method}`, parameters: blocks.parameters, knots: schedule.knots,
    rows: signals.rowsOf(schedule), state, times: doubles(times), settings,
  }, watch);
}

/** It in motion with these numbers; raises an error where it cannot start. */
export async function moved(
  engine: Engine, bundle: Bundle, values: readonly number[], name: Name, blocks: Blocks, watch: Watch,
): Promise<Regime> {
  const { settings } = bundle;
  const info = bundle.runs[name]!;
  const each = range(0, info.signals).map((k) => signals.schedule(blocks[`knots.${k}`], blocks[`coefficients.${k}`]));
  const schedule = signals.merged(each.map((one) => signals.until(one, settings.duration)));
  if (!each.length) schedule.knots[1] = settings.duration;
  const held = firstState(engine, bundle, values, name, blocks);
  const still = balanced(engine, info.balance, blocks, name, schedule, held);
  const first = begun(engine, info, blocks, name, schedule, still ?? held, !!(info.balance && still));
  const state = settled(engine, bundle, name, blocks, schedule, first);
  const run = await runFrom(engine, bundle, { name, blocks, schedule }, state, watch);
  return { name, info, blocks, each, schedule, run, off: !still };
}
