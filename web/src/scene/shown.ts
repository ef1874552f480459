// A run as it is shown, whatever draws it: its motion, that of itself before a change, its colours and their range.
import type { Run } from "../contract";
import { Motion, type Arrays, type Tip } from "./motion";
import type { Palette } from "./palette";
import type { Settings } from "./settings";
import { round125 } from "./units";

export interface Range {
  low: number;
  high: number;
}

/** Which links a quantity colours. */
export type Painted = "none" | "bending" | "all";

export class ShownRun {
  motion: Motion;
  /** Whether its surface is shown where surfaces are: another run may show the same. */
  showsSurface = true;
  /** How far it is shown from where it is, along x and y [m]. */
  aside: [number, number] = [0, 0];
  protected before: Motion | null = null;

  /** `alone`: there is no other run, so that the robot needs no colour of its own. */
  constructor(
    readonly run: Run,
    protected readonly index: number,
    protected readonly alone: boolean,
    private readonly own: Palette,
  ) {
    this.motion = new Motion(run.scene);
  }

  /** The colour by which this run is reported from the others. */
  get colour(): string {
    return this.alone ? this.own.real : this.own.runs[this.index % this.own.runs.length];
  }

  get referenceColour(): string {
    return this.alone ? this.own.reference : this.own.rigid;
  }

  /** The tips that leave a path, in the order in which they are drawn, and its colour. */
  get paths(): [Tip, string][] {
    return [["commanded", this.own.commanded], ["nominal", this.referenceColour], ["actual", this.colour]];
  }

  get changed(): boolean {
    return this.before !== null;
  }

  /** Other arrays, which the page's own then stand next to as a ghost; null: the page's own. */
  replace(arrays: Arrays | null): void {
    const { scene } = this.run;
    const next = new Motion(arrays ?? scene);
    this.before = arrays === null ? null : (this.before ?? new Motion(scene));
    this.motion = next;
  }

  /** Take the pose of a time. */
  protected seek(time: number, settings: Settings): void {
    const { motion } = this;
    const values = motion.arrays.colours.find(({ id }) => id === settings.colour)?.values ?? null;
    motion.seek(time, settings.factor, values);
    this.before?.seek(time, settings.factor, null);
  }

  /** Widen a range by all values of a quantity on the links that it colours. */
  widen(id: string, range: Range): void {
    const { arrays, links, stations } = this.motion;
    const info = arrays.colours.find((one) => one.id === id)?.values.data;
    const coloured = this.run.scene.links.map((link) => link.bends || paints(id) === "all");
    if (info === undefined) return;
    for (let k = 0; k < info.length; k++) {
      if (!coloured[Math.floor(k / stations) % links]) continue;
      if (info[k] < range.low) range.low = info[k];
      if (info[k] > range.high) range.high = info[k];
    }
  }
}

/** Displacement is one of all links, other quantities are of those that bend. */
export function paints(colour: string): Painted {
  return colour === "run" ? "none" : colour === "displacement" ? "all" : "bending";
}

const USUAL_FORCE = 10; // N, of runs that touch nothing: a changed one may

/** The length of a newton with which the largest force of all runs is about a third of the reach; 0: no contact. */
export function forceScale(runs: Run[], reach: number): number {
  let largest = 0;
  for (const { scene } of runs) {
    const force = scene.contact?.force.data ?? [];
    for (let k = 0; k + 2 < force.length; k += 3)
      largest = Math.max(largest, Math.hypot(force[k], force[k + 1], force[k + 2]));
  }
  if (runs.every(({ scene }) => scene.contact === null)) return 0;
  return round125((0.35 * reach) / (largest || USUAL_FORCE));
}
