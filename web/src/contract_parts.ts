// What the parts of a page promise each other: the live model and its runs, and the scene.

import type { Chart, LinePanel, Mode, Slider, Verdict } from "./contract";
import type { Scene, SceneContact } from "./contract_scene";

/** A picture that is known. */
export type LiveScene = NonNullable<LiveRun["scene"]>;

/** What the live model gives: the same names as the result's variables, at the run's own samples. */
export interface LiveRun {
  status: string;
  message: string;
  /** Wall time of the simulation [s]. */
  seconds: number;
  times: Float64Array;
  /** By the result's variable names, [n, ...]. */
  series: Record<string, { data: Float64Array; shape: number[] }>;
  /**
   * New arrays for the scene's fields, at its own display times; links, joints and meshes stay. Not there as long as
   * only the curves are known.
   */
  scene?: Pick<Scene, "times" | "line" | "rigid" | "roots" | "reference" | "referenceRigid" | "tip" | "tipReference"
  | "tipCommanded">
  & {
    colours: Scene["colours"];
    /** `surface`: where it is, if that changed. */
    contact: (Pick<SceneContact, "force" | "at"> & Partial<Pick<SceneContact, "surface">>) | null;
  };
  /** Of its links; comes with the scene. */
  line?: LinePanel | null;
  /** First and last time [s] of what its spectra are of; without it those of the charts serve. */
  span?: [number, number];
  /** Headline numbers by the ids of the facts; those that cannot be computed are absent. */
  facts: Record<string, { value: number | null; note: string; time?: number; more?: string }>;
  /** Of this very run; not there as long as it is not known. */
  verdict?: Verdict;
  /** Names of fields of the verdict, and ids of facts, that are still being computed. */
  pending?: string[];
  /** Where a native run gives other numbers, or more: why, and its command. */
  native?: string;
  /** Its modes; a sentence where they cannot be reported, none where they are not known yet. */
  vibration?: Vibration | string;
}

/** Small vibrations about the rest: what `Run.modes` and the marks of spectra tell. */
export interface Vibration {
  modes: Mode[];
  marks: Chart["marks"];
}

/** `openLive(bundle)` of src/live/live.ts gives it; all work is done in a worker where there is one. */
export interface Live {
  sliders: Slider[];
  /** Simulate with these values; a newer call ends an older one, whose promise is then rejected with `Superseded`. */
  /** `early` hears the curves, and again when their picture is known; the promise gives all of the run. */
  run(values: number[], progress?: (share: number) => void, early?: (run: LiveRun) => void): Promise<LiveRun>;
  /** The data sheet as YAML with these values. */
  sheet(values: number[]): string;
  close(): void;
}

/** A cause of the tip's error, shown alone: the line from commanded to actual tip, cut into all causes. */
export interface Cause {
  /** Index of the run. */
  run: number;
  /** The link or joint that is marked. */
  element: string | null;
  /** Written at the line. */
  label: string;
  /** Components along the error [m], in order. */
  parts: { value: number; colour: string; lit: boolean }[];
}

/** `mountScene(element, page, clock)` of src/scene/scene.ts gives it. */
export interface SceneView {
  /** When the first run's robot is bent most [s]. */
  readonly opensAt: number;
  /** From where it is looked at [m], six numbers, and how many times deformations are enlarged. */
  view: { pose: number[]; factor: number };
  /** The picture as it is now, with the words that it needs; drawn on `canvas` again where one is given. */
  picture(canvas?: HTMLCanvasElement): HTMLCanvasElement;
  /** Show other arrays for a run (of the live model); null: those of the page. The page's own stay as a ghost. */
  replace(run: number, scene: LiveScene | null): void;
  /**
   * Show a mode instead of the motion; null: the motion. `amplitude`: largest displacement, share of the robot's size.
   */
  showMode(mode: Mode | null, amplitude: number): void;
  /** Show one cause of the error alone, deformations enlarged until it is seen; null: all as it was before. */
  explain(cause: Cause | null): void;
  /** Mark a link or a joint by its name; null: none. */
  highlight(element: string | null): void;
  /** What a click on a link or a joint does, by its name. */
  onPick(act: (element: string) => void): void;
  resize(): void;
  dispose(): void;
}
