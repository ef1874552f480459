// What is drawn about a robot: the ways of the tips, the force at a contact and the surface that is touched.
import {
  BufferAttribute, BufferGeometry, ConeGeometry, CylinderGeometry, DoubleSide, Group, Line, LineDashedMaterial, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, Quaternion, Vector3,
} from "three"; // prettier-ignore
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import type { SceneContact } from "../contract_scene";

const UP = new Vector3(0, 1, 0);

/** The way of a tip: full until now, dashed and faint from now on. */
export class Trace {
  readonly group = new Group();
  private readonly past: Line2;
  private readonly rest: Line<BufferGeometry, LineDashedMaterial>;
  private length = 0;

  constructor(path: Float32Array, color: string, dash: number) {
    this.past = new Line2(new LineGeometry(), new LineMaterial({ color, linewidth: 2.5 }));
    const faint = new LineDashedMaterial({ color, transparent: true, opacity: 0.7, dashSize: dash, gapSize: dash });
    this.rest = new Line(new BufferGeometry(), faint);
    this.past.frustumCulled = this.rest.frustumCulled = false;
    this.group.add(this.past, this.rest);
    this.lay(path);
  }

  /** Another way, of the same or of another number of points. */
  lay(path: Float32Array): void {
    this.length = path.length / 3;
    this.rest.geometry.dispose();
    this.past.geometry.dispose();
    this.past.geometry = new LineGeometry(); // one that was drawn keeps the number of points that it had
    const along = new Float32Array(this.length);
    for (let k = 1; k < along.length; k++)
      along[k] =
        along[k - 1] +
        Math.hypot(path[3 * k] - path[3 * k - 3], path[3 * k + 1] - path[3 * k - 2], path[3 * k + 2] - path[3 * k - 1]);
    this.rest.geometry.setAttribute("position", new BufferAttribute(path, 3));
    this.rest.geometry.setAttribute("lineDistance", new BufferAttribute(along, 1));
    this.past.visible = this.length > 1;
    if (this.past.visible) this.past.geometry.setPositions(path);
  }

  /** The frame up to which it is past. */
  seek(frame: number): void {
    this.past.geometry.instanceCount = Math.min(frame, this.length - 1);
    this.rest.geometry.setDrawRange(frame, this.length - frame);
  }

  dispose(): void {
    [this.past.geometry, this.past.material, this.rest.geometry, this.rest.material].forEach((thing) =>
      thing.dispose(),
    );
    this.group.removeFromParent();
  }
}

/** An arrow from where a force acts, as long as the force is large. */
export class Arrow {
  readonly group = new Group();
  private readonly shaft: Mesh;
  private readonly head: Mesh;
  private readonly parts: (BufferGeometry | MeshBasicMaterial)[];
  private readonly way = new Vector3();
  private readonly turn = new Quaternion();

  /** `wide`: radius of its shaft [m]; `scale`: length of a newton [m]. */
  constructor(color: string, private readonly wide: number, readonly scale: number) {
    const material = new MeshBasicMaterial({ color });
    const shaft = new CylinderGeometry(wide, wide, 1, 12).translate(0, 0.5, 0);
    const head = new ConeGeometry(2.6 * wide, 6 * wide, 16).translate(0, -3 * wide, 0);
    [this.shaft, this.head] = [new Mesh(shaft, material), new Mesh(head, material)];
    this.parts = [material, shaft, head];
    this.group.add(this.shaft, this.head);
  }

  point(force: Float32Array, at: Float32Array): void {
    const size = this.way.fromArray(force).length();
    const length = size * this.scale;
    this.group.visible = length > 0.5 * this.wide;
    if (!this.group.visible) return;
    this.group.position.fromArray(at);
    this.group.quaternion.copy(this.turn.setFromUnitVectors(UP, this.way.divideScalar(size)));
    this.shaft.scale.set(1, Math.max(length - 5 * this.wide, 1e-6), 1);
    this.head.position.y = length;
  }

  dispose(): void {
    this.parts.forEach((part) => part.dispose());
    this.group.removeFromParent();
  }
}

/** The part of the surface about the places of contact [k, 3], `margin` m larger than they need. */
export function surfaceMesh(
  surface: SceneContact["surface"],
  at: ArrayLike<number>,
  margin: number,
  color: string,
): Mesh {
  const material = new MeshLambertMaterial({
    color,
    transparent: true,
    opacity: 0.28,
    side: DoubleSide,
    depthWrite: false,
  });
  return new Mesh(patch(surface, at, margin), material);
}

type Place = (u: number, v: number) => Vector3;

/** Squares along each side of a patch. */
export const SQUARES = 24;

/** The part of a surface about places, as a grid of (SQUARES + 1)² vertices, row after row. */
export function patch(surface: SceneContact["surface"], at: ArrayLike<number>, margin: number): BufferGeometry {
  const points: Vector3[] = [];
  for (let k = 0; k + 2 < at.length; k += 3) points.push(new Vector3(at[k], at[k + 1], at[k + 2]));
  const [place, coordinates, more] = chart(surface, points, margin);
  const found = points.map(coordinates);
  const [u, v] = [0, 1].map((c) => {
    const values = found.map((pair) => pair[c]);
    return [
      values.reduce((a, b) => Math.min(a, b), Infinity) - more[c],
      values.reduce((a, b) => Math.max(a, b), -Infinity) + more[c],
    ];
  });
  return grid(place, u, v);
}

/** A map of the surface: place of two coordinates, coordinates of a place, and the margin in them. */
function chart(
  surface: SceneContact["surface"],
  points: Vector3[],
  margin: number,
): [Place, (p: Vector3) => [number, number], [number, number]] {
  if (surface.kind === "plane") {
    const origin = new Vector3(...surface.position);
    const [x, y] = across(new Vector3(...surface.normal).normalize());
    const place: Place = (u, v) => origin.clone().addScaledVector(x, u).addScaledVector(y, v);
    return [place, (p) => [p.clone().sub(origin).dot(x), p.clone().sub(origin).dot(y)], [3 * margin, 3 * margin]];
  }
  const center = new Vector3(...surface.center);
  const axis = surface.kind === "cylinder" ? new Vector3(...surface.axis).normalize() : new Vector3(0, 0, 1);
  const mean = points
    .reduce((sum, p) => sum.add(p), new Vector3())
    .divideScalar(Math.max(points.length, 1))
    .sub(center);
  const ahead = mean.addScaledVector(axis, -mean.dot(axis));
  if (ahead.length() < 1e-6 * surface.radius) ahead.copy(across(axis)[0]);
  ahead.normalize();
  const aside = new Vector3().crossVectors(axis, ahead);
  const { radius } = surface;
  const ball = surface.kind === "ball";
  const place: Place = (u, v) => {
    const flat = ball ? radius * Math.cos(v) : radius;
    const p = center
      .clone()
      .addScaledVector(ahead, flat * Math.cos(u))
      .addScaledVector(aside, flat * Math.sin(u));
    return p.addScaledVector(axis, ball ? radius * Math.sin(v) : v);
  };
  const coordinates = (p: Vector3): [number, number] => {
    const d = p.clone().sub(center);
    const up = d.dot(axis);
    return [
      Math.atan2(d.dot(aside), d.dot(ahead)),
      ball ? Math.asin(Math.max(-1, Math.min(1, up / (d.length() || 1)))) : up,
    ];
  };
  return [place, coordinates, [margin / radius, ball ? margin / radius : margin]];
}

function across(normal: Vector3): [Vector3, Vector3] {
  const x = new Vector3().crossVectors(Math.abs(normal.z) < 0.9 ? new Vector3(0, 0, 1) : UP, normal).normalize();
  return [x, new Vector3().crossVectors(normal, x)];
}

function grid(place: Place, u: number[], v: number[], count = SQUARES): BufferGeometry {
  const positions: number[] = [];
  const faces: number[] = [];
  for (let i = 0; i <= count; i++)
    for (let j = 0; j <= count; j++) {
      positions.push(...place(u[0] + ((u[1] - u[0]) * i) / count, v[0] + ((v[1] - v[0]) * j) / count).toArray());
      const a = i * (count + 1) + j;
      if (i < count && j < count) faces.push(a, a + 1, a + count + 1, a + 1, a + count + 2, a + count + 1);
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
  geometry.setIndex(faces);
  geometry.computeVertexNormals();
  return geometry;
}
