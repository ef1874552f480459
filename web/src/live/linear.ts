// Small dense systems of equations.

import { Matrix, SingularValueDecomposition } from "ml-matrix";

const EPSILON = 2 ** -52;

/** Solve matrix x = right by elimination with pivots: both are used up, `right` becomes x; false where singular. */
export function solveInPlace(a: Float64Array, x: Float64Array): boolean {
  const n = x.length;
  for (let k = 0; k < n; k += 1) {
    let pivot = k;
    for (let i = k + 1; i < n; i += 1) if (Math.abs(a[i * n + k]) > Math.abs(a[pivot * n + k])) pivot = i;
    const size = Math.abs(a[pivot * n + k]);
    if (!(size > 0) || size === Infinity) return false;
    if (pivot !== k) exchanged(a, x, k, pivot);
    for (let i = k + 1; i < n; i += 1) {
      const factor = a[i * n + k] / a[k * n + k];
      if (factor === 0) continue;
      for (let j = k + 1; j < n; j += 1) a[i * n + j] -= factor * a[k * n + j];
      x[i] -= factor * x[k];
    }
  }
  for (let i = n - 1; i >= 0; i -= 1) {
    for (let j = i + 1; j < n; j += 1) x[i] -= a[i * n + j] * x[j];
    x[i] /= a[i * n + i];
  }
  return true;
}

function exchanged(a: Float64Array, x: Float64Array, i: number, j: number): void {
  const n = x.length;
  for (let k = 0; k < n; k += 1) {
    const kept = a[i * n + k];
    a[i * n + k] = a[j * n + k];
    a[j * n + k] = kept;
  }
  const kept = x[i];
  x[i] = x[j];
  x[j] = kept;
}

/** The lower triangle L with L L^T = a [n, n], whose upper triangle is not read; null where there is none. */
export function cholesky(a: Float64Array, n: number): Float64Array | null {
  const root = new Float64Array(n * n);
  for (let j = 0; j < n; j += 1) {
    for (let i = j; i < n; i += 1) {
      let value = a[i * n + j];
      for (let k = 0; k < j; k += 1) value -= root[i * n + k] * root[j * n + k];
      if (i === j && !(value > 0)) return null;
      root[i * n + j] = i === j ? Math.sqrt(value) : value / root[j * n + j];
    }
  }
  return root;
}

/** Solve L x = b for the columns of b [n, width], in place. */
export function solveLower(root: Float64Array, b: Float64Array, n: number, width: number): void {
  for (let i = 0; i < n; i += 1) {
    for (let k = 0; k < i; k += 1) lessRow(b, i, k, root[i * n + k], width);
    for (let c = 0; c < width; c += 1) b[i * width + c] /= root[i * n + i];
  }
}

/** Solve L^T x = b for the columns of b [n, width], in place. */
export function solveUpper(root: Float64Array, b: Float64Array, n: number, width: number): void {
  for (let i = n - 1; i >= 0; i -= 1) {
    for (let k = i + 1; k < n; k += 1) lessRow(b, i, k, root[k * n + i], width);
    for (let c = 0; c < width; c += 1) b[i * width + c] /= root[i * n + i];
  }
}

function lessRow(b: Float64Array, i: number, k: number, factor: number, width: number): void {
  for (let c = 0; c < width; c += 1) b[i * width + c] -= factor * b[k * width + c];
}

/** L^-1 a L^-T [n, n]. */
export function congruent(root: Float64Array, a: Float64Array, n: number): Float64Array {
  const left = a.slice();
  solveLower(root, left, n, n);
  const right = transposed(left, n);
  solveLower(root, right, n, n);
  return transposed(right, n);
}

function transposed(a: Float64Array, n: number): Float64Array {
  return a.map((_, k) => a[(k % n) * n + Math.floor(k / n)]);
}

/** a b of a [rows, inner], b [inner, width]; `turned`: of the transpose of a [inner, rows]. */
export function product(
  a: Float64Array,
  b: Float64Array,
  rows: number,
  inner: number,
  width: number,
  turned = false,
): Float64Array {
  const found = new Float64Array(rows * width);
  for (let i = 0; i < rows; i += 1) {
    for (let k = 0; k < inner; k += 1) {
      const factor = turned ? a[k * rows + i] : a[i * inner + k];
      if (factor) for (let j = 0; j < width; j += 1) found[i * width + j] += factor * b[k * width + j];
    }
  }
  return found;
}

/** The inverse of a [n, n], which is used up; null where it has none. */
export function inverted(a: Float64Array, n: number): Float64Array | null {
  const found = Float64Array.from({ length: n * n }, (_, k) => (k % (n + 1) ? 0 : 1));
  for (let k = 0; k < n; k += 1) {
    let pivot = k;
    for (let i = k + 1; i < n; i += 1) if (Math.abs(a[i * n + k]) > Math.abs(a[pivot * n + k])) pivot = i;
    const size = Math.abs(a[pivot * n + k]);
    if (!(size > 0) || size === Infinity) return null;
    for (const matrix of [a, found]) {
      if (pivot !== k) {
        const kept = matrix.slice(k * n, (k + 1) * n);
        matrix.copyWithin(k * n, pivot * n, (pivot + 1) * n);
        matrix.set(kept, pivot * n);
      }
    }
    const own = a[k * n + k];
    for (let j = 0; j < n; j += 1) {
      a[k * n + j] /= own;
      found[k * n + j] /= own;
    }
    for (let i = 0; i < n; i += 1) {
      const factor = a[i * n + k];
      if (i === k || factor === 0) continue;
      for (let j = k; j < n; j += 1) a[i * n + j] -= factor * a[k * n + j];
      for (let j = 0; j < n; j += 1) found[i * n + j] -= factor * found[k * n + j];
    }
  }
  return found;
}

/** x of least size with a x = b as nearly as can be, of a [rows, n], b [rows, width], which are used up. */
export function leastSquares(a: Float64Array, b: Float64Array, rows: number, n: number, width: number): Float64Array {
  for (let k = 0; k < Math.min(n, rows); k += 1) {
    let size = 0;
    for (let i = k; i < rows; i += 1) size = Math.hypot(size, a[i * n + k]);
    if (!size) continue;
    const lead = a[k * n + k] > 0 ? -size : size;
    const mirror = Float64Array.from({ length: rows - k }, (_, i) => a[(k + i) * n + k] - (i ? 0 : lead));
    const half = mirror.reduce((sum, value) => sum + value * value, 0) / 2;
    for (const [matrix, wide] of [[a, n], [b, width]] as const)
      for (let j = 0; j < wide; j += 1) {
        let along = 0;
        for (let i = k; i < rows; i += 1) along += mirror[i - k] * matrix[i * wide + j];
        for (let i = k; i < rows; i += 1) matrix[i * wide + j] -= (along / half) * mirror[i - k];
      }
  }
  const m = Math.min(n, rows);
  const square = a.subarray(0, m * n).map((value, k) => (k % n < Math.floor(k / n) ? 0 : value));
  const upper = Matrix.from1DArray(m, n, square);
  const { diagonal, leftSingularVectors: u, rightSingularVectors: v } =
    new SingularValueDecomposition(upper, { autoTranspose: true });
  const found = new Float64Array(n * width);
  diagonal.forEach((value, t) => {
    if (!(value > EPSILON * Math.max(rows, n) * diagonal[0])) return;
    for (let j = 0; j < width; j += 1) {
      let along = 0;
      for (let i = 0; i < m; i += 1) along += u.get(i, t) * b[i * width + j];
      for (let i = 0; i < n; i += 1) found[i * width + j] += (v.get(i, t) * along) / value;
    }
  });
  return found;
}
