// All that stands in one scene: the runs, or a mode of the first; what colours mean; and what the notes over it say.
import { Vector3 } from "three";
import type { LiveRun, Mode, Page } from "../contract";
import { Cameras, type View } from "./cameras";
import type { Extent } from "./extent";
import { ModeView, SWING } from "./mode";
import type { Entry, Notes } from "./notes";
import { palette, type Palette } from "./palette";
import { forceScale, RunView, type Range, type Shared } from "./run";
import type { Settings } from "./settings";
import { Stage, type Quality } from "./stage";
import { digits, readable } from "./units";

export class World {
  private readonly stage: Stage;
  private readonly cameras: Cameras;
  private readonly colours: Palette;
  private readonly runs: RunView[];
  private readonly shared: Shared;
  private range: Range = { low: 0, high: 1 };
  private mode: ModeView | null = null;
  private shown: Mode | null = null;

  constructor(page: Page, private readonly extent: Extent, quality: Quality, dark: boolean, private readonly settings: Settings, ask: () => void) {
    this.colours = palette(dark);
    this.stage = new Stage(quality, extent);
    this.stage.dress(this.colours);
    this.shared = { extent, colours: this.colours, fine: quality === "high", scale: forceScale(page.runs, extent.reach) };
    this.runs = page.runs.map((run, k) => new RunView(run, k, page.runs.length === 1, this.shared));
    this.runs.forEach(({ group }) => this.stage.scene.add(group));
    this.cameras = new Cameras(this.stage.camera, this.canvas, extent.reach, ask);
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    const keys = "Arrow keys turn the view, with Shift they move it, + and - zoom.";
    this.canvas.setAttribute("aria-label", `The robot in space: ${page.runs.map(({ name }) => name).join(", ")}. ${keys}`);
    this.canvas.title = `Drag to turn, right button to move, click and wheel to zoom. ${keys}`;
    this.refresh();
  }

  get canvas(): HTMLCanvasElement {
    return this.stage.canvas;
  }

  draw(time: number, seconds: number): void {
    if (this.mode) this.mode.swing((2 * Math.PI * seconds) / SWING);
    else this.runs.forEach((run) => run.update(time, this.settings, this.range));
    if (!this.mode) this.cameras.follow(this.runs[0].motion.tip);
    this.stage.draw();
  }

  replace(run: number, scene: LiveRun["scene"] | null): void {
    this.runs[run]?.replace(scene);
  }

  showMode(mode: Mode | null, amplitude: number): void {
    this.mode?.dispose();
    this.mode = mode && new ModeView(mode, this.runs[0].run.scene, amplitude, this.shared);
    this.shown = mode;
    if (this.mode) this.stage.scene.add(this.mode.group);
    this.runs.forEach(({ group }) => (group.visible = mode === null));
  }

  /** Take over what has been chosen. */
  refresh(): void {
    const { settings, runs } = this;
    const range = { low: Infinity, high: -Infinity };
    runs.forEach((run) => run.widen(settings.colour, range));
    this.range = range.low <= range.high ? range : { low: 0, high: 0 };
    const { box, reach } = this.extent;
    const wide = settings.apart ? Math.max(0.4 * reach, box.max.y - box.min.y + 0.15 * reach) : 0;
    const surfaces = runs.map(({ run }) => JSON.stringify(run.scene.contact?.surface));
    runs.forEach((run, k) => {
      run.group.position.set(0, (k - (runs.length - 1) / 2) * wide, 0);
      run.showsSurface = settings.apart || surfaces.indexOf(surfaces[k]) === k;
    });
    this.cameras.box.copy(box).expandByVector(new Vector3(0, ((runs.length - 1) / 2) * wide, 0));
    this.stage.floorShown = settings.floor;
  }

  look(view: View, glide: boolean): void {
    this.cameras.show(view, this.runs[0].motion.tip, glide);
  }

  /** Look from where another world was looked at. */
  takeView(other: World): void {
    this.cameras.take(other.cameras);
  }

  resize(width: number, height: number): void {
    this.stage.resize(width, height);
  }

  /** Write legend, scale, enlargement and grid. */
  tell(notes: Notes): void {
    const { settings, extent, shown } = this;
    const told = this.runs.flatMap(({ run }) => run.scene.colours).find(({ id }) => id === settings.colour);
    notes.list(shown ? this.modeEntries(shown) : this.entries(), !shown && this.forceShown());
    if (shown) notes.range({ label: "Displacement, share of the largest", unit: "", low: 0, high: 1 });
    else notes.range(told ? { label: told.label, unit: told.unit, ...this.range } : null);
    notes.enlarged(settings.factor === 1 || shown ? "" : `Deformation × ${settings.factor}`);
    const height = extent.floor === 0 ? "" : `, at z = ${digits(extent.floor)} m`;
    notes.floor(settings.floor ? `Grid ${digits(extent.cell)} m${height}${this.thick()}` : "");
  }

  /** The force at the tip, in words. */
  words(): string {
    if (!this.forceShown()) return "";
    const size = (force: Float32Array) => digits(Math.hypot(...force));
    const forces = this.runs.filter(({ run }) => run.scene.contact).map(({ motion }) => `${size(motion.force)} N`);
    return `Contact force ${forces.join(", ")} (arrow: ${digits(0.1 / this.shared.scale)} N per 0.1 m)`;
  }

  dispose(): void {
    this.mode?.dispose();
    this.runs.forEach((run) => run.dispose());
    this.cameras.dispose();
    this.stage.dispose();
  }

  private forceShown(): boolean {
    return this.settings.force && this.shared.scale > 0;
  }

  private entries(): Entry[] {
    const { settings, runs, colours } = this;
    const alone = runs.length === 1;
    const entries: Entry[] = [];
    if (!alone) entries.push(...runs.map((run) => ({ colour: run.colour, label: run.run.name })));
    else if (settings.traces) entries.push({ colour: colours.real, label: "Path of the tip" });
    const has = (key: "reference" | "rigid") => settings[key] && runs.some(({ run }) => run.scene[key]);
    if (has("reference")) entries.push({ colour: runs[0].referenceColour, label: "Reference" });
    else if (settings.traces && runs.some(({ run }) => run.scene.tipReference)) entries.push({ colour: runs[0].referenceColour, label: "Path of the reference" });
    if (has("rigid")) entries.push({ colour: colours.rigid, label: "Without any elasticity" });
    if (runs.some(({ changed }) => changed)) entries.push({ colour: colours.before, label: "The run as it was" });
    return entries;
  }

  private modeEntries(mode: Mode): Entry[] {
    const damping = `damping ${digits(100 * mode.damping)} %`;
    const label = `Mode ${digits(mode.frequency)} Hz, ${damping}, ${mode.livesIn}; motors ${mode.case}; slowed, not to scale`;
    return [{ colour: this.colours.rigid, label: "At rest" }, { colour: "transparent", label }];
  }

  /** What is drawn thicker than it is, or of a thickness that nobody told. */
  private thick(): string {
    const sections = this.runs.flatMap(({ run }) => run.scene.links.map(({ section }) => section));
    const thin = sections.some((section) => section && Math.min(...section.sizes.data) < this.extent.least);
    const unit = readable("m", 2 * this.extent.least);
    if (thin) return `; links are drawn at least ${digits(2 * this.extent.least * unit.factor)} ${unit.name} thick`;
    return sections.some((section) => section?.guessed) ? "; thickness of links by their stiffness and mass" : "";
  }
}
