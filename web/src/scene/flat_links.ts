// A robot of lines: each link as wide as it is seen, its joints as dots, the nearer before the farther.
import type { Vector3 } from "three";
import type { SceneLink } from "../contract_scene";
import type { Pen } from "./flat_pen";
import type { Motion } from "./motion";
import { SCALE, step } from "./palette";
import { nearest, sizes, type Body, type Look, type Widths } from "./links";
import type { Range } from "./shown";
import { sectionAxes, transport, type SectionSizes } from "./sweep";

const OVERLAP = 0.6; // px: no gap between the pieces of a line

interface Part {
  depth: number;
  draw(): void;
}

export class FlatRobot {
  private readonly sections: SectionSizes[];
  /** What holds a link next to its parent: where the parent is nearest. */
  private readonly rods: { link: number; place: number }[] = [];
  private readonly axes = new Float32Array(9);
  private readonly pair = new Float32Array(6);

  constructor(private readonly body: Body, private readonly motion: Motion, private readonly widths: Widths) {
    this.sections = body.links.slice(0, motion.links).map((link) => sizes(link, motion.stations, widths));
    body.links.slice(0, motion.links).forEach(({ parent }, link) => {
      if (parent < 0) return;
      const { place, away } = nearest(motion, parent, link);
      if (away >= 0.5 * widths.usual) this.rods.push({ link, place });
    });
  }

  /** All of it: base, links, joints, payload; seen from `eye`. */
  draw(pen: Pen, line: Float32Array, look: Look, range: Range, eye: Vector3): void {
    const { motion, widths } = this;
    const size = 3 * motion.stations;
    const parts = this.body.links
      .slice(0, motion.links)
      .flatMap((link, k) => [
        { depth: this.far(pen, line, k), draw: () => this.link(pen, line, k, link, look, range, eye) },
        ...(link.parent < 0
          ? [{ depth: pen.depth(line, k * size) + widths.usual, draw: () => this.stand(pen, line, k * size, look) }]
          : []),
      ]);
    parts.push(...this.rods.map(({ link, place }) => this.rod(pen, line, link * size, place, look)));
    for (const { link, drawing, elastic } of this.body.joints) {
      if (link >= motion.links || drawing === "none") continue;
      const draw = () => pen.dot(line, link * size, 1.5 * widths.usual, elastic ? look.gear : look.joint, look.base);
      parts.push({ depth: pen.depth(line, link * size) - 2 * widths.usual, draw });
    }
    const payload = () => pen.dot(motion.tip, 0, 1.5 * widths.usual, look.payload, look.base);
    parts.push({ depth: pen.depth(motion.tip, 0) - 2 * widths.usual, draw: payload });
    parts.sort((one, other) => other.depth - one.depth).forEach((part) => part.draw());
  }

  /** Links alone, faint. */
  ghost(pen: Pen, line: Float32Array, color: string, alpha: number): void {
    const { motion, sections } = this;
    const { stations } = motion;
    for (let k = 0; k < motion.links; k++) {
      const first = 3 * stations * k;
      const wide = Math.max(...sections[k].sizes);
      pen.path(line, first, stations);
      pen.stroke(color, Math.max(1.6 * wide * pen.perMeter(pen.depth(line, first)), 2), alpha);
    }
  }

  private link(pen: Pen, line: Float32Array, k: number, link: SceneLink, look: Look, range: Range, eye: Vector3): void {
    const { motion } = this;
    const { stations, values } = motion;
    const first = 3 * stations * k;
    const painted = look.painted === "all" || (look.painted === "bending" && link.bends);
    const wide = this.seenWidths(pen, line, k, eye);
    for (let s = 1; s < stations; s++) {
      pen.path(line, first + 3 * s - 3, 2);
      pen.stroke(look.base, wide[s] + 2, 1, s === 1 || s === stations - 1 ? "round" : "butt");
    }
    const low = range.low;
    const span = range.high - low || 1;
    for (let s = 1; s < stations; s++) {
      const value = (values[k * stations + s - 1] + values[k * stations + s]) / 2;
      this.stretch(pen, line, first + 3 * s);
      pen.stroke(painted ? shade((value - low) / span) : look.link, wide[s], 1, "butt");
    }
  }

  /** The piece of a line that ends at `k`, a little longer than it is. */
  private stretch(pen: Pen, line: Float32Array, k: number): void {
    const { pair } = this;
    const length = Math.hypot(line[k] - line[k - 3], line[k + 1] - line[k - 2], line[k + 2] - line[k - 1]);
    const more = length > 0 ? OVERLAP / pen.perMeter(pen.depth(line, k)) / length : 0;
    for (let c = 0; c < 3; c++) {
      const way = more * (line[k + c] - line[k - 3 + c]);
      pair[c] = line[k - 3 + c] - way;
      pair[3 + c] = line[k + c] + way;
    }
    pen.path(pair, 0, 2);
  }

  /** Width of each piece of a link on the canvas [px], as its section is turned. */
  private seenWidths(pen: Pen, line: Float32Array, k: number, eye: Vector3): Float32Array {
    const { axes, motion } = this;
    const { stations, roots } = motion;
    const { shape, sizes: half } = this.sections[k];
    const found = new Float32Array(stations);
    sectionAxes(axes, roots, 4 * k);
    for (let s = 1; s < stations; s++) {
      const at = 3 * (stations * k + s);
      transport(axes, line[at] - line[at - 3], line[at + 1] - line[at - 2], line[at + 2] - line[at - 1]);
      const [left, ahead] = [line[at] + pen.aside[0], line[at + 1] + pen.aside[1]];
      const [ax, ay, az] = across(axes, eye.x - left, eye.y - ahead, eye.z - line[at + 2]);
      const y = half[2 * s] * Math.abs(ax * axes[3] + ay * axes[4] + az * axes[5]);
      const z = half[2 * s + 1] * Math.abs(ax * axes[6] + ay * axes[7] + az * axes[8]);
      const wide = shape === "round" ? Math.hypot(y, z) : y + z;
      found[s] = Math.max(2 * Math.max(wide, this.widths.least) * pen.perMeter(pen.depth(line, at)), 2.5);
    }
    return found;
  }

  private far(pen: Pen, line: Float32Array, k: number): number {
    const { stations } = this.motion;
    return pen.depth(line, 3 * (stations * k + (stations >> 1)));
  }

  private rod(pen: Pen, line: Float32Array, root: number, place: number, look: Look): Part {
    const depth = pen.depth(line, root) + this.widths.usual;
    const draw = () => {
      pen.context.beginPath();
      pen.piece(line, place, line, root, true);
      pen.stroke(look.base, 1.6 * this.widths.usual * pen.perMeter(depth) + 2);
      pen.stroke(look.link, 1.6 * this.widths.usual * pen.perMeter(depth));
    };
    return { depth, draw };
  }

  /** A column from the floor to a root. */
  private stand(pen: Pen, line: Float32Array, root: number, look: Look): void {
    const { usual, floor } = this.widths;
    const foot = [line[root], line[root + 1], floor];
    const [above, below] = [pen.at(line, root), pen.at(foot, 0)];
    if (above === null || below === null) return;
    const [narrow, broad] = [
      1.8 * usual * pen.perMeter(pen.depth(line, root)),
      3 * usual * pen.perMeter(pen.depth(foot, 0)),
    ];
    const length = Math.hypot(below[0] - above[0], below[1] - above[1]);
    if (length > 1) {
      const [x, y] = [(below[1] - above[1]) / length, (above[0] - below[0]) / length];
      const corner = (from: [number, number], size: number): [number, number] => [
        from[0] + size * x,
        from[1] + size * y,
      ];
      pen.fill([corner(above, narrow), corner(below, broad), corner(below, -broad), corner(above, -narrow)], look.base);
    }
    pen.dot(line, root, 1.8 * usual, look.base, look.base);
  }
}

/** The direction across both a line and the way to the eye, of length 1. */
function across(tangent: Float32Array, x: number, y: number, z: number): [number, number, number] {
  const found = [tangent[1] * z - tangent[2] * y, tangent[2] * x - tangent[0] * z, tangent[0] * y - tangent[1] * x];
  const size = Math.hypot(...found) || 1;
  return [found[0] / size, found[1] / size, found[2] / size];
}

function shade(share: number): string {
  const at = step(share);
  return `rgb(${[0, 1, 2].map((c) => Math.round(255 * SCALE[at + c])).join(" ")})`;
}
