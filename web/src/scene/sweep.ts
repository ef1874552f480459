// A cross-section swept along a line that bends: one geometry, whose vertices move with the line.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";
import { SCALE, step } from "./palette";

/** The outline of a section of half-widths 1: points y, z and outward normals, in order; flat faces have their own. */
interface Outline {
  points: Float32Array;
  normals: Float32Array;
}

const SQUARE = [[1, 1], [-1, 1], [-1, -1], [1, -1]];

function round(count: number): Outline {
  const points = new Float32Array(2 * (count + 1));
  for (let k = 0; k <= count; k++) {
    points[2 * k] = Math.cos((2 * Math.PI * k) / count);
    points[2 * k + 1] = Math.sin((2 * Math.PI * k) / count);
  }
  return { points, normals: points };
}

function box(): Outline {
  const points: number[] = [];
  const normals: number[] = [];
  SQUARE.forEach((corner, k) => {
    const next = SQUARE[(k + 1) % 4];
    points.push(...corner, ...next);
    for (let twice = 0; twice < 2; twice++) normals.push((corner[0] + next[0]) / 2, (corner[1] + next[1]) / 2);
  });
  return { points: Float32Array.from(points), normals: Float32Array.from(normals) };
}

export interface SectionSizes {
  shape: "round" | "box";
  /** Half-widths along y and z at each station [S, 2] m. */
  sizes: Float32Array;
}

export class Sweep {
  readonly geometry = new BufferGeometry();
  private readonly outline: Outline;
  private readonly around: number;
  private readonly position: Float32Array;
  private readonly normal: Float32Array;
  private readonly colour: Float32Array;
  private readonly axes = new Float32Array(9);

  constructor(private readonly stations: number, private readonly section: SectionSizes, segments: number) {
    this.outline = section.shape === "round" ? round(segments) : box();
    this.around = this.outline.points.length / 2;
    const vertices = (stations + 2) * this.around; // the rings, and the ends once more with normals of their own
    [this.position, this.normal, this.colour] = [0, 1, 2].map(() => new Float32Array(3 * vertices));
    this.colour.fill(1);
    ["position", "normal", "color"].forEach((name, k) => {
      const attribute = new BufferAttribute([this.position, this.normal, this.colour][k], 3);
      this.geometry.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
    });
    this.geometry.setIndex(this.faces());
  }

  /** Lay the surface about a line [S, 3] at `from`; `root` is the quaternion at `at` that turns the section there. */
  shape(line: Float32Array, from: number, roots: Float32Array, at: number): void {
    const { stations, axes } = this;
    sectionAxes(axes, roots, at);
    for (let s = 0; s < stations; s++) {
      const before = from + 3 * Math.max(s - 1, 0);
      const after = from + 3 * Math.min(s + 1, stations - 1);
      transport(
        axes,
        line[after] - line[before],
        line[after + 1] - line[before + 1],
        line[after + 2] - line[before + 2],
      );
      this.ring(s, s, line, from + 3 * s, 0);
      if (s === 0) this.ring(stations, s, line, from, -1);
      if (s === stations - 1) this.ring(stations + 1, s, line, from + 3 * s, 1);
    }
    this.geometry.attributes.position.needsUpdate = true;
    this.geometry.attributes.normal.needsUpdate = true;
  }

  /** Colour the stations by their values [S] at `from`, of the range `low` to `high`. */
  paint(values: Float32Array, from: number, low: number, high: number): void {
    const { around, colour, stations } = this;
    const span = high > low ? high - low : 1;
    for (let ring = 0; ring < stations + 2; ring++) {
      const s = ring < stations ? ring : ring === stations ? 0 : stations - 1;
      const found = step((values[from + s] - low) / span);
      for (let k = 3 * ring * around; k < 3 * (ring + 1) * around; k += 3) {
        colour[k] = SCALE[found];
        colour[k + 1] = SCALE[found + 1];
        colour[k + 2] = SCALE[found + 2];
      }
    }
    this.geometry.attributes.color.needsUpdate = true;
  }

  dispose(): void {
    this.geometry.dispose();
  }

  /** `end` -1 and 1: the flat faces at root and tip, 0: the side. */
  private ring(ring: number, station: number, line: Float32Array, at: number, end: number): void {
    const { axes, around, position, normal, section, outline } = this;
    const wide = section.sizes[2 * station];
    const high = section.sizes[2 * station + 1];
    for (let k = 0; k < around; k++) {
      const y = wide * outline.points[2 * k];
      const z = high * outline.points[2 * k + 1];
      const ny = outline.normals[2 * k];
      const nz = outline.normals[2 * k + 1];
      for (let c = 0; c < 3; c++) {
        const place = 3 * (ring * around + k) + c;
        position[place] = line[at + c] + y * axes[3 + c] + z * axes[6 + c];
        normal[place] = end === 0 ? ny * axes[3 + c] + nz * axes[6 + c] : end * axes[c];
      }
    }
  }

  private faces(): number[] {
    const { around, stations } = this;
    const found: number[] = [];
    for (let s = 0; s < stations - 1; s++)
      for (let k = 0; k < around - 1; k++) {
        const a = s * around + k;
        found.push(a, a + around, a + 1, a + 1, a + around, a + around + 1);
      }
    for (let k = 1; k < around - 1; k++) {
      const root = stations * around;
      const tip = root + around;
      found.push(root, root + k, root + k + 1, tip, tip + k + 1, tip + k);
    }
    // Seen from outside the corners run against the clock.
    for (let k = 0; k < found.length; k += 3) [found[k + 1], found[k + 2]] = [found[k + 2], found[k + 1]];
    return found;
  }
}

/** The axes x, y, z (each three numbers) of the quaternion x, y, z, w at `at`. */
export function sectionAxes(out: Float32Array, q: Float32Array, at: number): void {
  const x = q[at];
  const y = q[at + 1];
  const z = q[at + 2];
  const w = q[at + 3];
  out[0] = 1 - 2 * (y * y + z * z);
  out[1] = 2 * (x * y + z * w);
  out[2] = 2 * (x * z - y * w);
  out[3] = 2 * (x * y - z * w);
  out[4] = 1 - 2 * (x * x + z * z);
  out[5] = 2 * (y * z + x * w);
  out[6] = 2 * (x * z + y * w);
  out[7] = 2 * (y * z - x * w);
  out[8] = 1 - 2 * (x * x + y * y);
}

/** Turn the axes to a new tangent without twist: by the shortest way, which is the rotation from tangent to tangent. */
export function transport(axes: Float32Array, tx: number, ty: number, tz: number): void {
  const size = Math.hypot(tx, ty, tz);
  if (size === 0) return;
  const x = tx / size;
  const y = ty / size;
  const z = tz / size;
  // Rotation by the axis a x t: v' = v + c x v + (c x (c x v))/(1 + a.t); for opposite tangents there is no such way.
  const cx = axes[1] * z - axes[2] * y;
  const cy = axes[2] * x - axes[0] * z;
  const cz = axes[0] * y - axes[1] * x;
  const along = 1 + axes[0] * x + axes[1] * y + axes[2] * z;
  const less = along > 1e-9 ? 1 / along : 0;
  for (let k = 3; k < 9; k += 3) {
    const ux = cy * axes[k + 2] - cz * axes[k + 1];
    const uy = cz * axes[k] - cx * axes[k + 2];
    const uz = cx * axes[k + 1] - cy * axes[k];
    axes[k] += ux + less * (cy * uz - cz * uy);
    axes[k + 1] += uy + less * (cz * ux - cx * uz);
    axes[k + 2] += uz + less * (cx * uy - cy * ux);
  }
  axes[0] = x;
  axes[1] = y;
  axes[2] = z;
}
