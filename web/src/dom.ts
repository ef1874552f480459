// Elements made in one line: text stays text, whatever it holds; its numbers stay with their units.

import { bound } from "./format";

type Attributes = Record<string, string | boolean | undefined>;

/** One element with attributes (`text` is its text, `false` and undefined are left out) and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  name: K,
  attributes: Attributes = {},
  ...children: (Node | null)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === "text") element.textContent = name === "code" ? String(value) : bound(String(value));
    else if (value !== undefined && value !== false) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

export function button(text: string, act: () => void, attributes: Attributes = {}): HTMLButtonElement {
  const element = make("button", { type: "button", text, ...attributes });
  element.addEventListener("click", act);
  return element;
}

const EDGE = 8; // px between a menu and the edges of the window

/** A button that opens a panel under it, inside the window, which a click elsewhere or Escape closes. */
export function menu(text: string, ...items: Node[]): HTMLElement {
  const id = ownId("menu");
  const opener = make("button", { type: "button", class: "menu-button", text, popovertarget: id });
  const panel = make("div", { id, class: "menu-panel", popover: "auto", role: "group", "aria-label": text }, ...items);
  const place = () => {
    const { left, top, bottom } = opener.getBoundingClientRect();
    const { width, height } = panel.getBoundingClientRect();
    const { clientWidth, clientHeight } = document.documentElement;
    const below = bottom + height + 2 * EDGE < clientHeight;
    panel.style.left = `${Math.max(EDGE, Math.min(left, clientWidth - width - EDGE))}px`;
    panel.style.top = `${below ? bottom + EDGE / 2 : Math.max(EDGE, top - height - EDGE / 2)}px`;
  };
  panel.addEventListener("beforetoggle", (event) => {
    const opens = event.newState === "open";
    if (opens) requestAnimationFrame(place); // it has no size before it is open
    for (const kind of ["scroll", "resize"])
      window[opens ? "addEventListener" : "removeEventListener"](kind, place, { capture: true });
  });
  return make("span", { class: "menu" }, opener, panel);
}

/** Write a text where it is not there yet: what stays the same is not laid out again. */
export function put(element: HTMLElement, text: string): void {
  const shown = bound(text);
  if (element.textContent !== shown) element.textContent = shown;
}

/** A line as a curve is drawn, for a legend. */
export function swatch(color: string, dash: number[], width = 2): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  const line = document.createElementNS(space, "line");
  const info = { x1: 0, y1: 5, x2: 26, y2: 5, "stroke-width": width, "stroke-dasharray": dash.join(" ") };
  for (const [key, value] of Object.entries(info)) line.setAttribute(key, String(value));
  line.style.stroke = color;
  for (const [key, value] of Object.entries({ width: 26, height: 10, "aria-hidden": "true" }))
    svg.setAttribute(key, String(value));
  svg.append(line);
  return svg;
}

let info = 0;
/** A name that no other element of the page has. */
export function ownId(stem: string): string {
  info += 1;
  return `tm-${stem}-${info}`;
}

/** Give the user a picture as a PNG file. */
export function savePicture(canvas: HTMLCanvasElement, name: string): void {
  canvas.toBlob((blob) => blob && save(blob, `${name}.png`, "image/png"), "image/png");
}

/** Give the user a file. */
export function save(content: string | Blob, name: string, type: string): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
