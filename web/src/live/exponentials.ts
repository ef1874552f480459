// Sums of decaying exponentials: their rates in samples by a matrix pencil, their coefficients by least squares, and
// which of them are one mode; as tmodes/analysis/vibration.py.

import { EigenvalueDecomposition, Matrix, SingularValueDecomposition } from "ml-matrix";
import { leastSquares } from "./linear";
import { columns, range } from "./series";

/** A complex number; rows of them. */
export type Complex = readonly [re: number, im: number];
export type Complexes = readonly [re: Float64Array, im: Float64Array];

/** The constants of tmodes/analysis/vibration.py. */
export type VibrationRules = { AT_REST: string } & Record<"RANKS" | "WRONG" | "WINDOWS", number[]> & Record<
  "STANDS" | "FEWEST" | "MOST_SAMPLES" | "MOST_TERMS" | "RINGS" | "NOTHING" | "NEAR" | "WEIGHTY" | "DRIFTS" | "PERIODIC"
  | "BETWEEN" | "SMALL" | "PLACES" | "STRONG", number>;

/** A vibration of about one frequency, as `Oscillation` there. */
export interface Oscillation {
  frequency: number;
  damping: number;
  amplitude: number;
  share: number;
  drift: [number, number] | null;
  poles: Complex[];
}

const AXES = 3;
const FACTORS = 100; // of a Lanczos bidiagonalisation: well more than the exponentials that are looked for
const NONE = 1e-15; // size of a further direction, over the largest, that is rounding

/** Right singular vectors of all windows of samples [n, 3], and their singular values: the largest ones. */
export interface Windows {
  width: number;
  sizes: number[];
  shapes: Float64Array[];
}

/** By Lanczos' bidiagonalisation with full orthogonalisation, as tmodes/analysis/vibration.py by all of them. */
export function windowsOf(values: Float64Array): Windows {
  const n = values.length / AXES;
  const width = Math.floor(n / 3);
  const [rows, wide] = [n - width + 1, AXES * width];
  const axes = range(0, AXES).map((c) => columns(values, AXES, [c]));
  const ahead = (v: Float64Array) => Float64Array.from({ length: rows }, (_, i) => {
    let sum = 0;
    for (let c = 0; c < AXES; c += 1)
      for (let j = 0, at = c * width; j < width; j += 1) sum += axes[c][i + j] * v[at + j];
    return sum;
  });
  const back = (u: Float64Array) => {
    const found = new Float64Array(wide);
    for (let c = 0; c < AXES; c += 1)
      for (let i = 0; i < rows; i += 1)
        for (let j = 0, at = c * width; j < width; j += 1) found[at + j] += u[i] * axes[c][i + j];
    return found;
  };
  const most = Math.min(FACTORS, rows, wide);
  const [us, vs, diagonal, above]: [Float64Array[], Float64Array[], number[], number[]] = [[], [], [], []];
  let seed = 1;
  let v = Float64Array.from({ length: wide }, () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5);
  for (let k = 0; k < most; k += 1) {
    const beta = apart(v, vs);
    if (k && beta <= NONE * diagonal[0]) break;
    if (k) above.push(beta);
    vs.push(v);
    const u = ahead(v);
    diagonal.push(apart(u, us));
    us.push(u);
    v = back(u);
  }
  const entry = (k: number, j: number) => (j === k ? diagonal[k] : j === k + 1 ? above[k] : 0);
  const small = new Matrix(diagonal.map((_, k) => diagonal.map((__, j) => entry(k, j))));
  const { diagonal: sizes, rightSingularVectors: turned } = new SingularValueDecomposition(small);
  const along = (t: number, j: number) => vs.reduce((sum, own, k) => sum + turned.get(k, t) * own[j], 0);
  return { width, sizes, shapes: sizes.map((_, t) => Float64Array.from({ length: wide }, (__, j) => along(t, j))) };
}

/** Takes the parts along others off a vector and makes it of length 1; returns the length that was left. */
function apart(vector: Float64Array, others: Float64Array[]): number {
  for (let twice = 0; twice < 2; twice += 1)
    for (const other of others) {
      let along = 0;
      for (let k = 0; k < vector.length; k += 1) along += vector[k] * other[k];
      for (let k = 0; k < vector.length; k += 1) vector[k] -= along * other[k];
    }
  const size = Math.sqrt(vector.reduce((sum, value) => sum + value * value, 0));
  if (size) for (let k = 0; k < vector.length; k += 1) vector[k] /= size;
  return size;
}

/** Rates [1/s] of `terms` exponentials, conjugates in pairs. */
export function polesOf({ width, shapes }: Windows, terms: number, step: number): Complex[] {
  const rows = AXES * (width - 1);
  const side = (shift: number) => Float64Array.from({ length: rows * terms }, (_, k) => {
    const row = Math.floor(k / terms);
    return shapes[k % terms][Math.floor(row / (width - 1)) * width + (row % (width - 1)) + shift];
  });
  const found = new EigenvalueDecomposition(
    Matrix.from1DArray(terms, terms, leastSquares(side(0), side(1), rows, terms, terms)), { assumeSymmetric: false },
  );
  return found.realEigenvalues.flatMap((re, k): Complex[] => {
    const im = found.imaginaryEigenvalues[k] || 0;
    const size = Math.hypot(re, im);
    return size > 1e-12 ? [[Math.log(size) / step, Math.atan2(im, re) / step]] : [];
  });
}

/** Coefficients of exponentials of these poles that make up values [n, width]: of each its real and imaginary parts. */
export function fitted(times: Float64Array, values: Float64Array, poles: readonly Complex[]): Complexes[] {
  const n = times.length;
  const width = values.length / n;
  const paired = (re: number, im: number) => poles.some(([a, b]) => a === re && b === -im);
  const columns: [pole: number, phase: number, share: number][] = poles.flatMap(([re, im], k) => {
    if (im !== 0 && paired(re, im)) return im > 0 ? [[k, 0, Math.SQRT2], [k, Math.PI / 2, Math.SQRT2]] : [];
    return [[k, im * times[0], 1]]; // a factor below zero from sample to sample: real but for its first phase
  });
  const m = columns.length;
  const basis = new Float64Array(n * m);
  columns.forEach(([k, phase, share], j) => {
    const [re, im] = poles[k];
    for (let i = 0; i < n; i += 1) basis[i * m + j] = share * Math.exp(re * times[i]) * Math.cos(im * times[i] - phase);
  });
  const x = leastSquares(basis, values.slice(), n, m, width);
  const parts: Complexes[] = poles.map(() => [new Float64Array(width), new Float64Array(width)]);
  columns.forEach(([k, phase, share], j) => {
    for (let c = 0; c < width; c += 1) {
      parts[k][0][c] += (x[j * width + c] * Math.cos(phase)) / share;
      parts[k][1][c] -= (x[j * width + c] * Math.sin(phase)) / share;
    }
  });
  poles.forEach(([re, im], k) => {
    const other = im < 0 ? poles.findIndex(([a, b]) => a === re && b === -im) : -1;
    if (other >= 0) parts[k] = [parts[other][0].slice(), parts[other][1].map((value) => -value)];
  });
  return parts;
}

export function largestOf(values: Float64Array): number {
  return values.reduce((most, value) => Math.max(most, value), 0);
}

/** The sum [n, width] of exponentials, or its derivative of an order. */
export function sumOf(
  times: Float64Array, poles: readonly Complex[], parts: readonly Complexes[], order = 0,
): Complexes {
  const width = parts.length ? parts[0][0].length : AXES;
  const found: Complexes = [new Float64Array(width * times.length), new Float64Array(width * times.length)];
  poles.forEach(([re, im], p) => {
    for (let k = 0; k < times.length; k += 1) {
      const size = Math.exp(re * times[k]);
      let [a, b] = [size * Math.cos(im * times[k]), size * Math.sin(im * times[k])];
      for (let more = 0; more < order; more += 1) [a, b] = [a * re - b * im, a * im + b * re];
      for (let c = 0; c < width; c += 1) {
        found[0][width * k + c] += a * parts[p][0][c] - b * parts[p][1][c];
        found[1][width * k + c] += a * parts[p][1][c] + b * parts[p][0][c];
      }
    }
  });
  return found;
}

/** Turning exponentials, whose real part is the motion. */
export interface Signals {
  times: Float64Array;
  poles: Complex[];
  parts: Complexes[];
}

function sumIn({ times, poles, parts }: Signals, group: number[], order = 0): Complexes {
  return sumOf(times, group.map((k) => poles[k]), group.map((k) => parts[k]), order);
}

/** The largest distance within a turn, without its decay: the end of a turning vector draws an ellipse. */
export function envelopeOf(signals: Signals, group: number[]): Float64Array {
  const [re, im] = sumIn(signals, group);
  return Float64Array.from(signals.times, (_, k) => {
    let [size, a, b] = [0, 0, 0];
    for (let j = 3 * k; j < 3 * k + 3; j += 1) {
      size += re[j] ** 2 + im[j] ** 2;
      a += re[j] ** 2 - im[j] ** 2;
      b += 2 * re[j] * im[j];
    }
    return Math.sqrt((size + Math.hypot(a, b)) / 2);
  });
}

export function modesOf(
  rules: VibrationRules, signals: Signals, apart: Float64Array, length: number, least: number,
): Oscillation[] {
  const whole = envelopeOf(signals, signals.poles.map((_, k) => k)).subarray(1);
  const strong = rules.WEIGHTY * largestOf(whole);
  const last = whole.reduce((found, value, k) => (value >= strong ? k : found), whole.length - 1);
  const left = apart.slice(0, 3 * (last + 1));
  const square = (values: Float64Array) => values.reduce((sum, value) => sum + value * value, 0);
  const found: Oscillation[] = [];
  for (const group of groupsOf(rules, signals.poles, length)) {
    const envelope = envelopeOf(signals, group);
    if (!(largestOf(envelope) > least)) continue;
    const turning = sumIn(signals, group);
    const [re, im] = rateOf(turning, sumIn(signals, group, 1));
    const own = turning[0].subarray(3, 3 + left.length);
    own.forEach((value, k) => { left[k] -= value; });
    found.push({
      frequency: im / (2 * Math.PI), damping: -re / Math.hypot(re, im), amplitude: largestOf(envelope),
      share: square(own), drift: group.length > 1 ? driftOf(rules, signals, group, envelope, im) : null,
      poles: group.map((k) => signals.poles[k]),
    });
  }
  const total = found.reduce((sum, mode) => sum + mode.share, 0) + square(left);
  return found.map((mode) => ({ ...mode, share: mode.share / total })).sort((a, b) => b.amplitude - a.amplitude);
}

/** The mean rate of change of a turning motion, over itself, of some of its samples. */
function rateOf([a, b]: Complexes, [da, db]: Complexes, which: (k: number) => boolean = () => true): Complex {
  let [re, im, weight] = [0, 0, 0];
  for (let k = 0; k < a.length; k += 1) {
    if (!which(Math.floor(k / 3))) continue;
    weight += a[k] ** 2 + b[k] ** 2;
    re += a[k] * da[k] + b[k] * db[k];
    im += a[k] * db[k] - b[k] * da[k];
  }
  return [re / weight, im / weight];
}

/** Poles that are one mode: of about one frequency, by its share, by their decay, or by the time that is seen. */
function groupsOf({ NEAR }: VibrationRules, poles: Complex[], length: number): number[][] {
  const order = poles.map((_, k) => k).sort((a, b) => poles[a][1] - poles[b][1]);
  const groups: number[][] = [];
  order.forEach((k, place) => {
    const before = poles[order[place - 1] ?? k];
    const near = Math.max(
      NEAR * poles[k][1], (2 * Math.PI) / length, Math.abs(poles[k][0]) / 2 + Math.abs(before[0]) / 2,
    );
    if (!place || poles[k][1] - before[1] > near) groups.push([k]);
    else groups[groups.length - 1].push(k);
  });
  return groups;
}

function driftOf(
  rules: VibrationRules, signals: Signals, group: number[], envelope: Float64Array, rate: number,
): [number, number] | null {
  const { times } = signals;
  const [turning, slope, turn] = [sumIn(signals, group), sumIn(signals, group, 1), (2 * Math.PI) / rate];
  const strong = rules.WEIGHTY * largestOf(envelope);
  const last = envelope.reduce((found, value, k) => (value >= strong ? times[k] : found), 0);
  const [first, end] = [0, Math.max(last - turn, 0)].map((begin) =>
    rateOf(turning, slope, (k) => times[k] >= begin && times[k] <= begin + turn)[1] / (2 * Math.PI));
  return Math.abs(end - first) > rules.DRIFTS * Math.abs(first) ? [first, end] : null;
}
