// All that stands in one scene in 3D: the runs, or a mode of the first, drawn by WebGL.
import type { Mode } from "../contract";
import { ModeView, SWING } from "./mode";
import { RunView, type Shared } from "./run";
import { forceScale } from "./shown";
import { Sight, type Scenery } from "./sight";
import { Stage, type Quality } from "./stage";

export class World extends Sight<RunView> {
  private readonly stage: Stage;
  private readonly shared: Shared;
  private mode: ModeView | null = null;

  /** Raises an error where there is no WebGL after all. */
  constructor(given: Scenery, quality: Quality) {
    const { page, extent, colours } = given;
    const stage = new Stage(quality, extent);
    const shared = { extent, colours, fine: quality === "high", scale: forceScale(page.runs, extent.reach) };
    const runs = page.runs.map((run, k) => new RunView(run, k, page.runs.length === 1, shared));
    super(stage.canvas, stage.camera, runs, given);
    this.stage = stage;
    this.shared = shared;
    stage.dress(colours);
    runs.forEach(({ group }) => stage.scene.add(group));
    this.refresh();
  }

  draw(time: number, seconds: number, ratio?: number): void {
    const { settings } = this.given;
    if (this.mode) this.mode.swing((2 * Math.PI * seconds) / SWING);
    else this.runs.forEach((run) => run.update(time, settings, this.range));
    if (!this.mode) this.cameras.follow(this.tip);
    this.stage.draw(ratio);
  }

  override get coarse(): boolean {
    return this.stage.quality === "low";
  }

  override showMode(mode: Mode | null, amplitude: number): void {
    super.showMode(mode, amplitude);
    this.mode?.dispose();
    this.mode = mode && new ModeView(mode, this.runs[0].run.scene, amplitude, this.shared);
    if (this.mode) this.stage.scene.add(this.mode.group);
    this.runs.forEach(({ group }) => (group.visible = mode === null));
  }

  refresh(): void {
    super.refresh();
    this.runs.forEach(({ group, aside }) => group.position.set(...aside, 0));
    this.stage.floorShown = this.given.settings.floor;
  }

  resize(width: number, height: number): void {
    this.stage.resize(width, height);
  }

  dispose(): void {
    this.mode?.dispose();
    this.runs.forEach((run) => run.dispose());
    super.dispose();
    this.stage.dispose();
  }
}

/** Drawn by WebGL; null where the browser has none after all. */
export function inSpace(given: Scenery, quality: Quality): World | null {
  try {
    return new World(given, quality);
  } catch {
    return null;
  }
}
