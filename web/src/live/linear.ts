// Small dense systems of equations.

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
