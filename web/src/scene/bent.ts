// The surface of a link that bends: each vertex at its station of the link's line, off it as in the section there.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { finer, type Triangles } from "./finer";
import { SCALE, step } from "./palette";
import { sectionAxes, transport } from "./sweep";

const PIECES = 24; // along a link, at least: a longer triangle would stay straight

/** Distances of the stations from the root along links that follow each other, in the first frame [m]. */
export function distances(line: Float32Array, stations: number, links: number[]): Float32Array {
  const found = new Float32Array(stations * links.length);
  let total = 0;
  links.forEach((link, j) => {
    for (let s = 0; s < stations; s++) {
      const at = 3 * (stations * link + s);
      if (s > 0) total += Math.hypot(line[at] - line[at - 3], line[at + 1] - line[at - 2], line[at + 2] - line[at - 1]);
      found[j * stations + s] = total;
    }
  });
  return found;
}

export class Bent {
  readonly geometry: BufferGeometry;
  private readonly rest: Float32Array;
  private readonly facing: Float32Array;
  /** Of each vertex the station before it, the share of the way to the next, and how far it is beyond both ends [m]. */
  private readonly station: Uint16Array;
  private readonly share: Float32Array;
  private readonly beyond: Float32Array;
  private readonly frames: Float32Array;
  private readonly axes = new Float32Array(9);

  /**
   * `surface`: in the frame of the root of the first of `links`, whose x runs along the line; `at`: of its
   * stations.
   */
  constructor(surface: Triangles, private readonly links: number[], private readonly stations: number,
    at: Float32Array, crease: number) {
    const { vertices, faces } = finer(surface, at[at.length - 1] / PIECES);
    const plain = new BufferGeometry();
    plain.setAttribute("position", new BufferAttribute(vertices, 3));
    plain.setIndex(new BufferAttribute(faces, 1));
    this.geometry = toCreasedNormals(plain, crease);
    const { position, normal } = this.geometry.attributes as Record<string, BufferAttribute>;
    [this.rest, this.facing] = [position, normal].map(({ array }) => Float32Array.from(array));
    for (const one of [position, normal]) one.setUsage(DynamicDrawUsage);
    const count = this.rest.length / 3;
    this.geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * count).fill(1), 3));
    this.station = new Uint16Array(count);
    [this.share, this.beyond] = [new Float32Array(count), new Float32Array(count)];
    this.frames = new Float32Array(9 * at.length);
    for (let v = 0; v < count; v++) this.place(v, at);
  }

  private place(v: number, at: Float32Array): void {
    const x = this.rest[3 * v];
    const inside = Math.min(Math.max(x, 0), at[at.length - 1]);
    let k = 0;
    while (k < at.length - 2 && at[k + 1] < inside) k++;
    const span = at[k + 1] - at[k];
    this.station[v] = k;
    this.share[v] = span > 0 ? (inside - at[k]) / span : 0;
    this.beyond[v] = x - inside;
  }

  /** Lay it about the lines [L, S, 3]; `roots` are the quaternions that turn the sections at the links' roots. */
  shape(line: Float32Array, roots: Float32Array): void {
    this.turn(line, roots);
    const { rest, facing, station, share, beyond, frames } = this;
    const { position, normal } = this.geometry.attributes as Record<string, BufferAttribute>;
    const [places, faced] = [position.array, normal.array];
    for (let v = 0; v < station.length; v++) {
      const [k, w, out] = [station[v], share[v], beyond[v]];
      const [here, next] = [this.placeOf(k), this.placeOf(k + 1)];
      const [y, z] = [rest[3 * v + 1], rest[3 * v + 2]];
      for (let c = 0; c < 3; c++) {
        const a = 9 * k + c;
        const [ax, ay, az] = [0, 3, 6].map((row) => frames[a + row] + w * (frames[a + row + 9] - frames[a + row]));
        places[3 * v + c] = line[here + c] + w * (line[next + c] - line[here + c]) + out * ax + y * ay + z * az;
        faced[3 * v + c] = facing[3 * v] * ax + facing[3 * v + 1] * ay + facing[3 * v + 2] * az;
      }
    }
    position.needsUpdate = normal.needsUpdate = true;
  }

  /** Colour by the values [L, S] of the stations, of the range `low` to `high`. */
  paint(values: Float32Array, low: number, high: number): void {
    const { color } = this.geometry.attributes as Record<string, BufferAttribute>;
    for (let v = 0; v < this.station.length; v++) {
      const k = this.station[v] + Math.round(this.share[v]);
      const found = step((values[this.placeOf(k) / 3] - low) / (high - low || 1));
      for (let c = 0; c < 3; c++) color.array[3 * v + c] = SCALE[found + c];
    }
    color.needsUpdate = true;
  }

  /** Where a station is in the numbers of all lines. */
  private placeOf(station: number): number {
    const { links, stations } = this;
    return 3 * (links[Math.floor(station / stations)] * stations + (station % stations));
  }

  /** The axes of the sections at all stations. */
  private turn(line: Float32Array, roots: Float32Array): void {
    const { axes, frames, links, stations } = this;
    links.forEach((link, j) => {
      sectionAxes(axes, roots, 4 * link);
      for (let s = 0; s < stations; s++) {
        const before = 3 * (link * stations + Math.max(s - 1, 0));
        const after = 3 * (link * stations + Math.min(s + 1, stations - 1));
        transport(
          axes, line[after] - line[before], line[after + 1] - line[before + 1], line[after + 2] - line[before + 2],
        );
        frames.set(axes, 9 * (j * stations + s));
      }
    });
  }
}
