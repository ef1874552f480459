// What is drawn about a robot of lines: floor, surface that is touched, ways of the tips, force at the contact.
import type { SceneContact } from "../contract_scene";
import type { Extent } from "./extent";
import type { Pen } from "./flat_pen";
import { patch, SQUARES } from "./marks";
import type { Palette } from "./palette";

/** Vertices of a surface between two lines that are drawn of it. */
const EVERY = 4;

/** The squares of the floor. */
export function drawFloor(pen: Pen, extent: Extent, colours: Palette): void {
  const { cell, reach, floor } = extent;
  const half = cell * Math.ceil((1.6 * reach) / cell);
  const { context } = pen;
  for (const strong of [false, true]) {
    context.beginPath();
    for (let at = -half; at <= half + cell / 2; at += cell) {
      if (Math.abs(at) < cell / 2 !== strong) continue;
      pen.piece([at, -half, floor], 0, [at, half, floor], 0, true);
      pen.piece([-half, at, floor], 0, [half, at, floor], 0, true);
    }
    pen.stroke(strong ? colours.gridStrong : colours.grid, 1);
  }
}

/** The way of a tip [m, 3]: full until a frame, dashed from there on. */
export function drawTrace(pen: Pen, path: Float32Array, frame: number, color: string): void {
  const count = path.length / 3;
  pen.path(path, 0, Math.min(frame + 1, count));
  pen.stroke(color, 2.5);
  pen.context.setLineDash([4, 4]);
  pen.path(path, 3 * frame, count - frame);
  pen.stroke(color, 1.2, 0.8, "butt");
  pen.context.setLineDash([]);
}

/** An arrow of a force [N], `scale` m for a newton, from where it acts. */
export function drawArrow(pen: Pen, force: Float32Array, at: Float32Array, scale: number, color: string): void {
  const end = [0, 1, 2].map((c) => at[c] + scale * force[c]);
  const [tail, tip] = [pen.at(at, 0), pen.at(end, 0)];
  if (tail === null || tip === null) return;
  const [x, y] = [tip[0] - tail[0], tip[1] - tail[1]];
  const length = Math.hypot(x, y);
  if (length < 3) return;
  const head = Math.min(12, 0.5 * length);
  const [u, v] = [x / length, y / length];
  const neck: [number, number] = [tip[0] - head * u, tip[1] - head * v];
  pen.context.beginPath();
  pen.context.moveTo(...tail);
  pen.context.lineTo(...neck);
  pen.stroke(color, 4, 1, "butt");
  pen.fill(
    [
      tip,
      [neck[0] - 0.45 * head * v, neck[1] + 0.45 * head * u],
      [neck[0] + 0.45 * head * v, neck[1] - 0.45 * head * u],
    ],
    color,
  );
}

/** The part of the surface about the contact, as it is once and for all. */
export class FlatSurface {
  private readonly places: Float32Array;

  constructor(contact: Pick<SceneContact, "at" | "surface">, extent: Extent, private readonly color: string) {
    const found = patch(contact.surface, contact.at.data, 0.12 * extent.reach);
    this.places = Float32Array.from(found.getAttribute("position").array);
  }

  draw(pen: Pen): void {
    for (let i = 0; i < SQUARES; i += EVERY) for (let j = 0; j < SQUARES; j += EVERY) this.square(pen, i, j);
  }

  private square(pen: Pen, i: number, j: number): void {
    const corner = (a: number, b: number) => pen.at(this.places, 3 * ((i + a) * (SQUARES + 1) + j + b));
    const corners: [number, number][] = [];
    for (let k = 0; k < 4 * EVERY; k++) {
      const [side, along] = [Math.floor(k / EVERY), k % EVERY];
      const [a, b] = [[0, along], [along, EVERY], [EVERY, EVERY - along], [EVERY - along, 0]][side];
      const found = corner(a, b);
      if (found === null) return;
      corners.push(found);
    }
    pen.fill(corners, this.color, 0.16);
    pen.context.closePath();
    pen.stroke(this.color, 1, 0.35);
  }
}
