// The controls above the picture: what colours the links, how much elasticity is enlarged, where one looks from.
import { menu } from "../dom";
import { VIEWS, type View } from "./cameras";
import { TOGGLES, type Settings } from "./settings";

const VIEW_NAMES: Record<View, string> = {
  iso: "Oblique",
  front: "Front",
  side: "Side",
  top: "Top",
  tip: "Tip (follows)",
};

const SLIDER_STEPS = 100;

export interface Wishes {
  changed(): void;
  look(view: View): void;
  quality(): void;
}

/** A new element of a tag with properties and children; text stays text. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag, properties: Partial<HTMLElementTagNameMap[Tag]> = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  Object.assign(element, properties);
  element.append(...children);
  return element;
} // prettier-ignore

/**
 * `colours`: ids and labels of what may colour the links; `toggles`: which things may be shown or not; `most`:
 * how many times deformations may be enlarged, 1: not at all; `fine`: there are qualities to choose from.
 */
export function makeControls(
  settings: Settings,
  colours: [string, string][],
  toggles: (keyof Settings)[],
  most: number,
  fine: boolean,
  wishes: Wishes,
): HTMLElement {
  const bar = make("div", { className: "scene-bar", role: "toolbar", ariaLabel: "The robot in space" });
  const colour = chooser("Colour", colours, settings.colour, (id) => {
    settings.colour = id;
    wishes.changed();
  });
  bar.append(make("label", {}, name("Colour"), colour));
  if (most > 1) bar.append(factorSlider(settings, most, wishes));
  const view = chooser(
    "View",
    VIEWS.map((id) => [id, VIEW_NAMES[id]]),
    "iso",
    (id) => wishes.look(id as View),
  );
  bar.append(make("label", {}, name("View"), view));
  const reset = make("button", { type: "button", ariaLabel: "Reset view" }, "Reset");
  const again = () => wishes.look(view.value as View);
  reset.addEventListener("click", again);
  bar.append(reset, more(settings, toggles, fine, wishes, again));
  return bar;
} // prettier-ignore

function factorSlider(settings: Settings, most: number, wishes: Wishes): HTMLElement {
  const slider = make("input", {
    type: "range",
    min: "0",
    max: String(SLIDER_STEPS),
    step: "1",
    value: String(Math.round((SLIDER_STEPS * Math.log(settings.factor)) / Math.log(most))),
    ariaLabel: "Deformation",
  });
  const info = make("output", {}, `×${settings.factor}`);
  slider.dataset.scene = "factor";
  slider.addEventListener("input", () => {
    settings.factor = rounded(most ** (Number(slider.value) / SLIDER_STEPS));
    info.textContent = slider.ariaValueText = `×${settings.factor}`;
    wishes.changed();
  });
  slider.title =
    "How many times the displacement of each robot from itself without elasticity is enlarged; double click: to scale";
  slider.addEventListener("dblclick", () => {
    slider.value = "0";
    slider.dispatchEvent(new Event("input"));
  });
  return make("label", { className: "scene-factor-row" }, "Deformation", slider, info);
}

/** A name that goes where there is no room for it: what it names reports the same. */
function name(text: string): HTMLElement {
  return make("span", { className: "scene-name" }, text);
}

function rounded(factor: number): number {
  return factor < 10 ? Math.round(10 * factor) / 10 : Math.round(factor);
}

function more(
  settings: Settings, toggles: (keyof Settings)[], fine: boolean, wishes: Wishes, again: () => void,
): HTMLElement {
  const items: HTMLElement[] = [];
  for (const [key, label] of TOGGLES) {
    if (!toggles.includes(key)) continue;
    const box = make("input", { type: "checkbox", checked: settings[key] });
    box.dataset.scene = key;
    box.addEventListener("change", () => {
      settings[key] = box.checked;
      wishes.changed();
      if (key === "apart") again();
    });
    items.push(make("label", {}, box, label));
  }
  if (fine) items.push(make("label", {}, "Quality", qualities(settings, wishes)));
  return menu("Show", ...items);
}

function qualities(settings: Settings, wishes: Wishes): HTMLSelectElement {
  const known: [string, string][] = [["auto", "automatic"], ["low", "low"], ["high", "high"], ["lines", "lines alone"]];
  return chooser("Quality", known, settings.quality, (id) => {
    settings.quality = id as Settings["quality"];
    wishes.quality();
  });
}

function chooser(
  ariaLabel: string,
  options: [string, string][],
  chosen: string,
  changed: (id: string) => void,
): HTMLSelectElement {
  const select = make(
    "select",
    { ariaLabel },
    ...options.map(([value, label]) => make("option", { value, textContent: label })),
  );
  select.value = chosen;
  select.addEventListener("change", () => changed(select.value));
  return select;
}
