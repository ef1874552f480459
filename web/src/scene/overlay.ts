// What is drawn over the picture: the axes of the world, gravity, and one cause of the tip's error with its element.
import type { PerspectiveCamera } from "three";
import type { Run } from "../contract";
import type { Cause } from "../contract_parts";
import { Pen } from "./flat_pen";
import type { ShownRun } from "./shown";

const ARM = 26; // px: length of the axes
const FONT = "600 12px system-ui, sans-serif";
const AXES: [string, [number, number, number]][] = [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]];
const NEAR = 24; // px: so near to a link, or to a joint, a click is on it
const GRAVITY = 0.3; // of the arm: how far beyond the axes the arrow of gravity is drawn

/** Colours that it takes from the page. */
export interface Inks {
  ink: string;
  chip: string;
  axes: [string, string, string];
  gravity: string;
}

export class Overlay {
  private readonly pen: Pen;
  /** In the middle of the axes [px]. */
  private origin: [number, number] = [0, 0];

  private ratio: number | undefined;
  private taken: [number, number, number, number][] = []; // by words: left, top, right, bottom [px]

  constructor(
    private readonly camera: PerspectiveCamera, private readonly reach: number, private readonly inks: Inks,
  ) {
    this.pen = new Pen(camera);
    this.canvas.className = "scene-overlay";
    this.canvas.ariaHidden = "true";
  }

  get canvas(): HTMLCanvasElement {
    return this.pen.canvas;
  }

  /** `axes`: the room in the picture that they have. */
  layout(place: DOMRect, axes: DOMRect): void {
    this.pen.resize(place.width, place.height, this.ratio);
    this.origin = [axes.left - place.left + axes.width / 2, axes.top - place.top + axes.height / 2];
  }

  /** `marked`: a link or a joint of the first run; `ratio`: pixels for one of the page; none: those of the screen. */
  draw(runs: ShownRun[], cause: Cause | null, marked: string, ratio?: number): void {
    const { pen } = this;
    if (ratio !== this.ratio) pen.resize(pen.width, pen.height, ratio);
    this.ratio = ratio;
    pen.begin(this.reach);
    pen.context.font = FONT;
    this.triad(runs[0].run.scene.gravity);
    const [u, v] = this.origin;
    this.taken = [[u - 2 * ARM, v - 2 * ARM, u + 2 * ARM, v + 2 * ARM]];
    const shown = runs[cause?.run ?? 0];
    if (!shown) return;
    pen.aside = shown.aside;
    this.element(shown, cause ? cause.element : marked, cause?.parts.find(({ lit }) => lit)?.colour ?? this.inks.ink);
    if (cause) this.error(shown, cause);
    pen.aside = [0, 0];
  }

  /** The joint of a run, else the link, that is drawn near a place of the picture [px]. */
  nearest({ run: { scene }, motion, aside }: ShownRun, x: number, y: number): string | null {
    const { pen } = this;
    let [best, least]: [string | null, number] = [null, NEAR];
    const look = (name: string, place: number, less: number) => {
      const at = pen.at(motion.line, place);
      const away = at ? Math.hypot(at[0] - x, at[1] - y) - less : Infinity;
      if (away < least) [best, least] = [name, away];
    };
    pen.aside = aside;
    for (const { name, link } of scene.joints) look(name, 3 * motion.stations * link, NEAR / 2);
    for (let k = 0; k < 3 * motion.stations * motion.links; k += 3)
      look(scene.links[Math.floor(k / 3 / motion.stations)]?.name ?? "", k, 0);
    pen.aside = [0, 0];
    return best || null;
  }

  private triad(gravity: number[] | undefined): void {
    const { context } = this.pen;
    const e = this.camera.matrixWorldInverse.elements;
    const seen = (way: number[]): [number, number, number] =>
      [0, 1, 2].map((row) => e[row] * way[0] + e[4 + row] * way[1] + e[8 + row] * way[2]) as [number, number, number];
    const arrow = (way: number[], name: string, color: string, wide: number, start: number) => {
      const [x, y] = seen(way);
      const [u, v] = [ARM * x, -ARM * y];
      context.beginPath();
      context.moveTo(this.origin[0] + start * u, this.origin[1] + start * v);
      context.lineTo(this.origin[0] + u, this.origin[1] + v);
      this.pen.stroke(color, wide, 1, "butt");
      const size = Math.hypot(u, v) || 1;
      this.words(name, this.origin[0] + u + (9 * u) / size - 3, this.origin[1] + v + (9 * v) / size + 4, color);
    };
    const far = AXES.map(([name, way], k) => ({ name, way, color: this.inks.axes[k], depth: seen(way)[2] }));
    far.sort((one, other) => one.depth - other.depth);
    for (const { name, way, color } of far) arrow(way, name, color, 2.5, 0);
    const size = Math.hypot(...(gravity ?? []));
    if (!gravity || size === 0) return;
    arrow(gravity.map((g) => (g / size) * (1 + GRAVITY)), "g", this.inks.gravity, 2.5, GRAVITY);
  }

  /** A link or a joint, marked and named. */
  private element({ run, motion }: ShownRun, name: string | null, colour: string): void {
    const { pen } = this;
    const size = 3 * motion.stations;
    const { pieces, joint } = placeOf(run, name, motion.links);
    const middle = (pieces[pieces.length >> 1] ?? 0) * size + 3 * (motion.stations >> 1);
    const at = pen.at(motion.line, joint >= 0 ? joint * size : middle);
    if ((!pieces.length && joint < 0) || !at || !name) return;
    for (const piece of pieces) {
      pen.path(motion.line, piece * size, motion.stations);
      pen.stroke(colour, 7, 0.85);
    }
    if (!pieces.length) {
      pen.context.beginPath();
      pen.context.arc(...at, 15, 0, 2 * Math.PI);
      pen.stroke(colour, 4);
    }
    this.chip(name, [[at[0] - 15, at[1] - 15], [at[0] + 15, at[1] + 15]]);
  }

  /** From the commanded tip to the actual one, cut into the causes. */
  private error({ motion }: ShownRun, cause: Cause): void {
    const { context } = this.pen;
    const reference = motion.arrays.tipCommanded ? motion.tipCommanded : motion.tipReference;
    const [start, end] = [this.pen.at(reference, 0), this.pen.at(motion.tip, 0)];
    if (!start || !end) return;
    const total = cause.parts.reduce((sum, { value }) => sum + value, 0) || 1;
    const at = (share: number) => [0, 1].map((c) => start[c] + share * (end[c] - start[c])) as [number, number];
    let from = 0;
    for (const { value, colour, lit } of cause.parts) {
      const to = from + value / total;
      context.beginPath();
      context.moveTo(...at(from));
      context.lineTo(...at(to));
      this.pen.stroke(colour, lit ? 7 : 3, lit ? 1 : 0.6, "butt");
      from = to;
    }
    for (const [place, fill] of [[start, this.inks.chip], [end, this.inks.ink]] as const) {
      context.beginPath();
      context.arc(...place, 4, 0, 2 * Math.PI);
      context.fillStyle = fill;
      context.fill();
      this.pen.stroke(this.inks.ink, 1.5);
    }
    this.chip(cause.label, [start, end]);
  }

  /** Words on a ground next to some places: on that side of them where the picture has room. */
  private chip(text: string, places: [number, number][]): void {
    const { context, width, height } = this.pen;
    const { chip, ink } = this.inks;
    const [wide, tall, gap] = [context.measureText(text).width + 12, 20, 8];
    const [xs, ys] = [0, 1].map((c) => places.map((place) => place[c]));
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const middle: [number, number] = [(left + right - wide) / 2, (top + bottom - tall) / 2];
    const sides: [number, number][] = [
      [right + gap, middle[1]], [left - gap - wide, middle[1]],
      [middle[0], bottom + gap], [middle[0], top - gap - tall],
    ];
    const free = ([u, v]: [number, number]) => u > 0 && u + wide < width && v > 0 && v + tall < height &&
      this.taken.every(([a, b, c, d]) => u > c || u + wide < a || v > d || v + tall < b);
    const [x, y] = sides.find(free) ?? middle;
    this.taken.push([x, y, x + wide, y + tall]);
    context.fillStyle = chip;
    context.fillRect(x, y, wide, tall);
    this.words(text, x + 6, y + 14, ink);
  }

  private words(text: string, x: number, y: number, color: string): void {
    this.pen.context.globalAlpha = 1;
    this.pen.context.fillStyle = color;
    this.pen.context.fillText(text, x, y);
  }
}

/** The pieces of a link, which has one or is `link.1`, `link.2`; or the link at whose root a joint is, -1: none. */
function placeOf({ scene }: Run, element: string | null, count: number): { pieces: number[]; joint: number } {
  const joint = scene.joints.find(({ name }) => name === element)?.link ?? -1;
  const of = ({ name }: { name: string }) => name === element || name.replace(/\.\d+$/, "") === element;
  const pieces = scene.links.flatMap((link, k) => (of(link) && k < count && joint < 0 ? [k] : []));
  return { pieces, joint: joint < count ? joint : -1 };
}
