// One chart: title, switches, curves, legend with values; drawn only when it is looked at.

import type uPlot from "uplot";
import type { Clock } from "../clock";
import type { LiveRun } from "../contract_parts";
import { button, make, ownId, put } from "../dom";
import { info } from "../format";
import { spare } from "../spare";
import { drawnBy, drawnShare, summary, thinnest } from "./chart_words";
import { changedMarks, marksWithin } from "./frequency_marks";
import { makeLegend, type Legend } from "./legend";
import { makePlot, type PlotLine } from "./plot";
import { aligned, entriesOf, extremes, valueAt, type ChartSet, type Entry, type Values } from "./series";
import type { Look } from "./look";
import { saveButtons, type Drawn } from "./saving";
import { narrow, shapes, stacks } from "./stack";
import type { Zoom } from "./zoom";

export interface ChartView {
  readonly element: HTMLElement;
  readonly id: string;
  /** Draw the live model's run, the page's own pale behind it; null: the page's own alone. */
  show(live: LiveRun | null): void;
  /** Draw again: the colours have changed. */
  recolour(): void;
  state(): Drawn | null;
  dispose(): void;
}

const DECADES = { spectrum: 5, other: 6 };
const HEIGHT = 190;
const ROUNDING = 1e-9;
const READABLE = 100; // ms

export function mountChart(set: ChartSet, clock: Clock, zoom: Zoom): ChartView {
  const { chart } = set;
  const timed = chart.abscissa === "time";
  const title = ownId("chart");
  const abscissa = timed ? "time [s]" : "frequency [Hz]";
  const unit = chart.unit === "–" ? "" : chart.unit;
  let log = chart.log === "first";
  let live: LiveRun | null = null;
  let current = true; // whether the entries are those of what is to be shown
  let entries: Entry[] = entriesOf(set, null);
  let marks = chart.marks;
  let width = 0;
  let plot: uPlot | null = null;
  let cursor: HTMLElement | null = null;
  let hover: number | null = null;
  let seen = false;
  let stale = true;
  let pieces: PlotLine[] = [];
  let drawn = ""; // what the plot is made for
  let scheme = 0;
  let largest = 0;
  let toldAt = 0;

  const later = spare(draw);
  const place = make("div", { class: "plot-area", role: "img" });
  const readout = make("span", { class: "readout" });
  const logButton = button("log", () => setLog(!log), {
    class: "tool",
    "aria-pressed": String(log),
    title: "Logarithmic ordinate, of the size of the values",
    hidden: chart.log === "no",
  });
  const resetButton = button("reset zoom", () => zoom.set(null), { class: "tool", hidden: true });
  const tools = make("div", { class: "tools" }, resetButton, logButton, ...saveButtons(state));
  const titled = `${chart.title}${unit ? ` [${unit}]` : ""}`;
  const units = make("span", { class: "unit", text: titled.slice(chart.title.length) });
  const heading = make("h4", { id: title, text: chart.title }, units);
  const thinning = make("p", {
    class: "note",
    hidden: !timed || drawnShare(thinnest(set)) >= 1,
    text: drawnBy(thinnest(set)),
  });
  const marksNote = make("p", {
    class: "note",
    hidden: true,
    text: "The marked frequencies are of the run as it was.",
  });
  const ownNote = make("p", { class: "note", hidden: !chart.note, text: `Note: ${chart.note}.` });
  const axisNote = make("p", { class: "note", hidden: true });
  const legend: Legend = makeLegend(entries, set.compared, unit, redraw);
  const element = make("figure", { class: "chart", "aria-labelledby": title, "data-chart": chart.id },
    make("figcaption", {}, heading, readout, tools), make("div", { class: "drawing" }, legend.element, place),
    ownNote, axisNote, thinning, marksNote);

  function setLog(on: boolean): void {
    log = on;
    logButton.setAttribute("aria-pressed", String(on));
    redraw();
  }

  function redraw(): void {
    stale = true;
    if (seen) draw();
    else later.ask();
  }

  /** What is looked at is computed, and nothing else. */
  function known(): Entry[] {
    if (current) return entries;
    current = true;
    entries = entriesOf(set, live);
    const changed = changedMarks(chart, live);
    marks = changed ? marksWithin(changed, entries) : chart.marks;
    legend.renew(entries);
    return entries;
  }

  function draw(): void {
    if (!stale || width === 0) return;
    stale = false;
    const shown = chosen();
    const [axis, ...columns] = aligned(shown, log);
    const drawing = shapes(shown, columns, stacks(set));
    pieces = drawing.map(({ entry, filled }) => ({
      ...legend.look(entry),
      width: filled ? 0 : entry.ghost ? 1 : entry.role === "real" ? 1.6 : 1.3,
      ghost: entry.ghost,
      filled,
    }));
    const data: [Values, ...ArrayLike<number | null>[]] = [axis, ...drawing.map(({ values }) => values)];
    const words = log ? "" : narrow(shown, unit);
    put(axisNote, words);
    axisNote.hidden = !words;
    largest = Math.max(0, ...shown.map((entry) => Math.max(...extremes(entry.y).map(Math.abs))));
    const kind = JSON.stringify([pieces, marks, log, width, scheme]);
    if (plot && kind === drawn) plot.setData(data as unknown as uPlot.AlignedData);
    else renew(data, pieces);
    drawn = kind;
    place.setAttribute("aria-label", summary(chart, unit, shown));
    if (timed) stretch(zoom.range);
    tell();
  }

  function renew(data: [Values, ...ArrayLike<number | null>[]], lines: PlotLine[]): void {
    plot?.destroy();
    hover = null; // where the pointer was, was a place of that plot
    plot = makePlot(place, data, lines, {
      log, decades: chart.group === "spectrum" ? DECADES.spectrum : DECADES.other, height: HEIGHT, marks,
      abscissa, ordinate: chart.ordinate,
      zoomed: (range) => (timed ? zoom.set(range) : stretch(range)),
      hovered: (at) => { hover = at; tell(); },
      chosen: (at) => { if (timed) clock.seek(at); },
    });
    cursor = timed ? make("div", { class: "time-line" }) : null;
    if (cursor) plot.over.append(cursor);
  }

  function stretch(range: [number, number] | null): void {
    const axis = plot?.data[0];
    resetButton.hidden = range === null;
    if (!plot || !axis?.length) return;
    const [min, max] = range ?? [axis[0], axis[axis.length - 1]];
    if (max > min) plot.setScale("x", { min, max });
    queueMicrotask(moveCursor); // uPlot sets its scales then
  }

  function moveCursor(): void {
    if (!plot || !cursor) return;
    const left = plot.valToPos(clock.time, "x");
    // as uPlot knows it: asking the page makes it lay itself out
    const right = plot.valToPos(plot.scales.x.max ?? 0, "x");
    const inside = left >= -0.5 && left <= right + 0.5;
    cursor.style.display = inside ? "" : "none";
    cursor.style.transform = `translateX(${left}px)`;
  }

  /** The cursor at once; the numbers at most ten times a second while the time runs. */
  function follow(): void {
    moveCursor();
    if (!clock.playing || performance.now() - toldAt > READABLE) tell();
  }

  function tell(): void {
    toldAt = performance.now();
    const at = hover ?? (timed ? clock.time : null);
    put(readout, hover === null ? "" : timed ? `at ${hover.toFixed(3)} s` : `at ${info(hover, "Hz")}`);
    legend.tell((entry) => (at === null ? null : calmed(valueAt(entry, at))));
  }

  /** What is rounding next to the largest value is zero. */
  function calmed(value: number | null): number | null {
    return value !== null && Math.abs(value) < ROUNDING * largest && !log ? 0 : value;
  }

  const chosen = () => known().filter((entry) => legend.shows(entry));

  /** Drawn now, be it seen or not. */
  function state(): Drawn | null {
    draw();
    const looks = chosen().map((entry) => [entry, legend.look(entry)] as [Entry, Look]);
    return plot && { id: chart.id, titled, unit, abscissa, plot, marks, pieces, looks };
  }

  const watch = new IntersectionObserver((found) => {
    seen = found.some((one) => one.isIntersecting);
    if (seen) draw();
    if (seen) follow(); // the time may have moved meanwhile
  }, { rootMargin: "120px" });
  const resized = new ResizeObserver(() => {
    width = place.clientWidth;
    if (width > 0) redraw();
  });
  const onPaper = () => { // also what was never looked at, in the colours and the width of the paper
    scheme += 1;
    stale = true;
    draw();
  };
  for (const when of ["beforeprint", "afterprint"]) addEventListener(when, onPaper);
  watch.observe(element);
  place.setAttribute("aria-label", summary(chart, unit, entries.filter((entry) => legend.shows(entry))));
  resized.observe(place);
  const ends = [
    clock.subscribe(() => {
      if (seen && timed) follow();
    }),
    zoom.subscribe(() => timed && stretch(zoom.range)),
  ];

  return {
    element,
    id: chart.id,
    state,
    show(run) {
      live = run;
      current = false;
      marksNote.hidden = run === null || changedMarks(chart, run) !== null || chart.marks.length === 0;
      redraw();
    },
    recolour() {
      scheme += 1;
      redraw();
    },
    dispose() {
      for (const when of ["beforeprint", "afterprint"]) removeEventListener(when, onPaper);
      later.end();
      watch.disconnect();
      resized.disconnect();
      ends.forEach((end) => end());
      plot?.destroy();
    },
  };
}
