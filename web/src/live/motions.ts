// The motions of a regime about its start: eigenvalues of its closed loop, as tmodes/analysis/spectrum.py has them.

import { EigenvalueDecomposition, Matrix } from "ml-matrix";
import type { Engine } from "./engine";
import type { Regime } from "./regime";
import { range } from "./series";
import { rowsAt } from "./signals";

const [LONG, SHORT, ROUNDING] = [1e-3, 1e-6, 1e-8]; // steps by which the tangent is found; what of a row is rounding

/** Eigenvalues [1/s] of a regime about its start. */
export function motionsOf(engine: Engine, { name, info, blocks, schedule, run }: Regime): { re: number; im: number }[] {
  const [size, m] = [run.states.length / run.times.length, info.state.works[0]];
  const start = run.states.slice(0, size);
  for (let k = info.state.modes[0]; k < info.state.modes[0] + info.slipping; k += 1) start[k] ||= 1;
  const time = new Float64Array(1);
  const still = { time, row: rowsAt(schedule, time), step: new Float64Array(1) };
  /** Derivatives of the rates i by the states j: differences of fourth order. */
  const slopes = (step: number) => {
    const states = new Float64Array(4 * m * size);
    [step, -step, 2 * step, -2 * step].forEach((away, s) => {
      for (let j = 0; j < m; j += 1) {
        states.set(start, (s * m + j) * size);
        states[(s * m + j) * size + j] += away;
      }
    });
    const { rate } = engine.sample(`${name}.rate`, blocks.parameters, { ...still, state: states }, 4 * m);
    const at = (s: number, i: number, j: number) => rate[(s * m + j) * size + i];
    return (i: number, j: number) => (8 * (at(0, i, j) - at(1, i, j)) - (at(2, i, j) - at(3, i, j))) / (12 * step);
  };
  const given = info.exact.flatMap(([k]) => [info.state.q[0] + k, info.state.v[0] + k]);
  const free = range(0, m).filter((k) => !given.includes(k)); // given motions neither ring nor decay
  const [long, short] = [slopes(LONG), slopes(SHORT)]; // long steps round less, short ones follow dry friction
  const tangent = new Matrix(free.map((i) => {
    const most = free.reduce((largest, j) => Math.max(largest, Math.abs(short(i, j))), 0);
    const same = (j: number) => Math.abs(long(i, j) - short(i, j)) <= ROUNDING * most;
    return free.map((j) => (same(j) ? long(i, j) : short(i, j)));
  }));
  if (!free.length || !tangent.to1DArray().every(Number.isFinite)) return [];
  const found = new EigenvalueDecomposition(tangent, { assumeSymmetric: false });
  return found.realEigenvalues.map((re, k) => ({ re, im: found.imaginaryEigenvalues[k] }));
}
