// Which parameter matters: a tornado of ranges, or Sobol' indices with their confidence intervals.
import { make } from "../dom";
import { plain, pretty } from "../format";
import type { Indices, Tornado } from "./contract";
import { axes, chart, svg, type Box } from "./draw";
import { scale } from "./scale";
import type { Store } from "./store";

const [ROW, EDGE] = [26, 66];

export function mountBars(host: HTMLElement, store: Store): void {
  if (!store.page.tornados.length && !store.page.indices.length) return;
  const place = make("div", {});
  host.append(place);
  const mount = () => {
    place.replaceChildren();
    const of = ({ quantity }: { quantity: string }) => quantity === store.quantity;
    const [indices, tornado] = [store.page.indices.find(of), store.page.tornados.find(of)];
    if (indices) sobol(place, store, indices);
    else if (tornado) swings(place, store, tornado);
  };
  store.listen((change) => change === "quantity" && mount());
  mount();
}

function titles(store: Store, name: string): string {
  return store.column(name).title || name;
}

function room(names: string[], width: number, height: number): Box {
  const wide = Math.min(0.4 * width, 16 + 7.6 * Math.max(...names.map((one) => one.length)));
  return { left: wide, top: 8, right: width - 14, bottom: height - 40 };
}

function label(root: SVGSVGElement, box: Box, words: string, at: number): void {
  const most = Math.floor((box.left - 10) / 7.4);
  const short = words.length > most ? `${words.slice(0, most - 1)}…` : words;
  root.append(svg("text", { x: box.left - 8, y: at + 4, "text-anchor": "end", class: "name" }, short));
}

function swings(host: HTMLElement, store: Store, found: Tornado): void {
  const bars = [...found.bars].sort((a, b) => Math.abs(b.high - b.low) - Math.abs(a.high - a.low)).slice(0, 12);
  const names = bars.map(({ name }) => titles(store, name));
  chart(host, "What matters", ROW * bars.length + EDGE, (root, width, height) => {
    const box = room(names, width, height);
    const ends = bars.flatMap(({ low, high }) => [low, high]).concat(found.base);
    const [low, high] = [Math.min(...ends), Math.max(...ends)];
    const edge = 0.06 * (high - low) || 0.5;
    const x = scale([low - edge, high + edge], [box.left, box.right], Math.max(2, width / 110));
    const unit = pretty(found.unit);
    axes(root, box, x, null, [unit ? `${titles(store, found.quantity)} [${unit}]` : found.how, ""]);
    bars.forEach((bar, k) => {
      const at = box.top + ROW * (k + 0.5);
      for (const [end, kind] of [[bar.low, "low"], [bar.high, "high"]] as const) {
        const [from, to] = [x.at(found.base), x.at(end)].sort((a, b) => a - b);
        root.append(svg("rect", { x: from, y: at - 8, width: Math.max(to - from, 1), height: 16,
          class: `swing ${kind}` },
          svg("title", {}, `${names[k]} ${kind}: ${plain(end)} ${unit}`)));
      }
      label(root, box, names[k], at);
    });
    root.append(svg("path", { d: `M${x.at(found.base)} ${box.top}V${box.bottom}`, class: "edge" }));
  }, found.how);
}

function sobol(host: HTMLElement, store: Store, found: Indices): void {
  const order = found.names.map((_, k) => k).sort((a, b) => found.total[b][0] - found.total[a][0]).slice(0, 12);
  const names = order.map((k) => titles(store, found.names[k]));
  chart(host, "What matters", (ROW + 8) * order.length + EDGE, (root, width, height) => {
    const box = room(names, width, height);
    const most = Math.max(1, ...found.total.map(([, , high]) => high));
    const least = Math.min(0, ...found.first.map(([, low]) => low));
    const x = scale([least, most], [box.left, box.right], 5);
    axes(root, box, x, null, ["share of the variance", ""]);
    order.forEach((of, k) => {
      const at = box.top + (ROW + 8) * (k + 0.5);
      for (const [values, offset, kind] of [[found.first[of], -8, "first"], [found.total[of], 2, "total"]] as const) {
        const [value, low, high] = values;
        const [from, to] = [x.at(0), x.at(value)].sort((a, b) => a - b);
        root.append(svg("rect", { x: from, y: at + offset, width: Math.max(to - from, 1), height: 9,
          class: `index ${kind}` },
          svg("title", {}, `${names[k]} ${kind}: ${plain(value)}, 95 %: ${plain(low)} to ${plain(high)}`)),
        svg("path", { d: `M${x.at(low)} ${at + offset + 4.5}H${x.at(high)}`, class: "interval" }));
      }
      label(root, box, names[k], at);
    });
  }, `${found.how}. Upper bar: first order (alone); lower bar: total (with all interactions); lines: 95 % confidence.`);
}
