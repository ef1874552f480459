// Parts of a vector over time, along their sum: they add up to its size, as `along` of tmodes/analysis/error_parts.py.

/** Of parts [n, parts, 3] at sample `k` the component of part `index` along their sum; of -1 the size of the sum. */
export function alongSum(
  { data, shape: [, parts] }: { data: ArrayLike<number>; shape: number[] }, k: number, index: number,
): number {
  const total = [0, 0, 0];
  for (let j = 0; j < 3 * parts; j += 1) total[j % 3] += data[3 * parts * k + j];
  const size = Math.hypot(...total);
  if (index < 0 || size === 0) return size;
  return total.reduce((sum, value, j) => sum + value * data[3 * (parts * k + index) + j], 0) / size;
}
