// One run in space: its robot, the ghosts of its reference, its rigid plan and of itself before a change, tips, contact.
import { Group, type Material, type Mesh } from "three";
import type { Run } from "../contract";
import type { Extent } from "./extent";
import { Arrow, surfaceMesh, Trace } from "./marks";
import { Motion, type Arrays } from "./motion";
import { RUNS, type Palette } from "./palette";
import { RobotView, type Body, type Look } from "./robot";
import type { Settings } from "./settings";
import { round125 } from "./units";

type Ghost = "reference" | "rigid" | "before";

export interface Range {
  low: number;
  high: number;
}

/** What all runs of a scene share. */
export interface Shared {
  extent: Extent;
  colours: Palette;
  fine: boolean;
  /** Length of a newton [m]. */
  scale: number;
}

export class RunView {
  readonly group = new Group();
  motion: Motion;
  /** Whether its surface is shown where surfaces are: another run may show the same. */
  showsSurface = true;
  private before: Motion | null = null;
  private robot!: RobotView;
  private look!: Look;
  private readonly ghosts = new Map<Ghost, RobotView>();
  private traces: { trace: Trace; reference: boolean }[] = [];
  private arrow: Arrow | null = null;
  private surface: Mesh | null = null;
  private built = "";
  private traced = "";

  /** `alone`: there is no other run, so that the robot needs no colour of its own. */
  constructor(readonly run: Run, private readonly index: number, private readonly alone: boolean, private readonly shared: Shared) {
    this.motion = new Motion(run.scene);
  }

  /** The colour by which this run is told from the others. */
  get colour(): string {
    return this.alone ? this.shared.colours.real : RUNS[this.index % RUNS.length];
  }

  get referenceColour(): string {
    return this.alone ? this.shared.colours.reference : this.shared.colours.rigid;
  }

  get changed(): boolean {
    return this.before !== null;
  }

  /** Other arrays, which the page's own then stand beside as a ghost; null: the page's own. */
  replace(arrays: Arrays | null): void {
    const { scene } = this.run;
    const shapes = this.motion.arrays.line.shape;
    const next = new Motion(arrays ?? scene);
    if (String(next.arrays.line.shape.slice(1)) !== String(shapes.slice(1))) this.built = "";
    this.before = arrays === null ? null : (this.before ?? new Motion(scene));
    this.motion = next;
    this.traced = "";
    if (this.built !== "") this.placeSurface(); // else it comes with the robot
  }

  update(time: number, settings: Settings, range: Range): void {
    const { motion } = this;
    this.build(settings);
    const values = motion.arrays.colours.find(({ id }) => id === settings.colour)?.values ?? null;
    motion.seek(time, settings.factor, values);
    this.robot.update(motion, motion.line, range.low, range.high);
    this.before?.seek(time, settings.factor, null);
    this.haunt("reference", motion, settings.reference ? motion.reference : null);
    this.haunt("rigid", motion, settings.rigid ? motion.rigid : null);
    this.haunt("before", this.before ?? motion, this.before?.line ?? null);
    this.draw(settings);
  }

  /** Widen a range by all values of a quantity on the links that it colours. */
  widen(id: string, range: Range): void {
    const { arrays, links, stations } = this.motion;
    const told = arrays.colours.find((one) => one.id === id)?.values.data;
    const coloured = this.run.scene.links.map((link) => link.bends || paints(id) === "all");
    if (told === undefined) return;
    for (let k = 0; k < told.length; k++) {
      if (!coloured[Math.floor(k / stations) % links]) continue;
      if (told[k] < range.low) range.low = told[k];
      if (told[k] > range.high) range.high = told[k];
    }
  }

  dispose(): void {
    this.clear();
    this.group.removeFromParent();
  }

  /** Make what is shown, where the choice of what it is made of has changed. */
  private build(settings: Settings): void {
    const painted = paints(settings.colour);
    if (painted === this.built) return;
    this.clear();
    this.built = painted;
    const { scene } = this.run;
    const { extent, colours, fine } = this.shared;
    const own = painted === "none" ? this.colour : colours.link;
    const joint = this.alone ? colours.joint : this.colour;
    const look: Look = { link: own, joint, gear: this.alone ? colours.gear : joint, base: colours.base, payload: joint, opacity: 1, painted, fine };
    this.robot = this.added(scene, this.motion, look, 1);
    this.look = look;
    if (scene.contact) {
      this.arrow = new Arrow(colours.force, 0.006 * extent.reach, this.shared.scale);
      this.group.add(this.arrow.group);
      this.placeSurface();
    }
  }

  /** A pale robot along a line, null: not now. It is made when it is first shown, and kept. */
  private haunt(of: Ghost, motion: Motion, line: Float32Array | null): void {
    const known = this.ghosts.get(of);
    if (known) known.group.visible = line !== null;
    if (line === null) return;
    const view = known ?? this.ghost(of, motion);
    view.update(motion, line, 0, 1);
  }

  private ghost(of: Ghost, motion: Motion): RobotView {
    const { colours } = this.shared;
    const link = { reference: this.referenceColour, rigid: colours.rigid, before: colours.before }[of];
    const view = this.added(this.run.scene, motion, { ...this.look, link, opacity: 0.42, painted: "none" }, 0.85);
    this.ghosts.set(of, view);
    return view;
  }

  /** Draw the surface where these arrays have it. */
  private placeSurface(): void {
    const { contact } = this.run.scene;
    if (!contact) return;
    const { surface, at } = { ...contact, ...this.motion.arrays.contact };
    this.dropSurface();
    this.surface = surfaceMesh(surface ?? contact.surface, at.data, 0.12 * this.shared.extent.reach, this.shared.colours.surface);
    this.group.add(this.surface);
  }

  private dropSurface(): void {
    if (!this.surface) return;
    this.surface.geometry.dispose();
    (this.surface.material as Material).dispose();
    this.surface.removeFromParent();
    this.surface = null;
  }

  private added(body: Body, motion: Motion, look: Look, share: number): RobotView {
    const { extent } = this.shared;
    const widths = { usual: share * extent.usual, least: share * extent.least, floor: extent.floor };
    const view = new RobotView(share < 1 ? thinner(body, share) : body, motion, look, widths);
    this.group.add(view.group);
    return view;
  }

  private draw(settings: Settings): void {
    this.trace(settings);
    for (const { trace, reference } of this.traces) {
      trace.group.visible = settings.traces && (!reference || this.motion.arrays.tipReference !== null);
      trace.seek(this.motion.frame);
    }
    if (this.surface) this.surface.visible = settings.surface && this.showsSurface;
    if (!this.arrow) return;
    this.arrow.point(this.motion.force, this.motion.at);
    this.arrow.group.visible &&= settings.force && this.motion.arrays.contact !== null;
  }

  private trace(settings: Settings): void {
    const wanted = `${settings.factor}`;
    if (wanted === this.traced) return;
    const first = this.traces.length === 0;
    this.traced = wanted;
    for (const reference of [false, true]) {
      const path = this.motion.path(reference, settings.factor);
      const known = this.traces.find((one) => one.reference === reference);
      if (path === null) continue;
      if (known) known.trace.lay(path);
      else if (first) {
        const colour = reference ? this.referenceColour : this.colour;
        const trace = new Trace(path, colour, 0.012 * this.shared.extent.reach);
        this.traces.push({ trace, reference });
        this.group.add(trace.group);
      }
    }
  }

  private clear(): void {
    this.robot?.dispose();
    this.ghosts.forEach((view) => view.dispose());
    this.traces.forEach(({ trace }) => trace.dispose());
    this.arrow?.dispose();
    this.dropSurface();
    this.ghosts.clear();
    this.traces = [];
    this.traced = this.built = "";
  }
}

/** Displacement is one of all links, other quantities are of those that bend. */
function paints(colour: string): Look["painted"] {
  return colour === "run" ? "none" : colour === "displacement" ? "all" : "bending";
}

/** Ghosts lie inside of what they are ghosts of, as long as they are in the same place. */
function thinner(body: Body, share: number): Body {
  const links = body.links.map((link) => {
    if (link.section === null) return link;
    const { data, shape } = link.section.sizes;
    return { ...link, section: { ...link.section, sizes: { data: Float32Array.from(data, (size) => share * size), shape } } };
  });
  return { ...body, links };
}

const USUAL_FORCE = 10; // N, of runs that touch nothing: a changed one may

/** The length of a newton with which the largest force of all runs is about a third of the robot's reach; 0: no contact. */
export function forceScale(runs: Run[], reach: number): number {
  let largest = 0;
  for (const { scene } of runs) {
    const force = scene.contact?.force.data ?? [];
    for (let k = 0; k + 2 < force.length; k += 3) largest = Math.max(largest, Math.hypot(force[k], force[k + 1], force[k + 2]));
  }
  if (runs.every(({ scene }) => scene.contact === null)) return 0;
  return round125((0.35 * reach) / (largest || USUAL_FORCE));
}
