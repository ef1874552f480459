// The legend of a chart: curves by colour and dash, switched by buttons, with the values at the cursor.

import { make, put, swatch } from "../dom";
import { plain } from "../format";
import { lookOf, type Look } from "./look";
import type { Entry } from "./series";

export interface Legend {
  readonly element: HTMLElement;
  shows(entry: Entry): boolean;
  look(entry: Entry): Look;
  /** Values at the cursor by entry; null where there is none. */
  tell(values: (entry: Entry) => number | null): void;
  /** Other values of the same curves; the switches stay. */
  renew(entries: Entry[]): void;
}

type Key = (entry: Entry) => string;

/**
 * `changed` is called after a switch. What is switched: runs, labels, roles, each where there are several of them.
 * `compared`: the page has several runs, whose colours tell them apart, also where only one has this chart.
 */
export function makeLegend(entries: Entry[], compared: boolean, unit: string, changed: () => void): Legend {
  let own = entries.filter((entry) => !entry.ghost);
  const keys: Key[] = [(entry) => String(entry.run), (entry) => entry.label, (entry) => entry.role];
  const kinds = keys.map((key) => [...new Set(own.map(key))]);
  const off = keys.map(
    (key, k) => new Set(kinds[k].filter((kind) => !own.some((entry) => entry.shown && key(entry) === kind))),
  );
  const byColour = compared ? 0 : kinds[1].length > 1 ? 1 : 2;
  const dashed = kinds[2].length;
  const look = (entry: Entry) => {
    if (byColour > 0) return { property: `--${entry.colour}`, dash: entry.dash };
    const dash = dashed > 1 ? entry.dash : lookOf(kinds[1].length > 1 ? kinds[1].indexOf(entry.label) : entry.run).dash;
    return { ...lookOf(entry.run), dash };
  };
  const element = make("div", { class: "legend" });
  const values = new Map<string, HTMLElement>();
  keys.forEach((key, k) => {
    if (kinds[k].length < 2 && !(k === byColour)) return;
    const row = make("div", { class: "legend-row", role: "group", "aria-label": ["Runs", "Curves", "Parts"][k] });
    for (const kind of kinds[k]) {
      const one = own.find((entry) => key(entry) === kind);
      if (one) row.append(toggle(one, kind, k));
    }
    element.append(row);
  });
  function toggle(first: Entry, kind: string, k: number): HTMLElement {
    const words = k === 0 ? first.runName : k === 2 && dashed > 1 ? first.part : first.label;
    const drawn = k === byColour ? look(first) : { property: "--quiet", dash: k === 2 ? look(first).dash : [] };
    const sample = swatch(`var(${drawn.property})`, k === byColour && byColour < 2 && dashed > 1 ? [] : drawn.dash);
    const value = make("span", { class: "value" });
    const element = make(
      "button",
      { type: "button", class: "toggle", "aria-pressed": String(!off[k].has(kind)) },
      sample,
      make("span", { text: words }),
      value,
    );
    if (k === byColour) values.set(kind, value);
    element.addEventListener("click", () => {
      if (!off[k].delete(kind)) off[k].add(kind);
      element.setAttribute("aria-pressed", String(!off[k].has(kind)));
      changed();
    });
    return element;
  }
  return {
    element,
    look,
    renew(others) {
      own = others.filter((entry) => !entry.ghost);
    },
    shows: (entry) => keys.every((key, k) => !off[k].has(key(entry))),
    tell(valueOf) {
      for (const [kind, place] of values) {
        const entry = own.find((one) => keys[byColour](one) === kind && keys.every((key, k) => !off[k].has(key(one))));
        const value = entry ? valueOf(entry) : null;
        put(place, value === null ? "" : `${plain(value).replace("-", "−")} ${unit}`);
      }
    },
  };
}
