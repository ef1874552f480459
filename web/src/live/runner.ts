// What makes runs from a bundle, in a worker or in the page itself.

import type { LiveRun } from "../contract_parts";
import { completed } from "./arm_later";
import type { Regime as ArmRegime } from "./arm_regime";
import { runArm } from "./arm_run";
import type { ArmBundle, Bundle, RobotBundle } from "./bundle";
import { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { Kept } from "./kept";
import { runRobot, type Regime as RobotRegime } from "./robot_run";
import { withSettling } from "./robot_settling";

export interface Runner {
  /** `early` hears the curves where more of the run takes longer. */
  run(values: readonly number[], watch: Watch, early?: (run: LiveRun) => void): Promise<LiveRun>;
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
        early(run);
        return completed(engine, bundle as ArmBundle, values, run, real!, watch);
      },
    };
  }
  const kept = new Kept<RobotRegime>();
  return {
    async run(values, watch, early = () => undefined) {
      const regimes: RobotRegime[] = [];
      const run = await runRobot(engine, bundle as RobotBundle, values, watch, kept, (...both) =>
        regimes.push(...both),
      );
      early(run);
      return withSettling(engine, bundle as RobotBundle, run, regimes[0], regimes[1], watch);
    },
  };
}
