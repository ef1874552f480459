// What a chart says of itself in words: what it shows, and by how many of its samples it is drawn.

import type { Chart } from "../contract";
import { plain } from "../format";
import { extremes, type ChartSet, type Entry } from "./series";

/** What is shown, for those who do not see it. */
export function summary(chart: Chart, unit: string, shown: Entry[]): string {
  const parts = shown.filter((entry) => !entry.ghost).map((entry) => {
    const [low, high] = extremes(entry.y);
    return `${entry.label} ${entry.part}, from ${plain(low)} to ${plain(high)} ${unit}`.trim();
  });
  return `${chart.title}: ${parts.join("; ") || "no curve is shown"}.`;
}

/** Of the runs side by side the one that is thinned most. */
export function thinnest(set: ChartSet): Chart {
  return set.runs
    .map((one) => one.chart)
    .reduce((least, chart) => (drawnShare(chart) < drawnShare(least) ? chart : least));
}

/** How many of the samples are drawn, as a share. */
export function drawnShare(chart: Chart): number {
  return chart.at.data.length / chart.samples;
}

/** The same in words. */
export function drawnBy(chart: Chart): string {
  const [drawn, all] = [chart.at.data.length, chart.samples].map((count) => count.toLocaleString("en"));
  return `Drawn by ${drawn} of ${all} samples; every extreme is kept.`;
}
