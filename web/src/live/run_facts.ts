// Headline numbers of a run, but for those of its loads, by the ids and words of tmodes/report/facts.py.

import type { Bundle } from "./bundle";
import { energyFacts, figures, meanOverTime, trackingFacts, type Facts } from "./facts";
import { columns, range, worst, type SeriesOf } from "./series";

/** Of the curves. */
export function factsOf(bundle: Bundle, times: Float64Array, series: SeriesOf): Facts {
  const tracking = trackingFacts(times, series, bundle.errorParts ?? []);
  const facts: Facts = { ...tracking, ...energyFacts(series, times.length) };
  const every = bundle.deformations.flatMap((name, k) => (name.endsWith(".gear") ? [k] : []));
  const turning = every.filter((k) => bundle.turning.includes(bundle.deformations[k].replace(/\.gear$/, "")));
  const gears = turning.length ? turning : every; // as the page's own fact: radians and meters are not compared
  if (gears.length) {
    const angles = columns(series.deformation.data, bundle.deformations.length, gears);
    const others = gears.length < every.length ? " (of the gears that turn)" : "";
    const { value, note } = largest(times, angles, gears.map((k) => bundle.deformations[k].replace(/\.gear$/, "")));
    facts["gear.max"] = { value, note: `${note}${others}` };
  }
  const { drives } = bundle.layout;
  const all = range(0, drives.length);
  const turned = all.filter((k) => bundle.turning.includes(drives[k]));
  for (const [name, kept] of [["gear_torque", turned.length ? turned : all], ["voltage", all]] as const) {
    if (!series[name]) continue;
    const found = largest(times, columns(series[name].data, drives.length, kept), kept.map((k) => drives[k]));
    if (found.value) facts[`${name}.max`] = found;
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

/** The largest size of some columns, of which one and when. */
function largest(times: Float64Array, values: Float64Array, names: string[]): Facts[string] {
  const k = worst(values);
  const note = `${names[k % names.length]}, at ${figures(times[Math.floor(k / names.length)])} s`;
  return { value: Math.abs(values[k]), note, time: times[Math.floor(k / names.length)] };
}
