// The curves of a run in the page, from values of the sliders, as tmodes/simulation/simulate.py finds them; what takes
// longer comes after them: pictured.ts and later.ts.

import type { Verdict } from "../contract";
import type { LiveRun } from "../contract_parts";
import { causesOf } from "./causes";
import { factsOf } from "./run_facts";
import { limitFact, limitsOf } from "./load_facts";
import type { Nominal, Planner } from "./nominal";
import { moved, type Regime } from "./regime";
import { compared, firstOf, seenOf, seriesOf } from "./run_series";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { brokenOff, type Facts } from "./facts";
import type { Kept } from "./kept";
import { numbersOf } from "./map";
import { judgedOf, unjudged, verdictOf, type Judged } from "./verdict";
import { setpointsOf, spanOf } from "./span";
import { brokenAt } from "./native";
import * as signals from "./signals";

/** Curves and the numbers that follow from them, and what more of a run is made of. */
export interface Curves {
  run: LiveRun;
  /** The actual robot in motion, the nominal one, and when the move ends [s]; null: never. */
  real: Regime;
  nominal?: Nominal;
  end: number | null;
  /** Numbers as they are, and as they are reported of this run: of one that broke off, until then. */
  facts: Facts;
  reported: (facts: Facts) => Facts;
  /** What is known of the verdict, and the verdict by what is known. */
  judged: Judged;
  judge: (found: Judged) => Verdict;
}

/** Raises an error where the run cannot start. `kept`: the nominal run before, which many sliders leave as it is. */
export async function curvesOf(
  engine: Engine, bundle: Bundle, values: readonly number[], watch: Watch, kept: Kept<Nominal>, planner: Planner,
): Promise<Curves> {
  const began = performance.now();
  const [nominal, real] = await bothMoved(engine, bundle, values, watch, kept, planner);
  const seconds = (performance.now() - began) / 1000;
  const count = Math.min(real.run.times.length, nominal?.regime.run.times.length ?? Infinity);
  const own = seenOf(engine, real, count);
  const planned = nominal && firstOf(nominal.seen, nominal.regime.run.times.length, count);
  const times = real.run.times.subarray(0, count);
  const series = {
    ...seriesOf(engine, bundle, real, own, count), ...(planned ? compared(bundle, own, planned, count) : {}),
    ...causesOf(engine, bundle, [real, nominal?.regime], [own, planned], count),
  };
  const end = signals.moveEnd(real.info.moving.map((k) => real.each[k]));
  const failed = [nominal?.regime, real].find((regime) => regime && regime.run.status !== "finished");
  const limits = bundle.carried.limits.flatMap((limit) => limitsOf(limit, series));
  const judged = judgedOf(engine, bundle, real, [own, planned], times, series, limits);
  const facts: Facts = { ...factsOf(bundle, times, series), ...limitFact(limits) };
  const reported = (all: Facts) => (failed ? brokenOff(all) : all);
  const run: LiveRun = {
    status: failed ? failed.run.status : "finished",
    message: failed ? `${failed === real ? "actual robot" : "nominal run"}: ${failed.run.message}` : real.run.message,
    seconds,
    times,
    series,
    span: spanOf(times, end, setpointsOf(bundle, series)),
    facts: reported(facts),
    ...brokenAt(bundle, values, failed?.run.status ?? ""),
  };
  const lost = Number(facts["energy.residual"]?.value) > bundle.judged.energy;
  const warned = bundle.judged.warned || real.off || lost;
  const judge = (found: Judged) =>
    verdictOf(bundle, bundle.after ? found : unjudged(found), run.status, run.message, warned);
  run.verdict = judge(judged);
  return { run, judged, judge, real, nominal, end, facts, reported };
}

/** The nominal robot, where there is one, and the actual one in motion, at once where somebody else has the former. */
async function bothMoved(
  engine: Engine, bundle: Bundle, values: readonly number[], watch: Watch, kept: Kept<Nominal>, planner: Planner,
): Promise<[Nominal | undefined, Regime]> {
  const shares = bundle.runs.reference ? [0, 0] : [0];
  const part = (k: number): Watch => ({
    ...watch,
    progress: (share) => {
      shares[k] = share;
      watch.progress?.(shares.reduce((sum, one) => sum + one, 0) / shares.length);
    },
  });
  const own = () => moved(engine, bundle, values, "real", numbersOf(bundle.map, values, "real"), part(0));
  if (!bundle.runs.reference) return [undefined, await own()];
  const other = async () => {
    const made = await kept.of(numbersOf(bundle.map, values, "reference"), () => planner.plan(values, part(1)));
    shares[1] = 1;
    return made;
  };
  if (planner.apart) return Promise.all([other(), own()]);
  const nominal = await other();
  return [nominal, await own()];
}
