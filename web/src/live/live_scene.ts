// The picture of the robot at the display frames: where its links are, bent, without elasticity, and as planned.

import type { SceneContact } from "../contract_scene";
import type { LiveScene } from "../contract_parts";
import type { Numbers } from "../pack";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { linesAt, sizeOf } from "./loads";
import type { Blocks } from "./map";
import { rowsOf, sizes, type SeriesOf } from "./series";

/** y = matrix x + constant of rows x [n, columns]; the constants are the last column of the matrix. */
export function affine(matrix: Float64Array, rows: Float64Array, count: number): Float64Array {
  const width = rows.length / count;
  const height = matrix.length / (width + 1);
  const found = new Float64Array(count * height);
  for (let k = 0; k < count; k += 1) {
    for (let i = 0; i < height; i += 1) {
      let value = matrix[i * (width + 1) + width];
      for (let j = 0; j < width; j += 1) value += matrix[i * (width + 1) + j] * rows[k * width + j];
      found[k * height + i] = value;
    }
  }
  return found;
}

interface Pose {
  line: Numbers; // [m, L, S, 3]
  roots: Numbers; // [m, L, 4]
}

/**
 * Scene of a run, whose numbers are those of the passes to the stations and of the surface; `loads`: what else may
 * colour the links.
 */
export function sceneOf(
  engine: Engine,
  bundle: Bundle,
  blocks: Blocks,
  series: SeriesOf,
  times: Float64Array,
  frames: number[],
  loads: LiveScene["colours"],
): LiveScene {
  const at = (name: string) =>
    rowsOf(
      series[name].data,
      series[name].shape.slice(1).reduce((a, b) => a * b, 1),
      frames,
    );
  const m = frames.length;
  const real = poseOf(engine, bundle, blocks, at("q"), m);
  const lineAt = (q: Float64Array) => poseOf(engine, bundle, blocks, q, m).line;
  const rigidAt = (q: Float64Array) => lineAt(affine(blocks.straight, q, m));
  const rigid = rigidAt(at("q"));
  const numbers = (name: string) => ({ data: at(name), shape: [m, ...series[name].shape.slice(1)] });
  const compared = "q_nominal" in series;
  const shape = real.line.shape.slice(0, 3);
  const away = (real.line.data as Float64Array).map((value, k) => value - rigid.data[k]);
  return {
    times: { data: rowsOf(times, 1, frames), shape: [m] },
    line: real.line,
    rigid,
    roots: real.roots,
    reference: compared ? lineAt(at("q_nominal")) : null,
    referenceRigid: compared ? rigidAt(at("q_nominal")) : null,
    colours: [
      ...loads,
      {
        id: "displacement",
        label: "Displacement by all elasticity",
        unit: "m",
        values: { data: sizes(away, 3), shape },
      },
    ],
    tip: numbers("tip"),
    tipReference: compared ? numbers("tip_nominal") : null,
    tipCommanded: "tip_commanded" in series ? numbers("tip_commanded") : null,
    contact:
      bundle.contactPoint < 0
        ? null
        : {
            force: numbers("contact_force"),
            at: contactPlace(bundle, series, frames),
            surface: surfaceAt(bundle, blocks.surface),
          },
  };
}

/** The surface where it is now: `numbers` are its place, its radius and its normal. */
function surfaceAt({ surface }: Bundle, numbers: Float64Array): SceneContact["surface"] | undefined {
  const place: [number, number, number] = [numbers[0], numbers[1], numbers[2]];
  const normal: [number, number, number] = [numbers[4], numbers[5], numbers[6]];
  if (surface?.kind === "plane") return { ...surface, position: place, normal };
  return surface ? { ...surface, center: place, radius: numbers[3] } : undefined;
}

function contactPlace(bundle: Bundle, series: SeriesOf, frames: number[]): Numbers {
  const points = series.position.shape[1];
  const all = rowsOf(series.position.data, 3 * points, frames);
  const data = new Float64Array(3 * frames.length);
  for (let k = 0; k < frames.length; k += 1) {
    for (let j = 0; j < 3; j += 1) data[3 * k + j] = all[3 * (k * points + bundle.contactPoint) + j];
  }
  return { data, shape: [frames.length, 3] };
}

/** Lines and roots of all links at coordinates q [count, nq]. */
export function poseOf(engine: Engine, bundle: Bundle, blocks: Blocks, q: Float64Array, count: number): Pose {
  const [L, S] = [bundle.links.length, bundle.stations.data.length];
  const still = new Float64Array(q.length / count);
  const line = new Float64Array(count * L * S * 3);
  const roots = new Float64Array(count * L * 4);
  const infos = bundle.links.map(({ name }) => bundle.carried.lines.find((one) => one.name === name) ?? null);
  linesAt(engine, blocks, { q, v: still, a: still, base: blocks.base }, count, (found, k) => {
    bundle.links.forEach(({ name }, l) => {
      const info = infos[l];
      const place = (k * L + l) * 4;
      const own = found(name, sizeOf(bundle, info));
      roots.set(quaternion(info ? own.subarray(info.at.rotation[0]) : own), place);
      if (k) steady(roots, place, 4 * L);
      for (let s = 0; s < S; s += 1) {
        const to = ((k * L + l) * S + s) * 3;
        for (let i = 0; i < 3; i += 1) {
          line[to + i] = info
            ? own[bundle.carried.shown.data[s] * info.width + info.at.position[0] + i]
            : own[9 + i] + bundle.stations.data[s] * (own[12 + i] - own[9 + i]);
        }
      }
    });
  });
  return { line: { data: line, shape: [count, L, S, 3] }, roots: { data: roots, shape: [count, L, 4] } };
}

/** Turns the sign of the quaternion at `place` to the side of the one `before` it: both are the same rotation. */
function steady(roots: Float64Array, place: number, before: number): void {
  let along = 0;
  for (let i = place; i < place + 4; i += 1) along += roots[i] * roots[i - before];
  if (along < 0) for (let i = place; i < place + 4; i += 1) roots[i] *= -1;
}

/** x, y, z, w of a rotation, row-major. */
export function quaternion(r: ArrayLike<number>): [number, number, number, number] {
  const trace = r[0] + r[4] + r[8];
  if (trace > 0) {
    const s = 2 * Math.sqrt(1 + trace);
    return [(r[7] - r[5]) / s, (r[2] - r[6]) / s, (r[3] - r[1]) / s, s / 4];
  }
  if (r[0] > r[4] && r[0] > r[8]) {
    const s = 2 * Math.sqrt(1 + r[0] - r[4] - r[8]);
    return [s / 4, (r[1] + r[3]) / s, (r[2] + r[6]) / s, (r[7] - r[5]) / s];
  }
  if (r[4] > r[8]) {
    const s = 2 * Math.sqrt(1 + r[4] - r[0] - r[8]);
    return [(r[1] + r[3]) / s, s / 4, (r[5] + r[7]) / s, (r[2] - r[6]) / s];
  }
  const s = 2 * Math.sqrt(1 + r[8] - r[0] - r[4]);
  return [(r[2] + r[6]) / s, (r[5] + r[7]) / s, s / 4, (r[3] - r[1]) / s];
}
