// What all ways to draw a scene have in common: the runs, the camera, what colours mean, what the notes over it say.
import type { PerspectiveCamera } from "three";
import type { Mode, Page } from "../contract";
import type { LiveScene } from "../contract_parts";
import { Cameras, type View } from "./cameras";
import { placesOf, type Extent } from "./extent";
import type { Entry, Notes } from "./notes";
import type { Palette } from "./palette";
import type { Settings } from "./settings";
import { forceScale, type Range, type ShownRun } from "./shown";
import { surfaced } from "./surfaces";
import { digits, readable } from "./units";

const NOTHING = 1e-12; // m, N m, ...: rounding
const GAP = 0.1; // of the reach, between robots side by side

export interface Scenery {
  page: Page;
  extent: Extent;
  colours: Palette;
  settings: Settings;
  /** Ask for a picture. */
  ask: () => void;
}

export abstract class Sight<Kind extends ShownRun = ShownRun> {
  readonly cameras: Cameras;
  protected readonly scale: number;
  protected range: Range = { low: 0, high: 1 };
  private shown: Mode | null = null;

  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly camera: PerspectiveCamera,
    readonly runs: Kind[],
    protected readonly given: Scenery,
  ) {
    const { page, extent, ask } = given;
    this.scale = forceScale(page.runs, extent.reach);
    this.cameras = new Cameras(camera, canvas, extent.reach, extent.opening.direction, ask);
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    const keys = "Arrow keys turn the view, with Shift they move it, + and - zoom.";
    canvas.setAttribute("aria-label", `The robot in space: ${page.runs.map(({ name }) => name).join(", ")}. ${keys}`);
    canvas.title = `Drag to turn, right button to move, click and wheel to zoom. ${keys}`;
  }

  /** `ratio`: pixels for one of the page; none: as many as suit what moves. */
  abstract draw(time: number, seconds: number, ratio?: number): void;

  /** Whether it is drawn with few pixels while it moves. */
  get coarse(): boolean {
    return false;
  }

  abstract resize(width: number, height: number): void;

  replace(run: number, scene: LiveScene | null): void {
    this.runs[run]?.replace(scene);
  }

  showMode(mode: Mode | null, _amplitude: number): void {
    this.shown = mode;
  }

  /** Take over what has been chosen. */
  refresh(): void {
    const { runs } = this;
    const { settings, extent } = this.given;
    const range = { low: Infinity, high: -Infinity };
    runs.forEach((run) => run.widen(settings.colour, range));
    this.range = range.low <= range.high ? range : { low: 0, high: 0 };
    const places = placesOf(this.given.page, settings.factor, extent);
    const [x, y] = this.cameras.across;
    const spots = settings.apart ? places.flatMap((_, k) => (k % 3 ? [] : [x * places[k] + y * places[k + 1]])) : [0];
    const ends = [Math.min, Math.max].map((best) => spots.reduce((one, other) => best(one, other)));
    const wide = settings.apart ? ends[1] - ends[0] + GAP * extent.reach : 0;
    const surfaces = runs.map(({ run }) => JSON.stringify(run.scene.contact?.surface));
    runs.forEach((run, k) => {
      const far = (k - (runs.length - 1) / 2) * wide;
      run.aside = [far * x, far * y];
      run.showsSurface = settings.apart || surfaces.indexOf(surfaces[k]) === k;
    });
    const moved = ({ aside }: ShownRun) => places.map((place, k) => place + (aside[k % 3] ?? 0));
    this.cameras.places = wide ? [runs[0], runs[runs.length - 1]].flatMap(moved) : places;
  }

  look(view: View, glide: boolean): void {
    this.cameras.view = view;
    if (this.given.settings.apart) this.refresh(); // side by side as they are seen from there
    this.cameras.show(view, this.tip, glide);
  }

  /** Where the tip of the first run is. */
  protected get tip(): Float32Array {
    const { aside, motion } = this.runs[0];
    return motion.tip.map((place, k) => place + (aside[k] ?? 0));
  }

  /** Look from where another one looks. */
  takeView(other: Sight): void {
    this.cameras.take(other.cameras);
  }

  /** Write legend, scale, enlargement and grid. */
  tell(notes: Notes): void {
    const { settings, extent } = this.given;
    const { shown } = this;
    const info = this.runs.flatMap(({ run }) => run.scene.colours).find(({ id }) => id === settings.colour);
    notes.list(shown ? this.modeEntries(shown) : this.entries(), !shown && this.forceShown());
    if (shown) notes.range({ label: "Displacement, share of the largest", unit: "", low: 0, high: 1 });
    else notes.range(info && this.range.high > NOTHING ? { label: info.label, unit: info.unit, ...this.range } : null);
    notes.enlarged(settings.factor === 1 || shown ? "" : `Deformation × ${settings.factor}, not to scale`);
    const height = extent.floor === 0 ? "" : `, at z = ${digits(extent.floor)} m`;
    notes.flat("");
    notes.floor(settings.floor ? `Grid ${digits(extent.cell)} m${height}${this.thick()}` : "");
  }

  /** The force at the tip, in words. */
  words(): string {
    if (!this.forceShown()) return "";
    const size = (force: Float32Array) => digits(Math.hypot(...force));
    const forces = this.runs.filter(({ run }) => run.scene.contact).map(({ motion }) => `${size(motion.force)} N`);
    return `Contact force ${forces.join(", ")} (arrow: ${digits(0.1 / this.scale)} N per 0.1 m)`;
  }

  dispose(): void {
    this.cameras.dispose();
    this.canvas.remove();
  }

  private forceShown(): boolean {
    return this.given.settings.force && this.scale > 0;
  }

  private entries(): Entry[] {
    const { runs } = this;
    const { settings, colours } = this.given;
    const alone = runs.length === 1;
    const entries: Entry[] = [];
    if (!alone) entries.push(...runs.map((run) => ({ colour: run.colour, label: run.run.name })));
    else if (settings.traces && this.moves()) entries.push({ colour: colours.real, label: "Path of the tip" });
    const wanted = runs.some(({ motion }) => motion.arrays.tipCommanded);
    if (settings.traces && wanted && this.moves()) entries.push({ colour: colours.commanded, label: "Commanded path" });
    const has = (key: "reference" | "rigid") => settings[key] && runs.some(({ run }) => run.scene[key]);
    const led = settings.traces && this.moves() && runs.some(({ run }) => run.scene.tipReference);
    if (has("reference")) entries.push({ colour: runs[0].referenceColour, label: "Nominal" });
    else if (led) entries.push({ colour: runs[0].referenceColour, label: "Nominal path" });
    if (has("rigid")) entries.push({ colour: colours.rigid, label: "Undeformed" });
    if (runs.some(({ changed }) => changed)) entries.push({ colour: colours.before, label: "The run as it was" });
    return entries;
  }

  /** A robot at rest leaves no path. */
  private moves(): boolean {
    return this.runs.some(({ run }) => run.charts.length > 0);
  }

  private modeEntries(mode: Mode): Entry[] {
    const damping = `damping ${digits(100 * mode.damping)} %`;
    const how = `motors ${mode.case}; slowed, not to scale`;
    const label = `Mode ${digits(mode.frequency)} Hz, ${damping}, ${mode.element}; ${how}`;
    return [
      { colour: this.given.colours.rigid, label: "At rest" },
      { colour: "transparent", label },
    ];
  }

  /** What is drawn thicker than it is, or of a thickness that nobody reported. */
  protected thick(): string {
    const { least } = this.given.extent;
    const sections = this.runs.flatMap(({ run: { scene } }) => {
      const hidden = surfaced(scene);
      return scene.links.filter((_, k) => !hidden.has(k)).map(({ section }) => section);
    });
    const thin = sections.some((section) => section && Math.min(...section.sizes.data) < least);
    const unit = readable("m", 2 * least);
    if (thin) return `; links are drawn at least ${digits(2 * least * unit.factor)} ${unit.name} thick`;
    return sections.some((section) => section?.guessed) ? "; thickness of links by their stiffness and mass" : "";
  }
}
