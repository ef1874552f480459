// The part of a run whose spectrum shows its vibration, as tmodes/plot/facts.py chooses it.

import type { Bundle } from "./bundle";
import { columns, type SeriesOf } from "./series";

const FEWEST = 32; // samples of a spectrum
const KEEPS_RATE = 1e-6; // second difference of a setpoint, over the largest, that counts as a constant rate

/** Position setpoints over time, one after another. */
export function setpointsOf(bundle: Bundle, series: SeriesOf): Float64Array[] {
  const { wanted } = series;
  return wanted ? bundle.setpoints.map((k) => columns(wanted.data, wanted.shape[1], [k])) : [];
}

/**
 * Its first and last time [s]: after the move where it has enough samples; else the longest part in which no setpoint
 * accelerates, where that has so many; else the whole run. A last sample that is off the even grid does not count.
 */
export function spanOf(times: Float64Array, end: number | null, setpoints: Float64Array[]): [number, number] {
  const count = times.length - (isOdd(times) ? 1 : 0);
  const last = times[times.length - 1];
  const after = end === null ? -1 : times.findIndex((time) => time >= end * (1 + 1e-9));
  if (after >= 0 && count - after >= FEWEST) return [times[after], last];
  const [from, to] = longest(coasting(count, setpoints));
  return to - from >= FEWEST ? [times[from], times[to - 1]] : [times[0], last];
}

function isOdd(times: Float64Array): boolean {
  const n = times.length;
  return n > 2 && Math.abs((times[n - 1] - times[n - 2]) / (times[1] - times[0]) - 1) > 1e-6;
}

/** Samples at which every setpoint keeps its rate; none where there is no setpoint. */
function coasting(count: number, setpoints: Float64Array[]): boolean[] {
  const inside = new Array<boolean>(Math.max(count, 0)).fill(false);
  if (count < 3 || !setpoints.length) return inside;
  const bends = new Float64Array(count);
  for (const wanted of setpoints)
    for (let k = 1; k < count - 1; k += 1)
      bends[k] = Math.max(bends[k], Math.abs(wanted[k + 1] - 2 * wanted[k] + wanted[k - 1]));
  const limit = KEEPS_RATE * Math.max(Number.MIN_VALUE, bends.reduce((a, b) => Math.max(a, b), 0));
  for (let k = 1; k < count - 1; k += 1) inside[k] = bends[k] <= limit;
  return inside;
}

/** First sample of the longest stretch that is inside, and the one after its last. */
function longest(inside: boolean[]): [number, number] {
  let [best, from]: [[number, number], number] = [[0, 0], -1];
  for (let k = 0; k <= inside.length; k += 1) {
    if (k < inside.length && inside[k]) from = from < 0 ? k : from;
    else if (from >= 0) {
      if (k - from > best[1] - best[0]) best = [from, k];
      from = -1;
    }
  }
  return best;
}
