// A surface of smaller triangles: edges that are long along x are halved, for both of their triangles alike.

export interface Triangles {
  /** Places [n, 3] m, and three of them for each triangle. */
  vertices: Float32Array;
  faces: Uint32Array;
}

const MOST = 60_000; // triangles
const ROUNDS = 12;

/** No edge longer along x than `length` [m], as far as the number of triangles allows. */
export function finer({ vertices, faces }: Triangles, length: number): Triangles {
  const places = Array.from(vertices);
  let triangles = Array.from(faces);
  for (let round = 0; round < ROUNDS && triangles.length < 3 * MOST; round++) {
    const middles = new Map<string, number>();
    const middle = (a: number, b: number): number | null => {
      if (!(Math.abs(places[3 * a] - places[3 * b]) > length)) return null;
      const key = a < b ? `${a},${b}` : `${b},${a}`;
      const known = middles.get(key);
      if (known !== undefined) return known;
      const made = places.length / 3;
      for (let c = 0; c < 3; c++) places.push((places[3 * a + c] + places[3 * b + c]) / 2);
      middles.set(key, made);
      return made;
    };
    const next: number[] = [];
    for (let k = 0; k < triangles.length; k += 3) {
      const [a, b, c] = triangles.slice(k, k + 3);
      split(next, [a, b, c], [middle(a, b), middle(b, c), middle(c, a)]);
    }
    triangles = next;
    if (middles.size === 0) break;
  }
  return { vertices: Float32Array.from(places), faces: Uint32Array.from(triangles) };
}

/** The parts of a triangle whose edges ab, bc, ca have these middles, null where an edge stays. */
function split(out: number[], corners: number[], middles: (number | null)[]): void {
  const count = middles.filter((one) => one !== null).length;
  if (count === 0) return void out.push(...corners);
  // turned so that the edges that stay come last
  const first = [0, 1, 2].find((k) => middles[k] !== null && (count !== 2 || middles[(k + 1) % 3] !== null)) ?? 0;
  const [a, b, c] = [0, 1, 2].map((k) => corners[(first + k) % 3]);
  const [p, q, r] = [0, 1, 2].map((k) => middles[(first + k) % 3] ?? -1);
  if (count === 1) out.push(a, p, c, p, b, c);
  else if (count === 2) out.push(p, b, q, a, p, q, a, q, c);
  else out.push(a, p, r, p, b, q, r, q, c, p, q, r);
}
