// What makes runs from a bundle, in a worker or in the page itself.

import type { LiveRun } from "../contract_parts";
import type { Bundle } from "./bundle";
import { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";
import { Kept } from "./kept";
import { completed } from "./later";
import { picturedOf } from "./pictured";
import { curvesOf, type Nominal } from "./run";

export interface Runner {
  /** `early` hears the curves, then these with the picture, and what of them must stay here for what takes longer. */
  run(values: readonly number[], watch: Watch, early?: (run: LiveRun, needed: unknown) => void): Promise<LiveRun>;
}

/** The runner of a bundle; compiles its module. */
export async function openRunner(bundle: Bundle): Promise<Runner> {
  const engine = await Engine.open(bundle.module.data as Uint8Array<ArrayBuffer>, bundle.layout);
  const kept = new Kept<Nominal>();
  return {
    async run(values, watch, early = () => undefined) {
      const curves = await curvesOf(engine, bundle, values, watch, kept);
      const { real, run: { times, series } } = curves;
      const needed = [times, series, real];
      early(curves.run, needed);
      await new Promise((resolve) => setTimeout(resolve, 0));
      if (watch.cancelled?.()) throw new Cancelled("a newer run began");
      const pictured = picturedOf(engine, bundle, curves);
      early(pictured, needed);
      return completed(engine, bundle, values, pictured, real, watch);
    },
  };
}
