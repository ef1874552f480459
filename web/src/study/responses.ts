// The quantity that is looked at over each parameter: points and the middle of them; of a grid of two a surface.
import { make } from "../dom";
import { plain } from "../format";
import type { Column } from "./contract";
import { axes, chart, crosses, dots, gutter, line, named, svg, type Box } from "./draw";
import { clamped, rangeOf, scale } from "./scale";
import { nearestRow, spanOf, type Store } from "./store";

const [MOST_POINTS, BINS, MOST_LEVELS, MOST_SHOWN] = [2500, 24, 60, 12];

export function mountResponses(host: HTMLElement, store: Store): void {
  const place = host.classList.contains("study-grid") ? host : make("div", { class: "study-grid" });
  if (place !== host) host.append(place);
  const varied = store.page.parameters.filter(({ values }) => new Set(values.data.slice(0, 500)).size > 1);
  if (isGrid(varied, store.size)) surface(place, store, varied[0], varied[1]);
  for (const parameter of varied.slice(0, MOST_SHOWN)) response(place, store, parameter);
}

function response(host: HTMLElement, store: Store, parameter: Column): void {
  const view = chart(host, `Response to ${parameter.title || parameter.name}`, 230, (root, width, height) => {
    const column = store.shown;
    const [given, found] = [parameter.values.data, column.values.data];
    const [top, bottom] = [10, height - 40];
    const y = clamped(scale(spanOf(store, column), [bottom, top], 5));
    const box: Box = { left: gutter(y), top, right: width - 12, bottom };
    const x = scale(rangeOf(given, parameter.labels), [box.left, box.right], Math.max(3, width / 90), parameter.labels);
    axes(root, box, x, y, [named(parameter), named(column)]);
    const [near, far, lost, beyond]: [number, number][][] = [[], [], [], []];
    const step = Math.max(1, Math.floor(store.size / MOST_POINTS));
    for (let row = 0; row < store.size; row += 1) {
      if (!store.isGood(row) && Number.isFinite(found[row])) beyond.push([x.at(given[row]), y.at(found[row])]);
      else if (!store.isGood(row)) lost.push([x.at(given[row]), box.bottom - 4]);
      else if (row % step === 0 && Number.isFinite(found[row]))
        (store.inside(row) ? near : far).push([x.at(given[row]), y.at(found[row])]);
    }
    root.append(svg("path", { d: dots(far), class: "points faint" }), svg("path", { d: dots(near), class: "points" }),
      svg("path", { d: crosses(beyond), class: "points beyond" }));
    const middle = middles(store, parameter, column).map(([a, b]): [number, number] => [x.at(a), y.at(b)]);
    if (parameter.labels) // names have no order: nothing lies between them
      root.append(svg("path", { d: middle.map(([a, b]) => `M${a - 8} ${b}h16`).join(""), class: "middle" }));
    else if (!store.page.designs) root.append(svg("path", { d: line(middle), class: "middle" }));
    if (lost.length) root.append(svg("path", { d: dots(lost), class: "points lost" }, svg("title", {},
      "cases that did not finish")));
    if (store.row !== null && Number.isFinite(found[store.row]))
      root.append(svg("path", { d: dots([[x.at(given[store.row]), y.at(found[store.row])]]),
        class: "points chosen-point" }));
    root.onclick = (event) => {
      const frame = root.getBoundingClientRect();
      const at = (row: number): [number, number] => [x.at(given[row]), y.at(found[row])];
      const row = nearestRow(store, at, event.clientX - frame.left, event.clientY - frame.top);
      if (row !== null) store.pick(row);
    };
  });
  store.listen(() => view.redraw());
}

/** Medians of the quantity in bins of equally many cases; of few levels at each. */
function middles(store: Store, parameter: Column, column: Column): [number, number][] {
  const pairs: [number, number][] = [];
  for (let row = 0; row < store.size; row += 1) {
    const pair: [number, number] = [parameter.values.data[row], column.values.data[row]];
    if (pair.every(Number.isFinite) && store.isGood(row) && store.inside(row)) pairs.push(pair);
  }
  pairs.sort((a, b) => a[0] - b[0]);
  const levels = new Set(pairs.map(([value]) => value)).size;
  if (levels === pairs.length && varying(store) === 1) return pairs; // a curve
  if (levels <= BINS) return groups(pairs, (pair, before) => pair[0] !== before[0]);
  const each = Math.max(8, Math.ceil(pairs.length / BINS));
  return groups(pairs, (_, __, k) => k % each === 0);
}

function varying({ page }: Store): number {
  return page.parameters.filter(({ values }) => new Set(values.data.slice(0, 500)).size > 1).length;
}

function groups(
  pairs: [number, number][], begins: (pair: [number, number], before: [number, number], k: number) => boolean,
): [number, number][] {
  const parts: [number, number][][] = [];
  pairs.forEach((pair, k) => (k === 0 || begins(pair, pairs[k - 1], k)
    ? parts.push([pair]) : parts[parts.length - 1].push(pair)));
  return parts.map((part) => [median(part.map(([a]) => a)), median(part.map(([, b]) => b))]);
}

function median(values: number[]): number {
  const sorted = values.sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

/** Whether the cases are all combinations of two parameters' values. */
function isGrid(varied: Column[], size: number): boolean {
  if (varied.length !== 2) return false;
  const [one, two] = varied.map(({ values }) => new Set(values.data).size);
  return one > 2 && two > 2 && one <= MOST_LEVELS && two <= MOST_LEVELS && one * two === size;
}

function surface(host: HTMLElement, store: Store, one: Column, two: Column): void {
  const view = chart(host, `Response to ${one.title || one.name} and ${two.title || two.name}`, 300, (root, width,
    height) => {
    const column = store.shown;
    const [xs, ys] = [one, two].map(({ values }) => [...new Set(values.data)].sort((a, b) => a - b));
    const [left, top] = [edgesOf(xs), edgesOf(ys)];
    const y = scale([top[0], top[ys.length]], [height - 40, 10], 5, two.labels);
    const box: Box = { left: gutter(y), top: 10, right: width - 84, bottom: height - 40 };
    const x = scale([left[0], left[xs.length]], [box.left, box.right], Math.max(3, width / 90), one.labels);
    const values = column.values.data;
    const [low, high] = extremes(values);
    axes(root, box, x, y, [named(one), named(two)]);
    for (let row = 0; row < store.size; row += 1) {
      const [i, j] = [xs.indexOf(one.values.data[row]), ys.indexOf(two.values.data[row])];
      const share = (values[row] - low) / (high - low || 1);
      const cell = svg("rect", { x: x.at(left[i]), y: y.at(top[j + 1]), width: x.at(left[i + 1]) - x.at(left[i]) + 0.5,
        height: y.at(top[j]) - y.at(top[j + 1]) + 0.5, class: store.row === row ? "cell picked" : "cell",
        fill: Number.isFinite(values[row]) ? shade(share) : "none" },
      svg("title", {}, `${plain(xs[i])}, ${plain(ys[j])}: ${plain(values[row])}`));
      cell.onclick = () => store.pick(row);
      root.append(cell);
    }
    for (let k = 0; k < 40; k += 1) {
      const at = box.bottom - ((k + 1) / 40) * (box.bottom - box.top);
      root.append(svg("rect", { x: box.right + 12, y: at, width: 12, height: (box.bottom - box.top) / 40 + 0.5,
        fill: shade(k / 39) }));
    }
    for (const [value, at] of [[low, box.bottom], [(low + high) / 2, (box.top + box.bottom) / 2], [high, box.top + 8]])
      root.append(svg("text", { x: box.right + 28, y: at, class: "name" }, plain(Number(value.toPrecision(3)))));
    const place = `translate(${width - 6} ${(box.top + box.bottom) / 2}) rotate(-90)`;
    root.append(svg("text", { transform: place, "text-anchor": "middle", class: "name" }, named(column)));
  });
  store.listen((change) => change !== "brush" && view.redraw());
}

function extremes(values: ArrayLike<number>): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < values.length; k += 1)
    if (Number.isFinite(values[k])) [low, high] = [Math.min(low, values[k]), Math.max(high, values[k])];
  return low > high ? [0, 1] : [low, high];
}

/** Half-way between neighbours, and as far beyond the ends. */
function edgesOf(sorted: number[]): number[] {
  const middle = sorted.slice(1).map((value, k) => (value + sorted[k]) / 2);
  return [2 * sorted[0] - middle[0], ...middle, 2 * sorted[sorted.length - 1] - middle[middle.length - 1]];
}

/** From dark blue through green to yellow, evenly light for every eye (points of viridis). */
const VIRIDIS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
function shade(share: number): string {
  const at = Math.min(Math.max(share, 0), 1) * (VIRIDIS.length - 1);
  const k = Math.min(Math.floor(at), VIRIDIS.length - 2);
  return `rgb(${VIRIDIS[k].map((value, c) => Math.round(value + (at - k) * (VIRIDIS[k + 1][c] - value))).join(" ")})`;
}
