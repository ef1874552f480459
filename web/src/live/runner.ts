// What makes runs from a bundle, in a worker or in the page itself.

import type { LiveRun } from "../contract_parts";
import type { Bundle } from "./bundle";
import { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";
import { Kept } from "./kept";
import { completed, LATER } from "./later";
import { LOADS } from "./load_facts";
import { picturedOf } from "./pictured";
import { planHere, planThere, serve, type Nominal } from "./nominal";
import { curvesOf } from "./run";

export interface Runner {
  /** `early` hears the curves, then these with the picture, and what of them must stay here for what takes longer. */
  run(values: readonly number[], watch: Watch, early?: (run: LiveRun, needed: unknown) => void): Promise<LiveRun>;
}

/** The runner of a bundle; compiles its module. `partner`: at its other end somebody makes the nominal runs. */
export async function openRunner(bundle: Bundle, partner?: MessagePort): Promise<Runner> {
  const engine = await openEngine(bundle);
  const kept = new Kept<Nominal>();
  const own = planHere(engine, bundle);
  const planner = partner ? planThere(partner, own) : own;
  return {
    async run(values, watch, early = () => undefined) {
      const curves = await curvesOf(engine, bundle, values, watch, kept, planner);
      const { real, run: { times, series } } = curves;
      const needed = [times, series, real];
      early({ ...curves.run, pending: [...LATER, ...LOADS] }, needed);
      await new Promise((resolve) => setTimeout(resolve, 0));
      if (watch.cancelled?.()) throw new Cancelled("a newer run began");
      const pictured = { ...picturedOf(engine, bundle, curves), pending: LATER };
      early(pictured, needed);
      return completed(engine, bundle, values, pictured, curves, watch, (run) => early(run, needed));
    },
  };
}

/** Makes the nominal runs of a bundle for who asks at the other end of `port`. */
export async function openPlanner(bundle: Bundle, port: MessagePort): Promise<void> {
  serve(port, planHere(await openEngine(bundle), bundle));
}

function openEngine({ module, layout }: Bundle): Promise<Engine> {
  return Engine.open(module.data as Uint8Array<ArrayBuffer>, layout);
}
