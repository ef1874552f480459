// Headline numbers of a run, but for those of its loads, by the ids and words of tmodes/report/run_facts.py.

import type { Bundle } from "./bundle";
import { energyFacts, figures, meanOverTime, trackingFacts, type Facts } from "./facts";
import { columns, worst, type SeriesOf } from "./series";

/** `end`: when the move ends [s]; null where it never does. */
export function factsOf(bundle: Bundle, times: Float64Array, series: SeriesOf, end: number | null): Facts {
  const facts: Facts = { ...trackingFacts(times, series, end), ...energyFacts(series, times.length) };
  const every = bundle.deformations.flatMap((name, k) => (name.endsWith(".gear") ? [k] : []));
  const turning = every.filter((k) => bundle.turning.includes(bundle.deformations[k].replace(/\.gear$/, "")));
  const gears = turning.length ? turning : every; // as the page's own fact: radians and meters are not compared
  if (gears.length) {
    const angles = columns(series.deformation.data, bundle.deformations.length, gears);
    const k = worst(angles);
    const name = bundle.deformations[gears[k % gears.length]].replace(/\.gear$/, "");
    const others = gears.length < every.length ? " (of the gears that turn)" : "";
    facts["gear.max"] = {
      value: Math.abs(angles[k]),
      note: `${name}, at ${figures(times[Math.floor(k / gears.length)])} s${others}`,
    };
  }
  const force = series.contact_force_normal?.data;
  if (force) {
    const [least, most] = [force.reduce((a, b) => Math.min(a, b)), force.reduce((a, b) => Math.max(a, b))];
    facts["contact.mean"] = {
      value: meanOverTime(times, force),
      note: `from ${figures(least, 4)} to ${figures(most, 4)} N`,
    };
  }
  return facts;
}
