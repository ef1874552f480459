// The elastic line of the 2010 robot's two modes at some samples, and the picture that is drawn of it.

import type { Scene } from "../contract";
import type { Numbers } from "../pack";
import type { Engine, Samples } from "./engine";
import { sizes } from "./series";

const MOTION = 21;
const COORDINATES = 6;

/** Of both modes what is known at each sample and station, rows [n * S]; `motion` [n, 21] as it was asked. */
export interface Lines {
  stations: Float64Array;
  motion: Float64Array;
  parts: Samples[];
}

let given = new Float64Array(); // what a call is given: copied by it, and used again by the next one

/** Each of the rows [n, width] at every station: both as a call is given them, [n * S] and [n * S, width]. */
function atEvery(stations: Float64Array, rows: Float64Array, width: number): Record<"station" | "each", Float64Array> {
  const [count, points] = [rows.length / width, stations.length];
  if (given.length < count * points * (width + 1)) given = new Float64Array(count * points * (width + 1));
  const station = given.subarray(0, count * points);
  const each = given.subarray(station.length, station.length * (width + 1));
  for (let k = 0; k < count; k += 1) {
    for (let s = 0; s < points; s += 1) {
      const row = k * points + s;
      station[row] = stations[s];
      for (let j = 0; j < width; j += 1) each[row * width + j] = rows[k * width + j];
    }
  }
  return { station, each };
}

/** Coordinates, rates, accelerations and tip force [n, 21] to lines; parameters of the robot whose lines they are. */
export function linesAt(engine: Engine, parameters: Float64Array, motion: Float64Array, stations: Float64Array): Lines {
  const { station, each } = atEvery(stations, motion, MOTION);
  const inputs = { station, motion: each };
  const parts = [1, 2].map((mode) => engine.sample(`real.line${mode}`, parameters, inputs, station.length));
  return { stations, motion, parts };
}

/** Where both lines are at coordinates [n, 6], whatever moves or loads them: [n, 2, S, 3] m. */
export function placesAt(engine: Engine, parameters: Float64Array, phi: Float64Array, stations: Float64Array): Numbers {
  const [count, points] = [phi.length / COORDINATES, stations.length];
  const { station, each } = atEvery(stations, phi, COORDINATES);
  const { line } = engine.sample("real.places", parameters, { station, phi: each }, station.length);
  const data = new Float64Array(line.length);
  for (let k = 0; k < count; k += 1) {
    for (let s = 0; s < points; s += 1) {
      for (let i = 0; i < 6; i += 1) {
        data[((2 * k + Math.floor(i / 3)) * points + s) * 3 + (i % 3)] = line[(k * points + s) * 6 + i];
      }
    }
  }
  return { data, shape: [count, 2, points, 3] };
}

/** A quantity of both modes [n, 2, S, width]. */
export function stacked(lines: Lines, name: string): Numbers {
  const [count, points] = [lines.motion.length / MOTION, lines.stations.length];
  const width = lines.parts[0][name].length / (count * points);
  const data = new Float64Array(count * 2 * points * width);
  lines.parts.forEach((part, mode) => {
    for (let k = 0; k < count; k += 1) {
      data.set(part[name].subarray(k * points * width, (k + 1) * points * width), (2 * k + mode) * points * width);
    }
  });
  return { data, shape: [count, 2, points, width] };
}

/** What colours the links, by the ids of tmodes/report/scene_robot.py. */
export function colours(lines: Lines, line: Numbers, rigid: Numbers): Scene["colours"] {
  const shape = line.shape.slice(0, 3);
  const away = (line.data as Float64Array).map((value, k) => value - rigid.data[k]);
  const size = (name: string) => sizes(stacked(lines, name).data as Float64Array, 2);
  return [
    { id: "bending_moment", label: "Bending moment", unit: "N m", values: { data: size("bending_moment"), shape } },
    {
      id: "deflection",
      label: "Deflection from the root's tangent",
      unit: "m",
      values: { data: size("deflection"), shape },
    },
    { id: "displacement", label: "Displacement by all elasticity", unit: "m", values: { data: sizes(away, 3), shape } },
  ];
}

/** Rotation of each mode's root as quaternions x, y, z, w [n, 2, 4]: turned about z, then about y, from phi [n, 6]. */
export function roots(phi: Float64Array): Numbers {
  const count = phi.length / 6;
  const data = new Float64Array(count * 8);
  for (let k = 0; k < count; k += 1) {
    const [q, , gamma, vt] = phi.subarray(6 * k, 6 * k + 6);
    data.set(turned(gamma, 0), 8 * k);
    data.set(turned(q + (q - gamma) / 2, vt + vt / 2), 8 * k + 4);
  }
  return { data, shape: [count, 2, 4] };
}

/** About z by an azimuth, then upwards by an elevation (about -y). */
function turned(azimuth: number, elevation: number): number[] {
  const [c, s] = [Math.cos(azimuth / 2), Math.sin(azimuth / 2)];
  const [up, rise] = [Math.cos(elevation / 2), Math.sin(elevation / 2)];
  return [s * rise, -c * rise, s * up, c * up];
}
