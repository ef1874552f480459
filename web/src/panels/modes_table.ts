// The table of the modes: its rows stay when other numbers come, and with them the place of the keyboard.

import type { Mode } from "../contract";
import { button, make, put } from "../dom";
import { digits } from "../format";

export interface ModesTable {
  readonly element: HTMLElement;
  /** `before`: those of the run as it was, by their places; null: these are they. `shown`: the one that swings. */
  tell(modes: Mode[], before: Mode[] | null, shown: Mode | null): void;
  /** Puts the keyboard on the button of a place; on the table where there is none. */
  focus(place: number): void;
}

interface Row {
  readonly element: HTMLElement;
  readonly button: HTMLButtonElement;
  tell(mode: Mode, before: Mode | null | undefined, shown: boolean): void;
}

/** `pressed` hears of which mode the button was pressed. */
export function makeModesTable(pressed: (mode: Mode) => void): ModesTable {
  const head = ["Frequency [Hz]", "Damping [%]", "Dominant element", ""].map((text) =>
    make(text ? "th" : "td", text ? { scope: "col", text, class: text.endsWith("]") ? "number" : "" } : {}),
  );
  const body = make("tbody");
  const element = make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Modes" },
    make("table", {}, make("thead", {}, make("tr", {}, ...head)), body));
  const rows: Row[] = [];
  const focus = (place: number) => (rows[Math.min(place, rows.length - 1)]?.button ?? element).focus();

  function adjust(count: number): void {
    while (rows.length < count) {
      const row = makeRow(pressed);
      rows.push(row);
      body.append(row.element);
    }
    const gone = rows.splice(count);
    const held = gone.some((row) => row.button === document.activeElement);
    for (const row of gone) row.element.remove();
    if (held) focus(count);
  }

  return {
    element,
    tell(modes, before, shown) {
      adjust(modes.length);
      modes.forEach((mode, k) => rows[k].tell(mode, before && before[k], mode === shown));
    },
    focus,
  };
}

function makeRow(pressed: (mode: Mode) => void): Row {
  let own: Mode | null = null;
  const [frequency, damping, where] = [number(), number(), make("td")];
  const showIt = button("", () => own && pressed(own));
  return {
    element: make("tr", {}, frequency.element, damping.element, where, make("td", {}, showIt)),
    button: showIt,
    tell(mode, before, shown) {
      own = mode;
      const was = (info: (mode: Mode) => string) => (before === null ? "" : before ? info(before) : "–");
      const percent = (one: Mode) => digits(100 * one.damping, 3);
      frequency.tell(digits(mode.frequency), was((one) => digits(one.frequency)));
      damping.tell(percent(mode), was(percent));
      put(where, mode.element);
      put(showIt, shown ? "stop" : "show");
      showIt.setAttribute("aria-pressed", String(shown));
      const label = shown ? "Stop showing the mode" : `Show the mode of ${digits(mode.frequency)} Hz in 3D`;
      showIt.setAttribute("aria-label", label);
    },
  };
}

/** A number with that of the run as it was, where it is another. */
function number(): { element: HTMLElement; tell(text: string, was: string): void } {
  const [value, before] = [make("span"), make("span", { class: "was", hidden: true })];
  return {
    element: make("td", { class: "number" }, value, before),
    tell(text, was) {
      put(value, text);
      before.hidden = !was || was === text;
      put(before, before.hidden ? "" : `was ${was}`);
    },
  };
}
