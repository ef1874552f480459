// Small vibrations M x'' + D x' + K x = 0: undamped shapes, and the motions of the damped equations.

import { EigenvalueDecomposition, Matrix } from "ml-matrix";
import { cholesky, congruent, product, solveUpper } from "./linear";
import { betweenSamples, overPeriod, type Sampled } from "./sampled";

/** Squared circular frequencies, rising, and shapes [n, n] (columns) of unit modal mass. */
export interface Undamped {
  squares: Float64Array;
  shapes: Float64Array;
  /** Whether the stiffness is symmetric, as far as rounding lets it: then the shapes are orthogonal. */
  symmetric: boolean;
}

/** Numbers of one complex matrix or row. */
export interface Complex {
  re: Float64Array;
  im: Float64Array;
}

/** Eigenvalues [1/s] and complex shapes [n, count] (columns) of the coordinates. */
export interface Motions {
  count: number;
  values: Complex;
  shapes: Complex;
}

const SYMMETRIC = 1e-9;
const NOTHING = 1e-13;
const APART = 1e-11; // share of a motion below which a state is none of it, but rounding
const SLOWEST = 1e-6; // share of the largest frequency by which slow motions are scaled at least

/**
 * The undamped motions of masses and stiffnesses [n, n]; raises an error where the masses are not positive. From 1/w^2
 * where the stiffness is positive definite: the low frequencies then keep all their digits.
 */
export function undamped(mass: Float64Array, given: Float64Array, n: number): Undamped {
  const root = cholesky(mass, n);
  if (!root)
    throw new Error(
      "mass matrix: got one that is not positive definite; expected mass or inertia along every coordinate",
    );
  let [odd, largest] = [0, 0];
  for (let i = 0; i < n; i += 1) {
    for (let j = 0; j < n; j += 1) {
      odd = Math.max(odd, Math.abs(given[i * n + j] - given[j * n + i]));
      largest = Math.max(largest, Math.abs(given[i * n + j]));
    }
  }
  if (odd > SYMMETRIC * largest)
    return { ...sorted(root, eigen(congruent(root, given, n), n, false), n), symmetric: false };
  const stiffness = given.map((value, k) => (value + given[(k % n) * n + Math.floor(k / n)]) / 2);
  const stiff = cholesky(stiffness, n);
  const inverse = stiff && eigen(congruent(stiff, mass, n), n, true);
  const most = inverse ? Math.max(...inverse.re) : 0;
  if (!stiff || !inverse || Math.min(...inverse.re) <= 0 || 1 / most <= (NOTHING * n) / Math.min(...inverse.re)) {
    return { ...sorted(root, eigen(congruent(root, stiffness, n), n, true), n), symmetric: true };
  }
  const info = sorted(stiff, { re: inverse.re.map((value) => 1 / value), vectors: inverse.vectors }, n);
  // these have unit stiffness: their modal mass is 1/w^2
  return {
    squares: info.squares,
    shapes: info.shapes.map((value, k) => value * Math.sqrt(info.squares[k % n])),
    symmetric: true,
  };
}

interface Eigen {
  re: Float64Array;
  vectors: Float64Array;
}

function eigen(matrix: Float64Array, n: number, symmetric: boolean): Eigen {
  const even = symmetric ? matrix.map((value, k) => (value + matrix[(k % n) * n + Math.floor(k / n)]) / 2) : matrix;
  const found = new EigenvalueDecomposition(Matrix.from1DArray(n, n, even), { assumeSymmetric: symmetric });
  const { realEigenvalues: re, imaginaryEigenvalues: im, eigenvectorMatrix } = found;
  const vectors = Float64Array.from(eigenvectorMatrix.to1DArray());
  // of a pair of complex ones both have the real part of their shape
  if (!symmetric)
    for (let k = 1; k < n; k += 1)
      if (im[k] < 0) for (let i = 0; i < n; i += 1) vectors[i * n + k] = vectors[i * n + k - 1];
  for (let k = 0; k < n; k += 1) {
    const size = Math.hypot(...Array.from({ length: n }, (_, i) => vectors[i * n + k]));
    for (let i = 0; i < n; i += 1) vectors[i * n + k] /= size;
  }
  return { re: Float64Array.from(re), vectors };
}

/** By rising eigenvalue, with the shapes x of L^T x = vector. */
function sorted(root: Float64Array, { re, vectors }: Eigen, n: number): Omit<Undamped, "symmetric"> {
  const order = Array.from(re.keys()).sort((a, b) => re[a] - re[b]);
  const shapes = new Float64Array(n * n);
  order.forEach((from, to) => { for (let i = 0; i < n; i += 1) shapes[i * n + to] = vectors[i * n + from]; });
  solveUpper(root, shapes, n, n);
  return { squares: Float64Array.from(order, (k) => re[k]), shapes };
}

/** States besides n coordinates and their rates, with the forces that are none of stiffness and damping. */
export interface Further {
  count: number;
  /** Forces by coordinates [n, n] and by these states [n, count]. */
  springs: Float64Array;
  drive: Float64Array;
  /** Their rates, and their values after samples, by coordinates, rates and these states [count, 2 n + count]. */
  by: Float64Array;
  held: Float64Array;
  samples: Sampled | null;
}

/**
 * The damped motions: eigenvalues and shapes of the equations of first order, in coordinates in which they are even.
 */
export function damped(
  mass: Float64Array, damping: Float64Array, stiffness: Float64Array, n: number, still: Undamped,
  further: Further | null = null,
): Motions {
  const basis = still.symmetric ? still.shapes : unitMasses(mass, n);
  const turned = (matrix: Float64Array, width = n) => product(basis, matrix, n, n, width, true);
  const info = (matrix: Float64Array) => turned(product(matrix, basis, n, n, n));
  const [springs, dampers] = [info(stiffness), info(damping)];
  if (still.symmetric) for (let k = 0; k < n * n; k += 1) springs[k] = k % (n + 1) ? 0 : still.squares[k / (n + 1)];
  const sizes = Array.from({ length: n }, (_, k) => Math.sqrt(Math.abs(springs[k * (n + 1)])));
  const least = SLOWEST * Math.max(...sizes) || 1;
  const scale = sizes.map((size) => Math.max(size, least));
  if (further) info(further.springs).forEach((value, k) => { springs[k] -= value; });
  const count = further?.count ?? 0;
  const size = 2 * n + count;
  const first = new Float64Array(size * size);
  const drive = further && turned(further.drive, count);
  for (let i = 0; i < n; i += 1) {
    first[i * size + n + i] = scale[i];
    const row = (n + i) * size;
    for (let j = 0; j < n; j += 1) {
      first[row + j] = -springs[i * n + j] / scale[j];
      first[row + n + j] = -dampers[i * n + j];
    }
    for (let j = 0; j < count; j += 1) first[row + 2 * n + j] = drive![i * count + j];
  }
  const inBasis = (rows: Float64Array) => rows.map((value, k) => {
    const [row, column] = [k - k % size, k % size];
    if (column >= 2 * n) return value;
    let sum = 0;
    for (let i = 0; i < n; i += 1) sum += rows[row + i + (column < n ? 0 : n)] * basis[i * n + column % n];
    return column < n ? sum / scale[column] : sum;
  });
  if (further) first.set(inBasis(further.by), 2 * n * size);
  const samples = further?.samples;
  const { values, re, im } = motionsOf(samples ? overPeriod(first, inBasis(further!.held), samples, n) : first, size);
  const shown = (part: Float64Array, from: number) => product(
    basis, part.slice(from * size, (from + n) * size).map((x, k) => (from ? x : x / scale[Math.floor(k / size)])),
    n, n, size,
  );
  const motions = { count: size, values, shapes: { re: shown(re, 0), im: shown(im, 0) } };
  return samples ? betweenSamples(motions, { re: shown(re, n), im: shown(im, n) }, samples.period, n) : motions;
}

/** Eigenvalues and complex vectors [n, n] (columns) of a matrix, balanced first: B. N. Parlett, C. Reinsch (1969). */
function motionsOf(matrix: Float64Array, n: number): Complex & { values: Complex } {
  const [even, scale] = balanced(matrix, n);
  const found = new EigenvalueDecomposition(Matrix.from1DArray(n, n, even), { assumeSymmetric: false });
  const [values, vectors] = [{
    re: Float64Array.from(found.realEigenvalues), im: Float64Array.from(found.imaginaryEigenvalues),
  }, found.eigenvectorMatrix];
  const [re, im] = [new Float64Array(n * n), new Float64Array(n * n)];
  values.im.forEach((turn, k) => {
    const parts = [[re, vectors.getColumn(turn < 0 ? k - 1 : k), 1]] as [Float64Array, number[], number][];
    if (turn) parts.push([im, vectors.getColumn(turn > 0 ? k + 1 : k), Math.sign(turn)]);
    const most = parts.reduce((size, [, column]) => column.reduce((a, x) => Math.max(a, Math.abs(x)), size), 0);
    for (const [into, column, sign] of parts)
      column.forEach((x, i) => { into[n * i + k] = Math.abs(x) > APART * most ? sign * scale[i] * x : 0; });
  });
  return { values, re, im };
}

/** The matrix D^-1 A D whose rows and columns are of like size, and the powers of two D. */
function balanced(matrix: Float64Array, n: number): [Float64Array, Float64Array] {
  const [a, scale] = [matrix.slice(), new Float64Array(n).fill(1)];
  for (let changed = true; changed;) {
    changed = false;
    for (let i = 0; i < n; i += 1) {
      let [row, column] = [0, 0];
      for (let j = 0; j < n; j += 1) {
        if (j === i) continue;
        row += Math.abs(a[i * n + j]);
        column += Math.abs(a[j * n + i]);
      }
      if (!row || !column) continue;
      const factor = 2 ** Math.round(Math.log2(row / column) / 2);
      if (column * factor + row / factor >= 0.95 * (column + row)) continue;
      changed = true;
      scale[i] *= factor;
      for (let j = 0; j < n; j += 1) {
        a[i * n + j] /= factor;
        a[j * n + i] *= factor;
      }
    }
  }
  return [a, scale];
}

/** Columns x with x^T M x = 1, each to each: L^-T. */
function unitMasses(mass: Float64Array, n: number): Float64Array {
  const columns = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  solveUpper(cholesky(mass, n)!, columns, n, n);
  return columns;
}
