// Headline numbers of a run in the page, by the ids and words of tmodes/report/facts.py.

import type { LiveRun } from "../contract_parts";
import { digits, info } from "../format";
import { sizes, worst, type SeriesOf } from "./series";

export type Facts = LiveRun["facts"];

const FEWEST = 8;
const NEEDS_THE_END = ["settling", "vibration.residual"];

/** A number in so many figures. */
export function figures(value: number, count = 3): string {
  return digits(value, count);
}

/** Mean over time; the last sample may follow a shorter step. */
export function meanOverTime(times: Float64Array, values: Float64Array): number {
  if (times.length < 2) return values[0];
  let total = 0;
  for (let k = 1; k < times.length; k += 1) total += ((values[k] + values[k - 1]) / 2) * (times[k] - times[k - 1]);
  return total / (times[times.length - 1] - times[0]);
}

/** How far the tip is from its reference, how long it takes to settle, how it swings after the move. */
export function trackingFacts(times: Float64Array, series: SeriesOf, moveEnd: number | null): Facts {
  const facts: Facts = {};
  const deviation = series.deviation?.data;
  if (deviation) {
    const k = worst(deviation);
    const end = deviation[deviation.length - 1];
    facts["deviation.max"] = {
      value: deviation[k],
      note: `at ${figures(times[k])} s; ${info(end, "m")} at the end of the run`,
    };
    facts["deviation.rms"] = {
      value: Math.sqrt(
        meanOverTime(
          times,
          deviation.map((x) => x * x),
        ),
      ),
      note: "over the run",
    };
    const unseen = unsettled(times, moveEnd);
    if (unseen) facts.settling = unseen;
  }
  facts["vibration.residual"] = vibration(times, series, moveEnd);
  return facts;
}

/**
 * Why settling is not seen; null where the native run carries on beyond its end to see it. The page does not carry on:
 * it then gives no number of its own, and the original run's stays, marked as such.
 */
function unsettled(times: Float64Array, moveEnd: number | null): Facts[string] | null {
  const end = times[times.length - 1];
  if (moveEnd === null) return { value: null, note: "not seen: what moves the arm changes up to the end of the run" };
  if (moveEnd <= end * (1 + 1e-9)) return null;
  const when = `the run ends at ${figures(end, 6)} s, the move at ${figures(moveEnd, 6)} s`;
  return { value: null, note: `not seen: ${when}: simulate longer to see it settle` };
}

/** Of a run that broke off: it has not settled, and what was largest was so until then. */
export function brokenOff(facts: Facts): Facts {
  const info: Facts = {};
  const needing = NEEDS_THE_END.filter((id) => id !== "settling" || "deviation.max" in facts);
  for (const id of needing) info[id] = { value: null, note: "the run broke off" };
  for (const [id, { value, note }] of Object.entries(facts)) {
    if (!needing.includes(id)) info[id] = { value, note: `until it broke off: ${note}` };
  }
  return info;
}

function vibration(times: Float64Array, series: SeriesOf, moveEnd: number | null): Facts[string] {
  if (moveEnd === null) return { value: null, note: "what moves the robot changes up to the end of the run" };
  const first = times.findIndex((time) => time > moveEnd * (1 + 1e-9));
  if (first < 0 || times.length - first < FEWEST) return { value: null, note: "the run ends with the move" };
  const planned = series.tip_reference?.data;
  const tip = series.tip.data.map((value, k) => value - (planned ? planned[k] : 0)).subarray(3 * first);
  const mean = [0, 1, 2].map(
    (axis) => tip.reduce((sum, value, k) => (k % 3 === axis ? sum + value : sum), 0) / (tip.length / 3),
  );
  const away = sizes(tip.map((value, k) => value - mean[k % 3]), 3);
  return { value: away[worst(away)], note: `about its mean place, from ${figures(times[first])} s on` };
}

/** How well the energies add up: the worst residual of their balance over what was moved. */
export function energyFacts(series: SeriesOf, count: number): Facts {
  if (!series.energy || !series.energy_balance) return {};
  const { energy, work } = series;
  const kinds = energy.shape[1];
  const moved = Math.max(
    energy.data.reduce((most, value, k) => Math.max(most, Math.abs(value - energy.data[k % kinds])), 0),
    work.data.reduce((most, value) => Math.max(most, Math.abs(value)), 0),
  );
  const residual = Math.abs(series.energy_balance.data[worst(series.energy_balance.data.subarray(0, count))]);
  const note = moved ? `worst residual, ${info(residual, "J")}, over ${info(moved, "J")} moved` : "nothing moved";
  return { "energy.residual": { value: moved ? residual / moved : null, note } };
}
