// Percentiles of the motion over time, as bands about the median; and what no case beats in two objectives.
import { plain } from "../format";
import type { Band, Pareto } from "./contract";
import { axes, chart, dots, gutter, line, named, svg, type Box } from "./draw";
import { rangeOf, scale } from "./scale";
import type { Store } from "./store";

export function mountBand(host: HTMLElement, band: Band): void {
  chart(host, band.title, 250, (root, width, height) => {
    const [top, bottom] = [10, height - 40];
    const [times, count] = [band.times.data, band.times.data.length];
    const row = (k: number) => band.values.data.subarray(k * count, (k + 1) * count) as Float32Array;
    const y = scale(rangeOf(band.values.data, null, band.nominal ? [...band.nominal.data] : []), [bottom, top], 5);
    const box: Box = { left: gutter(y), top, right: width - 12, bottom };
    const x = scale([times[0], times[count - 1]], [box.left, box.right], Math.max(3, width / 90));
    axes(root, box, x, y, ["time [s]", `${band.label} [${band.unit}]`]);
    const points = (values: ArrayLike<number>): [number, number][] =>
      Array.from(times, (time, j) => [x.at(time), y.at(values[j])] as [number, number]).filter(([, at]) =>
        Number.isFinite(at));
    for (let k = 0; 2 * k < band.shares.length - 1; k += 1) {
      const [low, high] = [points(row(k)), points(row(band.shares.length - 1 - k)).reverse()];
      root.append(svg("path", { d: `${line([...low, ...high])}Z`, class: `band band${k}` }));
    }
    if (band.shares.length % 2)
      root.append(svg("path", { d: line(points(row((band.shares.length - 1) / 2))), class: "middle" }));
    if (band.nominal) root.append(svg("path", { d: line(points(band.nominal.data)), class: "nominal" }));
  },
    `Bands: ${pairs(band.shares)} of ${band.cases} cases; line: median` +
    `${band.nominal ? "; dashed: the sheet's own run" : ""}.`);
}

function pairs(shares: number[]): string {
  const found = [];
  for (let k = 0; 2 * k < shares.length - 1; k += 1) found.push(`${shares[k]} to ${shares[shares.length - 1 - k]} %`);
  return found.join(", ");
}

export function mountPareto(host: HTMLElement, store: Store, pareto: Pareto): void {
  const [one, two] = [store.column(pareto.x), store.column(pareto.y)];
  const view = chart(host, "Best designs", 280, (root, width, height) => {
    const [top, bottom] = [10, height - 40];
    const y = scale(rangeOf(two.values.data, two.labels), [bottom, top], 5, two.labels);
    const box: Box = { left: gutter(y), top, right: width - 12, bottom };
    const x = scale(rangeOf(one.values.data, one.labels), [box.left, box.right], Math.max(3, width / 90), one.labels);
    axes(root, box, x, y, [named(one), named(two)]);
    const at = (row: number): [number, number] => [x.at(one.values.data[row]), y.at(two.values.data[row])];
    const all = [...Array(store.size).keys()].filter((row) => at(row).every(Number.isFinite));
    root.append(svg("path", { d: dots(all.map(at)), class: "points faint" }));
    const front = [...pareto.front].sort((a, b) => one.values.data[a] - one.values.data[b]);
    root.append(svg("path", { d: line(front.map(at)), class: "front" }));
    for (const row of front) {
      const [left, top] = at(row);
      const mark = svg("circle", { cx: left, cy: top, r: store.row === row ? 7 : 5, class: "front-point" },
        svg("title", {},
          `case ${store.page.case.data[row]}: ${plain(one.values.data[row])}, ${plain(two.values.data[row])}`));
      mark.onclick = () => store.pick(row);
      root.append(mark);
    }
  }, "Line: designs that no other beats in both.");
  store.listen((change) => change === "case" && view.redraw());
}
