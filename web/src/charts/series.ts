// What a chart draws: the curves of all runs under one name, and their values on one common axis.

import { alongSum } from "../along";
import type { Chart, Curve, Page } from "../contract";
import type { LiveRun } from "../contract_parts";
import { spectrumOf } from "./spectrum";

export type Values = ArrayLike<number>;

type Drawn = Pick<Curve, "label" | "role" | "part" | "colour" | "dash">;

export interface Entry extends Drawn {
  run: number;
  runName: string;
  x: Values;
  y: Values;
  shown: boolean;
  /** The page's own run behind that of the live model. */
  ghost: boolean;
}

/** The charts of one name in all runs. */
export interface ChartSet {
  chart: Chart;
  runs: { run: number; name: string; chart: Chart }[];
  /** Whether the page has several runs, all of which may or may not have this chart. */
  compared: boolean;
}

export function chartSets(page: Page): ChartSet[] {
  const sets = new Map<string, ChartSet>();
  page.runs.forEach((one, run) =>
    one.charts.forEach((chart) => {
      const known = sets.get(chart.id);
      if (known) known.runs.push({ run, name: one.name, chart });
      else sets.set(chart.id, { chart, runs: [{ run, name: one.name, chart }], compared: page.runs.length > 1 });
    }),
  );
  return [...sets.values()];
}

/** All curves to draw; `live` is the live model's run of the first run's robot. */
export function entriesOf(set: ChartSet, live: LiveRun | null): Entry[] {
  const own = set.runs.flatMap(({ run, name, chart }) =>
    (live && run === 0 && chart.stacked ? chart.curves.slice(-1) : chart.curves).map((curve) => ({
      ...drawnAs(curve), run, runName: name, x: chart.at.data, y: curve.values.data,
      shown: curve.shown && (set.runs.length < 2 || leading(curve, chart)),
      ghost: live !== null && run === 0,
    })),
  );
  if (live === null) return own;
  const first = set.runs.find(({ run }) => run === 0);
  const fresh = (first?.chart.curves ?? []).flatMap((curve) => liveEntry(curve, first!.chart, first!.name, live));
  return [...own, ...fresh];
}

function drawnAs({ label, role, part, colour, dash }: Curve): Drawn {
  return { label, role, part, colour, dash };
}

/** Of several runs only the first curve, of parts their total, is shown at first: the rest is a click away. */
function leading(curve: Curve, chart: Chart): boolean {
  return curve.role === "real" && curve.label === chart.curves[chart.stacked ? chart.curves.length - 1 : 0].label;
}

function liveEntry(curve: Curve, chart: Chart, runName: string, live: LiveRun): Entry[] {
  const values = liveValues(curve, live);
  if (values === null) return [];
  const entry = { ...drawnAs(curve), run: 0, runName, shown: curve.shown, ghost: false };
  if (chart.abscissa === "time") return [{ ...entry, x: live.times, y: values }];
  let found: { x: Values; y: Values } | null = null; // of a curve that is switched off no spectrum is needed
  const spectrum = () => (found ??= spectrumOf(live.times, values, chart, live.span));
  return [Object.defineProperties(entry as Entry, { x: { get: () => spectrum().x }, y: { get: () => spectrum().y } })];
}

/** Whether the live model's later run has for these charts only what the earlier one had. */
export function unchanged(set: ChartSet, earlier: LiveRun, later: LiveRun): boolean {
  if (set.chart.group === "spectrum" && earlier.vibration !== later.vibration) return false;
  const variables = set.runs.flatMap(({ chart }) =>
    chart.curves.flatMap(({ source }) => (source ? [source.variable, source.less?.variable ?? source.variable] : [])),
  );
  return variables.every((name) => earlier.series[name] === later.series[name]);
}

/** A curve's values from the series of the live model; null where it does not have them. */
export function liveValues(curve: Curve, live: LiveRun): Float64Array | null {
  const source = curve.source;
  if (source === null) return null;
  const column = columnOf(live, source.variable, source.index, source.along);
  const less = source.less ? columnOf(live, source.less.variable, source.less.index) : null;
  if (column === null || (source.less && less === null)) return null;
  for (let k = 0; k < column.length; k += 1) column[k] = source.factor * (column[k] - (less ? less[k] : 0));
  return column;
}

function columnOf(live: LiveRun, variable: string, index: number, along = false): Float64Array | null {
  const series = live.series[variable];
  if (series === undefined) return null;
  if (along) return Float64Array.from(live.times, (_, k) => alongSum(series, k, index));
  const width = series.shape.slice(1).reduce((product, size) => product * size, 1);
  if (index >= width) return null;
  const found = new Float64Array(series.shape[0]);
  for (let k = 0; k < found.length; k += 1) found[k] = series.data[k * width + index];
  return found;
}

/** One rising axis for all curves, with null where a curve has no value of its own. */
export function aligned(entries: Entry[], magnitude: boolean): [Values, ...ArrayLike<number | null>[]] {
  const axes = [...new Set(entries.map((entry) => entry.x))];
  const axis = axes.every((other) => same(other, axes[0])) ? axes[0] : union(axes);
  return [axis, ...entries.map((entry) => onAxis(entry, axis, magnitude))];
}

function same(one: Values, other: Values): boolean {
  if (one === other) return true;
  if (one.length !== other.length) return false;
  for (let k = 0; k < one.length; k += 1) if (Math.abs(one[k] - other[k]) > 1e-6 * Math.abs(other[k])) return false;
  return true;
}

function union(axes: Values[]): number[] {
  const all = axes.flatMap((axis) => Array.from(axis)).sort((one, other) => one - other);
  return all.filter((value, k) => k === 0 || value > all[k - 1]);
}

function onAxis(entry: Entry, axis: Values, magnitude: boolean): ArrayLike<number | null> {
  const shape = (value: number) => (!magnitude ? value : value === 0 ? null : Math.abs(value));
  const whole = axis === entry.x || same(axis, entry.x);
  if (whole) return magnitude ? Array.from(entry.y, shape) : entry.y;
  const found: (number | null)[] = new Array<number | null>(axis.length).fill(null);
  for (let k = 0, place = 0; k < entry.x.length; k += 1) {
    while (place < axis.length && axis[place] < entry.x[k]) place += 1;
    if (place < axis.length) found[place] = shape(entry.y[k]);
  }
  return found;
}

/** A curve's value at a place, between two samples on the straight line; null outside. */
export function valueAt(entry: Entry, place: number): number | null {
  const { x, y } = entry;
  const last = x.length - 1;
  if (last < 0 || place < x[0] - 1e-9 || place > x[last] + 1e-6 * Math.abs(x[last]) + 1e-9) return null;
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= place) low = middle;
    else high = middle;
  }
  if (high === low || place >= x[high]) return y[high];
  return y[low] + ((y[high] - y[low]) * (place - x[low])) / (x[high] - x[low]);
}

const EXTREMES = new WeakMap<object, [number, number]>();

/** Least and largest finite value; zeros where there is none. */
export function extremes(values: Values): [number, number] {
  const known = EXTREMES.get(values);
  if (known) return known;
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < values.length; k += 1) {
    const value = values[k];
    if (!Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const found: [number, number] = low <= high ? [low, high] : [0, 0];
  EXTREMES.set(values, found);
  return found;
}
