// Where one looks from: presets that fit all that moves into the picture, turning by mouse, touch and keys.
import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { aimed } from "./aim";
import { WHOLE, type Rooms } from "./room";

export const VIEWS = ["iso", "front", "side", "top", "tip"] as const;
export type View = (typeof VIEWS)[number];

const DIRECTIONS: Record<Exclude<View, "iso">, [number, number, number]> = {
  front: [1, 0, 0.08], side: [0, -1, 0.08], top: [0, -1e-3, 1], tip: [0.62, -1, 0.4],
}; // prettier-ignore

const GLIDE = 0.35; // s

export class Cameras {
  view: View = "iso";
  /** What presets fit into the picture, places [k, 3]. */
  places: number[] = [0, 0, 0];
  /** The parts of the picture of which one holds all of that. */
  rooms: () => Rooms = () => WHOLE;
  /** Whether one looks from a preset, not from where somebody turned to. */
  preset = false;
  private readonly controls: OrbitControls;
  private readonly start = new Vector3();
  private readonly end = new Vector3();
  private readonly targetStart = new Vector3();
  private readonly targetEnd = new Vector3();
  private readonly offset = new Vector3();
  private readonly spherical = new Spherical();
  private began = 0;
  private gliding = 0;

  constructor(
    private readonly camera: PerspectiveCamera,
    private readonly canvas: HTMLCanvasElement,
    private readonly reach: number,
    private readonly oblique: readonly [number, number, number],
    private readonly changed: () => void,
  ) {
    this.controls = new OrbitControls(camera, canvas);
    this.controls.minDistance = 0.05 * reach;
    this.controls.maxDistance = 40 * reach;
    this.controls.enableZoom = false; // a page scrolls on: the wheel zooms once the picture has been clicked
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", this.turned);
    canvas.addEventListener("keydown", this.key);
    canvas.addEventListener("focus", this.zoomable);
    canvas.addEventListener("blur", this.zoomable);
  }

  /** Look from a preset; `tip` is where the tip is, `glide`: on the way there, as long as that is no trouble. */
  show(view: View, tip: Float32Array, glide: boolean): void {
    this.view = view;
    this.preset = true;
    const direction = this.side(view);
    if (view === "tip") this.end.copy(this.targetEnd.fromArray(tip)).addScaledVector(direction, 0.55 * this.reach);
    else this.fit(direction);
    cancelAnimationFrame(this.gliding);
    if (!glide) return this.place(1);
    this.start.copy(this.camera.position);
    this.targetStart.copy(this.controls.target);
    this.began = performance.now();
    this.step(this.began);
  }

  /** From the same side, with all in the picture again; a view that follows the tip stays as near as it is. */
  refit(): void {
    if (this.view === "tip") return;
    const { camera, controls, offset } = this;
    this.fit(this.preset ? this.side(this.view) : offset.copy(camera.position).sub(controls.target).normalize());
    cancelAnimationFrame(this.gliding);
    this.place(1);
  }

  /** Horizontally to the right, as one looks from the preset. */
  get across(): [number, number] {
    const { x, y } = this.side(this.view);
    return [-y / Math.hypot(x, y), x / Math.hypot(x, y)];
  }

  private side(view: View): Vector3 {
    return this.offset.set(...(view === "iso" ? this.oblique : DIRECTIONS[view])).normalize();
  }

  /** Where the camera is and what it looks at [m], six numbers. */
  get pose(): number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  set pose(wanted: number[]) {
    this.preset = false;
    cancelAnimationFrame(this.gliding);
    this.end.fromArray(wanted);
    this.targetEnd.fromArray(wanted, 3);
    this.place(1);
  }

  /** Look from where another one looks. */
  take(other: Cameras): void {
    this.view = other.view;
    this.preset = other.preset;
    this.camera.position.copy(other.camera.position);
    this.controls.target.copy(other.controls.target);
    this.controls.update();
  }

  /** Keep looking at the tip where that is the view. */
  follow(tip: Float32Array): void {
    if (this.view !== "tip") return;
    this.offset.copy(this.camera.position).sub(this.controls.target);
    this.controls.target.fromArray(tip);
    this.camera.position.copy(this.controls.target).add(this.offset);
    this.camera.lookAt(this.controls.target);
  }

  dispose(): void {
    cancelAnimationFrame(this.gliding);
    this.controls.dispose();
    this.canvas.removeEventListener("keydown", this.key);
    this.canvas.removeEventListener("focus", this.zoomable);
    this.canvas.removeEventListener("blur", this.zoomable);
  }

  private readonly turned = () => {
    this.preset = false;
  };

  private readonly zoomable = (event: Event) => {
    this.controls.enableZoom = event.type === "focus";
  };

  private readonly key = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = MathUtils.degToRad(5);
    const moves: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
    }; // prettier-ignore
    const move = moves[event.key];
    if (move && event.shiftKey) this.pan(0.04 * move[0], -0.04 * move[1]);
    else if (move) this.turn(turn * move[0], turn * move[1], 1);
    else if (event.key === "+" || event.key === "=") this.turn(0, 0, 1 / 1.15);
    else if (event.key === "-") this.turn(0, 0, 1.15);
    else return;
    this.turned();
    event.preventDefault();
    event.stopPropagation();
  };

  private turn(around: number, down: number, scale: number): void {
    const { camera, controls, offset, spherical } = this;
    offset.copy(camera.position).sub(controls.target);
    // Spherical counts from y up; here z is up.
    spherical.setFromCartesianCoords(offset.y, offset.z, offset.x);
    spherical.theta += around;
    spherical.phi = MathUtils.clamp(spherical.phi + down, 1e-3, Math.PI - 1e-3);
    spherical.radius = MathUtils.clamp(spherical.radius * scale, controls.minDistance, controls.maxDistance);
    offset.setFromSpherical(spherical);
    camera.position.set(offset.z, offset.x, offset.y).add(controls.target);
    controls.update();
    this.changed();
  }

  private pan(right: number, up: number): void {
    const { camera, controls, offset } = this;
    const far = camera.position.distanceTo(controls.target);
    for (const [column, share] of [[0, right], [1, up]]) {
      offset.setFromMatrixColumn(camera.matrix, column).multiplyScalar(share * far);
      camera.position.add(offset);
      controls.target.add(offset);
    }
    controls.update();
    this.changed();
  }

  /** Aim so, from the least distance, that all places are in the picture and off its notes. */
  private fit(direction: Vector3): void {
    const { camera, places, targetEnd } = this;
    const tall = Math.tan(MathUtils.degToRad(camera.fov / 2));
    const right = new Vector3().crossVectors(camera.up, direction).normalize();
    const axes = [right, new Vector3().crossVectors(direction, right), direction];
    const place = new Vector3();
    const along = axes.map((axis) => {
      const found = new Float64Array(places.length / 3);
      for (let k = 0; k < found.length; k++) found[k] = place.fromArray(places, 3 * k).dot(axis);
      return found;
    });
    const [least, most] = [Math.min, Math.max].map((best) => along[2].reduce((one, other) => best(one, other)));
    const near = Math.max(0.3 * this.reach, 0.6 * (most - least));
    const middle = (least + most) / 2;
    along[2].forEach((depth, k) => (along[2][k] = depth - middle));
    const { distance, at } = aimed({ along, tangents: [tall * camera.aspect, tall] }, this.rooms(), near);
    targetEnd.copy(direction).multiplyScalar(middle);
    at.forEach((found, k) => targetEnd.addScaledVector(axes[k], found));
    this.end.copy(targetEnd).addScaledVector(direction, distance);
  }

  private readonly step = (now: number) => {
    const share = Math.min(1, Math.max(0, (now - this.began) / 1000 / GLIDE));
    this.place(share * share * (3 - 2 * share));
    if (share < 1) this.gliding = requestAnimationFrame(this.step);
  };

  private place(share: number): void {
    this.camera.position.lerpVectors(share < 1 ? this.start : this.end, this.end, share);
    this.controls.target.lerpVectors(share < 1 ? this.targetStart : this.targetEnd, this.targetEnd, share);
    this.controls.update();
    this.changed();
  }
}
