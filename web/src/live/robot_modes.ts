// Small vibrations of the 2010 robot about its rest, as tmodes/analysis/modes.py finds them.

import type { LiveRun } from "../contract_parts";
import { doubles, type RobotBundle } from "./bundle";
import { damped, undamped, type Undamped } from "./eigen";
import type { Engine } from "./engine";
import type { Facts } from "./facts";
import { product } from "./linear";
import type { Blocks } from "./map";
import { motionOf, ringing, info, type Found, type Lines } from "./modes";
import { greedyPartners, likeness } from "./partners";
import { staticRoots } from "./robot_static";
import { placesAt } from "./robot_line";

const N = 6;
const MOTOR = 5;
const NO_REST = "the robot has no static equilibrium about which it could vibrate";

/** Modes, marks and the first frequency of the real robot's numbers; a sentence where there are none. */
export function robotVibration(
  engine: Engine,
  bundle: RobotBundle,
  numbers: Blocks,
): { vibration: NonNullable<LiveRun["vibration"]>; facts: Facts } {
  const { parameters } = numbers;
  const { angles, found } = staticRoots(
    engine,
    bundle,
    "modes.rest",
    parameters,
    numbers.start,
    new Float64Array(5),
    1,
  );
  if (!found[0]) return { vibration: NO_REST, facts: {} };
  const phi = Float64Array.from({ length: N }, (_, i) => {
    let value = numbers.start[0] * bundle.modes.turn[i];
    for (let j = 0; j < 5; j += 1) value += bundle.basis.data[5 * i + j] * angles[j];
    return value;
  });
  const { linear } = engine.sample("modes.linear", parameters, { phi }, 1);
  const lines: Lines = (q) => placesAt(engine, parameters, q, doubles(bundle.stations));
  try {
    const cases = Object.fromEntries(
      bundle.modes.cases.map(({ name, columns }) => [
        name,
        modesOf(bundle, parameters, linear, name, doubles(columns)),
      ]),
    );
    return info(cases, phi, lines);
  } catch (problem) {
    return { vibration: problem instanceof Error ? problem.message : String(problem), facts: {} };
  }
}

function modesOf(
  bundle: RobotBundle,
  parameters: Float64Array,
  linear: Float64Array,
  name: string,
  columns: Float64Array,
): Found[] {
  const m = columns.length / N;
  const matrices = [0, 1, 2].map((k) => linear.slice(k * N * N, (k + 1) * N * N));
  if (name === "controlled") addControl(bundle, parameters, matrices);
  const [mass, damping, stiffness] = matrices.map((matrix) =>
    product(columns, product(matrix, columns, N, N, m), m, N, m, true),
  );
  if (!m) return [];
  const still = undamped(mass, stiffness, m);
  const motions = damped(mass, damping, stiffness, m, still);
  const partners = greedyPartners(likeness(still, motions, m, null), motions, m);
  const turning = name === "free" ? wholeTurn(bundle, columns, still, m) : -1;
  return Array.from({ length: m }, (_, k) => {
    const motion = motionOf(motions, partners[k], N, m, (c, i) => columns[c * m + i]);
    if (k === turning) return { frequency: 0, rings: 0, damping: 0, element: "whole arm, turning freely", ...motion };
    const { rings, damping: ratio } = ringing(motions, partners[k]);
    const frequency = Math.sqrt(Math.max(still.squares[k], 0)) / (2 * Math.PI);
    return {
      frequency,
      rings,
      damping: ratio,
      element: home(bundle, parameters, moved(columns, still, k, m)),
      ...motion,
    };
  });
}

/** The controller's gains act on the motor as a spring and a damper. */
export function addControl(
  bundle: RobotBundle,
  parameters: Float64Array,
  [, damping, stiffness]: Float64Array[],
): void {
  const of = (path: string) => parameterOf(bundle, parameters, path);
  const gain = of("motor.torque_constant") / of("motor.resistance");
  stiffness[MOTOR * N + MOTOR] += gain * of("controller.position_gain");
  damping[MOTOR * N + MOTOR] += gain * (of("controller.velocity_gain") + of("motor.back_emf_constant"));
}

function parameterOf(bundle: RobotBundle, parameters: Float64Array, path: string): number {
  return parameters[bundle.layout.parameters!.indexOf(path)];
}

/** An undamped shape in all coordinates. */
function moved(columns: Float64Array, still: Undamped, k: number, m: number): Float64Array {
  return product(columns, Float64Array.from({ length: m }, (_, i) => still.shapes[i * m + k]), N, m, 1);
}

/** The mode in which a free motor carries the undeformed arm: gravity and contact do not mind it. */
function wholeTurn(bundle: RobotBundle, columns: Float64Array, still: Undamped, m: number): number {
  const shares = Array.from({ length: m }, (_, k) => {
    const shape = moved(columns, still, k, m);
    return Math.abs(shape.reduce((sum, value, i) => sum + value * bundle.modes.turn[i], 0)) / Math.hypot(...shape);
  });
  return shares.indexOf(Math.max(...shares));
}

/** The element that stores most of a shape's elastic energy. */
function home(bundle: RobotBundle, parameters: Float64Array, shape: Float64Array): string {
  const stored = bundle.modes.springs.map(({ row, stiffness, length }) => {
    const bending = parameterOf(bundle, parameters, stiffness);
    const value = length ? (3 * bending) / parameterOf(bundle, parameters, length) : bending;
    return value * row.reduce((sum, share, i) => sum + share * shape[i], 0) ** 2;
  });
  const most = Math.max(0, ...stored);
  return most > 0 ? bundle.modes.springs[stored.indexOf(most)].element : "controller, whole arm";
}
