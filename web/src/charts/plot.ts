// One uPlot: axes, lines, the cursor that shows the page's time, zoom by shift and drag.

import uPlot from "uplot";
import { plain } from "../format";
import { colour } from "./look";
import type { Values } from "./series";

export interface PlotLine {
  property: string;
  dash: number[];
  width: number;
  /** Drawn pale, behind. */
  ghost: boolean;
  /** Filled down to zero. */
  filled: boolean;
}

export interface PlotOptions {
  log: boolean;
  /** Decades below the largest value that a logarithmic axis shows. */
  decades: number;
  abscissa: string;
  ordinate: string;
  marks: { at: number; label: string }[];
  height: number;
  zoomed(range: [number, number] | null): void;
  /** The pointer is over this place of the abscissa; null: it left. */
  hovered(place: number | null): void;
  /** The place was chosen by click or drag. */
  chosen(place: number): void;
}

const FONT = "12px system-ui, sans-serif";
const SHORTEST = 2;
const CROWDED = 27; // lines of a logarithmic grid: three decades

export function makePlot(
  element: HTMLElement,
  data: [Values, ...ArrayLike<number | null>[]],
  lines: PlotLine[],
  wanted: PlotOptions,
): uPlot {
  const grid = { stroke: () => colour("--grid"), width: 1 };
  const axis = { stroke: () => colour("--quiet"), font: FONT, grid, ticks: { ...grid, size: 4 } };
  const filter = (_: uPlot, marks: number[]) =>
    wanted.log && marks.length > CROWDED ? marks.map((value) => (isPower(value) ? value : null)) : marks;
  const options: uPlot.Options = {
    width: Math.max(element.clientWidth, 120),
    height: wanted.height,
    legend: { show: false },
    padding: [10, 14, 0, 0],
    scales: {
      x: { time: false },
      y: wanted.log
        ? { distr: 3, range: (_, low, high) => decades(low, high, wanted.decades) }
        : { range: (_, low, high) => calm(low, high) },
    },
    axes: [
      {
        ...axis,
        label: wanted.abscissa,
        labelSize: 18,
        labelFont: FONT,
        size: 30,
        values: (_, marks) => marks.map(plain),
      },
      {
        ...axis,
        label: wanted.ordinate,
        labelSize: 16,
        labelFont: FONT,
        grid: { ...grid, filter },
        ticks: { ...axis.ticks, filter },
        size: (_, marks) => 16 + 7 * Math.max(2, ...(marks ?? []).map((mark) => mark.length)),
        values: (_, marks) => marks.map((mark) => (mark === null ? "" : wanted.log ? wholePower(mark) : plain(mark))),
      },
    ],
    series: [
      {},
      ...lines.map((line) => ({
        stroke: () => colour(line.property),
        width: line.width,
        dash: line.filled ? [] : line.dash,
        fill: line.filled ? () => colour(line.property) : undefined,
        alpha: line.ghost ? 0.35 : 1,
        spanGaps: true,
        points: { show: false },
      })),
    ],
    cursor: {
      y: false,
      points: { show: false },
      drag: { x: true, y: false, setScale: true, dist: SHORTEST },
      bind: {
        mousedown: (_, __, handler) => (event) => (event.shiftKey ? handler(event) : null),
        dblclick: () => () => {
          wanted.zoomed(null);
          return null;
        },
      },
    },
    hooks: {
      setSelect: [(plot) => selected(plot, wanted)],
      setCursor: [
        (plot) =>
          wanted.hovered(
            plot.cursor.left === undefined || plot.cursor.left < 0 ? null : plot.posToVal(plot.cursor.left, "x"),
          ),
      ],
      draw: [(plot) => drawMarks(plot, wanted.marks)],
    },
  };
  const plot = new uPlot(options, data as unknown as uPlot.AlignedData, element);
  chooseByPointer(plot, wanted);
  return plot;
}

/** What is constant but for rounding gets a scale on which it looks constant. */
function calm(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null || !Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const half = size > 1e-9 ? 0.05 * size : 0.05;
  if (high - low <= 1e-9 * size || size <= 1e-12) return [(low + high) / 2 - half, (low + high) / 2 + half];
  const room = 0.07 * (high - low);
  return [low - room, high + room];
}

function decades(low: number | null, high: number | null, most: number): [number, number] {
  if (low === null || high === null || !(high > 0)) return [0.1, 1];
  const least = Math.max(low > 0 ? low : high, high * 10 ** -most);
  return [10 ** Math.floor(Math.log10(least) + 1e-9), high * 1.6];
}

function isPower(value: number): boolean {
  const power = Math.log10(value);
  return Math.abs(power - Math.round(power)) < 1e-6;
}

/** A tick of a logarithmic axis: the powers of ten alone. */
function wholePower(value: number): string {
  if (!isPower(value)) return "";
  return plain(value).replace(/^1\u00a0×\u00a0|^1\.0\u00a0×\u00a0/, "");
}

function selected(plot: uPlot, wanted: PlotOptions): void {
  if (plot.select.width < SHORTEST) return;
  wanted.zoomed([plot.posToVal(plot.select.left, "x"), plot.posToVal(plot.select.left + plot.select.width, "x")]);
  plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
}

function chooseByPointer(plot: uPlot, wanted: PlotOptions): void {
  const over = plot.over;
  const choose = (event: PointerEvent) =>
    wanted.chosen(plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
  over.addEventListener("pointerdown", (event) => {
    if (event.shiftKey || event.button !== 0) return;
    over.setPointerCapture(event.pointerId);
    choose(event);
  });
  over.addEventListener("pointermove", (event) => {
    if (over.hasPointerCapture(event.pointerId)) choose(event);
  });
}

function drawMarks(plot: uPlot, marks: { at: number; label: string }[]): void {
  const { ctx, bbox } = plot;
  const ratio = uPlot.pxRatio;
  let free = -Infinity;
  ctx.save();
  ctx.fillStyle = colour("--quiet");
  ctx.font = `${11 * ratio}px system-ui, sans-serif`;
  ctx.lineJoin = "round";
  for (const { at } of marks) {
    const x = plot.valToPos(at, "x", true);
    if (x < bbox.left || x > bbox.left + bbox.width) continue;
    [ctx.strokeStyle, ctx.lineWidth] = [colour("--quiet"), ratio];
    ctx.setLineDash([3 * ratio, 3 * ratio]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    [ctx.strokeStyle, ctx.lineWidth] = [colour("--panel"), 4 * ratio];
    ctx.setLineDash([]);
    const text = `${plain(Number(at.toPrecision(3)))} Hz`;
    if (x > free && x + ctx.measureText(text).width < bbox.left + bbox.width) {
      const place = [text, x + 3 * ratio, bbox.top + 11 * ratio] as const;
      ctx.strokeText(...place); // a halo: curves pass below the words
      ctx.fillText(...place);
      free = x + ctx.measureText(text).width + 8 * ratio;
    }
  }
  ctx.restore();
}
