// Which damped motion is which undamped mode: as tmodes/analysis/modes/ pairs them.

import type { Motions, Undamped } from "./eigen";

const STILL = 1e-9; // imaginary over absolute value of an eigenvalue below which its motion does not ring

/**
 * How alike undamped shapes and damped motions are [n, count], from 0 to 1, where `inner` is the product of columns.
 */
export function likeness(still: Undamped, motions: Motions, n: number, mass: Float64Array | null): Float64Array {
  const { count, shapes } = motions;
  const weighted = (column: (i: number) => number) => (i: number) => {
    if (!mass) return column(i);
    let sum = 0;
    for (let j = 0; j < n; j += 1) sum += mass[i * n + j] * column(j);
    return sum;
  };
  const dot = (a: (i: number) => number, b: (i: number) => number) => {
    let sum = 0;
    for (let i = 0; i < n; i += 1) sum += a(i) * b(i);
    return sum;
  };
  const ours = columnsOf(still.shapes, n, n);
  const [re, im] = [columnsOf(shapes.re, n, count), columnsOf(shapes.im, n, count)];
  const heavy = ours.map((one) => Float64Array.from({ length: n }, (_, i) => weighted((j) => one[j])(i)));
  const size = (one: Float64Array) => dot((i) => one[i], weighted((j) => one[j]));
  const [own, other] = [
    ours.map((one) => Math.sqrt(size(one))),
    re.map((one, k) => Math.sqrt(size(one) + size(im[k]))),
  ];
  const found = new Float64Array(n * count);
  for (let k = 0; k < n; k += 1) {
    for (let m = 0; m < count; m += 1) {
      const [a, b] = [re, im].map((part) => dot((i) => heavy[k][i], (i) => part[m][i]));
      found[k * count + m] = Math.hypot(a, b) / (own[k] * (other[m] || 1));
    }
  }
  return found;
}

function columnsOf(matrix: Float64Array, rows: number, width: number): Float64Array[] {
  return Array.from({ length: width }, (_, k) => Float64Array.from({ length: rows }, (__, i) => matrix[i * width + k]));
}

/** Whether each motion rings upwards (of a pair the one counted), and whether it does not ring at all. */
function kinds({ values, count }: Motions): { rings: boolean[]; stands: boolean[] } {
  const sizes = Array.from({ length: count }, (_, k) => Math.hypot(values.re[k], values.im[k]));
  return {
    rings: sizes.map((size, k) => values.im[k] > STILL * size),
    stands: sizes.map((size, k) => Math.abs(values.im[k]) <= STILL * size),
  };
}

/** Each motion once, so that all pairs together are as alike as possible; oscillating and slow ones before others. */
export function bestPartners(alike: Float64Array, motions: Motions, n: number): number[] {
  const { count, values } = motions;
  const { rings, stands } = kinds(motions);
  const rank = new Float64Array(count);
  Array.from({ length: count }, (_, k) => k)
    .filter((k) => rings[k] || stands[k])
    .sort((a, b) => values.re[b] - values.re[a])
    .forEach((k, place) => {
      rank[k] = place;
    });
  const cost = Float64Array.from(alike, (value, at) => {
    const k = at % count;
    if (!rings[k] && !stands[k]) return 100;
    return rank[k] / (10 * count) - value * value - (rings[k] ? 10 : 0);
  });
  return assigned(cost, n, count);
}

/**
 * For each row [rows <= columns] its column, all different, of least total cost: R. Jonker, A. Volgenant, Computing 38
 * (1987).
 */
export function assigned(cost: Float64Array, rows: number, columns: number): number[] {
  const [u, v] = [new Float64Array(rows + 1), new Float64Array(columns + 1)];
  const row = new Int32Array(columns + 1); // of each column, counted from 1; 0: none
  for (let i = 1; i <= rows; i += 1) {
    const least = new Float64Array(columns + 1).fill(Infinity);
    const before = new Int32Array(columns + 1);
    const used = new Uint8Array(columns + 1);
    row[0] = i;
    let here = 0;
    while (row[here]) {
      used[here] = 1;
      let [step, next] = [Infinity, 0];
      for (let j = 1; j <= columns; j += 1) {
        if (used[j]) continue;
        const now = cost[(row[here] - 1) * columns + j - 1] - u[row[here]] - v[j];
        if (now < least[j]) { least[j] = now; before[j] = here; }
        if (least[j] < step) { step = least[j]; next = j; }
      }
      for (let j = 0; j <= columns; j += 1) {
        if (used[j]) { u[row[j]] += step; v[j] -= step; }
        else least[j] -= step;
      }
      here = next;
    }
    for (; here; here = before[here]) row[here] = row[before[here]];
  }
  const found = new Array<number>(rows).fill(-1);
  for (let j = 1; j <= columns; j += 1) if (row[j]) found[row[j] - 1] = j - 1;
  return found;
}
