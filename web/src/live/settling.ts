// When a motion stays near its own rest: as tmodes/result/settling.py and tmodes/analysis/vibration.py, with their
// constants.

import { digits, info } from "../format";
import type { VibrationRules } from "./exponentials";

/** The constants of tmodes/result/settling.py, and the band of the sheet: a share of the move, or a length [m]. */
export interface SettlingRules {
  NO_MOVE: number; HORIZON: number; SHORTEST: number; DECAYS: number; SAMPLES: number; MOST_WORK: number;
  NEGLIGIBLE: number; LAST: number; STEADY: number; CREEPS: number; UNREST: string; COSTLY: string; AT_REST: number;
  share: number | null; length: number | null; within: string;
}

/** Samples of a point: times [n] s, places and rates [n, 3]. */
export interface Path {
  times: Float64Array;
  tip: Float64Array;
  rates: Float64Array;
}

export interface Settled {
  time: number | null;
  limit: number;
  reason: string;
}

const AXES = [0, 1, 2];
export const CHANGES = "what moves the robot changes up to the end of the run";

/** Time from the `end` of the move from which on the tip stays near its rest; `finished`: where the run ends. */
export function settlingOf(
  rules: SettlingRules, { STANDS, AT_REST, PLACES }: VibrationRules, path: Path, end: number | null, finished: number,
  unrest = "",
): Settled {
  const { times, tip } = path;
  const { rest, spread } = restOf(rules, path, end);
  const run = times.reduce((count, time) => count + Number(time <= finished * (1 + 1e-9)), 0);
  const move = farthest(path, run, rest, PLACES);
  const limit = Math.max(rules.length ?? rules.share! * move, rules.NO_MOVE);
  const none = (reason: string, time: number | null = null) => ({ time, limit, reason });
  const last = times[times.length - 1];
  if (end === null) return none(CHANGES);
  if (last <= end * (1 + 1e-9))
    return none(
      `the run ends at ${digits(last, 6)} s, the move at ${digits(end, 6)} s: simulate longer to see it settle`,
    );
  if (move <= STANDS * tip.reduce((most, value) => Math.max(most, Math.abs(value)), 0)) return none(AT_REST, 0);
  if (spread > rules.STEADY * limit) {
    const by = `${info(2 * spread, "m", 3).replace("\u00a0", " ")} at t = ${digits(last, 4)} s`;
    return none(`the tip still moves by ${by}: ${unrest || rules.UNREST}`);
  }
  return none("", settledAfter(path, rest, limit, end));
}

/** Where a tip comes to rest: its smooth mean over the last fifth, and what creeping adds; its distance then. */
export function restOf(
  { LAST, CREEPS }: SettlingRules, { times, tip }: Path, end: number | null,
): { rest: number[]; spread: number } {
  const n = times.length;
  const last = times[n - 1];
  const length = LAST * Math.max(last - (end ?? 0), 0);
  const step = (k: number) =>
    (times[Math.min(k + 1, n - 1)] - times[Math.max(k - 1, 0)]) / (Math.min(k + 1, n - 1) - Math.max(k - 1, 0) || 1);
  const means = [2, 1, 0].map((back) => {
    let [sum, weights] = [[0, 0, 0], 0];
    for (let k = 0; k < n; k += 1) {
      const share = (times[k] - last) / (length || 1) + back + 1;
      const weight = share >= 0 && share <= 1 ? Math.sin(Math.PI * share) ** 2 * (n > 1 ? step(k) : 1) : 0;
      weights += weight;
      sum = sum.map((value, c) => value + weight * tip[3 * k + c]);
    }
    return AXES.map((c) => (weights > 0 ? sum[c] / weights : tip[3 * (n - 1) + c]));
  });
  const [before, after] = [1, 2].map((k) => AXES.map((c) => means[k][c] - means[k - 1][c]));
  const dot = (a: number[], b: number[]) => AXES.reduce((sum, c) => sum + a[c] * b[c], 0);
  const ratio = dot(after, before) / (dot(before, before) || 1);
  const creeps = ratio > 0 && ratio < CREEPS ? ratio / (1 - ratio) : 0;
  const rest = means[2].map((value, c) => value + after[c] * creeps);
  let spread = 0;
  for (let k = n - 1; k >= 0 && times[k] >= last - length; k -= 1) spread = Math.max(spread, away(tip, k, rest));
  return { rest, spread };
}

function away(tip: Float64Array, k: number, rest: number[]): number {
  return Math.sqrt(AXES.reduce((sum, c) => sum + (tip[3 * k + c] - rest[c]) ** 2, 0));
}

/** Powers [4] by axis of the share of an interval, and the most that the cubics can be away from the rest. */
function cubic({ times, tip, rates }: Path, k: number, rest: number[]): { powers: number[][]; bound: number } {
  const step = times[k + 1] - times[k];
  const control = [[], [], [], []] as number[][];
  const powers = AXES.map((c) => {
    const [first, last] = [tip[3 * k + c] - rest[c], tip[3 * k + 3 + c] - rest[c]];
    const [left, right] = [step * rates[3 * k + c], step * rates[3 * k + 3 + c]];
    [first, first + left / 3, last - right / 3, last].forEach((value, at) => control[at].push(value));
    return [first, left, 3 * (last - first) - 2 * left - right, 2 * (first - last) + left + right];
  });
  return { powers, bound: Math.max(...control.map((one) => Math.hypot(...one))) };
}

/** The largest distance of the first `count` samples from `rest`, between them too. */
function farthest(path: Path, count: number, rest: number[], places: number): number {
  let nearest = 0;
  for (let k = 0; k < count; k += 1) nearest = Math.max(nearest, away(path.tip, k, rest));
  let most = nearest;
  for (let k = 0; k + 1 < count; k += 1) {
    const { powers, bound } = cubic(path, k, rest);
    if (bound <= nearest) continue;
    for (let j = 0; j < places; j += 1) {
      const share = j / (places - 1);
      const at = powers.map(([a, b, c, d]) => a + share * (b + share * (c + share * d)));
      most = Math.max(most, Math.hypot(...at));
    }
  }
  return most;
}

/** Time after `since` from which on the motion stays within `limit` of `rest`, its last exit; null: not seen. */
function settledAfter(path: Path, rest: number[], limit: number, since: number): number | null {
  const { times, tip } = path;
  if (away(tip, times.length - 1, rest) > limit) return null;
  for (let k = times.length - 2; k >= 0 && times[k + 1] > since * (1 + 1e-12); k -= 1) {
    const { powers, bound } = cubic(path, k, rest);
    if (bound <= limit) continue;
    const far = new Array<number>(7).fill(0);
    for (const one of powers) one.forEach((a, i) => one.forEach((b, j) => { far[i + j] += a * b; }));
    far[0] -= limit ** 2;
    const crossed = zerosOf(far).pop();
    const when = times[k] + (crossed ?? 0) * (times[k + 1] - times[k]) - since;
    if (crossed !== undefined && when > 0) return when;
  }
  return 0;
}

/** Where a polynomial of these powers changes its sign between 0 and 1: between two zeros of its slope at most once. */
function zerosOf(powers: number[]): number[] {
  if (powers.length < 2) return [];
  const at = (x: number) => powers.reduceRight((sum, value) => sum * x + value, 0);
  const places = [0, ...zerosOf(powers.slice(1).map((value, k) => value * (k + 1))), 1];
  return places.slice(1).flatMap((end, k) => {
    let [low, high] = [places[k], end];
    const above = at(low) > 0;
    if (above === at(high) > 0) return [];
    for (let halving = 0; halving < 52; halving += 1) {
      const middle = (low + high) / 2;
      if (at(middle) > 0 === above) low = middle;
      else high = middle;
    }
    return [high];
  });
}

/** Whether the motion from a sample on is not known between samples to a thousandth of its distance from `rest`. */
export function areCoarse(
  { BETWEEN, SMALL }: VibrationRules, { times, tip, rates }: Path, from: number, rest: number[], limit: number,
): boolean {
  for (let k = from + 1; k + 1 < times.length; k += 1) {
    const step = times[k + 1] - times[k];
    if (!(Math.abs(step - (times[k] - times[k - 1])) < 1e-6 * step)) continue;
    const wrong = Math.hypot(...AXES.map((c) => {
      const [before, own, after] = [3 * k - 3 + c, 3 * k + c, 3 * k + 3 + c];
      return (tip[after] + tip[before]) / 2 + (step * (rates[before] - rates[after])) / 4 - tip[own];
    }));
    if (wrong / 16 > BETWEEN * Math.max(away(tip, k, rest), SMALL * limit)) return true;
  }
  return false;
}
