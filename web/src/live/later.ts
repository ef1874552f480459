// What a page shows of a run a little after its curves: the parts of its deformations, and its modes.

import type { LiveRun } from "../contract_parts";
import { vibrationOf } from "./vibration";
import type { Regime } from "./regime";
import { splitOf } from "./decomposition";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";

const PIECE = 50; // ms between two looks at whether a newer run began

/** The same run with its parts and modes; `real`: the actual robot in motion. Raises Cancelled. */
export async function completed(
  engine: Engine, bundle: Bundle, values: readonly number[], run: LiveRun, real: Regime, watch: Watch,
): Promise<LiveRun> {
  let since = performance.now();
  const pause = async (always = false): Promise<void> => {
    if (!always && performance.now() - since < PIECE) return;
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (watch.cancelled?.()) throw new Cancelled("a newer run began");
    since = performance.now();
  };
  await pause(true);
  const { vibration, facts } = vibrationOf(engine, bundle, values, real, run);
  await pause(true);
  const parts = await splitOf(engine, bundle, real.blocks, real.schedule, run.times, run.series, pause);
  return { ...run, vibration, facts: { ...run.facts, ...facts }, series: { ...run.series, ...parts } };
}
