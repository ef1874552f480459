// One run at any time: its arrays between two display frames, with what is elastic shown enlarged. No memory is taken.
import type { Scene, SceneContact } from "../contract_scene";
import type { Numbers } from "../pack";
import { turnAlong } from "./turn";

/** The arrays of a scene, those of the page or of the live model. */
export type Arrays = Pick<
  Scene,
  "times" | "line" | "rigid" | "reference" | "referenceRigid" | "roots" | "tip" | "tipReference" | "tipCommanded"
  | "colours"
> & { contact: (Pick<SceneContact, "force" | "at"> & Partial<Pick<SceneContact, "surface">>) | null };

export type Tip = "actual" | "nominal" | "commanded";

export class Motion {
  readonly links: number;
  readonly stations: number;
  readonly frames: number;
  /** Places [L, S, 3] as they are shown, and without elasticity; those of the nominal robot. */
  readonly line: Float32Array;
  readonly rigid: Float32Array | null;
  readonly reference: Float32Array | null;
  readonly roots: Float32Array;
  readonly values: Float32Array;
  readonly tip = new Float32Array(3);
  readonly tipReference = new Float32Array(3);
  readonly tipCommanded = new Float32Array(3);
  readonly force = new Float32Array(3);
  readonly at = new Float32Array(3);
  /** Index of the display frame before the time, and the share of the way to the next. */
  frame = 0;
  share = 0;
  private readonly tipPlace: number;
  private readonly once: Float32Array;
  private readonly planned: Float32Array;

  constructor(readonly arrays: Arrays) {
    [this.frames, this.links, this.stations] = arrays.line.shape;
    const size = this.links * this.stations * 3;
    this.line = new Float32Array(size);
    this.once = new Float32Array(size);
    this.planned = new Float32Array(size);
    this.rigid = arrays.rigid ? new Float32Array(size) : null;
    this.reference = arrays.reference ? new Float32Array(size) : null;
    this.roots = new Float32Array(this.links * 4);
    this.values = new Float32Array(this.links * this.stations);
    this.tipPlace = this.nearestEnd();
  }

  /** Move to a time; displacements from the rigid arm are shown `factor` times as large. */
  seek(time: number, factor: number, colour: Numbers | null): void {
    this.find(time);
    const { arrays } = this;
    this.mix(this.line, arrays.line);
    if (this.rigid && arrays.rigid) this.mix(this.rigid, arrays.rigid);
    if (this.reference && arrays.reference) this.mix(this.reference, arrays.reference);
    this.turn();
    this.mix(this.tip, arrays.tip);
    if (arrays.tipReference) this.mix(this.tipReference, arrays.tipReference);
    if (arrays.tipCommanded) this.mix(this.tipCommanded, arrays.tipCommanded);
    if (arrays.contact) {
      this.mix(this.force, arrays.contact.force);
      this.mix(this.at, arrays.contact.at);
    }
    if (colour) this.mix(this.values, colour);
    if (factor === 1 || !this.rigid) return;
    if (arrays.referenceRigid) this.mix(this.planned, arrays.referenceRigid);
    this.enlarge(factor, this.rigid, arrays.referenceRigid ? this.planned : this.rigid);
  }

  /** The path [m, 3] of a tip as it is shown; null where there is none. */
  path(of: Tip, factor: number): Float32Array | null {
    const { arrays, frames } = this;
    const tips = { actual: arrays.tip, nominal: arrays.tipReference, commanded: arrays.tipCommanded }[of];
    const lines = of === "nominal" ? arrays.reference : arrays.line;
    const rigid = (of === "nominal" && arrays.referenceRigid) || arrays.rigid;
    if (!tips) return null;
    const found = Float32Array.from(tips.data);
    if (!rigid || !lines || this.links === 0) return found;
    const size = this.links * this.stations * 3;
    for (let k = 0; k < frames; k++)
      for (let c = 0; c < 3; c++) {
        const place = k * size + this.tipPlace + c;
        const gap = of === "commanded" ? tips.data[3 * k + c] - arrays.tip.data[3 * k + c] : 0;
        found[3 * k + c] += (factor - 1) * (gap + lines.data[place] - rigid.data[place]);
      }
    return found;
  }

  private find(time: number): void {
    const times = this.arrays.times.data;
    let low = 0;
    let high = this.frames - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle;
    }
    this.frame = low;
    const span = high > low ? times[high] - times[low] : 0;
    this.share = span > 0 ? Math.min(1, Math.max(0, (time - times[low]) / span)) : 0;
  }

  private mix(out: Float32Array, from: Numbers): void {
    const size = out.length;
    const start = this.frame * size;
    const next = Math.min(this.frame + 1, this.frames - 1) * size;
    const { data } = from;
    for (let k = 0; k < size; k++) {
      const here = data[start + k];
      out[k] = here + this.share * (data[next + k] - here);
    }
  }

  private turn(): void {
    const { roots } = this;
    this.mix(roots, this.arrays.roots);
    for (let k = 0; k < roots.length; k += 4) {
      const size = Math.hypot(roots[k], roots[k + 1], roots[k + 2], roots[k + 3]) || 1;
      for (let c = 0; c < 4; c++) roots[k + c] /= size;
    }
  }

  private enlarge(factor: number, rigid: Float32Array, planned: Float32Array): void {
    const { line, reference, tipPlace } = this;
    for (let c = 0; c < 3 && this.links > 0; c++) {
      const more = (factor - 1) * (line[tipPlace + c] - rigid[tipPlace + c]);
      this.tipCommanded[c] += more + (factor - 1) * (this.tipCommanded[c] - this.tip[c]);
      this.tip[c] += more;
      this.at[c] += more;
      if (reference) this.tipReference[c] += (factor - 1) * (reference[tipPlace + c] - planned[tipPlace + c]);
    }
    this.once.set(line);
    for (let k = 0; k < line.length; k++) {
      line[k] = rigid[k] + factor * (line[k] - rigid[k]);
      if (reference) reference[k] = planned[k] + factor * (reference[k] - planned[k]);
    }
    turnAlong(this.roots, this.once, line, this.stations);
  }

  /** Where in a frame the end of the link is that is nearest to the tip. */
  private nearestEnd(): number {
    const { line, tip } = this.arrays;
    let best = 0;
    let least = Infinity;
    for (let link = 0; link < this.links; link++) {
      const place = (link * this.stations + this.stations - 1) * 3;
      const away = Math.hypot(...[0, 1, 2].map((c) => line.data[place + c] - tip.data[c]));
      if (away <= least) [best, least] = [place, away];
    }
    return best;
  }
}
