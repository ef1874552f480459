// The numbers that matter; those of the live model stand next to the page's own, with the difference.

import type { Clock } from "../clock";
import type { Fact, Page } from "../contract";
import type { LiveRun } from "../contract_parts";
import { button, make, put } from "../dom";
import { digits, info } from "../format";

export interface FactsView {
  /**
   * Numbers of the live model for the first run; null: the page's own alone. One that is still computed stays, grey.
   */
  show(live: LiveRun | null): void;
}

/** Texts of what is there already: no element is made again. */
type Info = (live: LiveRun | null) => void;

function isPending(id: string, live: LiveRun | null): boolean {
  return Boolean(live?.pending?.includes(id)) && !(id in live!.facts);
}

const MAIN = 7; // numbers that are shown at first

export function mountFacts(element: HTMLElement, page: Page, clock: Clock): FactsView {
  const known: Info[] = [];
  element.hidden = page.runs.every((run) => run.facts.length === 0);
  if (page.runs.length > 1) element.append(make("h3", { class: "offscreen", text: "Numbers" }), compared(page, known));
  else element.append(single(page.runs[0].facts, known, clock));
  const show = (live: LiveRun | null) => known.forEach((tell) => tell(live));
  show(null);
  return { show };
}

/** One line a number, the first ones; the rest, and when, where and why, on request. */
function single(facts: Fact[], known: Info[], clock: Clock): HTMLElement {
  const order = [...facts].sort((one, other) => Number(one.value === null) - Number(other.value === null));
  const list = make("dl", { class: "facts" }, ...order.map((fact, k) => row(fact, k >= MAIN, known, clock)));
  const all = button("all, with notes", () => {
    all.setAttribute("aria-pressed", String(list.classList.toggle("all")));
  }, { class: "tool", "aria-pressed": "false" });
  return make("div", {}, make("div", { class: "bar" }, make("h3", { text: "Numbers" }), all), list);
}

function row(fact: Fact, rest: boolean, known: Info[], clock: Clock): HTMLElement {
  const value = make("strong");
  const was = make("span", { class: "was" });
  const note = make("dd", { class: "note" });
  let time: number | null = null;
  const jump = make("button", { type: "button", class: "jump" });
  jump.addEventListener("click", () => time !== null && clock.seek(time));
  const place = make("dd", {}, value, was);
  known.push((live) => {
    const fresh = live?.facts[fact.id];
    const waits = isPending(fact.id, live);
    element.classList.toggle("computing", waits || (live !== null && !fresh));
    if (waits) {
      put(was, "computing");
      was.hidden = false;
      return;
    }
    const before = fresh ? `${change(fact, fresh.value)} was ${info(fact.value, fact.unit)}` : "of the original run";
    const about = live?.native && live.status === "finished" ? "≈ " : "";
    put(value, about + info(fresh ? fresh.value : fact.value, fact.unit));
    put(was, live ? before : "");
    put(note, [(fresh ?? fact).note, (fresh ?? fact).more].filter(Boolean).join("; "));
    was.hidden = live === null || (fresh !== undefined && fresh.value === null && fact.value === null);
    note.hidden = note.textContent === "";
    element.title = note.textContent ?? "";
    time = (fresh ? fresh.time : fact.time) ?? null;
    if (time === null) jump.replaceWith(value);
    else if (!jump.contains(value)) {
      value.replaceWith(jump);
      jump.append(value);
    }
    jump.title = time === null ? "" : `go to t = ${digits(time)} s`;
  });
  const element = make(
    "div", { "data-fact": fact.id, class: rest ? "rest" : undefined }, make("dt", { text: fact.name }), place, note,
  );
  return element;
}

/** `+12 %,` where both are known. */
function change(fact: Fact, value: number | null): string {
  if (value === null || fact.value === null || fact.value === 0) return "";
  const share = (100 * (value - fact.value)) / Math.abs(fact.value);
  if (Math.abs(share) < 0.05) return "";
  if (share >= 1000) return `×${Number((value / fact.value).toPrecision(3))},`;
  const size = `${Number(Math.abs(share).toPrecision(2))} %`;
  return `${share > 0 ? "+" : "−"}${size},`;
}

/** A table of all runs side by side. */
function compared(page: Page, known: Info[]): HTMLElement {
  const all = new Map<string, Fact>();
  for (const fact of page.runs.flatMap((run) => run.facts)) if (!all.has(fact.id)) all.set(fact.id, fact);
  const head = make("tr", {}, make("td", {}), ...page.runs.map((run) => make("th", { scope: "col", text: run.name })));
  const rows = [...all.values()].map((fact) =>
    make(
      "tr",
      { "data-fact": fact.id },
      make("th", { scope: "row", text: fact.name }),
      ...page.runs.map((run, k) => {
        const cell = make("td", { class: "number" });
        const own = run.facts.find((other) => other.id === fact.id);
        known.push((live) => {
          const fresh = k === 0 ? live?.facts[fact.id] : undefined;
          const waits = k === 0 && isPending(fact.id, live);
          cell.classList.toggle("computing", waits);
          if (waits) return;
          put(cell, info(fresh ? fresh.value : (own?.value ?? null), own?.unit ?? fact.unit));
          cell.title = (fresh ?? own)?.note ?? "";
        });
        return cell;
      }),
    ),
  );
  const table = make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows));
  return make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Numbers of the runs" }, table);
}
