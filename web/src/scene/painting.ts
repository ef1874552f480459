// The picture with what is drawn over it: with few pixels while something moves, with all of them when nothing does.
import type { Cause } from "../contract_parts";
import { framed } from "./framed";
import type { Notes } from "./notes";
import { Overlay } from "./overlay";
import { stops, type Palette } from "./palette";
import type { Sight } from "./sight";

const STILL = 150; // ms after which what does not move is drawn with all pixels
const FILMED = 300; // ms that a film may take from one picture to the next
const FINE = 2; // pixels for one of the page in what is taken along, and where nothing moves
const SHOWN = 0.1; // of the reach: as large a cause is shown
const FARTHEST = 0.5; // of the reach: and as large the whole error at most

export class Painting {
  cause: Cause | null = null;
  /** A link or a joint that is marked, and what a click on one does. */
  marked = "";
  picked: ((element: string) => void) | null = null;
  /** A mode swings in place of the run. */
  swings = false;
  private world!: Sight;
  private overlay!: Overlay;
  private settling = 0;
  private filmed = -Infinity; // when the last picture of a film was taken [ms]

  /** `seconds`: the time of what swings. */
  constructor(
    private readonly place: HTMLElement, private readonly notes: Notes, private readonly reach: number,
    private readonly seconds: () => { time: number; seconds: number },
  ) {
    let from = [0, 0];
    place.addEventListener("pointerdown", ({ clientX, clientY }) => (from = [clientX, clientY]));
    place.addEventListener("click", ({ clientX, clientY }) => {
      if (!this.picked || Math.hypot(clientX - from[0], clientY - from[1]) > 4) return; // it was turned
      const { left, top } = place.getBoundingClientRect();
      const element = this.overlay.nearest(this.world.runs[0], clientX - left, clientY - top);
      if (element) this.picked(element);
    });
  }

  /** Paint another world from now on. */
  take(world: Sight, { force, gravity, axes }: Palette): void {
    const colours = getComputedStyle(this.place);
    const [ink, chip] = ["--ink", "--field"].map((name) => colours.getPropertyValue(name).trim() || force);
    this.overlay?.canvas.remove();
    this.world = world;
    this.overlay = new Overlay(world.camera, this.reach, { ink, chip, axes, gravity });
    this.place.prepend(world.canvas, this.overlay.canvas);
  }

  /** The picture or its notes have another size. */
  layout(): void {
    this.overlay.layout(this.place.getBoundingClientRect(), this.notes.corner);
  }

  /** `moves`: another picture comes at once. */
  draw(now: number, moves: boolean): void {
    this.paint(now - this.filmed < FILMED ? fine() : undefined);
    window.clearTimeout(this.settling);
    this.place.dataset.still = String(!moves && !this.world.coarse);
    if (!moves && this.world.coarse) this.settling = window.setTimeout(this.settled, STILL);
  }

  /** With title and notes; of a film on the canvas that it had. */
  picture(title: string, canvas?: HTMLCanvasElement): HTMLCanvasElement {
    if (canvas) this.filmed = performance.now();
    this.paint(fine());
    const layers = [this.world.canvas, this.overlay.canvas];
    return framed(canvas ?? document.createElement("canvas"), layers, this.place, fine(), title, stops());
  }

  /** How many times deformations are enlarged so that a cause is seen. */
  factorOf({ parts }: Cause): number {
    const lit = Math.abs(parts.find((part) => part.lit)?.value ?? 0) || this.reach;
    const whole = Math.abs(parts.reduce((sum, part) => sum + part.value, 0)) || this.reach;
    return Number(Math.max(1, this.reach * Math.min(SHOWN / lit, FARTHEST / whole)).toPrecision(1));
  }

  dispose(): void {
    window.clearTimeout(this.settling);
    this.overlay.canvas.remove();
  }

  private readonly settled = () => {
    this.paint(fine());
    this.place.dataset.still = "true";
  };

  private paint(ratio?: number): void {
    const { time, seconds } = this.seconds();
    this.world.draw(time, seconds, ratio);
    this.overlay.draw(this.world.runs, this.swings ? null : this.cause, this.marked, ratio);
  }
}

function fine(): number {
  return Math.max(FINE, window.devicePixelRatio);
}
