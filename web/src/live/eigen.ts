// Small vibrations M x'' + D x' + K x = 0: undamped shapes, and the motions of the damped equations.

import { EigenvalueDecomposition, Matrix } from "ml-matrix";
import { cholesky, congruent, product, solveUpper } from "./linear";

/** Squared circular frequencies, rising, and shapes [n, n] (columns) of unit modal mass. */
export interface Undamped {
  squares: Float64Array;
  shapes: Float64Array;
  /** Whether the stiffness is symmetric, as far as rounding lets it: then the shapes are orthogonal. */
  symmetric: boolean;
}

/** Eigenvalues [1/s] and complex shapes [n, count] (columns) of the coordinates. */
export interface Motions {
  count: number;
  values: { re: Float64Array; im: Float64Array };
  shapes: { re: Float64Array; im: Float64Array };
}

const SYMMETRIC = 1e-9;
const NOTHING = 1e-13;
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

/**
 * The damped motions: eigenvalues and shapes of the equations of first order, in coordinates in which they are even.
 */
export function damped(
  mass: Float64Array, damping: Float64Array, stiffness: Float64Array, n: number, still: Undamped,
): Motions {
  const basis = still.symmetric ? still.shapes : unitMasses(mass, n);
  const info = (matrix: Float64Array) => product(basis, product(matrix, basis, n, n, n), n, n, n, true);
  const [springs, dampers] = [info(stiffness), info(damping)];
  if (still.symmetric) for (let k = 0; k < n * n; k += 1) springs[k] = k % (n + 1) ? 0 : still.squares[k / (n + 1)];
  const sizes = Array.from({ length: n }, (_, k) => Math.sqrt(Math.abs(springs[k * (n + 1)])));
  const least = SLOWEST * Math.max(...sizes) || 1;
  const scale = sizes.map((size) => Math.max(size, least));
  const first = Matrix.zeros(2 * n, 2 * n);
  for (let i = 0; i < n; i += 1) {
    first.set(i, n + i, scale[i]);
    for (let j = 0; j < n; j += 1) {
      first.set(n + i, j, -springs[i * n + j] / scale[j]);
      first.set(n + i, n + j, -dampers[i * n + j]);
    }
  }
  const found = new EigenvalueDecomposition(first, { assumeSymmetric: false });
  const values = { re: Float64Array.from(found.realEigenvalues), im: Float64Array.from(found.imaginaryEigenvalues) };
  return { count: 2 * n, values, shapes: shapesOf(found.eigenvectorMatrix, values.im, basis, scale, n) };
}

/** Complex shapes [n, 2 n] of the columns of real and imaginary parts, pair by pair. */
function shapesOf(
  vectors: Matrix, im: Float64Array, basis: Float64Array, scale: number[], n: number,
): Motions["shapes"] {
  const parts = { re: new Float64Array(2 * n * n), im: new Float64Array(2 * n * n) };
  for (let k = 0; k < 2 * n; k += 1) {
    for (let i = 0; i < n; i += 1) {
      parts.re[2 * n * i + k] = vectors.get(i, im[k] < 0 ? k - 1 : k) / scale[i];
      parts.im[2 * n * i + k] = (im[k] > 0 ? vectors.get(i, k + 1) : im[k] < 0 ? -vectors.get(i, k) : 0) / scale[i];
    }
  }
  return { re: product(basis, parts.re, n, n, 2 * n), im: product(basis, parts.im, n, n, 2 * n) };
}

/** Columns x with x^T M x = 1, each to each: L^-T. */
function unitMasses(mass: Float64Array, n: number): Float64Array {
  const columns = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  solveUpper(cholesky(mass, n)!, columns, n, n);
  return columns;
}
