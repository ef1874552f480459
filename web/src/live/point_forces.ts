// What acts on the named points of a robot: loads with their signals, and a surface, as
// tmodes/analysis/equilibrium_*.py.

import { WRENCH, wrenchAt } from "./wrench";
import type { Bundle, Surface } from "./bundle";
import { product } from "./linear";
import type { Blocks } from "./map";
import type { Schedule } from "./signals";

const POINT = 24;

/** Force and moment on each point [points, 6] in world axes, and what acts adds to M, D, K [n, n]. */
export interface Acts {
  wrenches: Float64Array;
  mass: Float64Array;
  damping: Float64Array;
  stiffness: Float64Array;
}

/**
 * All acts about a rest; `points` [points, 24] there and, of unit accelerations of each coordinate without weight,
 * `columns` [n, points, 24].
 */
export function actsAt(
  bundle: Bundle, blocks: Blocks, schedule: Schedule, points: Float64Array, columns: Float64Array, n: number,
  time = 0,
): Acts {
  const places = points.length / POINT;
  const found: Acts = {
    wrenches: new Float64Array(WRENCH * places),
    mass: new Float64Array(n * n),
    damping: new Float64Array(n * n),
    stiffness: new Float64Array(n * n),
  };
  const jacobian = (point: number, start: number) =>
    Float64Array.from(
      { length: 3 * n },
      (_, k) => columns[((k % n) * places + point) * POINT + start + Math.floor(k / n)],
    );
  bundle.loads.forEach((load, which) => {
    const { point, follower } = load;
    const own = blocks.loads.subarray(WRENCH * which, WRENCH * (which + 1));
    const wrench = wrenchAt(load, own, schedule, time, points, POINT * point);
    add(found.wrenches.subarray(WRENCH * point, WRENCH * (point + 1)), wrench, 1);
    if (!follower) return;
    const turn = jacobian(point, 21);
    // a turn d of the section turns a vector F by d x F, which is a force less -[F]x d
    for (const [rows, start] of [[jacobian(point, 18), 0], [turn, 3]] as const) {
      add(
        found.stiffness,
        product(rows, product(crossed(wrench.subarray(start, start + 3)), turn, 3, 3, n), n, 3, n, true),
        1,
      );
    }
  });
  if (bundle.touch)
    press(placed(bundle.touch, blocks.surface), blocks.touch, points, jacobian(bundle.touch.point, 18), found, n);
  return found;
}

function add(into: Float64Array, what: Float64Array, factor: number): void {
  for (let k = 0; k < what.length; k += 1) into[k] += factor * what[k];
}

function crossed([x, y, z]: Float64Array): Float64Array {
  return Float64Array.of(0, -z, y, z, 0, -x, -y, x, 0);
}

/** The surface where the sliders have it: its point or center, its radius and its normal. */
function placed(surface: Surface, [x, y, z, radius, ...normal]: Float64Array): Surface {
  if (surface.radius) return { ...surface, axis: [x, y, z], radius };
  const axis = normal.map((value) => value / Math.hypot(...normal));
  return { ...surface, axis, distance: -(axis[0] * x + axis[1] * y + axis[2] * z) };
}

/** A surface that is pressed; `numbers`: mass, damping, stiffness, preload. */
function press(
  surface: Surface,
  numbers: Float64Array,
  points: Float64Array,
  jacobian: Float64Array,
  found: Acts,
  n: number,
): void {
  const [mass, damping, stiffness, preload] = numbers;
  const place = POINT * surface.point + 9;
  const { gap, normal, curvature } = touched(surface, points.subarray(place, place + 3));
  const force = preload - stiffness * gap;
  if (!surface.bilateral && !(gap <= 0 && force > 0)) return;
  for (let i = 0; i < 3; i += 1) found.wrenches[WRENCH * surface.point + i] += force * normal[i];
  const along = product(normal, jacobian, 1, 3, n);
  const squared = product(along, along, n, 1, n);
  add(found.mass, squared, mass);
  add(found.damping, squared, damping);
  add(found.stiffness, squared, stiffness);
  add(found.stiffness, product(jacobian, product(curvature, jacobian, 3, 3, n), n, 3, n, true), -force);
}

/** Distance of a position from a surface, positive in the free; the normal towards the free, and its slope [3, 3]. */
function touched(
  surface: Surface,
  position: Float64Array,
): { gap: number; normal: Float64Array; curvature: Float64Array } {
  const along = (one: ArrayLike<number>) => one[0] * position[0] + one[1] * position[1] + one[2] * position[2];
  if (!surface.radius)
    return {
      gap: along(surface.axis) + surface.distance,
      normal: Float64Array.from(surface.axis),
      curvature: new Float64Array(9),
    };
  const away = position.map((value, i) => value - surface.axis[i]);
  const distance = Math.hypot(...away) || 1e-300;
  const side = surface.inside ? -1 : 1;
  const outward = away.map((value) => value / distance);
  const curvature = Float64Array.from(
    { length: 9 },
    (_, k) => (side * ((k % 4 ? 0 : 1) - outward[Math.floor(k / 3)] * outward[k % 3])) / distance,
  );
  return { gap: side * (distance - surface.radius), normal: outward.map((value) => side * value), curvature };
}
