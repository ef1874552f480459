// Which gear, link or controller a vibration is in, and what else keeps a tip from its rest: as
// tmodes/result/vibrating.py finds it.

import { digits } from "../format";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { fitted, sumOf, type Complex } from "./exponentials";
import { affine } from "./live_scene";
import type { Blocks } from "./map";
import type { Found } from "./modes";
import type { Residual } from "./residual";
import { columns, range, rowsOf } from "./series";
import { storedIn } from "./vibration";

const [STEADY, TURNS, NOTHING] = [0.05, 0.5, 1e-8]; // of a motion that is none of vibration
const INSTANTS = 200;
const NOTICEABLE = 1e-3; // energy of all springs over the kinetic one, below which none is named
const SAME = 0.03; // distance of two poles over their size up to which they are of one mode
export const LOADS = "whole arm, in its weight and loads";

/** A mode that was seen in a run: its natural frequency [Hz], its damping, and where it was. */
export interface SeenMode {
  frequency: number;
  damping: number;
  element: string;
}

/** Modes about a pose, with the element that the nearest one seen in a run has, where both poles are the same. */
export function namedAsSeen(modes: Found[], seen: SeenMode[]): Found[] {
  const poleOf = (frequency: number, damping: number): Complex => {
    const size = 2 * Math.PI * frequency;
    return [-damping * size, size * Math.sqrt(Math.max(1 - damping ** 2, 0))];
  };
  const names = new Map<number, string>();
  for (const one of [...seen].reverse()) {
    if (!one.element || one.damping ** 2 >= 1) continue;
    const [re, im] = poleOf(one.frequency, one.damping);
    const far = modes.map(({ frequency, damping }) => {
      const [a, b] = poleOf(frequency, damping);
      return Math.hypot(a - re, b - im);
    });
    const nearest = far.indexOf(Math.min(...far));
    if (far[nearest] < SAME * Math.hypot(re, im)) names.set(nearest, one.element);
  }
  return modes.map((mode, k) => ({ ...mode, element: names.get(k) ?? mode.element }));
}

/** What keeps a motion q [n, nq] from its rest, empty where that is a vibration; and whether it is none at all. */
export function unrestOf(
  engine: Engine, bundle: Bundle, blocks: Blocks, times: Float64Array, q: Float64Array,
): [words: string, none: boolean] {
  const { coordinates } = engine.layout;
  const [width, n] = [coordinates.length, times.length];
  const from = Math.floor(n / 2) - 1;
  if (from < 0) return ["", false];
  const count = n - from;
  const at = (k: number) => q.subarray(k * width, (k + 1) * width);
  const [first, last, middle] = [from, n - 1, from + Math.floor((count - 1) / 2)].map(at);
  let [fastest, most] = [-1, 0];
  for (let j = 0; j < width; j += 1) {
    const travel = last[j] - first[j];
    let swing = 0;
    for (let k = 0; k < count; k += 1)
      swing = Math.max(swing, Math.abs(q[(from + k) * width + j] - first[j] - (k / (count - 1)) * travel));
    const share = Math.abs(travel) > Math.max(2 * swing, NOTHING) ? (middle[j] - first[j]) / travel : 0;
    if (Math.abs(share - 0.5) < STEADY && Math.abs(travel) > most) [fastest, most] = [j, Math.abs(travel)];
  }
  if (fastest >= 0) {
    const unit = bundle.units[fastest];
    const speed = most / (times[n - 1] - times[from]);
    const words = `${coordinates[fastest]} moves on at ${digits(speed, 3)} ${unit}/s`;
    return [words, unit === "rad" && most > TURNS];
  }
  const every = Math.floor(count / INSTANTS) + 1;
  const seen = Array.from({ length: Math.ceil(count / every) }, (_, k) => from + k * every);
  for (const { coordinate, gear, place } of bundle.plays) {
    const play = blocks.chain[place];
    const own = columns(q.subarray(from * width), width, [coordinate]);
    const moved = own.reduce((a, b) => Math.max(a, b)) - own.reduce((a, b) => Math.min(a, b));
    const loose = seen.filter((k) => {
      return Math.abs(affine(blocks.deflections, at(k), 1)[gear]) <= play;
    });
    if (moved > STEADY * play && loose.length > seen.length / 2)
      return [`${coordinates[coordinate]} rattles in the play of its gear`, true];
  }
  return ["", false];
}

/** The element of each mode of a vibration: where most of its elastic energy is in this run. */
export function elementsOf(
  engine: Engine, bundle: Bundle, blocks: Blocks, times: Float64Array, q: Float64Array, found: Residual,
): string[] {
  if (!found.modes.length || !bundle.modes) return [];
  const n = engine.layout.coordinates.length;
  const last = times.reduce((count, time) => count + Number(time <= found.span * (1 + 1e-9)), 0) - 1;
  const kept = [...new Set(range(0, 3 * INSTANTS).map((k) => Math.floor((k * last) / (3 * INSTANTS - 1))))];
  const poles = found.modes.flatMap((mode) => mode.poles);
  const all: Complex[] = [...poles, ...poles.map(([re, im]): Complex => [re, -im]), ...found.slow];
  const some = Float64Array.from(kept, (k) => times[k]);
  const mean = Array.from({ length: n }, (_, j) => kept.reduce((sum, k) => sum + q[k * n + j] / kept.length, 0));
  const parts = fitted(some, rowsOf(q, n, kept).map((value, k) => value - mean[k % n]), all);
  const place = q.slice(kept[kept.length - 1] * n, (kept[kept.length - 1] + 1) * n);
  const still = new Float64Array(n);
  const units = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  const held = "servos" in blocks ? bundle.modes.servos.map((_, k) => blocks.servos[2 * k]) : null;
  const [{ base, chain, rotors }, pose] = [blocks, { q: place, v: still, base: blocks.base }];
  const springs = engine.slopes("elastic.slopes", chain, pose, { q: units }, n).slopes.forces;
  const elastic = springs.map((_, k) => springs[(k % n) * n + Math.floor(k / n)]);
  const driven = engine.sample("inertia", chain, { q: place, v: still, a: units, base }, n).forces;
  let begin = 0;
  return found.modes.map((mode) => {
    const own = parts.slice(begin, (begin += mode.poles.length));
    const instants = Float64Array.from({ length: INSTANTS }, (_, k) => (2 * k) / mode.frequency / (INSTANTS - 1));
    const [moved, rates] = [0, 1].map((order) => sumOf(instants, mode.poles, own, order)[0]);
    const stored = new Map<string, number>();
    let [kinetic, whole] = [0, 0];
    for (let k = 0; k < INSTANTS; k += 1) {
      const [shape, rate] = [moved, rates].map((rows) => rows.subarray(k * n, (k + 1) * n));
      for (const { element, energy } of storedIn(bundle, blocks, elastic, shape, held)) {
        stored.set(element, (stored.get(element) ?? 0) + Math.abs(energy));
        whole += Math.abs(energy);
      }
      for (let i = 0; i < n; i += 1) {
        kinetic += rate[i] ** 2 * rotors[i];
        for (let j = 0; j < n; j += 1) kinetic += rate[i] * driven[i * n + j] * rate[j];
      }
    }
    const [home, energy] = [...stored].reduce((a, b) => (b[1] > a[1] ? b : a), ["", 0]);
    return energy > 0 && whole > NOTICEABLE * kinetic ? home : LOADS;
  });
}
