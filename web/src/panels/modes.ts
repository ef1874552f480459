// The modes of small vibration: frequency, damping, where they live, and a button that shows each in 3D.

import type { Clock } from "../clock";
import type { Mode, Page, SceneView } from "../contract";
import { button, make, ownId } from "../dom";
import { digits } from "../format";

const CASES: Record<string, string> = { controlled: "under control", locked: "motors held", free: "motors free" };
const LARGEST = 0.12; // of the robot's size

export function mountModes(element: HTMLElement, page: Page, scene: SceneView, clock: Clock): { dispose(): void } {
  const modes = page.runs[0].modes;
  const cases = [...new Set(modes.map((mode) => mode.case))];
  let shown: Mode | null = null;
  let share = LARGEST;
  const table = make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Modes" });
  const name = ownId("case");
  const choice = make("select", { id: name }, ...cases.map((one) => make("option", { value: one, text: CASES[one] ?? one })));
  choice.addEventListener("change", () => fill(choice.value));
  const size = make("input", { type: "range", min: "0.02", max: "0.3", step: "0.01", value: String(share), id: ownId("size") });
  size.addEventListener("input", () => {
    share = Number(size.value);
    if (shown) scene.showMode(shown, share);
  });
  const back = button("back to the motion", () => show(null), { hidden: true });

  function show(mode: Mode | null): void {
    shown = mode;
    if (mode) clock.pause();
    scene.showMode(mode, share);
    back.hidden = mode === null;
    fill(choice.value);
  }

  function fill(which: string): void {
    const head = ["Frequency [Hz]", "Damping [%]", "Lives in", ""].map((text) => make(text ? "th" : "td", text ? { scope: "col", text } : {}));
    const rows = modes.filter((mode) => mode.case === which).map((mode) => {
      const label = `Show the mode of ${digits(mode.frequency)} Hz in 3D`;
      const showIt = button(mode === shown ? "stop" : "show", () => show(mode === shown ? null : mode), { "aria-pressed": String(mode === shown), "aria-label": mode === shown ? "Stop showing the mode" : label });
      return make("tr", {}, make("td", { class: "number", text: digits(mode.frequency) }), make("td", { class: "number", text: digits(100 * mode.damping, 3) }),
        make("td", { text: mode.livesIn }), make("td", {}, showIt));
    });
    table.replaceChildren(make("table", {}, make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...rows)));
  }

  const bar = make("div", { class: "bar" }, make("label", { for: name, text: "Modes" }), choice, make("label", { for: size.id, text: "amplitude" }), size, back);
  element.append(bar, table);
  fill(cases[0] ?? "");
  // who moves the time wants to see the motion
  const end = clock.subscribe((now) => { if (now.playing && shown) show(null); });
  return {
    dispose() {
      end();
      element.replaceChildren();
    },
  };
}
