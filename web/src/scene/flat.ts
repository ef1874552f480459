// The scene without WebGL: the same robots, camera and choices, drawn as lines on a flat canvas.
import { PerspectiveCamera } from "three";
import type { Mode, Run } from "../contract";
import type { Extent } from "./extent";
import { drawArrow, drawFloor, drawTrace, FlatSurface } from "./flat_marks";
import { Pen } from "./flat_pen";
import { FlatRobot } from "./flat_links";
import { Swinging, SWING } from "./mode";
import type { Arrays } from "./motion";
import type { Notes } from "./notes";
import type { Palette } from "./palette";
import type { Look } from "./links";
import type { Settings } from "./settings";
import { paints, ShownRun, type Range } from "./shown";
import { Sight, type Scenery } from "./sight";

const GHOST = 0.42;

interface Sheet {
  pen: Pen;
  camera: PerspectiveCamera;
  extent: Extent;
  colours: Palette;
  /** Length of a newton [m]. */
  scale: number;
}

class FlatRun extends ShownRun {
  private robot: FlatRobot;
  private was: FlatRobot | null = null;
  private surface: FlatSurface | null;
  private laid: { path: Float32Array; color: string }[] = [];
  private traced = 0;

  constructor(
    run: Run,
    index: number,
    alone: boolean,
    private readonly colours: Palette,
    private readonly extent: Extent,
  ) {
    super(run, index, alone, colours);
    this.robot = new FlatRobot(run.scene, this.motion, extent);
    this.surface = this.touched();
  }

  override replace(arrays: Arrays | null): void {
    super.replace(arrays);
    this.robot = new FlatRobot(this.run.scene, this.motion, this.extent);
    this.was = this.before && new FlatRobot(this.run.scene, this.before, this.extent);
    this.surface = this.touched();
    this.traced = 0;
  }

  /** The surface where these arrays have it. */
  private touched(): FlatSurface | null {
    const { contact } = this.run.scene;
    if (contact === null) return null;
    const { surface, at } = { ...contact, ...this.motion.arrays.contact };
    return new FlatSurface({ surface: surface ?? contact.surface, at }, this.extent, this.colours.surface);
  }

  draw({ pen, camera, scale, colours }: Sheet, time: number, settings: Settings, range: Range): void {
    const { motion, before } = this;
    pen.aside = this.aside;
    this.seek(time, settings);
    this.trace(settings.factor);
    if (settings.surface && this.showsSurface) this.surface?.draw(pen);
    if (this.was && before) this.was.ghost(pen, before.line, colours.before, GHOST);
    if (settings.rigid && motion.rigid) this.robot.ghost(pen, motion.rigid, colours.rigid, GHOST);
    if (settings.reference && motion.reference) this.robot.ghost(pen, motion.reference, this.referenceColour, GHOST);
    if (settings.traces) this.laid.forEach(({ path, color }) => drawTrace(pen, path, motion.frame, color));
    this.robot.draw(pen, motion.line, this.look(settings), range, camera.position);
    if (settings.force && motion.arrays.contact) drawArrow(pen, motion.force, motion.at, scale, colours.force);
    pen.aside = [0, 0];
  }

  private look(settings: Settings): Look {
    const painted = paints(settings.colour);
    return {
      ...lookOf(this.colours, this.alone ? null : this.colour, painted === "none" ? this.colour : this.colours.link),
      painted,
    };
  }

  private trace(factor: number): void {
    if (factor === this.traced) return;
    this.traced = factor;
    this.laid = this.paths.flatMap(([of, color]) => {
      const path = this.motion.path(of, factor);
      return path ? [{ path, color }] : [];
    });
  }
}

function lookOf({ joint, gear, base, payload }: Palette, one: string | null, link: string): Look {
  return {
    link,
    joint: one ?? joint,
    gear: one ?? gear,
    base,
    payload: one ?? payload,
    opacity: 1,
    painted: "all",
    fine: false,
  };
}

export class FlatWorld extends Sight<FlatRun> {
  private readonly sheet: Sheet;
  private mode: { swinging: Swinging; robot: FlatRobot } | null = null;
  private ratio: number | undefined;

  /** `wanted`: somebody chose it, it is not for want of WebGL. */
  constructor(given: Scenery, private readonly wanted: boolean) {
    const { page, extent, colours } = given;
    const camera = new PerspectiveCamera(32, 1, 0.01 * extent.reach, 100 * extent.reach);
    camera.up.set(0, 0, 1);
    const pen = new Pen(camera);
    super(
      pen.canvas,
      camera,
      page.runs.map((run, k) => new FlatRun(run, k, page.runs.length === 1, colours, extent)),
      given,
    );
    this.sheet = { pen, camera, extent, colours, scale: this.scale };
    this.refresh();
  }

  draw(time: number, seconds: number, ratio?: number): void {
    const { sheet } = this;
    const { width, height } = sheet.pen;
    if (ratio !== this.ratio) sheet.pen.resize(width, height, ratio);
    this.ratio = ratio;
    const { settings, extent, colours } = this.given;
    if (!this.mode) this.cameras.follow(this.tip);
    sheet.pen.begin(extent.reach);
    if (settings.floor) drawFloor(sheet.pen, extent, colours);
    if (this.mode) this.swing((2 * Math.PI * seconds) / SWING);
    else this.sorted().forEach((run) => run.draw(sheet, time, settings, this.range));
  }

  override showMode(mode: Mode | null, amplitude: number): void {
    super.showMode(mode, amplitude);
    const { scene } = this.runs[0].run;
    const swinging = mode && new Swinging(mode, scene, amplitude * this.given.extent.reach);
    this.mode = swinging && { swinging, robot: new FlatRobot(scene, swinging.motion, this.given.extent) };
  }

  resize(width: number, height: number): void {
    this.sheet.pen.resize(width, height, this.ratio);
  }

  override tell(notes: Notes): void {
    super.tell(notes);
    const meshed = this.runs.some(({ run }) => run.scene.meshes.length > 0);
    const left = meshed ? "; the surfaces of the parts (meshes) are left out" : "";
    notes.flat(`Drawn in lines${this.wanted ? "" : ", without WebGL"}${left}`);
  }

  /** That it is drawn in lines is said, in the same place. */
  protected override thick(): string {
    return "";
  }

  /** The farther first: the nearer is drawn over it. */
  private sorted(): FlatRun[] {
    const { pen } = this.sheet;
    const depth = (run: FlatRun) => pen.depth([...run.aside, 0], 0);
    return [...this.runs].sort((one, other) => depth(other) - depth(one));
  }

  private swing(phase: number): void {
    if (!this.mode) return;
    const { swinging, robot } = this.mode;
    const { pen, camera, colours } = this.sheet;
    robot.ghost(pen, Float32Array.from(swinging.motion.arrays.line.data), colours.rigid, GHOST);
    swinging.swing(phase);
    robot.draw(pen, swinging.motion.line, lookOf(colours, null, colours.link), { low: 0, high: 1 }, camera.position);
  }
}
