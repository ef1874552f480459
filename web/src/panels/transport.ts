// The time bar: play and pause, scrub, speed, the time shown; space and arrow keys wherever nothing else wants them.

import type { Clock } from "../clock";
import type { RunEvent } from "../contract";
import { button, make, ownId } from "../dom";
import { digits } from "../format";

const SPEEDS = [0.05, 0.1, 0.2, 0.5, 1, 2];
const STEPS = 1000;
const ARROW = 1 / 200;
const TOGETHER = 0.012; // of the bar: marks that would lie on each other are one

export interface TransportView {
  /** Other moments to mark, and other times of the samples that one steps by. */
  show(events: RunEvent[], samples: ArrayLike<number>): void;
  dispose(): void;
}

export function mountTransport(element: HTMLElement, clock: Clock): TransportView {
  let samples: ArrayLike<number> = [];
  const play = button("", () => clock.toggle(), { class: "play" });
  const marks = make("div", { class: "time-marks" });
  const loop = button("loop", () => {
    clock.loop = !clock.loop;
    loop.setAttribute("aria-pressed", String(clock.loop));
  }, { class: "loop", "aria-pressed": "true", title: "start again at the end" });
  const scrub = make("input", {
    type: "range",
    min: "0",
    max: String(STEPS),
    step: "1",
    "aria-label": "Time",
    class: "scrub",
  });
  const [now, end] = [make("span"), make("span")]; // a number and its unit stay in one line
  const shown = make("output", { class: "time", "aria-live": "off" }, now, document.createTextNode(" "), end);
  const speedName = ownId("speed");
  const speed = make(
    "select",
    { id: speedName },
    ...SPEEDS.map((value) =>
      make("option", { value: String(value), text: `${value}×`, selected: value === clock.speed }),
    ),
  );
  scrub.addEventListener("input", () => clock.seek((Number(scrub.value) / STEPS) * clock.duration));
  speed.addEventListener("change", () => { clock.speed = Number(speed.value); });
  const places = Math.max(3, Math.ceil(-Math.log10(clock.duration || 1)) + 3);
  const tell = () => {
    const share = clock.duration > 0 ? clock.time / clock.duration : 0;
    if (document.activeElement !== scrub || Number(scrub.value) !== Math.round(share * STEPS))
      scrub.value = String(Math.round(share * STEPS));
    scrub.setAttribute("aria-valuetext", `${clock.time.toFixed(places)} s`);
    now.textContent = `${clock.time.toFixed(places)} s`;
    end.textContent = `of ${digits(clock.duration)} s`;
    const words = clock.playing ? "Pause" : "Play";
    if (play.getAttribute("aria-label") !== words) {
      play.setAttribute("aria-label", words);
      play.title = `${words} (space)`;
      play.textContent = clock.playing ? "❚❚" : "▶";
    }
  };
  const keys = (event: KeyboardEvent) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || wanted(event)) return;
    const acts: Record<string, () => void> = {
      " ": () => clock.toggle(),
      ArrowRight: () => clock.seek(clock.time + (event.shiftKey ? 10 : 1) * ARROW * clock.duration),
      ArrowLeft: () => clock.seek(clock.time - (event.shiftKey ? 10 : 1) * ARROW * clock.duration),
    };
    if (event.key === "." || event.key === ",") acts[event.key] = () => step(event.key === "." ? 1 : -1);
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  };
  function step(way: 1 | -1): void {
    let k = way > 0 ? 0 : samples.length - 1;
    const there = clock.time + way * 1e-9 * (clock.duration || 1);
    while (k >= 0 && k < samples.length && way * (samples[k] - there) <= 0) k += way;
    if (k >= 0 && k < samples.length) clock.seek(samples[k]);
  }

  function mark(events: RunEvent[]): void {
    const near = (one: RunEvent, other: RunEvent) => Math.abs(one.time - other.time) < TOGETHER * clock.duration;
    const groups: RunEvent[][] = [];
    for (const event of events) {
      const known = groups.find((group) => near(group[0], event));
      if (known) known.push(event);
      else groups.push([event]);
    }
    marks.replaceChildren(...groups.map((group) => {
      const words = `${group.map(({ label }) => label).join("; ")}, t = ${digits(group[0].time)} s`;
      const look = { class: "time-mark", "aria-label": words, title: words };
      const found = button("", () => clock.seek(group[0].time), look);
      found.style.left = `${(100 * group[0].time) / (clock.duration || 1)}%`;
      return found;
    }));
  }

  document.addEventListener("keydown", keys);
  const label = make("label", { for: speedName, text: "speed" });
  element.append(play, make("div", { class: "scrub-box" }, marks, scrub), shown, loop, label, speed);
  const unsubscribe = clock.subscribe(tell);
  tell();
  return {
    show(events, times) {
      samples = times;
      mark(events);
    },
    dispose() {
      unsubscribe();
      document.removeEventListener("keydown", keys);
      element.replaceChildren();
    },
  };
}

/** Whether what has the focus takes this key itself. */
function wanted(event: KeyboardEvent): boolean {
  const place = event.target;
  if (!(place instanceof HTMLElement)) return false;
  if (place.isContentEditable || place.closest("input, select, textarea, canvas, [role=tablist]")) return true;
  if (event.key === " ") return place.closest("button, a, summary") !== null;
  return place.closest(".scroll") !== null;
}
