// Headline numbers of a run in the page, by the ids and words of tmodes/report/facts.py.

import { alongSum } from "../along";
import type { LiveRun } from "../contract_parts";
import { digits, info } from "../format";
import { range, worst, type SeriesOf } from "./series";

export type Facts = LiveRun["facts"];

const NEEDS_THE_END = ["settling", "vibration.residual", "vibration.nominal"];

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

/** How far the tip is from the commanded and nominal ones, and by which `parts`. */
export function trackingFacts(times: Float64Array, series: SeriesOf, parts: readonly string[]): Facts {
  const facts: Facts = {};
  const { tip_error: error } = series;
  if (error) {
    const away = Float64Array.from(times, (_, k) => alongSum(error, k, -1));
    facts["tip_error.commanded"] = largestError(times, away, error, parts);
  }
  const deviation = series.deviation?.data;
  if (deviation) {
    facts["deviation.max"] = largestError(times, deviation, series.tip_error_nominal, parts);
    facts["deviation.rms"] = {
      value: Math.sqrt(
        meanOverTime(
          times,
          deviation.map((x) => x * x),
        ),
      ),
      note: "over the run",
    };
  }
  return facts;
}

function largestError(
  times: Float64Array, sizes: Float64Array, error: SeriesOf[string] | undefined, parts: readonly string[],
): Facts[string] {
  const k = worst(sizes);
  const note = `at ${figures(times[k])} s; ${info(sizes[sizes.length - 1], "m")} at the end of the run`;
  const each = error ? range(0, error.shape[1]).map((part) => [alongSum(error, k, part), parts[part]] as const) : [];
  const words = each.filter(([size]) => size).map(([size, name]) => `${info(size, "m")} ${name ?? "geometry"}`);
  return { value: sizes[k], note, time: times[k], more: words.join(", ") };
}

/** Of a run that broke off: it has not settled, and what was largest was so until then. */
export function brokenOff(facts: Facts): Facts {
  const info: Facts = {};
  const needing = NEEDS_THE_END.filter((id) => id !== "vibration.nominal" || "deviation.max" in facts);
  for (const id of needing) info[id] = { value: null, note: "the run broke off" };
  for (const [id, fact] of Object.entries(facts)) {
    if (!needing.includes(id)) info[id] = { ...fact, note: `until it broke off: ${fact.note}` };
  }
  return info;
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
