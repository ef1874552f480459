// The equations of a robot, linear about a rest: M x'' + D x' + K x = 0, from the compiled passes.

import { actsAt } from "./point_forces";
import { isSmall, stepped } from "./rest";
import type { Bundle } from "./bundle";
import type { Engine, Samples } from "./engine";
import { solveInPlace } from "./linear";
import type { Blocks } from "./map";
import type { Schedule } from "./signals";

/** M, D, K [n, n], row by row, and the part of K that springs alone make. */
export interface Linear {
  mass: Float64Array;
  damping: Float64Array;
  stiffness: Float64Array;
  elastic: Float64Array;
  /** Forces that nothing holds [n]. */
  residual: Float64Array;
}

const STEPS = 40;
const STEP = 1e-3; // of differences of fourth order of forces that are smooth: weight and dead loads

/** Forces of inertia and weight less the wrenches on the points, of rows of coordinates, rates and accelerations. */
export function inertiaForces(engine: Engine, blocks: Blocks, inputs: Samples, count: number): Float64Array {
  const { samples } = engine.layout;
  return engine.sample("loaded" in samples ? "loaded" : "inertia", blocks.chain, inputs, count).forces;
}

/** About the rest q [n]; dry friction, which has no slope there, is left out. */
export function linearAbout(
  engine: Engine,
  bundle: Bundle,
  blocks: Blocks,
  schedule: Schedule,
  q: Float64Array,
  time = 0,
): Linear {
  const n = q.length;
  const still = new Float64Array(n);
  const units = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  const { base } = blocks;
  const driven = engine.sample("inertia", blocks.chain, { q, v: still, a: units, base }, n);
  const { points } = engine.sample("inertia", blocks.chain, { q, v: still, a: still, base }, 1);
  const acts = actsAt(bundle, blocks, schedule, points, driven.points, n, time);
  const mass = acts.mass;
  for (let i = 0; i < n; i += 1) {
    for (let j = 0; j < n; j += 1) mass[i * n + j] += (driven.forces[i * n + j] + driven.forces[j * n + i]) / 2;
    mass[i * n + i] += blocks.rotors[i];
  }
  const smooth = blocks.chain.slice();
  for (const k of bundle.modes!.dry) smooth[k] = 0;
  const springs = engine.slopes("elastic.slopes", smooth, { q, v: still, base }, { q: units }, n);
  const dampers = engine.slopes("elastic.slopes", smooth, { q, v: still, base }, { v: units }, n).slopes.forces;
  const weight = weightSlopes(engine, blocks, q, acts.wrenches);
  const turned = (rows: Float64Array) => rows.map((_, k) => rows[(k % n) * n + Math.floor(k / n)]);
  const elastic = turned(springs.slopes.forces);
  const loaded = inertiaForces(
    engine,
    blocks,
    { q, v: still, a: still, base: blocks.weight, wrenches: acts.wrenches },
    1,
  );
  return {
    mass,
    elastic,
    residual: loaded.map((force, k) => force + springs.values.forces[k]),
    damping: turned(dampers).map((value, k) => value + acts.damping[k]),
    stiffness: elastic.map((value, k) => value + weight[k] + acts.stiffness[k]),
  };
}

/**
 * The equations about the rest near q [n], in which the coordinates that are driven stand as there; null where none is
 * found.
 */
export function linearAtRest(
  engine: Engine, bundle: Bundle, blocks: Blocks, schedule: Schedule, near: Float64Array, time = 0,
): { rest: Float64Array; linear: Linear } | null {
  const { free } = bundle.modes!;
  const [rest, n, m] = [near.slice(), near.length, free.length];
  let [before, found] = [Infinity, !m];
  for (let step = 0; step < STEPS; step += 1) {
    const linear = linearAbout(engine, bundle, blocks, schedule, rest, time);
    if (found) return { rest, linear };
    const matrix = Float64Array.from(
      { length: m * m },
      (_, k) => linear.stiffness[free[Math.floor(k / m)] * n + free[k % m]],
    );
    const change = Float64Array.from(free, (k) => linear.residual[k]);
    if (!solveInPlace(matrix, change)) return null;
    const size = stepped(rest, free, change);
    if (!Number.isFinite(size)) return null;
    found = isSmall(size, before);
    before = size;
  }
  return null;
}

/** Slopes of the forces of weight and dead wrenches by the coordinates [n, n]. */
function weightSlopes(
  engine: Engine, blocks: Blocks, q: Float64Array, wrenches: Float64Array,
): Float64Array {
  const n = q.length;
  const steps = [STEP, -STEP, 2 * STEP, -2 * STEP];
  const rows = new Float64Array(steps.length * n * n);
  steps.forEach((step, s) => {
    for (let j = 0; j < n; j += 1) {
      rows.set(q, (s * n + j) * n);
      rows[(s * n + j) * n + j] += step;
    }
  });
  const still = new Float64Array(n);
  const forces = inertiaForces(
    engine,
    blocks,
    { q: rows, v: still, a: still, base: blocks.weight, wrenches },
    steps.length * n,
  );
  const at = (s: number, i: number, j: number) => forces[(s * n + j) * n + i];
  return Float64Array.from({ length: n * n }, (_, k) => {
    const [i, j] = [Math.floor(k / n), k % n];
    return (8 * (at(0, i, j) - at(1, i, j)) - (at(2, i, j) - at(3, i, j))) / (12 * STEP);
  });
}
