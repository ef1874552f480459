// Vectors and rotations in space, as runs of numbers within arrays: an array, and where in it they begin.

export type Reals = Float64Array;

/** into += factor a x b. */
export function addCross(into: Reals, at: number, a: Reals, i: number, b: Reals, j: number, factor = 1): void {
  const [x, y, z] = [a[i + 1] * b[j + 2] - a[i + 2] * b[j + 1], a[i + 2] * b[j] - a[i] * b[j + 2], a[i] * b[j + 1] - a[i + 1] * b[j]];
  into[at] += factor * x;
  into[at + 1] += factor * y;
  into[at + 2] += factor * z;
}

/** into += factor a. */
export function add(into: Reals, at: number, a: Reals, i: number, factor = 1): void {
  for (let k = 0; k < 3; k += 1) into[at + k] += factor * a[i + k];
}

/** into = a. */
export function copy(into: Reals, at: number, a: Reals, i: number, size = 3): void {
  for (let k = 0; k < size; k += 1) into[at + k] = a[i + k];
}

/** into += factor R x; `into` and `x` apart. */
export function addTurned(into: Reals, at: number, r: Reals, i: number, x: Reals, j: number, factor = 1): void {
  for (let k = 0; k < 3; k += 1) into[at + k] += factor * (r[i + 3 * k] * x[j] + r[i + 3 * k + 1] * x[j + 1] + r[i + 3 * k + 2] * x[j + 2]);
}

/** Of x what is along column `axis` of R. */
export function along(r: Reals, i: number, axis: number, x: Reals, j: number): number {
  return r[i + axis] * x[j] + r[i + 3 + axis] * x[j + 1] + r[i + 6 + axis] * x[j + 2];
}

/** into = A B; all apart. */
export function product(into: Reals, at: number, a: Reals, i: number, b: Reals, j: number): void {
  for (let row = 0; row < 3; row += 1) {
    for (let k = 0; k < 3; k += 1) {
      into[at + 3 * row + k] = a[i + 3 * row] * b[j + k] + a[i + 3 * row + 1] * b[j + 3 + k] + a[i + 3 * row + 2] * b[j + 6 + k];
    }
  }
}

/** into = rotation about a unit vector by an angle. */
export function rotationAbout(into: Reals, at: number, axis: Reals, i: number, angle: number): void {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y, z] = [axis[i], axis[i + 1], axis[i + 2]];
  const rows = [
    x * x + c * (1 - x * x), (1 - c) * x * y - s * z, (1 - c) * x * z + s * y,
    (1 - c) * x * y + s * z, y * y + c * (1 - y * y), (1 - c) * y * z - s * x,
    (1 - c) * x * z - s * y, (1 - c) * y * z + s * x, z * z + c * (1 - z * z),
  ];
  for (let k = 0; k < 9; k += 1) into[at + k] = rows[k];
}
