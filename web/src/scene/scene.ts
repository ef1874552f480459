// The robot in space: `mountScene` puts it into an element of the page, where it follows the page's clock.
import type { Clock } from "../clock";
import type { Mode, Page } from "../contract";
import type { Cause, LiveScene, SceneView } from "../contract_parts";
import { make, makeControls } from "./controls";
import { alike, extentOf } from "./extent";
import { FlatWorld } from "./flat";
import { Notes } from "./notes";
import { Painting } from "./painting";
import { palette } from "./palette";
import type { Settings } from "./settings";
import type { Sight } from "./sight";
import { suitable, type Quality } from "./stage";
import { useStyle } from "./style";
import { inSpace } from "./world";

const PATIENCE = 2000; // ms: a context that is lost comes back by then, or the robot is drawn without it

/** `bent`: deformations are enlarged until they are seen, with the undeformed robot as a ghost. */
export function mountScene(element: HTMLElement, page: Page, clock: Clock, bent = false): SceneView {
  useStyle();
  const frame = make("div", { className: "scene" });
  const view = make("div", { className: "scene-view" });
  element.append(frame);
  return new Mounted(frame, view, page, clock, suitable(), bent);
}

class Mounted implements SceneView {
  private readonly settings: Settings;
  private readonly notes: Notes;
  private readonly replaced: (LiveScene | null)[];
  private readonly ends: (() => void)[] = [];
  private readonly dark = window.matchMedia("(prefers-color-scheme: dark)");
  private readonly still = window.matchMedia("(prefers-reduced-motion: reduce)");
  private readonly extent;
  private world: Sight;
  private readonly painting: Painting;
  private before: SceneView["view"] | null = null; // that of all causes
  private waiting = 0;
  private mode: { mode: Mode; amplitude: number } | null = null;
  private asked = 0;
  private drawn = 1; // times the deformations are enlarged

  constructor(
    private readonly frame: HTMLElement,
    private readonly place: HTMLElement,
    private readonly page: Page,
    private readonly clock: Clock,
    /** The quality that suits the machine; null: there is no WebGL. */
    private best: Quality | null,
    bent: boolean,
  ) {
    const { runs } = page;
    const many = runs.length > 1;
    this.extent = extentOf(page);
    const enlarges = bent && this.extent.opening.most > 1;
    const bends = bent && this.extent.opening.bends;
    this.settings = {
      colour: many ? "run" : (runs[0].scene.colours[0]?.id ?? "run"),
      factor: enlarges ? this.extent.opening.factor : 1,
      reference: !many && !bends && runs[0].charts.length > 0, // at rest it is in the same place
      rigid: bends && !many,
      traces: true,
      force: true,
      surface: true,
      floor: true,
      apart: many && !alike(page, this.extent),
      quality: "auto",
    }; // prettier-ignore
    this.replaced = runs.map(() => null);
    this.notes = new Notes(place);
    this.painting = new Painting(place, this.notes, this.extent.reach, () => ({
      time: clock.time, seconds: this.still.matches ? 0 : performance.now() / 1000,
    }));
    frame.append(this.controls(), place);
    this.world = this.made();
    this.ends.push(clock.subscribe(this.ask));
    const sizes = new ResizeObserver(() => this.resize());
    sizes.observe(place);
    this.dark.addEventListener("change", this.remake);
    this.ends.push(() => sizes.disconnect(), () => this.dark.removeEventListener("change", this.remake));
    this.resize();
    this.refresh();
    this.world.look("iso", false);
  }

  replace(run: number, scene: LiveScene | null): void {
    this.replaced[run] = scene;
    this.world.replace(run, scene);
    this.refresh();
  }

  showMode(mode: Mode | null, amplitude: number): void {
    if (mode && this.mode?.mode !== mode) this.frame.scrollIntoView({ block: "nearest" });
    this.mode = mode === null ? null : { mode, amplitude };
    this.painting.swings = mode !== null;
    this.world.showMode(mode, amplitude);
    this.refresh();
  }

  get opensAt(): number {
    return this.extent.opening.time;
  }

  get view(): SceneView["view"] {
    return { pose: this.world.cameras.pose, factor: this.settings.factor };
  }

  set view({ pose, factor }: SceneView["view"]) {
    const slider = this.frame.querySelector<HTMLInputElement>("[data-scene=factor]");
    const { most } = this.extent.opening;
    if (slider && factor !== this.settings.factor) {
      slider.value = String((100 * Math.log(Math.min(Math.max(factor, 1), most))) / Math.log(most));
      slider.dispatchEvent(new Event("input"));
    }
    if (pose.length === 6 && pose.every(Number.isFinite)) this.world.cameras.pose = pose;
  }

  explain(cause: Cause | null): void {
    const pose = this.world.cameras.preset ? [] : this.view.pose;
    if (cause && !this.painting.cause) this.before = { ...this.view, pose };
    this.painting.cause = cause;
    if (cause) this.frame.scrollIntoView({ block: "nearest" });
    if (cause) this.view = { pose: [], factor: this.painting.factorOf(cause) };
    else if (this.before) this.view = this.before;
    this.ask();
  }

  highlight(element: string | null): void {
    this.place.dataset.marked = this.painting.marked = element ?? "";
    this.ask();
  }

  onPick(act: (element: string) => void): void {
    this.painting.picked = act;
  }

  picture(canvas?: HTMLCanvasElement): HTMLCanvasElement {
    const time = this.mode ? "" : `, t = ${this.clock.time.toFixed(3)} s`;
    const found = this.painting.picture(this.page.title + time, canvas);
    if (!canvas) this.ask();
    return found;
  }

  resize(): void {
    this.world.resize(this.place.clientWidth, this.place.clientHeight);
    if (this.world.cameras.preset) this.world.cameras.refit();
    this.painting.layout();
    this.ask();
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    window.clearTimeout(this.waiting);
    this.painting.dispose();
    this.ends.forEach((end) => end());
    this.world.canvas.removeEventListener("webglcontextlost", this.lost); // it loses it now
    this.world.dispose();
    this.frame.remove();
  }

  private controls(): HTMLElement {
    const { runs } = this.page;
    const quantities = new Map(runs.flatMap(({ scene }) => scene.colours.map(({ id, label }) => [id, label] as const)));
    const colours: [string, string][] = [...quantities, ["run", runs.length > 1 ? "each robot its own" : "none"]];
    const any = (has: (scene: Page["runs"][0]["scene"]) => unknown) => runs.some(({ scene }) => has(scene));
    const there: [keyof Settings, boolean][] = [
      ["reference", any((scene) => scene.reference)], ["rigid", any((scene) => scene.rigid)], ["traces", true],
      ["force", any((scene) => scene.contact)], ["surface", any((scene) => scene.contact)], ["floor", true],
      ["apart", runs.length > 1],
    ]; // prettier-ignore
    const toggles = there.filter(([, is]) => is).map(([key]) => key);
    return makeControls(this.settings, colours, toggles, this.extent.opening.most, this.best !== null, {
      changed: () => {
        const before = this.drawn;
        this.refresh();
        if (before !== this.settings.factor) this.world.cameras.refit();
      },
      look: (view) => this.world.look(view, !this.still.matches),
      quality: () => {
        this.best ??= suitable();
        this.remake();
      },
    });
  }

  private made(): Sight {
    const { page, extent, settings, ask } = this;
    const given = { page, extent, colours: palette(this.dark.matches), settings, ask };
    const { quality } = settings;
    const solid = quality === "lines" ? null : this.best && (quality === "auto" ? this.best : quality);
    const world = (solid && inSpace(given, solid)) ?? new FlatWorld(given, quality === "lines");
    world.cameras.rooms = () => this.notes.rooms();
    world.canvas.addEventListener("webglcontextlost", this.lost);
    world.canvas.addEventListener("webglcontextrestored", this.found);
    this.painting.take(world, given.colours);
    return world;
  }

  private readonly lost = (event: Event) => {
    if (event.target !== this.world.canvas) return; // of one that has gone
    window.clearTimeout(this.waiting);
    this.waiting = window.setTimeout(() => {
      this.best = null;
      this.remake();
    }, PATIENCE);
  };

  private readonly found = () => {
    window.clearTimeout(this.waiting);
    this.ask();
  };

  /** All again, in other colours or another quality, looked at from the same place. */
  private readonly remake = () => {
    const old = this.world;
    this.world = this.made();
    this.world.takeView(old);
    old.dispose();
    this.replaced.forEach((scene, run) => scene && this.world.replace(run, scene));
    if (this.mode) this.world.showMode(this.mode.mode, this.mode.amplitude);
    this.resize();
    this.refresh();
  };

  private refresh(): void {
    this.drawn = this.settings.factor;
    this.world.refresh();
    const before = this.notes.kinds;
    this.world.tell(this.notes);
    this.notes.tell(this.world.words());
    if (before !== this.notes.kinds && this.world.cameras.preset) this.world.cameras.refit(); // notes take room
    this.painting.layout();
    this.ask();
  }

  /** Ask for a picture: one for all that has changed until then. */
  private readonly ask = () => {
    if (this.asked === 0) this.asked = requestAnimationFrame(this.draw);
  };

  private readonly draw = (now: number) => {
    const moves = this.mode !== null && !this.still.matches;
    this.asked = 0;
    this.painting.draw(now, moves);
    this.notes.tell(this.world.words());
    if (moves) this.ask();
  };
}
