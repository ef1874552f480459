// Charts of a study as vector graphics: a frame with axes, and what is drawn in it; each can be saved as it is.
import { button, make, ownId, save } from "../dom";
import { pretty } from "../format";
import type { Scale } from "./scale";

const SPACE = "http://www.w3.org/2000/svg";
const EDGE = 13; // right of the axes, for the last number [px]
type Given = Record<string, string | number | undefined>;

/** An element of a vector graphic. */
export function svg<K extends keyof SVGElementTagNameMap>(
  name: K, given: Given = {}, ...children: (Node | string)[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SPACE, name);
  for (const [key, value] of Object.entries(given)) if (value !== undefined) element.setAttribute(key, String(value));
  element.append(...children);
  return element;
}

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** `name [unit]`. */
export function named({ title, name, unit }: { title?: string; name: string; unit: string }): string {
  const written = pretty(unit);
  return `${title || name}${written ? ` [${written}]` : ""}`;
}

/** A place for a chart: its title, a button that saves it, and `draw`, called again whenever its size changes. */
export function chart(
  host: HTMLElement, title: string, height: number, draw: (root: SVGSVGElement, width: number, height: number) => void,
  note = "",
): { redraw(): void; element: HTMLElement } {
  const id = ownId("chart");
  const area = make("div", { class: "study-area" });
  const root = svg("svg", { role: "img", "aria-labelledby": id, width: "100%", height });
  area.append(root);
  const head = make("h3", { text: title, id });
  const tools = make("span", { class: "tools" },
    button("SVG", () => save(standing(root), `${title.replace(/[^\w-]+/g, "_")}.svg`, "image/svg+xml"),
      { class: "tool", "aria-label": `Save ${title} as SVG` }));
  const element = make("figure", { class: "chart" }, make("figcaption", {}, head, tools), area,
    note ? make("p", { class: "note", text: note }) : null);
  host.append(element);
  let last = 0;
  const redraw = () => {
    const width = area.clientWidth || 600;
    root.setAttribute("viewBox", `0 0 ${width} ${height}`);
    root.replaceChildren();
    draw(root, width, height);
  };
  new ResizeObserver(() => {
    if (area.clientWidth === last) return;
    last = area.clientWidth;
    redraw();
  }).observe(area);
  return { redraw, element };
}

/** Width at the left [px] for the numbers of an ordinate and, left of them, what it measures. */
export function gutter(y: Scale): number {
  return 28 + 7.4 * Math.max(2, ...y.ticks.map(([, word]) => word.length));
}

/** Axes with their words; `x` or `y` may be left out. */
export function axes(root: SVGSVGElement, box: Box, x: Scale | null, y: Scale | null, words: [string, string]): void {
  const group = svg("g", { class: "axes" });
  for (const [value, word] of y?.ticks ?? []) {
    const at = y?.at(value) ?? 0;
    group.append(svg("path", { d: `M${box.left} ${at}H${box.right}`, class: "grid" }),
      svg("text", { x: box.left - 6, y: at + 4, "text-anchor": "end" }, word));
  }
  const ticks = x ? spaced(x) : [];
  for (const [value, word] of ticks) {
    const at = x?.at(value) ?? 0;
    group.append(svg("path", { d: `M${at} ${box.top}V${box.bottom}`, class: "grid" }),
      svg("text", { x: Math.min(at, box.right + EDGE - 3.6 * word.length), y: box.bottom + 16,
        "text-anchor": "middle" }, word));
  }
  group.append(svg("path", { d: `M${box.left} ${box.top}V${box.bottom}H${box.right}`, class: "edge" }),
    svg("text", { x: (box.left + box.right) / 2, y: box.bottom + 33, "text-anchor": "middle", class: "name" },
      words[0]),
    svg("text", { x: 12, y: (box.top + box.bottom) / 2, "text-anchor": "middle", class: "name",
      transform: `rotate(-90 12 ${(box.top + box.bottom) / 2})` }, words[1]));
  root.append(group);
}

/** Ticks whose words do not touch. */
function spaced(x: Scale): [number, string][] {
  let last = -Infinity;
  return x.ticks.filter(([value, word]) => {
    const [at, half] = [x.at(value), 3.6 * word.length + 3];
    if (at - half < last) return false;
    last = at + half;
    return true;
  });
}

/** All points as one path of dots. */
export function dots(points: [number, number][]): string {
  return points.map(([x, y]) => `M${x.toFixed(1)} ${y.toFixed(1)}h0`).join("");
}

/** All points as one path of small crosses. */
export function crosses(points: [number, number][], half = 3): string {
  return points.map(([x, y]) => [1, -1].map((way) =>
    `M${(x - half).toFixed(1)} ${(y - way * half).toFixed(1)}l${2 * half} ${2 * way * half}`).join("")).join("");
}

export function line(points: [number, number][]): string {
  return points.length ? `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}` : "";
}

const KEPT = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "opacity", "font-size",
  "font-weight", "paint-order"];

/** The graphic by itself, with the colours that it has in the page. */
function standing(root: SVGSVGElement): string {
  const copy = root.cloneNode(true) as SVGSVGElement;
  const [own, copied] = [root.querySelectorAll("*"), copy.querySelectorAll("*")];
  own.forEach((element, k) => {
    const look = getComputedStyle(element);
    for (const key of KEPT) copied[k].setAttribute(key, look.getPropertyValue(key));
    copied[k].removeAttribute("class");
  });
  const { width, height } = root.getBoundingClientRect();
  for (const [key, value] of Object.entries({ xmlns: SPACE, width, height, "font-family": "system-ui, sans-serif" }))
    copy.setAttribute(key, String(value));
  const paper = getComputedStyle(document.body).backgroundColor;
  copy.prepend(svg("rect", { width: "100%", height: "100%", fill: paper }));
  return new XMLSerializer().serializeToString(copy);
}
