// A run in the page: from values of the sliders to all that a page shows of it, as tmodes/simulation/simulate.py does.

import type { LiveRun } from "../contract_parts";
import { causesOf } from "./causes";
import { factsOf } from "./run_facts";
import { limitFact, loadFacts } from "./load_facts";
import { linePanel, loadColours } from "./load_picture";
import { loadsOf } from "./loads";
import { moved, type Name, type Regime } from "./regime";
import { sceneOf } from "./live_scene";
import { compared, seenOf, seriesOf } from "./run_series";
import { framesOf, type Bundle } from "./bundle";
import type { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { brokenOff, type Facts } from "./facts";
import type { Kept } from "./kept";
import { numbersOf } from "./map";
import { setpointsOf, spanOf } from "./span";
import * as signals from "./signals";

/**
 * The whole run; raises an error where it cannot start. `kept`: the nominal run before; `moving` hears the motion of
 * the actual robot.
 */
export async function runOf(
  engine: Engine, bundle: Bundle, values: readonly number[], watch: Watch, kept: Kept<Regime>,
  moving: (real: Regime) => void = () => undefined,
): Promise<LiveRun> {
  const began = performance.now();
  const names: Name[] = bundle.runs.reference ? ["reference", "real"] : ["real"];
  const regimes: Regime[] = [];
  for (const [k, name] of names.entries()) {
    const part: Watch = { ...watch, progress: (share) => watch.progress?.((k + share) / names.length) };
    const blocks = numbersOf(bundle.map, values, name);
    const make = () => moved(engine, bundle, values, name, blocks, part);
    regimes.push(await (name === "reference" ? kept.of(blocks, make) : make()));
  }
  const real = regimes[regimes.length - 1];
  moving(real);
  const seconds = (performance.now() - began) / 1000;
  const count = Math.min(...regimes.map((regime) => regime.run.times.length));
  const both = [real, ...regimes.slice(0, -1)];
  const seen = both.map((regime) => seenOf(engine, bundle, regime, count));
  const [own, planned] = seen;
  const times = real.run.times.subarray(0, count);
  const against = planned ? compared(bundle, own, planned, count) : {};
  const causes = causesOf(engine, bundle, both, seen, count);
  const series = { ...seriesOf(bundle, real, own, count), ...against, ...causes };
  const frames = framesOf(bundle, count);
  const end = signals.moveEnd(real.info.moving.map((k) => real.each[k]));
  const failed = regimes.find((regime) => regime.run.status !== "finished");
  const loads = loadsOf(engine, bundle, real.blocks, series, times, real.schedule, frames);
  const facts: Facts = {
    ...factsOf(bundle, times, series, end),
    ...loadFacts(loads, bundle.carried, times),
    ...limitFact(bundle.carried.limits, series),
  };
  const colours = loadColours(bundle, loads.links, frames.length);
  return {
    status: failed ? failed.run.status : "finished",
    message: failed ? `${failed === real ? "actual robot" : "nominal run"}: ${failed.run.message}` : real.run.message,
    seconds,
    times,
    series,
    scene: sceneOf(engine, bundle, real.blocks, series, times, frames, colours),
    line: linePanel(bundle, loads.links, frames.length),
    span: spanOf(times, end, setpointsOf(bundle, series)),
    facts: failed ? brokenOff(facts) : facts,
  };
}
