// What makes runs from a bundle, in a worker or in the page itself.

import type { LiveRun } from "../contract_parts";
import type { Bundle } from "./bundle";
import { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { Kept } from "./kept";
import { completed } from "./later";
import type { Regime } from "./regime";
import { runOf } from "./run";

export interface Runner {
  /** `early` hears the curves, as more of the run takes longer, and what of them must stay here for that. */
  run(values: readonly number[], watch: Watch, early?: (run: LiveRun, needed: unknown) => void): Promise<LiveRun>;
}

/** The runner of a bundle; compiles its module. */
export async function openRunner(bundle: Bundle): Promise<Runner> {
  const engine = await Engine.open(bundle.module.data as Uint8Array<ArrayBuffer>, bundle.layout);
  const kept = new Kept<Regime>();
  return {
    async run(values, watch, early = () => undefined) {
      let real: Regime | null = null;
      const run = await runOf(engine, bundle, values, watch, kept, (moving) => { real = moving; });
      early(run, [run.times, run.series, real]);
      return completed(engine, bundle, values, run, real!, watch);
    },
  };
}
