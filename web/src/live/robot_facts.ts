// Headline numbers of a run of the 2010 robot, beside those that all robots share.

import type { Lines } from "./robot_line";
import { energyFacts, figures, largestFact, meanOverTime, trackingFacts, type Facts } from "./facts";
import { worst, type SeriesOf } from "./series";

const ANGLES = ["mode 1, horizontal", "mode 2, horizontal", "mode 1, vertical", "mode 2, vertical", "gear"];

/** The settling among them is that of the run alone, not carried on; `moment`: the largest one. */
export function robotFacts(times: Float64Array, series: SeriesOf, moment: Facts[string], moveEnd: number): Facts {
  const angles = series.deformation.data;
  const k = worst(angles);
  const facts: Facts = {
    ...trackingFacts(times, series, moveEnd),
    "moment.max": moment,
    "deformation.max": { value: Math.abs(angles[k]), note: ANGLES[k % ANGLES.length] },
    "gear_torque.max": largestFact(times, series.gear_torque.data),
    "voltage.max": largestFact(times, series.voltage.data),
    ...energyFacts(series, times.length),
  };
  const force = series.contact_force_radial?.data;
  if (force) {
    const [least, most] = [force.reduce((a, b) => Math.min(a, b)), force.reduce((a, b) => Math.max(a, b))];
    facts["contact.mean"] = {
      value: meanOverTime(times, force),
      note: `from ${figures(least, 4)} to ${figures(most, 4)} N`,
    };
  }
  return facts;
}

/** Those that are final: how long it takes to settle, robot_settling.ts finds. */
export function withoutSettling({ settling: _, ...others }: Facts): Facts {
  return others;
}

/**
 * The largest bending moment: of all samples at the roots, and at the station that is worst among the frames of
 * `lines`; `at` gives the lines of all samples at some stations.
 */
export function largestMoment(times: Float64Array, lines: Lines, at: (stations: Float64Array) => Lines): Facts[string] {
  const seen = largest(lines);
  const stations = Float64Array.from(seen.s === 0 ? [0] : [0, seen.s]);
  const { value, mode, s, plane, sample } = largest(at(stations));
  const place = s === 0 ? "at the root" : `at ${figures(100 * s)} % of its length`;
  const note = `mode ${mode + 1}, ${place}, ${plane ? "vertical" : "horizontal"} plane, at ${figures(times[sample])} s`;
  return { value, note };
}

function largest(lines: Lines): { value: number; mode: number; s: number; plane: number; sample: number } {
  const points = lines.stations.length;
  const found = lines.parts.map((part, mode) => {
    const k = worst(part.bending_moment); // [n, S, planes]
    const value = Math.abs(part.bending_moment[k]);
    return {
      value,
      mode,
      s: lines.stations[Math.floor(k / 2) % points],
      plane: k % 2,
      sample: Math.floor(k / (2 * points)),
    };
  });
  return found[1].value > found[0].value ? found[1] : found[0];
}
