// What is written over the picture: the legend, the colour scale with its unit, the enlargement, the grid.
import { bound } from "../format";
import { make } from "./controls";
import { gradient } from "./palette";
import { roomsBetween, type Rooms } from "./room";
import { digits, readable } from "./units";

const TICKS = 5;

export interface Entry {
  colour: string;
  label: string;
}

export class Notes {
  private readonly legend = note("scene-legend");
  private readonly scale = note("scene-scale");
  private readonly factor = note("scene-factor");
  private readonly grid = note("scene-grid");
  private readonly way = note("scene-flat");
  private readonly axes = make("div", { className: "scene-axes" });
  private readonly live = make("span");
  private shown = "";

  constructor(private readonly place: HTMLElement) {
    const below = make("div", { className: "scene-below" }, this.axes, this.grid, this.way);
    place.append(this.legend, this.scale, make("div", { className: "scene-foot" }, below, this.factor));
  }

  /** What the notes leave free of the picture, whatever number the line that changes now shows. */
  rooms(): Rooms {
    this.live.textContent = this.shown.replace(/[\d.]+(?=\sN[, ])/g, "88.8");
    const notes = [this.legend, this.scale, this.factor, this.way, this.grid, this.axes];
    const [place, ...boxes] = [this.place, ...notes].map((element) => element.getBoundingClientRect());
    this.live.textContent = this.shown;
    return roomsBetween(place, boxes);
  }

  /** The room for the axes of the world. */
  get corner(): DOMRect {
    return this.axes.getBoundingClientRect();
  }

  /** Which notes there are, and all of their words on which their size depends. */
  get kinds(): string {
    const fixed = this.legend.textContent.slice(0, this.legend.textContent.length - this.live.textContent.length);
    const there = [this.live.isConnected, this.scale.hidden, this.scale.firstChild?.textContent, this.factor.hidden];
    return [fixed, ...there, this.way.textContent, this.grid.textContent].join("|");
  }

  /** The entries of the legend, and a line whose words change with time. */
  list(entries: Entry[], changing: boolean): void {
    this.legend.replaceChildren(...entries.map(({ colour, label }) => make("span", {}, swatch(colour), label)));
    if (changing) this.legend.append(this.live);
    this.legend.hidden = entries.length === 0 && !changing;
  }

  /** The line of the legend that changes with time. */
  tell(words: string): void {
    if (bound(words) === this.shown) return;
    this.shown = bound(words);
    this.live.textContent = this.shown;
  }

  /** The colours' range, in the quantity's unit; null: nothing is coloured by a quantity. */
  range(info: { label: string; unit: string; low: number; high: number } | null): void {
    this.scale.hidden = info === null;
    if (info === null) return;
    const unit = readable(info.unit, info.high);
    const low = Math.abs(info.low) < 1e-6 * Math.abs(info.high) ? 0 : info.low; // what rounding leaves is nothing
    const ticks = Array.from({ length: TICKS }, (_, k) => low + ((info.high - low) * k) / (TICKS - 1));
    const bar = swatch(gradient());
    const name = unit.name.replaceAll(" ", "\u00a0");
    const title = make("b", {}, name ? `${info.label} [${name}]` : info.label);
    this.scale.replaceChildren(
      title,
      bar,
      make("ol", {}, ...ticks.map((tick) => make("li", {}, digits(unit.factor * tick)))),
    );
  }

  enlarged(words: string): void {
    this.factor.hidden = words === "";
    this.factor.textContent = words;
  }

  /** How it is drawn, where that is not as usual. */
  flat(words: string): void {
    this.way.hidden = words === "";
    this.way.textContent = words;
  }

  floor(words: string): void {
    this.grid.hidden = words === "";
    this.grid.textContent = bound(words);
  }
}

function note(kind: string): HTMLElement {
  return make("div", { className: `scene-note ${kind}`, hidden: true });
}

function swatch(background: string): HTMLElement {
  const found = make("i", { ariaHidden: "true" });
  found.style.background = background;
  return found;
}
