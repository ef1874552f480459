// A run and its continuation with all signals at rest, until its tip is: as tmodes/result/settling.py continues it.

import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { integrate, sampleTimes, type RunResult, type Watch } from "./engine_run";
import { motionsOf } from "./motions";
import type { Regime } from "./regime";
import { ENDS, none, residualVibration, type Residual } from "./residual";
import { columns, range, rowsOf, sizes } from "./series";
import { areCoarse, CHANGES, restOf, settlingOf, type Path, type Settled } from "./settling";
import { merged, rowsOf as piecesOf, schedule as held, valueAt, type Schedule } from "./signals";

const [UNDAMPED, RINGS] = [3e-9, 1e-9]; // decay over size of an eigenvalue that is rounding; its turn that rings

/** A motion: coordinates q [n, nq] besides the tip. */
interface Motion extends Path {
  q: Float64Array;
}

/** The run and what follows; `even`: samples at equal times; `cut`: what ended it before all was seen. */
export interface AfterMove extends Motion {
  end: number | null;
  finished: number;
  even: number[];
  cut: string;
}

/** Continues a regime beyond its end, the `end` of its move; raises Cancelled. */
export async function afterMove(
  engine: Engine, bundle: Bundle, regime: Regime, end: number | null, watch: Watch,
): Promise<AfterMove> {
  const { HORIZON, SHORTEST, DECAYS, MOST_WORK, NEGLIGIBLE } = bundle.after!.settling;
  const [{ run }, n] = [regime, regime.run.times.length];
  const own = motionOf(engine, regime, run.times, run.states);
  const found: AfterMove = { ...own, end, finished: run.times[n - 1], even: range(0, n), cut: "" };
  if (end === null || end > found.finished * (1 + 1e-9) || run.status !== "finished") return found;
  const decays = decaysOf(engine, bundle, regime);
  const slowest = decays.reduce((least, rate) => Math.min(least, rate), decays.length ? Infinity : 1);
  const most = Math.floor(NEGLIGIBLE / Math.max(engine.layout.coordinates.length, 1));
  const more = new Continued(engine, bundle, regime, end, Math.max(Math.floor(MOST_WORK * stepsOf(run)), most), watch);
  const first = Math.max(Math.min(HORIZON, DECAYS / slowest), SHORTEST);
  return more.finer(slowest > 0 ? await more.beyond(found, first) : found);
}

/** When it has settled, by the band of the sheet. */
export function settledOf({ after }: Bundle, found: AfterMove, unrest = "", usual = false): Settled {
  const [share, length] = after!.settling.USUAL;
  const rules = usual ? { ...after!.settling, share, length } : after!.settling;
  return settlingOf(rules, after!.vibration, found, found.end, found.finished, unrest || found.cut);
}

/** Times after the end of the move, and the coordinates and the tip then. */
export function laterOf({ times, q, tip, even, end }: AfterMove): Pick<AfterMove, "times" | "q" | "tip"> {
  const kept = even.filter((k) => times[k] >= (end ?? 0) * (1 - 1e-12));
  const width = q.length / times.length;
  return { times: rowsOf(times, 1, kept), q: rowsOf(q, width, kept), tip: rowsOf(tip, 3, kept) };
}

/** The vibration at the end of the move, about the slowly moving mean; `nothing`: the motion is none. */
export async function vibrationAfter(
  { after }: Bundle, found: AfterMove, nothing: boolean, pause: () => Promise<void>,
): Promise<Residual> {
  if (nothing) return none(null, "");
  if (found.end === null) return none(null, CHANGES);
  const { times, tip } = laterOf(found);
  const last = lastEven(times, found.end) + 1;
  const { FEWEST } = after!.vibration;
  if (last < FEWEST) return none(null, ENDS);
  const far = sizes(tip.subarray(0, 3 * last).map((value, k) => value - tip[3 * last - 3 + (k % 3)]), 3);
  const least = after!.settling.AT_REST * far.reduce((most, value) => Math.max(most, value), 0);
  const moving = far.reduce((count, value, k) => (value > least ? k + 1 : count), 0);
  const kept = Math.min(Math.max(moving, 4 * FEWEST), last);
  return residualVibration(after!.vibration, times.subarray(0, kept), tip.subarray(0, 3 * kept), found.end, pause);
}

function stepsOf({ statistics }: RunResult): number {
  return Number(statistics.steps) + Number(statistics.rejected);
}

function motionOf(engine: Engine, { info, blocks }: Regime, times: Float64Array, states: Float64Array): Motion {
  const size = states.length / times.length;
  const [q, v] = [info.state.q, info.state.v].map((part) => columns(states, size, range(...part)));
  const inputs = { q, v, a: new Float64Array(q.length / times.length), base: blocks.base };
  const { points } = engine.sample("points", blocks.chain, inputs, times.length);
  const wide = points.length / times.length;
  return { times, q, tip: columns(points, wide, [9, 10, 11]), rates: columns(points, wide, [12, 13, 14]) };
}

/** The last sample, or the one before where the last follows a shorter step and the move has ended by then. */
function lastEven(times: Float64Array, end: number): number {
  const last = times.length - 1;
  const shorter = last > 1 && times[last] - times[last - 1] < (1 - 1e-6) * (times[1] - times[0]);
  return shorter && times[last - 1] >= end ? last - 1 : last;
}

/** Where the tip is [n, 3] m in a run of a regime. */
export function tipOf(engine: Engine, regime: Regime, { times, states }: RunResult): Float64Array {
  return motionOf(engine, regime, times, states).tip;
}

/** Decay rates [1/s] of the motions about the start that ring, or creep within the longest continuation. */
function decaysOf(engine: Engine, { after }: Bundle, regime: Regime): number[] {
  if (regime.info.clocks.length) return [];
  const rates = motionsOf(engine, regime).map(({ re, im }): [number, number] => {
    const whole = Math.hypot(re, im);
    return [Math.abs(re) <= UNDAMPED * whole ? 0 : re, Math.abs(im) / (whole || 1)];
  });
  const ringing = rates.filter(([, share]) => share > RINGS).map(([re]) => -re);
  const { DECAYS, HORIZON } = after!.settling;
  const creeping = rates.filter(([re]) => re < -DECAYS / HORIZON).map(([re]) => -re);
  return ringing.length ? [Math.min(...ringing), ...creeping] : [];
}

/** A run whose move is over, and how many steps may be taken to see what follows. */
class Continued {
  constructor(
    private engine: Engine, private bundle: Bundle, private regime: Regime,
    private end: number, private left: number, private watch: Watch,
  ) {}

  /** With what follows its last sample, for a time or up to the longest where it is not at rest then. */
  async beyond(alone: AfterMove, first: number): Promise<AfterMove> {
    const { HORIZON, SAMPLES } = this.bundle.after!.settling;
    const step = this.bundle.after!.outputStep;
    const last = lastEven(alone.times, this.end);
    let [best, horizon] = [alone, first];
    for (;;) {
      const stride = Math.max(1, Math.ceil(horizon / SAMPLES / step));
      const { done, motion } = await this.from(last, horizon, stride * step);
      const found = joined(alone, last, motion, stride);
      if (found.times[found.times.length - 1] >= best.times[best.times.length - 1]) best = found;
      if (done.status === "stopped" || this.left <= 0) return { ...best, cut: this.bundle.after!.settling.COSTLY };
      if (done.status !== "finished")
        return { ...alone, cut: `continued beyond its end, the run was lost: ${done.message}` };
      if (horizon >= HORIZON || settledOf(this.bundle, found).time !== null) return found;
      horizon = Math.min(2 * horizon, HORIZON);
    }
  }

  /** With samples as near as the steps of the integration, where its own are too far apart after the move. */
  async finer(found: AfterMove): Promise<AfterMove> {
    const [{ after }, { times, statistics }] = [this.bundle, this.regime.run];
    const wanted = times.subarray(0, -1).findIndex((time) => time >= this.end * (1 - 1e-12));
    const first = wanted < 0 ? times.length - 1 : wanted;
    const step = evened(Number(statistics.mean_step_s)) || Infinity;
    const span = Math.min(found.times[found.times.length - 1] - times[first], after!.settling.SAMPLES * step);
    const { rest } = restOf(after!.settling, found, this.end);
    const from = found.times.findIndex((time) => time >= times[first]);
    const fine = step >= after!.outputStep
      || !areCoarse(after!.vibration, found, from, rest, settledOf(this.bundle, found).limit);
    if (fine || Math.min(span, this.left) <= 0 || this.regime.info.noise.length) return found;
    const { done, motion } = await this.from(first, span, span / Math.ceil(span / step));
    const seen = motion.times.length > after!.vibration.FEWEST ? joined(found, first, motion, 0) : found;
    return done.status === "finished" || done.status === "stopped" ? { ...seen, cut: found.cut } : found;
  }

  private async from(sample: number, duration: number, step: number): Promise<{ done: RunResult; motion: Motion }> {
    const { name, info, run, blocks, schedule } = this.regime;
    const [begin, size] = [run.times[sample], run.states.length / run.times.length];
    const still = stillAt(this.regime, begin, duration);
    const state = run.states.slice(sample * size, (sample + 1) * size);
    for (const [coordinate, signal] of info.exact) {
      state[info.state.q[0] + coordinate] = valueAt(schedule, signal, begin);
      state[info.state.v[0] + coordinate] = 0;
    }
    const { settings, after } = this.bundle;
    const done = await integrate(this.engine, {
      loop: `${name}.${after!.method}`, parameters: blocks.parameters, knots: still.knots, rows: piecesOf(still), state,
      times: sampleTimes(duration, step), settings: { ...settings, duration, maxSteps: this.left },
    }, { ...this.watch, progress: undefined });
    this.left -= stepsOf(done);
    const until = evened(done.times[done.times.length - 1]) * (1 + 1e-9);
    const kept = done.times.filter((time) => done.status !== "stopped" || time <= until);
    const motion = motionOf(this.engine, this.regime, kept, done.states.subarray(0, kept.length * size));
    return { done, motion: { ...motion, times: kept.map((time) => begin + time) } };
  }
}

/** A time [s] rounded down to halves of a power of ten, the same where rounding decides on some of many steps. */
function evened(time: number): number {
  const half = time > 0 && Number.isFinite(time) ? 10 ** Math.floor(Math.log10(time)) / 2 : 1;
  return half * Math.floor((time / half) * (1 + 1e-12));
}

/** All signals at their values at a time; clocks of controllers go on, noise is none. */
function stillAt({ info, schedule }: Regime, time: number, duration: number): Schedule {
  const { signals, degree } = schedule;
  const each = range(0, signals).map((k) => {
    const clock = info.clocks.find(([own]) => own === k);
    if (clock) return sawTooth(clock[1], time - clock[2], duration);
    const value = info.noise.includes(k) ? 0 : valueAt(schedule, k, time);
    return held(Float64Array.of(0, duration), Float64Array.from({ length: degree + 1 }, (_, j) => (j ? 0 : value)));
  });
  return signals ? merged(each) : { ...merged([]), knots: Float64Array.of(0, duration) };
}

/** The time since the last sample of a controller. */
function sawTooth(period: number, begin: number, duration: number): Schedule {
  const first = Math.floor((begin / period) * (1 + 1e-12));
  const count = Math.ceil(((begin + duration) / period) * (1 - 1e-12)) - first;
  const knots = Float64Array.from({ length: count + 1 }, (_, k) => (first + k) * period - begin);
  const offset = knots[0];
  [knots[0], knots[count]] = [0, duration];
  return held(knots, Float64Array.from({ length: 2 * count }, (_, k) => (k % 2 ? 1 : k ? 0 : -offset)));
}

/** With another motion in the place of its samples after one; `stride`: how many of its steps are one of that. */
function joined(own: AfterMove, sample: number, motion: Motion, stride: number): AfterMove {
  const until = motion.times[motion.times.length - 1] * (1 + 1e-12);
  const after = own.times.findIndex((time) => time >= until);
  const last = after < 0 ? own.times.length : after;
  const put = (name: "times" | "tip" | "rates" | "q") => {
    const [rows, more] = [own[name], motion[name]];
    const wide = rows.length / own.times.length;
    const found = new Float64Array(rows.length + more.length + (sample - last) * wide);
    found.set(rows.subarray(0, (sample + 1) * wide));
    found.set(more.subarray(wide), (sample + 1) * wide);
    found.set(rows.subarray(last * wide), sample * wide + more.length);
    return found;
  };
  const even = stride ? range(0, sample).filter((k) => k % stride === sample % stride) : [];
  return {
    ...own, times: put("times"), tip: put("tip"), rates: put("rates"), q: put("q"), cut: "",
    even: [...even, ...range(sample, sample + motion.times.length)],
  };
}
