// Parallel coordinates: each case is a line; a range dragged along an axis leaves those within.
import { button, make, put } from "../dom";
import { plain } from "../format";
import type { Column } from "./contract";
import { chart, line, named, svg, type Box } from "./draw";
import { clamped, rangeOf, scale, type Scale } from "./scale";
import { spanOf, type Store } from "./store";

const [MOST_LINES, SHADES, NEAR] = [1500, 6, 12];

export function mountParallel(host: HTMLElement, store: Store): void {
  const columns = store.columns.filter(({ values }) => new Set(values.data.slice(0, 500)).size > 1).slice(0, 12);
  if (columns.length < 2) return;
  const count = make("span", { class: "readout", "aria-live": "polite" });
  const clear = button("all cases", () => store.clear(), { class: "tool" });
  let dragged: { name: string; from: number } | null = null;
  const view = chart(host, store.page.designs ? "All designs" : "All cases", 320, (root, width, height) => {
    const box: Box = { left: 60, top: 40, right: width - 60, bottom: height - 16 };
    const places = columns.map((_, k) => box.left + ((box.right - box.left) * k) / (columns.length - 1));
    const ways = columns.map((column) => clamped(scale(spanOf(store, column), [box.bottom, box.top], 5,
      column.labels)));
    draw(root, store, columns, places, ways);
    const room = Math.floor((2 * (box.right - box.left)) / (columns.length - 1) / 6.6); // letters
    columns.forEach((column, k) => axis(root, store, column, places[k], ways[k], box, k, room));
    grips(root, store, columns, places, ways, box, {
      start: (name, from) => (dragged = { name, from }),
      move: () => dragged,
      end: () => (dragged = null),
    });
  }, "Drag along an axis to keep the cases in that range; click a line to look at its case.");
  view.element.querySelector(".tools")?.prepend(count, clear);
  const tell = () => {
    const inside = [...Array(store.size).keys()].filter((row) => store.inside(row)).length;
    put(count, store.brushes.size ? `${inside} of ${store.size} cases` : "");
    clear.hidden = store.brushes.size === 0;
  };
  store.listen(() => {
    tell();
    view.redraw();
  });
  tell();
}

function draw(root: SVGSVGElement, store: Store, columns: Column[], places: number[], ways: Scale[]): void {
  const shown = store.shown;
  const [low, high] = rangeOf(shown.values.data);
  const step = Math.max(1, Math.floor(store.size / MOST_LINES));
  const shades: string[][] = Array.from({ length: SHADES }, () => []);
  const faint: string[] = [];
  for (let row = 0; row < store.size; row += step) {
    const path = pathOf(row, columns, places, ways);
    if (!path) continue;
    if (!store.inside(row) || !store.isGood(row)) faint.push(path);
    else {
      const share = (shown.values.data[row] - low) / (high - low || 1);
      shades[Math.min(SHADES - 1, Math.max(0, Math.floor(share * SHADES) || 0))].push(path);
    }
  }
  root.append(svg("path", { d: faint.join(""), class: "case-line faint" }));
  shades.forEach((paths, k) => root.append(svg("path", { d: paths.join(""), class: `case-line shade${k}` })));
  if (store.row !== null) root.append(svg("path", { d: pathOf(store.row, columns, places, ways), class: "chosen" }));
}

function pathOf(row: number, columns: Column[], places: number[], ways: Scale[]): string {
  const points: [number, number][] = [];
  columns.forEach((column, k) => {
    const value = column.values.data[row];
    if (Number.isFinite(value)) points.push([places[k], ways[k].at(value)]);
  });
  return points.length > 1 ? line(points) : "";
}

function axis(root: SVGSVGElement, store: Store, column: Column, at: number, way: Scale, box: Box, place: number,
  room: number): void {
  const anchor = place === 0 ? "start" : at >= box.right ? "end" : "middle";
  const from = { start: box.left - 50, middle: at, end: box.right + 50 }[anchor];
  const words = named(column);
  const most = Math.max(8, room - 2);
  const short = words.length > most ? `${words.slice(0, most - 1)}…` : words;
  const group = svg("g", { class: column.name === store.quantity ? "axes shown" : "axes" },
    svg("path", { d: `M${at} ${box.top}V${box.bottom}`, class: "edge" }),
    svg("text", { x: from, y: box.top - (place % 2 ? 10 : 24), "text-anchor": anchor, class: "name" }, svg("title",
      {}, words), short));
  for (const [value, word] of way.ticks)
    group.append(svg("text", { x: at + 5, y: way.at(value) + 4 }, word.length > 12 ? `${word.slice(0, 11)}…` : word));
  const range = store.brushes.get(column.name);
  if (range) {
    const [top, bottom] = [way.at(range[1]), way.at(range[0])];
    group.append(svg("rect", { x: at - 6, y: top, width: 12, height: Math.max(bottom - top, 2), class: "brush" },
      svg("title", {}, `${plain(range[0])} to ${plain(range[1])}`)));
  }
  root.append(group);
}

interface Drag {
  start(name: string, from: number): void;
  move(): { name: string; from: number } | null;
  end(): void;
}

function grips(
  root: SVGSVGElement, store: Store, columns: Column[], places: number[], ways: Scale[], box: Box, drag: Drag,
): void {
  const where = (event: PointerEvent): [number, number] => {
    const frame = root.getBoundingClientRect();
    return [event.clientX - frame.left, Math.min(box.bottom, Math.max(box.top, event.clientY - frame.top))];
  };
  root.onpointerdown = (event) => {
    const [x, y] = where(event);
    const k = places.findIndex((place) => Math.abs(place - x) < NEAR);
    if (k >= 0) {
      drag.start(columns[k].name, y);
      root.setPointerCapture(event.pointerId);
      event.preventDefault();
    } else pickNear(store, columns, places, ways, x, y);
  };
  root.onpointerup = (event) => {
    const now = drag.move();
    drag.end();
    if (!now) return;
    const [, y] = where(event);
    const way = ways[columns.findIndex(({ name }) => name === now.name)];
    const ends = [way.back(now.from), way.back(y)].sort((a, b) => a - b) as [number, number];
    store.brush(now.name, Math.abs(y - now.from) < 3 ? null : ends);
  };
}

/** The case whose line passes nearest. */
function pickNear(store: Store, columns: Column[], places: number[], ways: Scale[], x: number, y: number): void {
  const k = places.findIndex((place) => place > x);
  if (k < 1) return;
  const share = (x - places[k - 1]) / (places[k] - places[k - 1]);
  let [best, nearest] = [-1, Infinity];
  for (let row = 0; row < store.size; row += 1) {
    if (!store.inside(row)) continue;
    const [left, right] = [k - 1, k].map((one) => ways[one].at(columns[one].values.data[row]));
    const apart = Math.abs(left + share * (right - left) - y);
    if (apart < nearest) [best, nearest] = [row, apart];
  }
  if (best >= 0 && nearest < NEAR) store.pick(best);
}
