// The curves of a run in the page, from values of the sliders, as tmodes/simulation/simulate.py finds them; what takes
// longer comes after them: pictured.ts and later.ts.

import type { LiveRun } from "../contract_parts";
import { causesOf } from "./causes";
import { factsOf } from "./run_facts";
import { limitFact } from "./load_facts";
import { moved, type Name, type Regime } from "./regime";
import { compared, plannedOf, seenOf, seriesOf, type Seen } from "./run_series";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { brokenOff, type Facts } from "./facts";
import type { Kept } from "./kept";
import { numbersOf } from "./map";
import { setpointsOf, spanOf } from "./span";
import * as signals from "./signals";

/** Curves and the numbers that follow from them, and what more of a run is made of. */
export interface Curves {
  run: LiveRun;
  /** The actual robot in motion. */
  real: Regime;
  /** Numbers as they are, and as they are reported of this run: of one that broke off, until then. */
  facts: Facts;
  reported: (facts: Facts) => Facts;
}

/** The nominal run, which many sliders leave as it is, and what was seen of it. */
export interface Nominal {
  regime: Regime;
  seen: Map<number, Seen>;
}

/** Raises an error where the run cannot start. `kept`: the nominal run before. */
export async function curvesOf(
  engine: Engine, bundle: Bundle, values: readonly number[], watch: Watch, kept: Kept<Nominal>,
): Promise<Curves> {
  const began = performance.now();
  const share = bundle.runs.reference ? 1 / 2 : 1;
  const make = (name: Name, before: number) => () => {
    const progress = (part: number) => watch.progress?.(before + share * part);
    return moved(engine, bundle, values, name, numbersOf(bundle.map, values, name), { ...watch, progress });
  };
  const nominal = bundle.runs.reference && (await kept.of(numbersOf(bundle.map, values, "reference"), async () => (
    { regime: await make("reference", 0)(), seen: new Map<number, Seen>() })));
  const real = await make("real", 1 - share)();
  const seconds = (performance.now() - began) / 1000;
  const count = Math.min(real.run.times.length, nominal?.regime.run.times.length ?? Infinity);
  const own = seenOf(engine, bundle, real, count);
  const planned = nominal && knownOf(engine, bundle, nominal, count);
  const times = real.run.times.subarray(0, count);
  const series = {
    ...seriesOf(engine, bundle, real, own, count), ...(planned ? compared(bundle, own, planned, count) : {}),
    ...causesOf(engine, bundle, [real, nominal?.regime], [own, planned], count),
  };
  const end = signals.moveEnd(real.info.moving.map((k) => real.each[k]));
  const failed = [nominal?.regime, real].find((regime) => regime && regime.run.status !== "finished");
  const facts: Facts = { ...factsOf(bundle, times, series, end), ...limitFact(bundle.carried.limits, series) };
  const reported = (all: Facts) => (failed ? brokenOff(all) : all);
  const run: LiveRun = {
    status: failed ? failed.run.status : "finished",
    message: failed ? `${failed === real ? "actual robot" : "nominal run"}: ${failed.run.message}` : real.run.message,
    seconds,
    times,
    series,
    span: spanOf(times, end, setpointsOf(bundle, series)),
    facts: reported(facts),
  };
  return { run, real, facts, reported };
}

function knownOf(engine: Engine, bundle: Bundle, { regime, seen }: Nominal, count: number): Seen {
  const known = seen.get(count) ?? plannedOf(engine, bundle, regime, count);
  seen.clear();
  seen.set(count, known);
  return known;
}
