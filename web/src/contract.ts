// What a page is given: tmodes/report/ (Python) writes it, the parts of the page read it.
// Units are SI unless a field says its own. Arrays are row-major; shapes in brackets: m display frames, L links,
// S stations along each link (0 root .. 1 tip), n samples.

import type { Scene } from "./contract_scene";
import type { Numbers } from "./pack";

/** All of a page: one run (a report), or several side by side (compared). */
export interface Page {
  format: 1;
  title: string;
  subtitle: string;
  runs: Run[];
  /** One colour for one cause, on a light and on a dark page; as custom properties `--of-gear`, `--of-free-joint`. */
  colours: Record<string, { light: string; dark: string }>;
  /** The robot's own equations; null where a run cannot be made again in the page. Belongs to runs[0]. */
  live: LiveBundle | null;
  /** Why there is no live model, as a sentence; empty where there is one, or none is wanted. */
  notLive: string;
  /** Texts by name, as `PHRASES` of tmodes/result/verdict.py: parts in their order, each with alternatives. */
  phrases: Record<string, string[][]>;
}

export interface Run {
  name: string;
  status: string;
  success: boolean;
  message: string;
  verdict: Verdict;
  /** Names of fields of the verdict that are still being computed. */
  pending?: string[];
  warnings: string[];
  duration: number;
  /** The numbers that matter, most important first. */
  facts: Fact[];
  /** Moments that the time bar marks [s], in their order. */
  events: RunEvent[];
  charts: Chart[];
  scene: Scene;
  line: LinePanel | null;
  modes: Mode[];
  /** The data sheet of this very run as YAML, ready to be saved. */
  sheet: string;
}

/** What a run comes to: tmodes/result/verdict.py. `time_s` is the instant of the sentence; null: not known. */
export interface Verdict {
  point: string;
  against: "commanded" | "nominal" | null;
  largest_m: number | null;
  time_s: number | null;
  final_m: number | null;
  /** Of a run whose error is not known: the end of the link, else the gear, that is deflected most. */
  bends: { cause: "link" | "gear"; element: string; value: number; unit: string; time_s: number } | null;
  settling: { time_s: number | null; within_m: number | null; reason: string };
  residual: { amplitude_m: number; frequency_Hz: number; damping: number } | null;
  /** The most critical first. */
  limits: { quantity: string; element: string; value: number; limit: number; unit: string; share: number }[];
  /** Components along the largest error, which add up to it; the largest first. */
  culprits: { cause: string; element: string | null; value_m: number }[];
  /** The first jump of a command. */
  jump: { joint: string; time_s: number } | null;
  tolerance_m: number | null;
  level: "neutral" | "good" | "bad";
  sentence: string;
}

export interface RunEvent {
  time: number;
  label: string;
}

/** One headline number. */
export interface Fact {
  /** Stable name, such as `deviation.max`; what the live model computes again has the same. */
  id: string;
  name: string;
  value: number | null;
  unit: string;
  /** When, where, of what. */
  note: string;
  /** At which it is so [s]. */
  time?: number | null;
  /** What a reader may ask next. */
  more?: string;
}

/** A quantity of the result: column `index` of the flattened trailing dimensions of the result's variable. */
export interface Source {
  variable: string;
  index: number;
  factor: number;
  /** Taken off before the factor: what is drawn is a difference of two series. */
  less?: { variable: string; index: number };
  /** Of vectors [n, parts, 3]: the component of part `index` along their sum; -1: the size of the sum. */
  along: boolean;
}

/** What of a quantity a curve is: as it really is, nominal, commanded, of the motor, or a part of it. */
export type Role = "real" | "reference" | "commanded" | "motor" | "stationary" | "oscillatory";

export interface Curve {
  label: string;
  role: Role;
  /** The role in words: "nominal", "static part". */
  part: string;
  /** A custom property without its dashes: `of-gear`, `blue`; and lengths of dashes and gaps [px]. */
  colour: string;
  dash: number[];
  /** Values at the chart's abscissa [count], in the chart's unit. */
  values: Numbers;
  /** From which series of the result it is, so that the live model can draw it again; null where it cannot. */
  source: Source | null;
  shown: boolean;
}

export interface Chart {
  /** Stable name, such as `tip_deviation`. */
  id: string;
  title: string;
  group: "error" | "tip" | "contact" | "deformations" | "motors" | "energy" | "spectrum";
  unit: string;
  /** The quantity and its unit, as the axis says them. */
  ordinate: string;
  /** What is along: time [s] (linked with the clock) or frequency [Hz]. */
  abscissa: "time" | "frequency";
  at: Numbers;
  /** Samples of the run; where `at` has fewer, the extremes of every curve are kept. */
  samples: number;
  /** Of a spectrum: first and last time [s] of the samples that it is of; its curves' sources tell these. */
  span: [number, number] | null;
  /** Places along the abscissa with a name, such as the robot's own frequencies. */
  marks: { at: number; label: string }[];
  curves: Curve[];
  /** All curves but the last one are drawn as areas on each other: they add up to it. */
  stacked?: boolean;
  /** What must be known to read it; empty where that is nothing. */
  note: string;
  /** One of those to look at first, as is the first of each group. */
  overview: boolean;
  /** Whether a logarithmic ordinate serves, and whether it is the first choice. */
  log: "no" | "offered" | "first";
}

/** A mode of small vibration about the rest: displacements of the lines for one unit of it, complex. */
export interface Mode {
  /** `controlled`, `locked` or `free`. */
  case: string;
  frequency: number; // Hz
  damping: number; // share of the critical one
  element: string;
  /** Rest lines [L, S, 3] m, and real and imaginary part of the displacements [L, S, 3], largest of size 1. */
  rest: Numbers;
  real: Numbers;
  imaginary: Numbers;
}

/** The elastic line along each bending link at the scene's frames. */
export interface LinePanel {
  links: string[];
  /** Places along each link [links, S] m. */
  places: Numbers;
  /** For example `deflection`, m, [m, links, S, planes]. */
  quantities: { id: string; label: string; unit: string; planes: string[]; values: Numbers }[];
}

/** What can be changed in the page; the order is that of the values given to `Live.run`. */
export interface Slider {
  /** What `--set` takes: `payload.mass`, `joints.*.gear.stiffness`: a factor on all, `real:PATH`: actual / nominal. */
  path: string;
  label: string;
  symbol: string;
  unit: string;
  group: string;
  value: number;
  min: number;
  max: number;
  log: boolean;
  /** What the data sheet takes, where that has an end. */
  least?: number;
  most?: number;
  /** The designer of the robot chooses it; else it is of a material, of the surroundings or of the task. */
  design?: boolean;
}

/** The live model as it is shipped: known to src/live/ and tmodes/live/ alone, but for these. */
export interface LiveBundle {
  sliders: Slider[];
  [more: string]: unknown;
}
