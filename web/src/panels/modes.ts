// The modes of small vibration: frequency, damping, where they live, and a button that shows each in 3D.

import type { Clock } from "../clock";
import type { Mode, Page } from "../contract";
import type { LiveRun, SceneView } from "../contract_parts";
import { button, make, ownId, put } from "../dom";
import { isEarly, patience } from "./early";
import { makeModesTable } from "./modes_table";

const CASES: Record<string, string> = { controlled: "under control", locked: "motors held", free: "motors free" };
const LARGEST = 0.12; // of the robot's size

export interface ModesView {
  /**
   * Modes of the live model's run, those of the page next to them; null: the page's own alone. Shown ones stay
   * until a run reports its own.
   */
  show(live: LiveRun | null): void;
  dispose(): void;
}

export function mountModes(element: HTMLElement, page: Page, scene: SceneView, clock: Clock): ModesView {
  const own = page.runs[0].modes;
  const cases = [...new Set(own.map((mode) => mode.case))];
  let modes = own;
  let shown: Mode | null = null;
  let share = LARGEST;
  const table = makeModesTable((mode) => show(mode === shown ? null : mode));
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
  const back = button("back to the motion", () => {
    const place = placeOf(shown);
    show(null);
    table.focus(place); // the button itself is gone now
  }, { hidden: true });

  const note = make("p", { class: "note", hidden: true, role: "status" });
  const late = patience(() => {
    const which = modes === own ? "run as it was" : "setting before";
    say(`These are the modes of the ${which}; the new ones are being found.`);
  });

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

  const of = (some: Mode[], which: string) => some.filter((mode) => mode.case === which);
  const placeOf = (mode: Mode | null) => (mode ? of(modes, mode.case).indexOf(mode) : -1);

  function fill(which: string): void {
    table.tell(of(modes, which), modes === own ? null : of(own, which), shown);
  }

  function say(text: string): void {
    put(note, text);
    note.hidden = !text;
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
  element.append(bar, note, table.element);
  fill(cases[0] ?? "");
  // who moves the time wants to see the motion
  const end = clock.subscribe((now) => { if (now.playing && shown) show(null); });
  return {
    show(live) {
      if (isEarly(live)) return late.begin();
      late.end();
      const found = live?.vibration;
      const place = placeOf(shown);
      modes = typeof found === "object" ? found.modes : own;
      say(found === undefined ? "" : words(found));
      // the mode that swings continues as it is now
      const now = shown && (of(modes, shown.case)[place] ?? null);
      if (shown && now !== shown) swing(now);
      else fill(choice.value);
    },
    dispose() {
      end();
      late.end();
      element.replaceChildren();
    },
  };
}

function words(found: NonNullable<LiveRun["vibration"]>): string {
  return typeof found === "string"
    ? `These are the modes of the run as it was: ${found}.`
    : "About the rest with the changed numbers; under each number what it was.";
}
