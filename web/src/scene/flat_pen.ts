// Draws lines in space on a flat canvas, as the camera sees them: no WebGL is needed for that.
import type { PerspectiveCamera } from "three";

const NEAR = 1e-3; // of the camera's distance from where it looks: what is nearer is cut off

/** Places in space as x, y, z one after the other [m]. */
export type Places = ArrayLike<number>;

export class Pen {
  readonly canvas = document.createElement("canvas");
  readonly context: CanvasRenderingContext2D;
  /** Added to x and y of all places [m]. */
  aside: readonly [number, number] = [0, 0];
  /** Of the picture [px of the page]. */
  width = 1;
  height = 1;
  private readonly view = new Float64Array(16);
  private readonly from = new Float64Array(3);
  private readonly to = new Float64Array(3);
  private focal = 1;
  private near = NEAR;

  constructor(private readonly camera: PerspectiveCamera) {
    const context = this.canvas.getContext("2d");
    if (context === null) throw new Error("This browser draws on no canvas.");
    this.context = context;
    context.lineJoin = "round";
  }

  /** `ratio`: pixels of the canvas for one of the page. */
  resize(width: number, height: number, ratio = Math.min(Math.max(window.devicePixelRatio, 1), 2)): void {
    if (width < 1 || height < 1) return;
    [this.width, this.height] = [width, height];
    [this.canvas.width, this.canvas.height] = [Math.round(ratio * width), Math.round(ratio * height)];
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** A new picture, from where the camera is now; `reach` m is the size of what is looked at. */
  begin(reach: number): void {
    const { camera, canvas, context } = this;
    camera.updateMatrixWorld();
    this.view.set(camera.matrixWorldInverse.elements);
    this.focal = this.height / 2 / Math.tan((camera.fov * Math.PI) / 360);
    this.near = NEAR * reach;
    context.setTransform(canvas.width / this.width, 0, 0, canvas.height / this.height, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    context.lineJoin = "round";
  }

  /** How far before the camera a place is [m]. */
  depth(places: Places, k: number): number {
    return -this.seen(2, places, k);
  }

  /** Pixels of a meter at a depth. */
  perMeter(depth: number): number {
    return this.focal / Math.max(depth, this.near);
  }

  /** Where a place is on the canvas; null: behind the camera. */
  at(places: Places, k: number): [number, number] | null {
    const depth = this.depth(places, k);
    if (depth < this.near) return null;
    return this.pixel(this.seen(0, places, k), this.seen(1, places, k), depth);
  }

  /** The way through `count` places from index `first`: cut where it comes too near. */
  path(places: Places, first: number, count: number): void {
    this.context.beginPath();
    for (let k = 1; k < count; k++) this.piece(places, first + 3 * k - 3, places, first + 3 * k, k === 1);
  }

  /** From a place to another, begun again where `fresh` or where the last piece was cut. */
  piece(a: Places, i: number, b: Places, j: number, fresh: boolean): void {
    const { from, to, near, context } = this;
    for (let c = 0; c < 3; c++) [from[c], to[c]] = [this.seen(c, a, i), this.seen(c, b, j)];
    const [begins, ends] = [-from[2] < near, -to[2] < near];
    if (begins && ends) return;
    if (begins || ends) {
      const share = (-near - from[2]) / (to[2] - from[2]);
      const cut = begins ? from : to;
      for (let c = 0; c < 3; c++) cut[c] = this.seen(c, a, i) + share * (this.seen(c, b, j) - this.seen(c, a, i));
    }
    if (fresh || begins) context.moveTo(...this.pixel(from[0], from[1], -from[2]));
    context.lineTo(...this.pixel(to[0], to[1], -to[2]));
  }

  stroke(color: string, width: number, alpha = 1, cap: CanvasLineCap = "round"): void {
    const { context } = this;
    context.globalAlpha = alpha;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.lineCap = cap;
    context.stroke();
    context.globalAlpha = 1;
  }

  /** A filled circle of a radius in meters about a place, `least` pixels at least. */
  dot(places: Places, k: number, radius: number, color: string, edge: string, least = 2): void {
    const found = this.at(places, k);
    if (found === null) return;
    const size = Math.max(radius * this.perMeter(this.depth(places, k)), least);
    this.context.beginPath();
    this.context.arc(...found, size, 0, 2 * Math.PI);
    this.context.fillStyle = color;
    this.context.fill();
    this.stroke(edge, 1);
  }

  /** A filled shape of corners on the canvas. */
  fill(corners: [number, number][], color: string, alpha = 1): void {
    const { context } = this;
    context.beginPath();
    corners.forEach((corner) => context.lineTo(...corner));
    context.closePath();
    context.globalAlpha = alpha;
    context.fillStyle = color;
    context.fill();
    context.globalAlpha = 1;
  }

  private pixel(x: number, y: number, depth: number): [number, number] {
    const scale = this.focal / depth;
    return [this.width / 2 + scale * x, this.height / 2 - scale * y];
  }

  /** Coordinate of a place in the axes of the camera. */
  private seen(row: number, places: Places, k: number): number {
    const { view } = this;
    return (
      view[row] * (places[k] + this.aside[0]) +
      view[4 + row] * (places[k + 1] + this.aside[1]) +
      view[8 + row] * places[k + 2] +
      view[12 + row]
    );
  }
}
