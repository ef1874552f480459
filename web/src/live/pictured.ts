// What a page shows of a run in space, after its curves: where the robot is, and what its links carry.

import type { LiveRun } from "../contract_parts";
import { framesOf, type Bundle } from "./bundle";
import type { Engine } from "./engine";
import { sceneOf } from "./live_scene";
import { loadFacts } from "./load_facts";
import { linePanel, loadColours } from "./load_picture";
import { loadsOf } from "./loads";
import { withLoads } from "./verdict";
import type { Curves } from "./run";

/** The same run with the picture at the display frames, the elastic line, and the numbers of the loads. */
export function picturedOf(engine: Engine, bundle: Bundle, curves: Curves): LiveRun {
  const { run, real, facts, reported } = curves;
  const { times, series } = run;
  const frames = framesOf(bundle, times.length);
  const loads = loadsOf(engine, bundle, real.blocks, series, times, real.schedule, frames);
  const colours = loadColours(bundle, loads.links, frames.length);
  curves.judged = withLoads(curves.judged, loads, bundle.carried.strengths, times);
  return {
    ...run,
    verdict: curves.judge(curves.judged),
    scene: sceneOf(engine, bundle, real.blocks, series, times, frames, colours),
    line: linePanel(bundle, loads.links, frames.length),
    facts: reported({ ...facts, ...loadFacts(loads, bundle.carried, times) }),
  };
}
