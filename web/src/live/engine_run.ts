// One run of a compiled time loop, in pieces, with progress and cancellation: the counterpart of native_run.py.

import { digits } from "../format";
import type { Engine, Written } from "./engine";
import { ending } from "./engine_ending";
import { EngineError, expect, known } from "./engine_error";

/** As tmodes/integrate/settings.py names them. */
export interface RunSettings {
  duration: number; // s
  relativeTolerance: number;
  absoluteTolerance: number;
  step: number; // s; of methods with a fixed step
  maxSteps: number;
}

/**
 * What a run is made of: loop `REGIME.METHOD`, numbers, signals as pieces of polynomials, first state, sample times.
 */
export interface RunSpec {
  loop: string;
  parameters: Float64Array;
  knots: Float64Array; // [pieces + 1] s, the last one the end of the run
  rows: Float64Array; // [pieces, row]: start of the piece, coefficients
  state: Float64Array;
  times: Float64Array; // [n] s, the first one 0
  settings: RunSettings;
}

/** How a run ended, as far as it came: n samples. */
export interface RunResult {
  /** finished, diverged, step_too_small, not_converged, chattering, stopped. */
  status: string;
  message: string;
  times: Float64Array; // [n] s
  states: Float64Array; // [n, size]
  statistics: Record<string, number | string | null>;
}

const FIXED_STEP = ["rk4", "midpoint"];
const FIRST_PIECE = 500;

/** A run that continues as far as it is asked to: the pieces in which it is done change no bit of it. */
export class EngineRun {
  private readonly method: string;
  private readonly memory: Float64Array;
  private readonly state: Float64Array;
  private readonly slope: Float64Array;
  private readonly states: Float64Array;

  constructor(
    private readonly engine: Engine,
    private readonly spec: RunSpec,
  ) {
    const info = known(engine.layout.loops, spec.loop, "loop");
    expect(`${spec.loop}: parameters`, spec.parameters.length, info.parameters);
    expect(`${spec.loop}: state`, spec.state.length, info.size);
    expect(`${spec.loop}: rows`, spec.rows.length, (spec.knots.length - 1) * info.row);
    this.method = info.method;
    this.memory = new Float64Array(engine.layout.cells.length);
    this.state = spec.state.slice();
    this.slope = new Float64Array(info.size);
    this.states = new Float64Array(spec.times.length * info.size);
    this.states.set(spec.state);
    this.put({ sample: 1, fresh: 1, old_error: 1e-4 });
  }

  /** Time that is reached [s]. */
  get time(): number {
    return this.cell("t");
  }

  /** Whether something is left to do. */
  get running(): boolean {
    return this.cell("status") === this.engine.layout.statuses.running && this.tried < this.spec.settings.maxSteps;
  }

  private get tried(): number {
    return this.cell("steps") + this.cell("rejected");
  }

  private cell(name: string): number {
    return this.memory[this.engine.layout.cells.indexOf(name)];
  }

  private put(values: Record<string, number>): void {
    for (const [name, value] of Object.entries(values)) this.memory[this.engine.layout.cells.indexOf(name)] = value;
  }

  /** Do at most so many steps. */
  advance(steps: number): void {
    const { layout } = this.engine;
    const { settings, knots, rows, times, parameters } = this.spec;
    const most = Math.max(1, Math.min(steps, settings.maxSteps - this.tried));
    const chosen: Record<string, number> = {
      step: settings.step,
      rtol: settings.relativeTolerance,
      atol: settings.absoluteTolerance,
      chunk: most,
      bound: layout.limits.bound,
      watch: 0,
      most_events: layout.limits.most_events,
      event_time: layout.limits.event_time,
      looks: 0,
    };
    const before = this.cell("sample");
    const fresh = (into: Float64Array): Written => ({
      into, range: () => [before * this.state.length, this.cell("sample") * this.state.length],
    });
    const both = (into: Float64Array): Written => ({ into, given: true });
    const given: Record<string, Float64Array | number | Written> = {
      memory: both(this.memory),
      y: both(this.state),
      k1: both(this.slope),
      p: parameters,
      knots,
      rows,
      times,
      out: fresh(this.states),
      options: Float64Array.from(layout.options, (name) => chosen[name]),
      seen: new Float64Array(1),
      segments: knots.length - 1,
      samples: times.length,
    };
    this.engine.call(layout.loops[this.spec.loop].export, layout.arguments.map((name) => given[name]));
  }

  /** The run as far as it came. */
  result(): RunResult {
    const done = this.cell("sample");
    const size = this.state.length;
    const [status, message] = ending({
      layout: this.engine.layout, settings: this.spec.settings, status: this.cell("status"), time: this.time,
      lastStep: this.cell("h"), rates: () => this.rates(),
    });
    return {
      status, message, times: this.spec.times.slice(0, done), states: this.states.slice(0, done * size),
      statistics: this.statistics(),
    };
  }

  private statistics(): Record<string, number | string | null> {
    const [steps, smallest, t] = [this.cell("steps"), this.cell("smallest"), this.time];
    const mean = steps ? t / steps : null;
    const info: Record<string, number | string | null> = {
      steps, rejected: this.cell("rejected"), evaluations: this.cell("evaluations"), method: this.method,
      mean_step_s: mean, smallest_step_s: smallest > 0 ? smallest : mean,
    };
    if (this.cell("stiff_time") > 0) info.stiff_from_s = this.cell("stiff_time");
    if (FIXED_STEP.includes(this.method)) info.step = this.cell("h");
    if (this.cell("passes")) info.passes = this.cell("passes");
    if (this.cell("events")) info.contact_changes = this.cell("events");
    return info;
  }

  private rates(): Float64Array {
    const { loop, parameters, rows } = this.spec;
    const { row } = this.engine.layout.loops[loop];
    const segment = Math.min(this.cell("segment"), rows.length / row - 1);
    const inputs = {
      time: Float64Array.of(this.time),
      state: this.state,
      row: rows.slice(segment * row, (segment + 1) * row),
      step: new Float64Array(1),
    };
    return this.engine.sample(`${loop.slice(0, loop.lastIndexOf("."))}.rate`, parameters, inputs, 1).rate;
  }
}

/** A run that was given up. */
export class Cancelled extends EngineError {
  override name = "Cancelled";
}

/** How a run is watched: `progress` gets the share of the time that is done, `cancelled` says whether to stop. */
export interface Watch {
  progress?: (share: number) => void;
  cancelled?: () => boolean;
  /** Wall time between two looks at the above [s], in which nothing else of the page runs. */
  piece?: number;
}

/** A whole run. A short one is done at once; a longer one lets others have their turn; raises Cancelled. */
export async function integrate(engine: Engine, spec: RunSpec, watch: Watch = {}): Promise<RunResult> {
  const run = new EngineRun(engine, spec);
  const wanted = 1000 * (watch.piece ?? 0.05);
  let piece = FIRST_PIECE;
  let since = performance.now();
  while (run.running) {
    const began = performance.now();
    run.advance(piece);
    const now = performance.now();
    piece = Math.max(1, Math.floor(piece * Math.min(4, wanted / Math.max(now - began, 1e-3))));
    if (now - since < wanted) continue;
    watch.progress?.(run.time / spec.settings.duration);
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (watch.cancelled?.()) throw new Cancelled(`the run was given up at t = ${digits(run.time, 6)} s`);
    since = performance.now();
  }
  return run.result();
}

/** Times of the samples [s]: every `outputStep`, and the end, which is a sample even where it is no multiple. */
export function sampleTimes(duration: number, outputStep: number): Float64Array {
  const count = Math.floor((duration / outputStep) * (1 + 1e-12));
  const whole = duration - count * outputStep <= 1e-9 * outputStep;
  const times = Float64Array.from({ length: count + (whole ? 1 : 2) }, (_, k) => k * outputStep);
  times[times.length - 1] = duration;
  return times;
}
