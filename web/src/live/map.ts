// From what the sliders say to all numbers of a run: by the program that tmodes/live/map.py noted, with its guards.

import { doubles, type MapInfo } from "./bundle";
import { EngineError } from "./engine_error";

const NOTHING = 1e-60; // for a zero that would take other equations: next to any number it is none

/** The numbers of a run by the names of their blocks. */
export type Blocks = Record<string, Float64Array>;

const OPERATIONS: Record<string, (a: number, b: number) => number> = {
  add: (a, b) => a + b, sub: (a, b) => a - b, mul: (a, b) => a * b, div: (a, b) => a / b, neg: (a) => -a,
  pow: Math.pow, abs: Math.abs, sqrt: Math.sqrt, sin: Math.sin, cos: Math.cos, tan: Math.tan, exp: Math.exp,
  log: Math.log, arcsin: Math.asin, arccos: Math.acos, arctan: Math.atan, arctan2: Math.atan2, hypot: Math.hypot,
  tanh: Math.tanh, fmin: Math.min, fmax: Math.max,
};

/** All numbers of a run for values of the sliders; raises an EngineError where the program does not hold for them. */
export function numbersOf(map: MapInfo, values: readonly number[], run: string): Blocks {
  const registers = computed(map, values);
  const vector = doubles(map.base).slice();
  const { data, shape: [, count] } = map.moving;
  for (let k = 0, place = 0, register = 0; k < count; k += 1) {
    vector[(place += data[k])] = registers[(register += data[count + k])];
  }
  return Object.fromEntries(Object.entries(map.runs[run]).map(([name, { start, shape }]) =>
    [name, vector.slice(start, shape.reduce((product, length) => product * length, 1) + start)]));
}

function computed(map: MapInfo, values: readonly number[]): Float64Array {
  const { data: code, shape: [, count] } = map.code;
  const first = values.length + map.constants.data.length;
  const registers = new Float64Array(first + count);
  registers.set(values.map((value, k) => (value === 0 && map.start[k] !== 0 ? NOTHING : value)));
  registers.set(map.constants.data, values.length);
  const operations = map.operations.map((name) => OPERATIONS[name]);
  for (let k = 0, r = first; k < count; k += 1, r += 1) {
    registers[r] = operations[code[k]](registers[r - code[count + k]], registers[r - code[2 * count + k]]);
  }
  const guards = map.guards.data;
  for (let k = 0; k < guards.length; k += 3) {
    const [a, b] = [registers[guards[k + 1]], registers[guards[k + 2]]];
    const kind = guards[k] >> 1;
    const holds = kind === 0 ? a < b : kind === 1 ? a <= b : kind === 2 ? a === b : Number.isFinite(a);
    if (holds === Boolean(guards[k] & 1)) refuse(map, values, guards[k + 1], guards[k + 2]);
  }
  return registers;
}

/** Raises an error that names the sliders that were moved and on which two registers depend. */
function refuse(map: MapInfo, values: readonly number[], ...registers: number[]): void {
  const { data: code, shape: [, count] } = map.code;
  const first = values.length + map.constants.data.length;
  const acting = new Set(registers);
  for (const r of acting) if (r >= first) for (const k of [1, 2]) acting.add(r - code[k * count + r - first]);
  const moved = [...acting].filter((r) => r < values.length && values[r] !== map.start[r]).sort((a, b) => a - b);
  if (moved.length)
    throw new EngineError(
      `${moved.map((k) => `${map.paths[k]} = ${values[k]}`).join(", ")}: expected numbers that the data sheet takes ` +
        "and that leave the equations as they are; move it back, or run it natively, by `tmodes run --set PATH=VALUE`",
    );
}
