// How a quantity is distributed over all cases, with its percentiles, and where the chosen case is.
import { plain } from "../format";
import { axes, chart, gutter, named, svg, type Box } from "./draw";
import { rangeOf, scale } from "./scale";
import type { Store } from "./store";

const MARKED = [5, 50, 95];

export function mountHistogram(host: HTMLElement, store: Store): void {
  const view = chart(host, "Distribution", 252, (root, width, height) => {
    const column = store.shown;
    if (!column.edges || !column.counts) return;
    const [edges, counts] = [column.edges.data, column.counts.data];
    const [top, bottom] = [38, height - 40];
    const y = scale([0, 1.05 * Math.max(...counts)], [bottom, top], 4);
    const box: Box = { left: gutter(y), top, right: width - 10, bottom };
    const x = scale(rangeOf(edges), [box.left, box.right], Math.max(3, width / 90));
    axes(root, box, x, y, [named(column), "cases"]);
    for (let k = 0; k < counts.length; k += 1) {
      const [left, upper] = [x.at(edges[k]), y.at(counts[k])];
      root.append(svg("rect", { x: left, y: upper, width: Math.max(0.5, x.at(edges[k + 1]) - left - 1),
        height: box.bottom - upper, class: "bar-area" }));
    }
    const ends = [-Infinity, -Infinity]; // of the names in the lower and the upper row
    for (const [share, value] of column.percentiles.filter(([one]) => MARKED.includes(one))) {
      const at = x.at(value);
      root.append(svg("path", { d: `M${at} ${box.top}V${box.bottom}`, class: "percentile" }));
      const words = `${share} %: ${plain(Number(value.toPrecision(4)))}`;
      const half = 3.3 * words.length;
      const place = Math.min(Math.max(at, half), width - half);
      const row = ends.findIndex((end) => place - half > end);
      if (row < 0) continue;
      root.append(svg("text", { x: place, y: box.top - 8 - 14 * row, "text-anchor": "middle", class: "name" }, words));
      ends[row] = place + half;
    }
    const own = store.row === null ? NaN : column.values.data[store.row];
    if (Number.isFinite(own)) root.append(svg("path", { d: `M${x.at(own)} ${box.top}V${box.bottom}`,
      class: "chosen" }));
  }, "Dashed: percentiles of all cases.");
  store.listen((change) => change !== "brush" && view.redraw());
}
