// Vectors and rotations in space, as runs of numbers within arrays: an array, and where in it they begin. Written out,
// and without arrays in between: these run a million times while a slider moves.

export type Reals = Float64Array;

/** into += factor a x b. */
export function addCross(into: Reals, at: number, a: Reals, i: number, b: Reals, j: number, factor = 1): void {
  const x = a[i + 1] * b[j + 2] - a[i + 2] * b[j + 1];
  const y = a[i + 2] * b[j] - a[i] * b[j + 2];
  const z = a[i] * b[j + 1] - a[i + 1] * b[j];
  into[at] += factor * x;
  into[at + 1] += factor * y;
  into[at + 2] += factor * z;
}

/** into += factor a. */
export function add(into: Reals, at: number, a: Reals, i: number, factor = 1): void {
  into[at] += factor * a[i];
  into[at + 1] += factor * a[i + 1];
  into[at + 2] += factor * a[i + 2];
}

/** into = a. */
export function copy(into: Reals, at: number, a: Reals, i: number, size = 3): void {
  for (let k = 0; k < size; k += 1) into[at + k] = a[i + k];
}

/** into += factor R x; `into` and `x` apart. */
export function addTurned(into: Reals, at: number, r: Reals, i: number, x: Reals, j: number, factor = 1): void {
  into[at] += factor * (r[i] * x[j] + r[i + 1] * x[j + 1] + r[i + 2] * x[j + 2]);
  into[at + 1] += factor * (r[i + 3] * x[j] + r[i + 4] * x[j + 1] + r[i + 5] * x[j + 2]);
  into[at + 2] += factor * (r[i + 6] * x[j] + r[i + 7] * x[j + 1] + r[i + 8] * x[j + 2]);
}

/** Of x what is along column `axis` of R. */
export function along(r: Reals, i: number, axis: number, x: Reals, j: number): number {
  return r[i + axis] * x[j] + r[i + 3 + axis] * x[j + 1] + r[i + 6 + axis] * x[j + 2];
}

/** into = A B; all apart. */
export function product(into: Reals, at: number, a: Reals, i: number, b: Reals, j: number): void {
  for (let row = 0; row < 3; row += 1) {
    for (let k = 0; k < 3; k += 1) {
      into[at + 3 * row + k] =
        a[i + 3 * row] * b[j + k] + a[i + 3 * row + 1] * b[j + 3 + k] + a[i + 3 * row + 2] * b[j + 6 + k];
    }
  }
}

/** into = rotation about a unit vector by an angle. */
export function rotationAbout(into: Reals, at: number, axis: Reals, i: number, angle: number): void {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [x, y, z] = [axis[i], axis[i + 1], axis[i + 2]];
  into[at] = x * x + c * (1 - x * x);
  into[at + 1] = (1 - c) * x * y - s * z;
  into[at + 2] = (1 - c) * x * z + s * y;
  into[at + 3] = (1 - c) * x * y + s * z;
  into[at + 4] = y * y + c * (1 - y * y);
  into[at + 5] = (1 - c) * y * z - s * x;
  into[at + 6] = (1 - c) * x * z - s * y;
  into[at + 7] = (1 - c) * y * z + s * x;
  into[at + 8] = z * z + c * (1 - z * z);
}
