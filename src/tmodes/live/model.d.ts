// A robot of tmodes that runs in a page: `import { open } from "./NAME.js"; const model = await open();`

/** How a run is integrated. */
export interface RunSettings {
  duration: number; // s
  relativeTolerance: number;
  absoluteTolerance: number;
  step: number; // s; of methods with a fixed step
  maxSteps: number;
}

/** How a run ended, as far as it came: n samples. A state: coordinates, rates, then what else is integrated. */
export interface RunResult {
  /** finished, diverged, step_too_small, not_converged, chattering, stopped. */
  status: string;
  message: string;
  times: Float64Array; // [n] s
  states: Float64Array; // [n, size], row by row
  statistics: Record<string, number | string | null>;
}

/** What a run is to have other than described. */
export interface Changes {
  /** Numbers of the data sheet by name (`model.parameters()`), or all numbers of the equations. */
  parameters?: Record<string, number> | ArrayLike<number>;
  /** The first state; it is not searched again where numbers change. */
  state?: ArrayLike<number>;
  settings?: Partial<RunSettings>;
  outputStep?: number; // s
}

/** How a run is watched: `progress` hears the share of the time that is done, `cancelled` says whether to give up. */
export interface Watch {
  progress?: (share: number) => void;
  cancelled?: () => boolean;
  /** Wall time between two looks at the above [s], in which nothing else of the page runs. */
  piece?: number;
}

/** A robot that runs in this page. Runs: `reference`, as it is known and planned, and `real`, under control. */
export class Model {
  private constructor();
  /** Names of the coordinates, in which a state begins; their rates follow in the same order. */
  readonly coordinates: string[];
  /** Names of the runs. */
  readonly runs: string[];
  /** Numbers of the data sheet that may be changed, by their paths; `real:` is actual over nominal. */
  parameters(): Record<string, number>;
  /** Run from the described state; a long run lets the page go on meanwhile. Raises Cancelled, EngineError. */
  run(run?: string, changes?: Changes, watch?: Watch): Promise<RunResult>;
  /** What is observed of a run at its samples, by name: [n, numbers], row by row. */
  observe(result: RunResult, run?: string, changes?: Changes): Record<string, Float64Array>;
  /** Names of what is observed, with how many numbers each has. */
  observed(run?: string): Record<string, number>;
}

/** What goes wrong on purpose; the message says which, what was got, what is expected. */
export class EngineError extends Error {}

/** A run that was given up. */
export class Cancelled extends EngineError {}

/** The robot; `wasm`: the module's bytes, or where they are, if not next to this file. */
export function open(wasm?: BufferSource | URL | string): Promise<Model>;
