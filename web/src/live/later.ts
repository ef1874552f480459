// What a page shows of a run a little after its curves: how it settles, the parts of its deformations, and its modes.

import type { LiveRun } from "../contract_parts";
import { afterMove, laterOf, settledOf, vibrationAfter } from "./after";
import { naturalOf, settlingFact, vibrationFact } from "./after_facts";
import { elementsOf, unrestOf, type SeenMode } from "./vibrating";
import { vibrationOf } from "./vibration";
import type { Regime } from "./regime";
import type { Curves } from "./run";
import { splitOf } from "./decomposition";
import { approximate } from "./native";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";
import type { Facts } from "./facts";
import type { Residual } from "./residual";
import type { Settled } from "./settling";
import { withRest } from "./verdict";

const PIECE = 50; // ms between two looks at whether a newer run began
const QUIET = 100; // ms without a newer run before what takes longer begins

/** What comes later of a run, by the ids of facts. */
export const LATER = ["settling", "residual", "vibration.residual", "vibration.nominal", "frequency.first"];

/** The same run with all of it, `early` when it is known how it settles. Raises Cancelled. */
export async function completed(
  engine: Engine, bundle: Bundle, values: readonly number[], run: LiveRun, curves: Curves, watch: Watch,
  early: (run: LiveRun) => void,
): Promise<LiveRun> {
  const { real } = curves;
  let since = performance.now();
  const pause = async (always = false): Promise<void> => {
    if (!always && performance.now() - since < PIECE) return;
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (watch.cancelled?.()) throw new Cancelled("a newer run began");
    since = performance.now();
  };
  await new Promise((resolve) => setTimeout(resolve, QUIET));
  await pause(true);
  const after = await settled(engine, bundle, curves, watch, pause);
  if (after.settled && after.vibration) curves.judged = withRest(curves.judged, after.settled, after.vibration);
  const rested: LiveRun = {
    ...run, verdict: curves.judge(curves.judged), facts: { ...run.facts, ...curves.reported(after.facts) },
    pending: ["frequency.first"],
  };
  early(rested);
  await pause(true);
  const { vibration, facts } = vibrationOf(engine, bundle, values, real, run, after.seen);
  await pause(true);
  const parts = await splitOf(engine, bundle, real.blocks, real.schedule, run.times, run.series, pause);
  const none = { value: null, note: typeof vibration === "string" ? vibration : "" };
  const whole: LiveRun = {
    ...rested, vibration, facts: { ...rested.facts, "frequency.first": none, ...facts },
    series: { ...run.series, ...parts }, pending: undefined,
  };
  early(whole);
  await pause(true);
  return { ...whole, ...await approximate(engine, bundle, values, curves, watch) };
}

/** How both runs settle and vibrate after the move, and what modes are seen of the actual one. */
async function settled(
  engine: Engine, bundle: Bundle, { run, real, nominal, end }: Curves, watch: Watch,
  pause: () => Promise<void>,
): Promise<{ facts: Facts; seen: SeenMode[]; settled?: Settled; vibration?: Residual }> {
  if (!bundle.after || run.status !== "finished") return { facts: {}, seen: [] };
  const facts: Facts = {};
  const seenOf = async (regime: Regime, name: string) => {
    const found = await afterMove(engine, bundle, regime, end, watch);
    const later = laterOf(found);
    const rests = end === null || end >= found.times[found.times.length - 1]
      || settledOf(bundle, found, "", true).time !== null;
    const [unrest, still] = rests ? ["", false] : unrestOf(engine, bundle, regime.blocks, later.times, later.q);
    const vibration = await vibrationAfter(bundle, found, still, pause);
    if (unrest && !vibration.modes.length) vibration.reason = unrest;
    const since = later.times.map((time) => time - (end ?? 0));
    await pause();
    const elements = elementsOf(engine, bundle, regime.blocks, since, later.q, vibration);
    facts[name] = vibrationFact(vibration, found, elements);
    return { found, unrest: still || !found.cut ? unrest : "", vibration, seen: vibration.modes.map((mode, k) => (
      { frequency: naturalOf(mode), damping: mode.damping, element: elements[k] ?? "" }
    )) };
  };
  const { found, unrest, vibration, seen } = await seenOf(real, "vibration.residual");
  const settled = settledOf(bundle, found, unrest);
  facts.settling = settlingFact(settled, found, bundle.after.settling.within);
  if (nominal) {
    if (!nominal.vibration) await seenOf(nominal.regime, "vibration.nominal");
    facts["vibration.nominal"] ??= nominal.vibration!;
    nominal.vibration = facts["vibration.nominal"];
  }
  return { facts, seen, settled, vibration };
}
