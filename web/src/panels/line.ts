// The elastic line at the page's time: deflection, slope, moment and shear along the links, root to tip.

import uPlot from "uplot";
import type { Clock } from "../clock";
import { colour, lookOf } from "../charts/look";
import type { LinePanel, Page } from "../contract";
import type { LiveRun } from "../contract_parts";
import { make, put, swatch } from "../dom";
import { digits, plain, readable } from "../format";
import type { Numbers } from "../pack";
import { spare } from "../spare";

export interface LineView {
  /** The live model's lines of the first run; null: the page's own. */
  show(live: LiveRun | null): void;
  dispose(): void;
}

const HEIGHT = 150;
const FONT = "12px system-ui, sans-serif";

type Quantity = LinePanel["quantities"][number];

interface Picture {
  plot: uPlot;
  quantity: Quantity;
  factor: number;
  /** Show the same quantity of another run. */
  take(quantity: Quantity): void;
}

export function mountLine(element: HTMLElement, page: Page, clock: Clock): LineView {
  let panel = page.runs[0].line;
  let times: ArrayLike<number> = page.runs[0].scene.times.data;
  let pictures: Picture[] = [];
  let seen = false;
  let stale = false;
  let built = ""; // what the pictures are made for
  const grid = make("div", { class: "line-grid" });
  const heading = make("p", { class: "note" });
  element.append(heading, grid);

  const later = spare(() => (stale ? build() : show(true)));
  function build(): void {
    stale = false;
    const kind = panel === null ? "" : kindOf(panel);
    if (kind === built) pictures.forEach((one, k) => one.take(panel!.quantities[k]));
    else renew();
    built = kind;
    show();
  }

  function renew(): void {
    pictures.forEach(({ plot }) => plot.destroy());
    grid.replaceChildren();
    pictures = panel === null ? [] : panel.quantities.map((quantity) => picture(grid, panel!, quantity));
  }

  function show(now = seen): void {
    if (panel === null || stale) return;
    if (!now) return later.ask();
    const frame = nearest(times, clock.time);
    heading.textContent =
      `${panel.links.join(", ")}: along the links from root to tip, at ${digits(times[frame], 4)} s. ` +
      "The scales are those of the whole run.";
    const axis = along(panel);
    for (const { plot, quantity, factor } of pictures) {
      const columns = quantity.planes.map((_, k) =>
        row(panel!, quantity.values, frame, k, quantity.planes.length, factor),
      );
      plot.setData([axis, ...columns] as uPlot.AlignedData);
    }
  }

  const dark = matchMedia("(prefers-color-scheme: dark)");
  const redraw = () => pictures.forEach(({ plot }) => plot.redraw());
  dark.addEventListener("change", redraw);
  const resized = new ResizeObserver(() => pictures.forEach(({ plot }) => {
    const width = plot.root.parentElement?.clientWidth ?? 0;
    if (width > 0 && width !== plot.width) plot.setSize({ width, height: HEIGHT });
  }));
  resized.observe(grid);
  const watch = new IntersectionObserver((found) => {
    seen = found.some((one) => one.isIntersecting);
    if (seen && stale) build();
    else show();
  });
  watch.observe(element);
  const end = clock.subscribe(() => show());
  build();
  return {
    show(live) {
      panel = live ? (live.line ?? null) : page.runs[0].line;
      times = (live?.scene ?? page.runs[0].scene).times.data;
      stale = true;
      if (seen) build();
      else later.ask();
    },
    dispose() {
      end();
      later.end();
      resized.disconnect();
      watch.disconnect();
      dark.removeEventListener("change", redraw);
      pictures.forEach(({ plot }) => plot.destroy());
      element.replaceChildren();
    },
  };
}

/** What must be the same for pictures to serve another run: links, places along them, quantities and planes. */
function kindOf(panel: LinePanel): string {
  const { links, places, quantities } = panel;
  return JSON.stringify([
    links,
    Array.from(places.data),
    quantities.map(({ id, label, unit, planes }) => [id, label, unit, planes]),
  ]);
}

/** Places of all stations along the chain of bending links; a link begins where the one before ended. */
function along(panel: LinePanel): number[] {
  const stations = panel.places.shape[1];
  const found: number[] = [];
  let start = 0;
  for (let link = 0; link < panel.links.length; link += 1) {
    for (let k = 0; k < stations; k += 1)
      found.push(start + panel.places.data[link * stations + k] + (k === 0 && link > 0 ? 1e-9 : 0));
    start = found[found.length - 1];
  }
  return found;
}

/** One plane of a quantity at a frame, over all links; values [m, links, S, planes]. */
function row(
  panel: LinePanel,
  values: Numbers,
  frame: number,
  plane: number,
  planes: number,
  factor: number,
): number[] {
  const count = panel.links.length * panel.places.shape[1];
  const start = frame * count * planes;
  return Array.from({ length: count }, (_, k) => factor * values.data[start + k * planes + plane]);
}

function nearest(times: ArrayLike<number>, time: number): number {
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return Math.abs(times[high] - time) < Math.abs(times[low] - time) ? high : low;
}

function picture(grid: HTMLElement, panel: LinePanel, quantity: Quantity): Picture {
  let limits: [number, number] = [0, 1];
  const looks = quantity.planes.map((_, k) => lookOf(k));
  const place = make("div", { class: "plot-area", role: "img" });
  const unitName = make("span", { class: "unit" });
  const legend = make(
    "div",
    { class: "legend" },
    ...quantity.planes.map((name, k) =>
      make("span", { class: "key" }, swatch(`var(${looks[k].property})`, looks[k].dash), make("span", { text: name })),
    ),
  );
  const title = make("h4", { text: quantity.label }, unitName);
  grid.append(make("figure", { class: "chart" }, make("figcaption", {}, title, legend), place));
  const lines = { stroke: () => colour("--grid"), width: 1 };
  const axis = { stroke: () => colour("--quiet"), font: FONT, grid: lines, ticks: { ...lines, size: 4 } };
  const axisPlaces = along(panel);
  const joints = panel.links.slice(1).map((_, k) => axisPlaces[(k + 1) * panel.places.shape[1]]);
  const plot = new uPlot(
    {
      width: Math.max(place.clientWidth, 120),
      height: HEIGHT,
      legend: { show: false },
      padding: [8, 14, 0, 0],
      cursor: { show: false },
      scales: { x: { time: false }, y: { range: () => limits } },
      axes: [
        {
          ...axis,
          label: "along the links [m]",
          labelSize: 18,
          labelFont: FONT,
          size: 30,
          values: (_, marks) => marks.map(plain),
        },
        {
          ...axis,
          size: (_, marks) => 16 + 7 * Math.max(2, ...(marks ?? []).map((mark) => mark.length)),
          values: (_, marks) => marks.map(plain),
        },
      ],
      series: [
        {},
        ...looks.map((look) => ({
          stroke: () => colour(look.property),
          dash: look.dash,
          width: 1.6,
          points: { show: false },
        })),
      ],
      hooks: { draw: [(drawn) => separators(drawn, joints)] },
    },
    [axisPlaces, ...looks.map(() => axisPlaces.map(() => 0))] as uPlot.AlignedData,
    place,
  );
  const found: Picture = { plot, quantity, factor: 1, take };
  function take(other: Quantity): void {
    let [low, high] = [0, 0];
    for (const value of other.values.data) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
    const unit = readable(other.unit, Math.max(-low, high));
    const room = 0.06 * (high - low) || 1;
    limits = [(low - room) * unit.factor, (high + room) * unit.factor];
    [found.quantity, found.factor] = [other, unit.factor];
    put(unitName, ` [${unit.name || "–"}]`);
    place.setAttribute(
      "aria-label",
      `${other.label} along the links, ` +
        `between ${plain(low * unit.factor)} and ${plain(high * unit.factor)} ${unit.name}`,
    );
  }
  take(quantity);
  return found;
}

/** Thin lines where one link ends and the next begins. */
function separators(plot: uPlot, places: number[]): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.strokeStyle = colour("--quiet");
  ctx.setLineDash([3, 3]);
  for (const place of places) {
    const x = plot.valToPos(place, "x", true);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
  }
  ctx.restore();
}
