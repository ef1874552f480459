// One run in space: its robot, ghosts of its reference, of its rigid plan and of itself before a change, tips, contact.
import { Group, type Material, type Mesh } from "three";
import type { Run } from "../contract";
import type { Extent } from "./extent";
import { Arrow, surfaceMesh, Trace } from "./marks";
import type { Arrays, Motion, Tip } from "./motion";
import type { Palette } from "./palette";
import { RobotView, type Body, type Look } from "./links";
import type { Settings } from "./settings";
import { paints, ShownRun, type Range } from "./shown";

type Ghost = "reference" | "rigid" | "before";

/** What all runs of a scene share. */
export interface Shared {
  extent: Extent;
  colours: Palette;
  fine: boolean;
  /** Length of a newton [m]. */
  scale: number;
}

export class RunView extends ShownRun {
  readonly group = new Group();
  private robot!: RobotView;
  private look!: Look;
  private readonly ghosts = new Map<Ghost, RobotView>();
  private readonly traces = new Map<Tip, Trace>();
  private arrow: Arrow | null = null;
  private surface: Mesh | null = null;
  private built = "";
  private traced = "";

  constructor(run: Run, index: number, alone: boolean, private readonly shared: Shared) {
    super(run, index, alone, shared.colours);
  }

  override replace(arrays: Arrays | null): void {
    const shape = String(this.motion.arrays.line.shape.slice(1));
    super.replace(arrays);
    if (String(this.motion.arrays.line.shape.slice(1)) !== shape) this.built = "";
    this.traced = "";
    if (this.built !== "") this.placeSurface(); // else it comes with the robot
  }

  update(time: number, settings: Settings, range: Range): void {
    const { motion } = this;
    this.build(settings);
    this.seek(time, settings);
    this.robot.update(motion, motion.line, range.low, range.high);
    this.haunt("reference", motion, settings.reference ? motion.reference : null);
    this.haunt("rigid", motion, settings.rigid ? motion.rigid : null);
    this.haunt("before", this.before ?? motion, this.before?.line ?? null);
    this.draw(settings);
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
    const look: Look = {
      link: own,
      joint,
      gear: this.alone ? colours.gear : joint,
      base: colours.base,
      payload: joint,
      opacity: 1,
      painted,
      fine,
      layer: this.index,
    };
    this.robot = this.added(scene, this.motion, look, 1);
    this.look = look;
    if (scene.contact) {
      this.arrow = new Arrow(colours.force, 0.006 * extent.reach, this.shared.scale);
      this.group.add(this.arrow.group);
      this.placeSurface();
    }
  }

  /** Draw the surface where these arrays have it. */
  private placeSurface(): void {
    const { contact } = this.run.scene;
    if (!contact) return;
    const { extent, colours } = this.shared;
    const { surface, at } = { ...contact, ...this.motion.arrays.contact };
    const placed = surfaceMesh(surface ?? contact.surface, at.data, 0.12 * extent.reach, colours.surface);
    if (!this.surface) {
      this.group.add((this.surface = placed));
      return;
    }
    this.surface.geometry.dispose(); // its material stays: a new one needs a new program
    this.surface.geometry = placed.geometry;
    (placed.material as Material).dispose();
  }

  private dropSurface(): void {
    if (!this.surface) return;
    this.surface.geometry.dispose();
    (this.surface.material as Material).dispose();
    this.surface.removeFromParent();
    this.surface = null;
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

  private added(body: Body, motion: Motion, look: Look, share: number): RobotView {
    const { extent } = this.shared;
    const widths = { usual: share * extent.usual, least: share * extent.least, floor: extent.floor };
    const view = new RobotView(share < 1 ? thinner(body, share) : body, motion, look, widths);
    this.group.add(view.group);
    return view;
  }

  private draw(settings: Settings): void {
    this.trace(settings);
    for (const [of, trace] of this.traces) {
      const { tipReference, tipCommanded } = this.motion.arrays;
      const there = { actual: true, nominal: tipReference, commanded: tipCommanded }[of];
      trace.group.visible = settings.traces && Boolean(there);
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
    this.traced = wanted;
    for (const [of, colour] of this.paths) {
      const path = this.motion.path(of, settings.factor);
      if (path === null) continue;
      const trace = this.traces.get(of) ?? new Trace(path, colour, 0.012 * this.shared.extent.reach);
      trace.lay(path);
      this.traces.set(of, trace);
      this.group.add(trace.group);
    }
  }

  private clear(): void {
    this.robot?.dispose();
    this.ghosts.forEach((view) => view.dispose());
    this.traces.forEach((trace) => trace.dispose());
    this.arrow?.dispose();
    this.dropSurface();
    this.ghosts.clear();
    this.traces.clear();
    this.traced = this.built = "";
  }
}

/** Ghosts lie inside of what they are ghosts of, as long as they are in the same place. */
function thinner(body: Body, share: number): Body {
  const links = body.links.map((link) => {
    if (link.section === null) return link;
    const { data, shape } = link.section.sizes;
    return {
      ...link,
      section: { ...link.section, sizes: { data: Float32Array.from(data, (size) => share * size), shape } },
    };
  });
  return { ...body, links };
}
