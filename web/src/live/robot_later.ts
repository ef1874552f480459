// What a page shows of the 2010 robot's run a little after its curves: parts of its deformations, modes, settling.

import type { LiveRun } from "../contract_parts";
import type { RobotBundle } from "./bundle";
import type { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";
import { robotVibration } from "./robot_modes";
import { deformations, STATE, type Pair } from "./robot_run";
import { settlingFact } from "./robot_settling";
import { staticRoots } from "./robot_static";
import { beside, columns, difference, shaped, type SeriesOf } from "./series";

/** The same run with all of it; `deviation` [n]: that of its tip. Raises Cancelled. */
export async function completed(
  engine: Engine,
  bundle: RobotBundle,
  run: LiveRun,
  pair: Pair,
  deviation: Float64Array,
  watch: Watch,
): Promise<LiveRun> {
  const pause = async (): Promise<void> => {
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (watch.cancelled?.()) throw new Cancelled("a newer run began");
  };
  await pause();
  const parts = partsOf(engine, bundle, pair);
  const { vibration, facts } = robotVibration(engine, bundle, pair.real.numbers);
  await pause();
  const settled = run.status === "finished" ? await settlingFact(engine, bundle, pair, deviation, watch) : {};
  return { ...run, vibration, facts: { ...run.facts, ...facts, ...settled }, series: { ...run.series, ...parts } };
}

/** T_st, what the loads of each instant would hold by elasticity alone, and T_to, what swings about it. */
function partsOf(engine: Engine, bundle: RobotBundle, { real, seen, count }: Pair): SeriesOf {
  const states = real.run.states.subarray(0, count * STATE);
  const angles = deformations(states);
  const gross = beside(count, columns(states, STATE, [5, 11]), columns(seen.acceleration, 6, [5]), seen.contact_force);
  const held = staticRoots(engine, bundle, "real.quasistatic", real.numbers.parameters, gross, angles, count).angles;
  return {
    deformation_stationary: shaped(held, count, 5),
    deformation_oscillatory: shaped(difference(angles, held), count, 5),
  };
}
