// A robot's compiled equations for anybody's page: what `tmodes export --wasm` ships next to the module itself.
// Its declarations for others are src/tmodes/live/model.d.ts: a test compares them with what is exported here.

import { Engine, type Layout, type Samples } from "./engine";
import { EngineError, known } from "./engine_error";
import type { MapInfo } from "./bundle";
import { integrate, sampleTimes, type RunResult, type RunSettings, type Watch } from "./engine_run";
import { numbersOf, type Blocks } from "./map";
import { columns, range } from "./series";

export { Engine } from "./engine";
export { EngineError } from "./engine_error";
export { Cancelled, EngineRun, integrate, sampleTimes } from "./engine_run";

/** One motion of the robot: `reference`, as it is known and planned, or `real`, under control. */
export interface DescribedRun {
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
  /** Numbers of the data sheet by their paths, and how the parameters of the runs follow from them. */
  named: Record<string, number>;
  map: MapInfo;
}

/** What a run is to have other than described. */
export interface Changes {
  /** Numbers of the data sheet by name (`model.parameters`), or all numbers of the equations. */
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

  /** Numbers of the data sheet that may be changed, by their paths; `real:` is actual over nominal. */
  parameters(): Record<string, number> {
    return { ...this.description.named };
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
      loop: `${run}.${this.description.method}`, parameters: this.numbers(run, changes), knots, rows,
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
    const found = this.engine.sample(`${run}.observe`, this.numbers(run, changes), inputs, count);
    const { q, v, a } = found;
    const { chain, base } = this.blocks(run, changes);
    const { points } = this.engine.sample("inertia", chain, { q, v, a, base }, count);
    return { ...found, tip: columns(points, points.length / count, range(9, 9 + 3)) };
  }

  /** Names of what is observed, with how many numbers each has. */
  observed(run = "real"): Record<string, number> {
    return { ...known(this.description.layout.samples, `${run}.observe`, "function").outputs, tip: 3 };
  }

  private numbers(run: string, changes: Changes): Float64Array {
    const { parameters = {} } = changes;
    return "length" in parameters
      ? Float64Array.from(parameters as ArrayLike<number>)
      : this.blocks(run, changes).parameters;
  }

  private blocks(run: string, { parameters = {} }: Changes): Blocks {
    const { named, map } = this.description;
    const given = "length" in parameters ? {} : (parameters as Record<string, number>);
    const unknown = Object.keys(given).find((name) => !(name in named));
    if (unknown !== undefined)
      throw new EngineError(
        `parameter: got ${unknown}; expected one of ${Object.keys(named).join(", ") || "none: no number has a name"}`,
      );
    return numbersOf(map, Object.values({ ...named, ...given }), run);
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
