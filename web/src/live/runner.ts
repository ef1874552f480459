// What makes runs from a bundle, in a worker or in the page itself.

import type { LiveRun } from "../contract_parts";
import { completed as armCompleted } from "./arm_later";
import type { Regime as ArmRegime } from "./arm_regime";
import { runArm } from "./arm_run";
import type { ArmBundle, Bundle, RobotBundle } from "./bundle";
import { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { Kept } from "./kept";
import { completed as robotCompleted } from "./robot_later";
import { runRobot, type Pair, type Regime as RobotRegime } from "./robot_run";

export interface Runner {
  /** `early` hears the curves, as more of the run takes longer, and what of them must stay here for that. */
  run(values: readonly number[], watch: Watch, early?: (run: LiveRun, needed: unknown) => void): Promise<LiveRun>;
}

/** The runner of a bundle; compiles its module. */
export async function openRunner(bundle: Bundle): Promise<Runner> {
  const engine = await Engine.open(bundle.module.data as Uint8Array<ArrayBuffer>, bundle.layout);
  if (bundle.kind === "arm") {
    const kept = new Kept<ArmRegime>();
    return {
      async run(values, watch, early = () => undefined) {
        let real: ArmRegime | null = null;
        const run = await runArm(engine, bundle as ArmBundle, values, watch, kept, (moving) => { real = moving; });
        early(run, [run.times, run.series, real]);
        return armCompleted(engine, bundle as ArmBundle, values, run, real!, watch);
      },
    };
  }
  const kept = new Kept<RobotRegime>();
  return {
    async run(values, watch, early = () => undefined) {
      let pair: Pair | null = null;
      const run = await runRobot(engine, bundle as RobotBundle, values, watch, kept, (moving) => {
        pair = moving;
      });
      const deviation = run.series.deviation.data.slice();
      early(run, pair);
      return robotCompleted(engine, bundle as RobotBundle, run, pair!, deviation, watch);
    },
  };
}
