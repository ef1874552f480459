// A robot's compiled equations for anybody's page: what `tmodes export --wasm` ships next to the module itself.
// Its declarations for others are src/tmodes/live/model.d.ts: a test compares them with what is exported here.

import { Engine, type Layout, type Samples } from "./engine";
import { EngineError, known } from "./engine_error";
import { integrate, sampleTimes, type RunResult, type RunSettings, type Watch } from "./engine_run";

export { Engine } from "./engine";
export { EngineError } from "./engine_error";
export { Cancelled, EngineRun, integrate, sampleTimes } from "./engine_run";

/** One motion of the robot: `reference`, as it is known and planned, or `real`, under control. */
export interface DescribedRun {
  parameters: number[];
  knots: number[];
  rows: number[];
  state: number[];
}

/** All that tmodes/live/wasm_export.py reports of a robot. */
export interface Description {
  name: string;
  layout: Layout;
  method: string;
  outputStep: number;
  settings: RunSettings;
  runs: Record<string, DescribedRun>;
}

/** What a run is to have other than described. */
export interface Changes {
  /** By name where the robot's numbers have names (`model.parameters`), else all of them. */
  parameters?: Record<string, number> | ArrayLike<number>;
  /** The first state; it is not looked for again where numbers change. */
  state?: ArrayLike<number>;
  settings?: Partial<RunSettings>;
  outputStep?: number;
}

/** A robot that runs in this page. */
export class Model {
  private constructor(
    private readonly engine: Engine,
    readonly description: Description,
  ) {}

  /** From the module's bytes, or from where they are fetched. */
  static async open(wasm: BufferSource | URL | string, description: Description): Promise<Model> {
    const bytes = typeof wasm === "string" || wasm instanceof URL ? await (await fetch(wasm)).arrayBuffer() : wasm;
    return new Model(await Engine.open(bytes, description.layout), description);
  }

  /** Names of the coordinates, in which a state begins; their rates follow in the same order. */
  get coordinates(): string[] {
    return this.description.layout.coordinates;
  }

  /** Names of the runs. */
  get runs(): string[] {
    return Object.keys(this.description.runs);
  }

  /** The numbers of a run by their names; empty where they have none. */
  parameters(run = "real"): Record<string, number> {
    const values = known(this.description.runs, run, "run").parameters;
    return Object.fromEntries((this.description.layout.parameters ?? []).map((name, k) => [name, values[k]]));
  }

  /** Run from the described state; a long run lets the page go on meanwhile. */
  async run(run = "real", changes: Changes = {}, watch: Watch = {}): Promise<RunResult> {
    const info = known(this.description.runs, run, "run");
    const settings = { ...this.description.settings, ...changes.settings };
    if (settings.duration > this.description.settings.duration) {
      throw new EngineError(
        `duration: got ${settings.duration} s; ` +
          `expected at most ${this.description.settings.duration} s, for which there are signals`,
      );
    }
    const { knots, rows } = until(info, settings.duration);
    return integrate(this.engine, {
      loop: `${run}.${this.description.method}`, parameters: this.numbers(info, changes), knots, rows,
      state: Float64Array.from(changes.state ?? info.state),
      times: sampleTimes(settings.duration, changes.outputStep ?? this.description.outputStep), settings,
    }, watch);
  }

  /** What is observed of a run at its samples, by name (`model.observed(run)` reports the numbers of each). */
  observe(result: RunResult, run = "real", changes: Changes = {}): Samples {
    const info = known(this.description.runs, run, "run");
    const count = result.times.length;
    const inputs = {
      time: result.times,
      state: result.states,
      row: rowsAt(info, result.times),
      step: new Float64Array(1),
    };
    return this.engine.sample(`${run}.observe`, this.numbers(info, changes), inputs, count);
  }

  /** Names of what is observed, with how many numbers each has. */
  observed(run = "real"): Record<string, number> {
    return known(this.description.layout.samples, `${run}.observe`, "function").outputs;
  }

  private numbers(info: DescribedRun, { parameters = {} }: Changes): Float64Array {
    if ("length" in parameters) return Float64Array.from(parameters as ArrayLike<number>);
    const values = Float64Array.from(info.parameters);
    const names = this.description.layout.parameters ?? [];
    for (const [name, value] of Object.entries(parameters)) {
      const index = names.indexOf(name);
      if (index < 0)
        throw new EngineError(
          `parameter: got ${name}; expected one of ${names.join(", ") || "all numbers, for they have no names"}`,
        );
      values[index] = value;
    }
    return values;
  }
}

/** The signals up to a time within them. */
function until(info: DescribedRun, end: number): { knots: Float64Array; rows: Float64Array } {
  const pieces = Math.max(1, info.knots.filter((knot, k) => k < info.knots.length - 1 && knot < end).length);
  const width = info.rows.length / (info.knots.length - 1);
  return {
    knots: Float64Array.from([...info.knots.slice(0, pieces), end]),
    rows: Float64Array.from(info.rows.slice(0, pieces * width)),
  };
}

/** The row of signals at each time; at a jump, the later piece. */
function rowsAt(info: DescribedRun, times: Float64Array): Float64Array {
  const pieces = info.knots.length - 1;
  const width = info.rows.length / pieces;
  const rows = new Float64Array(times.length * width);
  let piece = 0;
  times.forEach((time, k) => {
    while (piece < pieces - 1 && info.knots[piece + 1] <= time) piece += 1;
    for (let j = 0; j < width; j++) rows[k * width + j] = info.rows[piece * width + j];
  });
  return rows;
}
