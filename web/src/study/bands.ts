// Percentiles of the motion over time, as bands about the median.
import type { Band } from "./contract";
import { axes, chart, gutter, line, svg, type Box } from "./draw";
import { rangeOf, scale } from "./scale";

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
