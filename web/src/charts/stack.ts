// The shapes of a chart: curves, or areas on each other that add up to the last curve; and what its axis leaves out.

import { extremes, type ChartSet, type Entry } from "./series";

export interface Shape {
  entry: Entry;
  values: ArrayLike<number | null>;
  filled: boolean;
}

const TOTAL = "total";
const NARROW = 0.05;

/** Whether its curves are drawn as areas: parts of several runs do not add up, these are curves. */
export function stacks({ chart, runs }: ChartSet): boolean {
  return chart.stacked === true && runs.length < 2;
}

/** Areas are above zero upwards, below it downwards; the largest come first, as the later ones are drawn over them. */
export function shapes(entries: Entry[], columns: ArrayLike<number | null>[], stacked: boolean): Shape[] {
  const curves = entries.map((entry, k) => ({ entry, values: columns[k], filled: false }));
  if (!stacked) return curves;
  const areas: Shape[] = [];
  for (const sign of [1, -1]) {
    let below = new Float64Array(columns[0]?.length ?? 0);
    for (const { entry, values } of curves) {
      if (entry.label === TOTAL) continue;
      below = below.map((value, k) => value + sign * Math.max(0, sign * (values[k] ?? 0)));
      areas.unshift({ entry, values: below, filled: true });
    }
  }
  return [...areas, ...curves.filter(({ entry }) => entry.label === TOTAL)];
}

/** Says so where values differ by so little that their axis does not start at zero; else empty. */
export function narrow(entries: Entry[], unit: string): string {
  const ranges = entries.map(({ y }) => extremes(y));
  const [low, high] = [Math.min(...ranges.map(([one]) => one)), Math.max(...ranges.map(([, one]) => one))];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (!(high - low < NARROW * size) || high - low <= 1e-9 * size) return "";
  const [least, most] = [low, high].map((value) => String(Number(value.toPrecision(6))));
  const share = Number(((100 * (high - low)) / size).toPrecision(2));
  return `The axis does not start at zero: ${least} to ${most} ${unit}, ${share} % apart.`;
}
