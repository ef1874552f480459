// The numbers that matter; those of the live model stand beside the page's own, with the difference.

import type { Fact, LiveRun, Page } from "../contract";
import { make } from "../dom";
import { told } from "../format";

export interface FactsView {
  /** Numbers of the live model for the first run; null: the page's own alone. */
  show(live: LiveRun | null): void;
}

export function mountFacts(element: HTMLElement, page: Page): FactsView {
  const show = (live: LiveRun | null) => {
    element.replaceChildren(page.runs.length > 1 ? compared(page, live) : single(page.runs[0].facts, live));
  };
  show(null);
  return { show };
}

function single(facts: Fact[], live: LiveRun | null): HTMLElement {
  return make("dl", { class: "facts" }, ...facts.map((fact) => {
    const fresh = live?.facts[fact.id];
    const value = make("dd", {}, make("strong", { text: told(fresh ? fresh.value : fact.value, fact.unit) }));
    if (fresh && (fresh.value ?? fact.value) !== null) {
      value.append(make("span", { class: "was", text: `${change(fact, fresh.value)} was ${told(fact.value, fact.unit)}` }));
    }
    if (live && !fresh) value.append(make("span", { class: "was", text: "of the original run" }));
    const note = (fresh ? fresh.note : fact.note) || "";
    return make("div", { "data-fact": fact.id }, make("dt", { text: fact.name }), value, note ? make("dd", { class: "note", text: note }) : null);
  }));
}

/** `+12 %,` where both are known. */
function change(fact: Fact, value: number | null): string {
  if (value === null || fact.value === null || fact.value === 0) return "";
  const share = (100 * (value - fact.value)) / Math.abs(fact.value);
  if (Math.abs(share) < 0.05) return "";
  return `${share > 0 ? "+" : "−"}${Math.abs(share) >= 1000 ? "1000 % and more" : `${Number(Math.abs(share).toPrecision(2))} %`},`;
}

/** A table of all runs beside each other. */
function compared(page: Page, live: LiveRun | null): HTMLElement {
  const known = new Map<string, Fact>();
  for (const fact of page.runs.flatMap((run) => run.facts)) if (!known.has(fact.id)) known.set(fact.id, fact);
  const head = make("tr", {}, make("td", {}), ...page.runs.map((run) => make("th", { scope: "col", text: run.name })));
  const rows = [...known.values()].map((fact) => make("tr", { "data-fact": fact.id }, make("th", { scope: "row", text: fact.name }),
    ...page.runs.map((run, k) => {
      const own = run.facts.find((other) => other.id === fact.id);
      const fresh = k === 0 ? live?.facts[fact.id] : undefined;
      const value = fresh ? fresh.value : (own?.value ?? null);
      return make("td", { class: "number", text: told(value, own?.unit ?? fact.unit), title: (fresh ?? own)?.note || undefined });
    })));
  const table = make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows));
  return make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Numbers of the runs" }, table);
}
