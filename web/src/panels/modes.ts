// The modes of small vibration: frequency, damping, where they live, and a button that shows each in 3D.

import type { Clock } from "../clock";
import type { Mode, Page } from "../contract";
import type { LiveRun, SceneView } from "../contract_parts";
import { button, make, ownId } from "../dom";
import { digits } from "../format";

const CASES: Record<string, string> = { controlled: "under control", locked: "motors held", free: "motors free" };
const LARGEST = 0.12; // of the robot's size

export interface ModesView {
  /** Modes of the live model's run, those of the page beside them; null: the page's own alone. */
  show(live: LiveRun | null): void;
  dispose(): void;
}

export function mountModes(element: HTMLElement, page: Page, scene: SceneView, clock: Clock): ModesView {
  const own = page.runs[0].modes;
  const cases = [...new Set(own.map((mode) => mode.case))];
  let modes = own;
  let shown: Mode | null = null;
  let share = LARGEST;
  const table = make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Modes" });
  const name = ownId("case");
  const choice = make(
    "select",
    { id: name },
    ...cases.map((one) => make("option", { value: one, text: CASES[one] ?? one })),
  );
  choice.addEventListener("change", () => fill(choice.value));
  const size = make("input", {
    type: "range",
    min: "0.02",
    max: "0.3",
    step: "0.01",
    value: String(share),
    id: ownId("size"),
  });
  size.addEventListener("input", () => {
    share = Number(size.value);
    if (shown) scene.showMode(shown, share);
  });
  const back = button("back to the motion", () => show(null), { hidden: true });

  const note = make("p", { class: "note", hidden: true, role: "status" });

  function show(mode: Mode | null): void {
    if (mode) clock.pause();
    swing(mode);
  }

  function swing(mode: Mode | null): void {
    shown = mode;
    scene.showMode(mode, share);
    back.hidden = mode === null;
    fill(choice.value);
  }

  function fill(which: string): void {
    const was = (k: number, told: (mode: Mode) => string) => (modes === own ? "" : before[k] ? told(before[k]) : "–");
    const head = ["Frequency [Hz]", "Damping [%]", "Lives in", ""].map((text) =>
      make(text ? "th" : "td", text ? { scope: "col", text } : {}),
    );
    const before = own.filter((mode) => mode.case === which);
    const rows = modes.filter((mode) => mode.case === which).map((mode, k) => {
      const label = `Show the mode of ${digits(mode.frequency)} Hz in 3D`;
      const showIt = button(mode === shown ? "stop" : "show", () => show(mode === shown ? null : mode), {
        "aria-pressed": String(mode === shown),
        "aria-label": mode === shown ? "Stop showing the mode" : label,
      });
      return make(
        "tr",
        {},
        number(
          digits(mode.frequency),
          was(k, (one) => digits(one.frequency)),
        ),
        number(
          digits(100 * mode.damping, 3),
          was(k, (one) => digits(100 * one.damping, 3)),
        ),
        make("td", { text: mode.livesIn }),
        make("td", {}, showIt),
      );
    });
    table.replaceChildren(make("table", {}, make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...rows)));
  }

  const bar = make(
    "div",
    { class: "bar" },
    make("label", { for: name, text: "Modes" }),
    choice,
    make("label", { for: size.id, text: "amplitude" }),
    size,
    back,
  );
  element.append(bar, note, table);
  fill(cases[0] ?? "");
  // who moves the time wants to see the motion
  const end = clock.subscribe((now) => { if (now.playing && shown) show(null); });
  return {
    show(live) {
      const found = live?.vibration;
      const [which, place] = shown
        ? [shown.case, modes.filter((mode) => mode.case === shown!.case).indexOf(shown)]
        : ["", -1];
      modes = typeof found === "object" ? found.modes : own;
      note.textContent = live ? words(found) : "";
      note.hidden = !note.textContent;
      // the mode that swings goes on as it is now
      const now = modes.filter((mode) => mode.case === which)[place] ?? null;
      if (shown && now !== shown) swing(now);
      else fill(choice.value);
    },
    dispose() {
      end();
      element.replaceChildren();
    },
  };
}

/** A number with that of the run as it was, where it is another. */
function number(text: string, was: string): HTMLElement {
  const cell = make("td", { class: "number", text });
  if (was && was !== text) cell.append(make("span", { class: "was", text: `was ${was}` }));
  return cell;
}

function words(found: LiveRun["vibration"]): string {
  if (found === undefined) return "These are the modes of the run as it was; the new ones are being found.";
  return typeof found === "string"
    ? `These are the modes of the run as it was: ${found}.`
    : "About the rest with the changed numbers; under each number what it was.";
}
