// What a page shows of an arm's run a little after its curves: the parts of its deformations, and its modes.

import type { LiveRun } from "../contract_parts";
import { armVibration } from "./arm_modes";
import type { Regime } from "./arm_regime";
import { splitOf } from "./arm_split";
import type { ArmBundle } from "./bundle";
import type { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";

const PIECE = 50; // ms between two looks at whether a newer run began

/** The same run with its parts and modes; `real`: the real arm in motion. Raises Cancelled. */
export async function completed(
  engine: Engine, bundle: ArmBundle, values: readonly number[], run: LiveRun, real: Regime, watch: Watch,
): Promise<LiveRun> {
  let since = performance.now();
  const pause = async (always = false): Promise<void> => {
    if (!always && performance.now() - since < PIECE) return;
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (watch.cancelled?.()) throw new Cancelled("a newer run began");
    since = performance.now();
  };
  await pause(true);
  const { vibration, facts } = armVibration(engine, bundle, values, real.blocks, real.schedule);
  await pause(true);
  const parts = await splitOf(engine, bundle, real.blocks, real.schedule, run.times, run.series, pause);
  return { ...run, vibration, facts: { ...run.facts, ...facts }, series: { ...run.series, ...parts } };
}
