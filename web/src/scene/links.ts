// One robot in space: links swept along their lines, housings of its joints, its base, the payload at its tip.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, Group, Material, Mesh, MeshLambertMaterial,
  MeshStandardMaterial, Quaternion, SphereGeometry, Vector3,
} from "three"; // prettier-ignore
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Scene, SceneJoint, SceneLink, SceneMesh } from "../contract_scene";
import { Bent, distances } from "./bent";
import type { Motion } from "./motion";
import { SCALE, step } from "./palette";
import type { Painted } from "./shown";
import { surfaced } from "./surfaces";
import { Sweep, type SectionSizes } from "./sweep";

/** What a robot is made of, whatever moves it. */
export type Body = Pick<Scene, "links" | "joints" | "meshes">;

export interface Look {
  /** Of links that are not coloured by a quantity. */
  link: string;
  joint: string;
  gear: string;
  base: string;
  payload: string;
  /** Below 1: a ghost, links alone. */
  opacity: number;
  /** Which links a quantity colours. */
  painted: Painted;
  fine: boolean;
  /** Which of several robots in one place hides the others: the lowest. */
  layer?: number;
}

/** Sizes that all robots of a scene share [m]: the half-width of links that tell none, and the least that is drawn. */
export interface Widths {
  usual: number;
  least: number;
  floor: number;
}

type Coloured = MeshStandardMaterial | MeshLambertMaterial;

const UP = new Vector3(0, 1, 0);

/** Edges of surfaces that are sharper than this stay edges [rad]. */
const CREASE = 0.6;

export class RobotView {
  readonly group = new Group();
  private readonly sweeps: (Sweep | null)[];
  private readonly bents: Bent[] = [];
  private readonly placed: { object: Mesh; link: number; turn: Quaternion | null }[] = [];
  private readonly tinted: { material: Coloured; link: number }[] = [];
  private readonly rods: { object: Mesh; link: number; parent: number; place: number }[] = [];
  private readonly pedestals: { object: Mesh; link: number }[] = [];
  private readonly payload: Mesh | null = null;
  private readonly trash: (BufferGeometry | Material)[] = [];
  private readonly from = new Vector3();
  private readonly to = new Vector3();
  private readonly quaternion = new Quaternion();

  constructor(
    body: Body,
    motion: Motion,
    private readonly look: Look,
    private readonly widths: Widths,
  ) {
    const plain = this.material(look.link, false);
    const painted = look.painted === "none" ? plain : this.material("#ffffff", true);
    const meshed = surfaced(body);
    this.sweeps = body.links.map((link, k) => {
      if (k >= motion.links || meshed.has(k)) return null;
      const sweep = new Sweep(motion.stations, sizes(link, motion.stations, widths), look.fine ? 24 : 10);
      this.add(new Mesh(sweep.geometry, link.bends || look.painted === "all" ? painted : plain));
      return sweep;
    });
    body.meshes
      .filter(({ link }) => link < motion.links)
      .forEach((mesh) => (mesh.along ? this.bend(mesh, mesh.along, motion, painted) : this.surface(mesh)));
    if (look.opacity < 1) return;
    body.joints
      .filter(({ link }) => link < motion.links)
      .forEach((joint) => this.housing(joint, body.links[joint.link], meshed.has(joint.link)));
    body.links.slice(0, motion.links).forEach((link, k) => this.holder(link, k, motion, meshed));
    const ball = new SphereGeometry((meshed.size > 0 ? 0.5 : 1.5) * widths.usual, 24, 16);
    this.payload = this.add(new Mesh(this.kept(ball), this.material(look.payload, false)));
  }

  /** Take the pose of a motion; values from `low` to `high` colour the links where they are coloured. */
  update(motion: Motion, line: Float32Array, low: number, high: number): void {
    const { stations, roots, values } = motion;
    const size = 3 * stations;
    this.sweeps.forEach((sweep, k) => {
      sweep?.shape(line, k * size, roots, 4 * k);
      if (this.look.painted !== "none") sweep?.paint(values, k * stations, low, high);
    });
    for (const bent of this.bents) {
      bent.shape(line, roots);
      if (this.look.painted !== "none") bent.paint(values, low, high);
    }
    for (const { object, link, turn } of this.placed) {
      if (link < 0) continue;
      object.position.fromArray(line, link * size);
      object.quaternion.fromArray(roots, 4 * link);
      if (turn) object.quaternion.multiply(turn);
    }
    for (const { material, link } of this.tinted) {
      const found = step((values[(link + 1) * stations - 1] - low) / (high - low || 1));
      material.color.setRGB(SCALE[found], SCALE[found + 1], SCALE[found + 2]);
    }
    for (const rod of this.rods) this.between(rod.object, line, rod.place, rod.link * size);
    for (const { object, link } of this.pedestals) this.stand(object, line, link * size);
    this.payload?.position.copy(this.from.fromArray(motion.tip));
  }

  dispose(): void {
    this.sweeps.forEach((sweep) => sweep?.dispose());
    this.trash.forEach((thing) => thing.dispose());
    this.group.removeFromParent();
  }

  private material(color: string, vertexColors: boolean): Coloured {
    const { opacity, fine, layer = 0 } = this.look;
    const offset = layer + (opacity < 1 ? 2 : 0);
    const behind = { polygonOffset: offset > 0, polygonOffsetFactor: offset, polygonOffsetUnits: 4 * offset };
    const ghost = { transparent: opacity < 1, opacity, depthWrite: opacity >= 1, ...behind };
    const info = { color, vertexColors, ...ghost };
    return this.kept(
      fine ? new MeshStandardMaterial({ ...info, roughness: 0.5, metalness: 0.1 }) : new MeshLambertMaterial(info),
    );
  }

  private kept<Thing extends BufferGeometry | Material>(thing: Thing): Thing {
    this.trash.push(thing);
    return thing;
  }

  private add(object: Mesh): Mesh {
    object.frustumCulled = false; // its vertices move, its bounds would have to follow
    object.castShadow = object.receiveShadow = this.look.opacity >= 1;
    this.group.add(object);
    return object;
  }

  private housing(joint: SceneJoint, link: SceneLink | undefined, meshed: boolean): void {
    if (link === undefined || meshed || joint.drawing === "none") return;
    const wide = 1.5 * this.widths.usual;
    const shape =
      joint.drawing === "cylinder"
        ? new CylinderGeometry(wide, wide, 2.2 * wide, this.look.fine ? 32 : 14)
        : joint.drawing === "ball"
          ? new SphereGeometry(1.2 * wide, this.look.fine ? 32 : 14, this.look.fine ? 24 : 10)
          : new BoxGeometry(2 * wide, 2.2 * wide, 2 * wide);
    const object = this.add(
      new Mesh(this.kept(shape), this.material(joint.elastic ? this.look.gear : this.look.joint, false)),
    );
    const axis = new Vector3(...joint.axis).normalize();
    this.placed.push({ object, link: joint.link, turn: new Quaternion().setFromUnitVectors(UP, axis) });
  }

  private bend(mesh: SceneMesh, along: number[], motion: Motion, painted: Coloured): void {
    const surface = { vertices: Float32Array.from(mesh.vertices.data), faces: Uint32Array.from(mesh.faces.data) };
    const at = distances(Float32Array.from(motion.arrays.line.data), motion.stations, along);
    const bent = new Bent(surface, along, motion.stations, at, CREASE);
    this.kept(bent.geometry);
    this.bents.push(bent);
    const own = this.look.painted === "none" && this.look.opacity >= 1;
    this.add(new Mesh(bent.geometry, own ? this.material(mesh.colour, false) : painted));
  }

  private surface(mesh: SceneMesh): void {
    const plain = new BufferGeometry();
    plain.setAttribute("position", new BufferAttribute(Float32Array.from(mesh.vertices.data), 3));
    plain.setIndex(new BufferAttribute(Uint32Array.from(mesh.faces.data), 1));
    const geometry = this.kept(toCreasedNormals(plain, CREASE));
    const material = this.material(this.look.opacity < 1 ? this.look.link : mesh.colour, false);
    this.placed.push({ object: this.add(new Mesh(geometry, material)), link: mesh.link, turn: null });
    if (this.look.painted === "all" && mesh.link >= 0) this.tinted.push({ material, link: mesh.link });
  }

  /** What holds the root of a link: its parent's end, a rod from the nearest place of the parent, or a pedestal. */
  private holder(link: SceneLink, index: number, motion: Motion, meshed: Set<number>): void {
    if (link.parent < 0) {
      if (meshed.has(-1) || meshed.has(index)) return;
      const shape = new CylinderGeometry(1.8 * this.widths.usual, 3 * this.widths.usual, 1, 32);
      this.pedestals.push({
        object: this.add(new Mesh(this.kept(shape), this.material(this.look.base, false))),
        link: index,
      });
      return;
    }
    const { place, away } = nearest(motion, link.parent, index);
    if (away < 0.5 * this.widths.usual || (meshed.has(index) && meshed.has(link.parent))) return;
    const shape = new CylinderGeometry(0.8 * this.widths.usual, 0.8 * this.widths.usual, 1, 16);
    const object = this.add(new Mesh(this.kept(shape), this.material(this.look.link, false)));
    this.rods.push({ object, link: index, parent: link.parent, place });
  }

  /** A rod of length 1 along its y from one place of the lines to another. */
  private between(object: Mesh, line: Float32Array, start: number, end: number): void {
    this.from.fromArray(line, start);
    this.to.fromArray(line, end).sub(this.from);
    const length = this.to.length();
    object.position.copy(this.from).addScaledVector(this.to, 0.5);
    object.scale.set(1, Math.max(length, 1e-9), 1);
    if (length > 0) object.quaternion.copy(this.quaternion.setFromUnitVectors(UP, this.to.divideScalar(length)));
  }

  private stand(object: Mesh, line: Float32Array, root: number): void {
    const height = Math.max(line[root + 2] - this.widths.floor, 1e-4);
    object.position.set(line[root], line[root + 1], this.widths.floor + height / 2);
    object.scale.set(1, height, 1);
    object.rotation.set(Math.PI / 2, 0, 0);
  }
}

/** Where in a frame that place of the parent is which is nearest to a link's root in the first frame; how near [m]. */
export function nearest({ arrays, stations }: Motion, parent: number, link: number): { place: number; away: number } {
  const { data } = arrays.line;
  const root = 3 * stations * link;
  let found = { place: 0, away: Infinity };
  for (let s = 0; s < stations; s++) {
    const place = 3 * (stations * parent + s);
    const away = Math.hypot(
      data[place] - data[root],
      data[place + 1] - data[root + 1],
      data[place + 2] - data[root + 2],
    );
    if (away < found.away) found = { place, away };
  }
  return found;
}

/** The half-widths of a link at `count` stations, none thinner than what is drawn. */
export function sizes(link: SceneLink, count: number, widths: Pick<Widths, "usual" | "least">): SectionSizes {
  const found = new Float32Array(2 * count).fill(widths.usual);
  if (link.section === null) return { shape: "round", sizes: found };
  const info = link.section.sizes;
  const last = info.shape[0] - 1;
  for (let s = 0; s < count; s++)
    for (let c = 0; c < 2; c++) {
      const row = Math.round((s / Math.max(count - 1, 1)) * last);
      found[2 * s + c] = Math.max(info.data[2 * row + c], widths.least);
    }
  return { shape: link.section.shape, sizes: found };
}
