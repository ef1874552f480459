// What a live bundle holds, as tmodes/live/bundle.py writes it.

import type { LiveBundle } from "../contract";
import type { SceneContact } from "../contract_scene";
import type { Numbers } from "../pack";
import type { LoadsInfo } from "./loads";
import type { LoopInfo } from "./feedback";
import type { VibrationRules } from "./exponentials";
import type { SettlingRules } from "./settling";
import type { LoadInfo } from "./wrench";
import type { Layout } from "./engine";

/** The program from the sliders to the numbers of both runs, as tmodes/live/map.py notes it, and their places. */
export interface MapInfo {
  /** Of the sliders: where they are in the sheet, and their values in the run as it was. */
  paths: string[];
  start: number[];
  constants: Numbers;
  operations: string[];
  /** [3, n]: operations, and how far back in the registers (sliders, constants, results) their operands are. */
  code: Numbers;
  /** Kind (`<`, `<=`, `==`, finite, doubled; one more: not so) and two registers, one guard after another. */
  guards: Numbers;
  /** All numbers as they were, and [2, m] which of them change, by which registers, each as a step from the last. */
  base: Numbers;
  moving: Numbers;
  runs: Record<string, Record<string, { start: number; shape: number[] }>>;
}

/** A place in the sheet: a number times the values of some sliders. */
export interface Place {
  sliders: number[];
  base: number;
}

export type SheetPart = string | { header: string } | { parts: (string | Place)[]; optional: number };

/** Samples that are shown in space, of a run of so many: its last one, wherever it broke off, among them. */
export function framesOf(bundle: Bundle, count: number): number[] {
  const frames = Array.from(bundle.frames.data).filter((frame) => frame < count);
  if (frames[frames.length - 1] !== count - 1) frames.push(count - 1);
  return frames;
}

/** The numbers as doubles. */
export function doubles(info: Numbers): Float64Array {
  return info.data instanceof Float64Array ? info.data : Float64Array.from(info.data);
}

/** By which rates, at which states [size], and of which numbers of them: what one unit of each moves [rad, m]. */
export interface BalanceInfo {
  function: string;
  size: number;
  /** Pairs: where these states and those of the run hold the same. */
  places: [number, number][];
  unknown: number[];
  equations: number[];
  weighs: Numbers;
  /** Signals that are left out: noise on what controllers see. */
  noise: number[];
}

/** How one run of a robot starts: `reported` coordinates by its sheet, `exact` ones by signals (coordinate, signal). */
export interface RunInfo {
  state: Record<"q" | "v" | "currents" | "controls" | "works" | "modes", [number, number]>;
  start: Numbers;
  info: number[];
  exact: [number, number][];
  /** Coordinates whose place a drive commands, and the signal of each. */
  commanded: [number, number][];
  /** Coordinates that drives move. */
  driven: number[];
  /** Joints whose position is commanded, and the signal of each. */
  commands: [string, number][];
  signals: number;
  /** How the equilibrium of its closed loop is found, from which it starts; null where its motors are held. */
  balance: BalanceInfo | null;
  /** Where the state holds outputs, samples after which these are those of the start, the signals of late ones. */
  held: number[];
  /** Of each drive under sampled commands the coordinate that it moves, and where the state holds them. */
  sampledCommands: [number, number[]][];
  samples: number;
  late: number[];
  /** Those of the signals that move the robot; `noise` and `clocks` (signal, period, shift) of samples move nothing. */
  moving: number[];
  noise: number[];
  clocks: [number, number, number][];
  /** How many of the modes are of dry friction that may stick. */
  slipping: number;
}

/** All of it; `links` are the lines of the scene. */
export interface Bundle extends LiveBundle {
  leftOut: { path: string; reason: string }[];
  map: MapInfo;
  module: Numbers;
  layout: Layout;
  settings: {
    method: string;
    duration: number;
    step: number;
    maxSteps: number;
    relativeTolerance: number;
    absoluteTolerance: number;
    note: string;
  };
  /** What `tmodes run` takes: the name of a published robot, or the file under which a page saves this one's sheet. */
  origin: string;
  /**
   * How a native run chooses its method, as tmodes/integrate/choice.py, where none is named (`auto`): `implicit` where
   * `explicit` steps, `reach` over the fastest motion long, are more than `most`. `noisy`: methods whose steps follow
   * from rounding, too.
   */
  choice: {
    auto: boolean; explicit: string; implicit: string | null; reach: number; most: number; noisy: string[];
  };
  times: Numbers;
  frames: Numbers;
  stations: Numbers;
  sheet: SheetPart[];
  runs: { reference?: RunInfo; real: RunInfo };
  restSize: number;
  atRest: boolean;
  deformations: string[];
  /** Joints that turn; others slide. */
  turning: string[];
  /** Names of the parts of the tip's error, controller, gears and links; none where no drive has a setpoint. */
  errorParts: string[] | null;
  /** Coordinates of the links' own deformations, and all elements of such a part with theirs, by the chain. */
  bends: number[];
  elements: { cause: string; name: string; own: number[] }[];
  /** Words of a verdict, tolerance of the task [m] and of the energy balance, whether the run had other warnings. */
  judged: { phrases: string[][]; tolerance: number | null; energy: number; warned: boolean };
  links: { name: string; bends: boolean }[];
  carried: LoadsInfo;
  contactPoint: number;
  /** What is touched, as the sheet says; the block `surface` of the map reports where: place, radius, normal. */
  surface: SceneContact["surface"] | null;
  electric: boolean;
  /** The drives, by their place, whose signals are positions. */
  setpoints: number[];
  /** Loads on named points, whose wrenches are a block of numbers; `signal` -1: constant. */
  loads: (LoadInfo & { point: number })[];
  touch: Surface | null;
  /** The coordinates that give way. */
  yields: number[];
  modes: ModesInfo | null;
  /** Of each coordinate, and gears with play: their coordinate, their place in `deformations`, that of the play. */
  units: string[];
  plays: { coordinate: number; gear: number; place: number }[];
  /** By which rules and method a run is continued until it is at rest; null where it is not judged by its tip. */
  after: {
    vibration: VibrationRules; settling: SettlingRules & { USUAL: [number | null, number | null] };
    method: string; outputStep: number;
  } | null;
  /** Why there are no modes. */
  noModes: string;
}

/** A plane at `distance` along `axis`, its normal; with a `radius` a ball about `axis`. */
export interface Surface {
  point: number;
  axis: number[];
  distance: number;
  radius: number;
  inside: boolean;
  bilateral: boolean;
}

/** The rest about which modes are reported, and by case the coordinates that move. */
export interface ModesInfo {
  rest: Numbers;
  /** The rest in which the run ends; null: it has none. */
  end: Numbers | null;
  /** The coordinates that weight and loads move there; others are driven. */
  free: number[];
  cases: { name: string; moving: number[] }[];
  servos: { coordinate: number; element: string }[];
  /** Of servos that are more than springs and dampers, else null. */
  loop: LoopInfo | null;
  /** `parallel`: place in the numbers of the chain of the stiffness of a parallel spring on that joint; -1: none. */
  springs: { element: string; rows: number[]; gear: boolean; parallel: number }[];
  /** Numbers of the chain that make dry friction. */
  dry: number[];
}
