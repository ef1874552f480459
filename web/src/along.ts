// Parts of a vector over time, along their sum: they add up to its size, as `along` of tmodes/analysis/error_parts.py.

/** Of parts [n, parts, 3] at sample `k` the component of part `index` along their sum; of -1 the size of the sum. */
export function alongSum(
  { data, shape: [, parts] }: { data: ArrayLike<number>; shape: number[] }, k: number, index: number,
): number {
  let [x, y, z] = [0, 0, 0];
  for (let j = 3 * parts * k; j < 3 * parts * (k + 1); j += 3) {
    x += data[j];
    y += data[j + 1];
    z += data[j + 2];
  }
  const size = Math.hypot(x, y, z);
  if (index < 0 || size === 0) return size;
  const own = 3 * (parts * k + index);
  return (x * data[own] + y * data[own + 1] + z * data[own + 2]) / size;
}
