// Headline numbers of the loads along the links, and of the joints' limits, as tmodes/report/facts.py.

import type { Verdict } from "../contract";
import { info } from "../format";
import type { Largest, LimitInfo, Loads, LoadsInfo, Quantity } from "./loads";
import { figures, type Facts } from "./facts";
import { columns, type SeriesOf } from "./series";

/** What follows from loads. */
export const LOADS = ["limits", "deflection.max", "moment.max", "stress.max", "stress.share"];

export function loadFacts(loads: Loads, { strengths, places, kept }: LoadsInfo, times: Float64Array): Facts {
  const part = [
    loads.every > 1 ? `one sample in ${loads.every}` : "",
    kept > places.data.length ? `${places.data.length} places along each link` : "",
  ];
  const seen = part.some(Boolean) ? ` (looked at: ${part.filter(Boolean).join(", ")})` : "";
  const of = (name: Quantity) => loads.links.flatMap(({ largest }) => largest[name] ?? []);
  const fact = (id: string, found: Largest[]): Facts => {
    const one = most(found, ({ value }) => value);
    const place = one && id !== "deflection.max" ? ` at s = ${figures(one.s, 2)}` : "";
    const time = one ? times[one.sample] : 0;
    return one ? { [id]: { value: one.value, note: `${one.link}${place}, at ${figures(time)} s${seen}`, time } } : {};
  };
  const share = most(
    of("stress").filter(({ link }) => link in strengths),
    ({ link, value }) => value / strengths[link],
  );
  const strength = share ? strengths[share.link] : 1;
  const margin =
    share &&
    `of ${info(strength, "Pa")}, ${share.link}; margin ${figures(100 * (1 - share.value / strength))} %${seen}`;
  return {
    ...fact("deflection.max", of("deflection")),
    ...fact("moment.max", of("moment")),
    ...fact("stress.max", of("stress")),
    ...(share && margin ? { "stress.share": { value: (100 * share.value) / strength, note: margin } } : {}),
  };
}

/** How near a run comes to a limit, as `limits_of` of tmodes/result/verdict.py. */
export type Limit = Verdict["limits"][number];

/** The largest share of a limit of a joint: of its speed, its effort, its range (from its middle). */
export function limitFact(limits: Limit[]): Facts {
  const worst = most(limits, ({ share }) => share);
  if (!worst) return {};
  const { quantity, element, value, limit, unit } = worst;
  const of = `${quantity} of ${element}`;
  const note = quantity === "range" ? `${of}, from its middle` : `${of}: ${info(value, unit)} of ${info(limit, unit)}`;
  return { "limits.share": { value: 100 * worst.share, note } };
}

/** Of one joint: its speed, its effort, its range (from its middle). */
export function limitsOf(
  { joint, coordinate, drive, unit, effortUnit, speed, effort, range }: LimitInfo, series: SeriesOf,
): Limit[] {
  const largest = (name: string, column: number, middle = 0) =>
    columns(series[name].data, series[name].shape[1], [column]).reduce(
      (size, value) => Math.max(size, Math.abs(value - middle)),
      0,
    );
  const shared = (quantity: string, value: number, limit: number, of: string) =>
    ({ quantity, element: joint, value, limit, unit: of, share: value / limit });
  return [
    ...(speed ? [shared("speed", largest("v", coordinate), speed, `${unit}/s`)] : []),
    ...(effort && drive >= 0 ? [shared("effort", largest("effort", drive), effort, effortUnit)] : []),
    ...(range ? [shared("range", largest("q", coordinate, range[0]), range[1], unit)] : []),
  ];
}

function most<T>(all: T[], size: (one: T) => number): T | null {
  return all.reduce<T | null>((best, one) => (best === null || size(one) > size(best) ? one : best), null);
}
