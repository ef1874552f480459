// Aiming a camera: all places between two edges of the picture, from as near as that can be, none under a note.
import { isUnder, type Rooms } from "./room";

const BETWEEN = 4; // points from one place to the next: what joins them is seen too

/** Places as a camera sees them: to the right, upwards, and towards it, and the tangents of half its angles. */
export interface Seen {
  along: Float64Array[];
  tangents: [number, number];
}

/** Where to aim in one direction of the picture, so that all is between `low` and `high` of its half size. */
class Aim {
  /** The least from which that can be [m]. */
  readonly distance: number;
  private readonly first: number;
  private readonly last: number;
  private readonly low: number;
  private readonly high: number;

  constructor(at: Float64Array, depths: Float64Array, tangent: number, low: number, high: number) {
    let [first, last] = [Infinity, -Infinity];
    [this.low, this.high] = [tangent * low, tangent * high];
    at.forEach((place, k) => {
      first = Math.min(first, place + this.low * depths[k]);
      last = Math.max(last, place + this.high * depths[k]);
    });
    [this.first, this.last] = [first, last];
    this.distance = (last - first) / (this.high - this.low);
  }

  /** What is in the middle of the picture, seen from a distance [m]. */
  from(distance: number): number {
    return (this.first + this.last - (this.low + this.high) * distance) / 2;
  }
}

/** From which distance, at least `near`, and at what to the right and upwards one looks. */
export function aimed(seen: Seen, rooms: Rooms, near: number): { distance: number; at: [number, number] } {
  const known = new Map<string, Aim>();
  const aim = (axis: 0 | 1, low: number, high: number) => {
    const key = `${axis} ${low} ${high}`;
    const found = known.get(key) ?? new Aim(seen.along[axis], seen.along[2], seen.tangents[axis], low, high);
    known.set(key, found);
    return found;
  };
  const fits = rooms.parts.map(([a, b, c, d]) => {
    const aims = [aim(0, a, b), aim(1, c, d)];
    const distance = Math.max(near, ...aims.map((one) => one.distance));
    return { distance, at: aims.map((one) => one.from(distance)) as [number, number] };
  });
  fits.sort((one, other) => one.distance - other.distance);
  return fits.find((fit) => !covered(seen, rooms, fit.distance, fit.at)) ?? fits[fits.length - 1];
}

/** Whether a place, or what is between it and the next, is under a note. */
function covered({ along: [x, y, z], tangents }: Seen, rooms: Rooms, distance: number, at: [number, number]): boolean {
  if (rooms.notes.length === 0) return false;
  for (let k = 0; k + 1 < x.length; k++)
    for (let part = 0; part < BETWEEN; part++) {
      const [right, up, depth] = [x, y, z].map((axis) => axis[k] + ((axis[k + 1] - axis[k]) * part) / BETWEEN);
      const far = distance - depth;
      if (isUnder(rooms, (right - at[0]) / (far * tangents[0]), (up - at[1]) / (far * tangents[1]))) return true;
    }
  return false;
}
