// One chart of a page: curves, areas and marks, with a legend that hides them and the numbers under the pointer.
import { make, swatch } from "../dom";
import { plain } from "../format";
import { axes, chart, dots, gutter, line, svg, type Box } from "../study/draw";
import { rangeOf, type Scale } from "../study/scale";
import { alike, axisScale } from "./axis";
import type { Curve, Plot } from "./contract";

const [NEAR, TOP, BELOW, RIGHT, ROOM] = [16, 10, 42, 14, 0.34];

interface Place {
  x: Scale;
  y: Scale;
}

export function mountPlot(host: HTMLElement, plot: Plot): void {
  const hidden = new Set<string>();
  let place: Place | null = null;
  const shown = () => plot.curves.filter(({ name }) => !hidden.has(name));
  const view = chart(host, plot.title, plot.height, (root, width, height) => {
    place = laid(root, plot, width, height);
    for (const curve of shown()) draw(root, curve, place);
  }, plot.note);
  hover(view.element.querySelector<HTMLElement>(".study-area")!, plot, () => place, shown);
  const names = [...new Set(plot.curves.map(({ name }) => name))];
  if (names.length > 1 || (names[0] && plot.curves.length > 1)) view.element.querySelector(".study-area")?.after(
    legend(names, plot.curves, hidden, view.redraw));
}

/** The axes; what is outside of them is cut. */
function laid(root: SVGSVGElement, plot: Plot, width: number, height: number): Place {
  const values = (key: "x" | "y") => plot.curves.flatMap((curve) => [...curve[key].data].filter(Number.isFinite));
  const [xs, ys] = [values("x"), values("y")];
  const [up, down] = [height - BELOW, TOP];
  const y = axisScale(plot.y, ys, [up, down], Math.max(3, (up - down) / 45), Math.floor((ROOM * width) / 7.4));
  const box: Box = { left: gutter(y), top: down, right: width - RIGHT, bottom: up };
  const count = Math.max(3, (box.right - box.left) / 90);
  let place = { x: axisScale(plot.x, xs, [box.left, box.right], count), y };
  if (plot.equal) {
    const own = [plot.x.range ?? rangeOf(xs), plot.y.range ?? rangeOf(ys)] as const;
    const [across, along] = alike(own[0], own[1], box.right - box.left, up - down);
    place = { x: axisScale({ ...plot.x, range: across }, xs, [box.left, box.right], count),
      y: axisScale({ ...plot.y, range: along }, ys, [up, down], (up - down) / 45) };
  }
  axes(root, box, place.x, place.y, [plot.x.label, plot.y.label]);
  const id = `${root.getAttribute("aria-labelledby")}-cut`;
  root.append(svg("clipPath", { id }, svg("rect", { x: box.left - 6, y: box.top - 6, width: box.right - box.left + 12,
    height: box.bottom - box.top + 12 })), svg("g", { "clip-path": `url(#${id})`, class: "curves" }));
  return place;
}

function draw(root: SVGSVGElement, curve: Curve, { x, y }: Place): void {
  const points = at(curve, x, y);
  const group = root.querySelector(".curves")!;
  const own = { class: `curve ${curve.kind}`, style: `--own: var(--${curve.colour})` };
  if (curve.kind === "line") group.append(svg("path", { ...own, d: pieces(points), "stroke-dasharray":
    curve.dash.join(" ") }));
  else if (curve.kind === "band") group.append(svg("path", { ...own, d: `${line(finite(points))}Z` }));
  else if (curve.kind === "dots") group.append(svg("path", { ...own, d: dots(finite(points)) }));
  else group.append(svg("path", { ...own, d: finite(points).map((one) => mark(curve.kind, one)).join("") }));
}

function at(curve: Curve, x: Scale, y: Scale): [number, number][] {
  return Array.from(curve.x.data, (value, k) => [x.at(value), y.at(curve.y.data[k])]);
}

function finite(points: [number, number][]): [number, number][] {
  return points.filter(([left, top]) => Number.isFinite(left) && Number.isFinite(top));
}

/** A line that has gaps where there is no number. */
function pieces(points: [number, number][]): string {
  const parts: [number, number][][] = [[]];
  for (const [left, top] of points) {
    if (Number.isFinite(left) && Number.isFinite(top)) parts[parts.length - 1].push([left, top]);
    else parts.push([]);
  }
  return parts.map(line).join("");
}

function mark(kind: Curve["kind"], [x, y]: [number, number], r = 4.5): string {
  switch (kind) {
    case "square": return `M${x - r} ${y - r}h${2 * r}v${2 * r}h${-2 * r}Z`;
    case "triangle": return `M${x} ${y - r - 1}l${r + 1} ${2 * r}h${-2 * r - 2}Z`;
    case "cross": return `M${x - r} ${y - r}l${2 * r} ${2 * r}M${x - r} ${y + r}l${2 * r} ${-2 * r}`;
    default: return `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
  }
}

function legend(names: string[], curves: Curve[], hidden: Set<string>, redraw: () => void): HTMLElement {
  return make("div", { class: "plot-legend", role: "group", "aria-label": "Curves" }, ...names.map((name) => {
    const own = curves.filter((curve) => curve.name === name);
    const first = own.find(({ kind }) => kind !== "band") ?? own[0];
    const button = make("button", { type: "button", "aria-pressed": "true" }, key(first),
      make("span", { text: name }));
    button.addEventListener("click", () => {
      if (!hidden.delete(name)) hidden.add(name);
      button.setAttribute("aria-pressed", String(!hidden.has(name)));
      redraw();
    });
    return button;
  }));
}

function key({ kind, colour, dash }: Curve): SVGSVGElement {
  if (kind === "line") return swatch(`var(--${colour})`, dash);
  const own = { class: `curve ${kind}`, style: `--own: var(--${colour})` };
  const shape = kind === "band" ? "M1 1h24v8h-24Z" : kind === "dots" ? dots([[7, 5], [13, 4], [19, 6]]) :
    mark(kind, [13, 5], 3.5);
  return svg("svg", { width: 26, height: 10, "aria-hidden": "true" }, svg("path", { ...own, d: shape }));
}

function hover(area: HTMLElement, plot: Plot, place: () => Place | null, shown: () => Curve[]): void {
  const words = make("div", { class: "hover", hidden: true });
  area.append(words);
  area.onpointermove = (event) => {
    const [frame, own] = [area.getBoundingClientRect(), place()];
    const found = own && nearest(shown(), own, event.clientX - frame.left, event.clientY - frame.top);
    words.hidden = !found;
    if (!found) return;
    const { curve, k, spot } = found;
    const shownAt = (key: "x" | "y") => {
      const value = curve[key].data[k];
      const { names, label } = plot[key];
      return names ? names[Math.round(value)] : `${label}: ${plain(Number(value.toPrecision(5)))}`;
    };
    words.replaceChildren(...[curve.name, shownAt("y"), shownAt("x")].filter(Boolean).map((text) => make("div",
      { text })));
    words.style.top = `${spot[1] + 10}px`;
    const left = spot[0] > area.clientWidth / 2;
    [words.style.left, words.style.right] = left ? ["", `${area.clientWidth - spot[0] + 10}px`] :
      [`${spot[0] + 10}px`, ""];
  };
  area.onpointerleave = () => (words.hidden = true);
}

function nearest(curves: Curve[], { x, y }: Place, left: number, top: number):
  { curve: Curve; k: number; spot: [number, number] } | null {
  let [best, least]: [{ curve: Curve; k: number; spot: [number, number] } | null, number] = [null, NEAR];
  for (const curve of curves) {
    if (curve.kind === "band") continue;
    at(curve, x, y).forEach((spot, k) => {
      const apart = Math.hypot(spot[0] - left, spot[1] - top);
      if (apart < least) [best, least] = [{ curve, k, spot }, apart];
    });
  }
  return best;
}
