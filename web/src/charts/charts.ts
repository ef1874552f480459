// All charts of a page: a choice of groups, a grid, one zoom.

import type { Clock } from "../clock";
import type { Chart, Page } from "../contract";
import type { LiveRun } from "../contract_parts";
import { button, make } from "../dom";
import { drawnSheet, saveSheets } from "./saving";
import { mountChart, type ChartView } from "./chart";
import { chartSets, unchanged, type ChartSet } from "./series";
import { makeZoom } from "./zoom";

export interface ChartsView {
  /** Draw the live model's run of the first run's robot; null: the page's own alone. */
  show(live: LiveRun | null): void;
  /** Other marks are known. */
  renew(): void;
  dispose(): void;
}

type Group = Chart["group"] | "overview" | "all";
const WORDS: Record<Group, string> = {
  overview: "Overview",
  error: "Error",
  tip: "Tip",
  contact: "Contact",
  deformations: "Deformations",
  motors: "Motors",
  energy: "Energy",
  spectrum: "Spectrum",
  all: "All",
};

export function mountCharts(element: HTMLElement, page: Page, clock: Clock): ChartsView {
  const sets = chartSets(page);
  const zoom = makeZoom();
  const grid = make("div", { class: "chart-grid", id: "tm-charts", role: "tabpanel", tabindex: "0" });
  const tabs = make("div", { class: "tabs", role: "tablist", "aria-label": "Charts" });
  const hint = make("p", {
    class: "note hint",
    text: "Click or drag: the time. Shift and drag: zoom, double click: back. Keys: space, arrows, and , . by sample.",
  });
  const groups = (Object.keys(WORDS) as Group[]).filter((group) => chosen(sets, group).length > 0);
  let drawn: ChartSet[] = [];
  let views: ChartView[] = [];
  let opened: Group = "overview";
  let live: LiveRun | null = null;

  for (const group of groups) {
    const tab = button(WORDS[group], () => open(group), {
      role: "tab",
      id: `tm-tab-${group}`,
      "aria-controls": "tm-charts",
      "data-group": group,
    });
    tabs.append(tab);
  }
  tabs.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const at = groups.findIndex((group) => `tm-tab-${group}` === (event.target as HTMLElement).id);
    if (step === undefined || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    open(groups[(at + step + groups.length) % groups.length]);
    tabs.querySelector<HTMLElement>("[aria-selected=true]")?.focus();
  });

  function open(group: Group): void {
    views.forEach((view) => view.dispose());
    opened = group;
    drawn = chosen(sets, group);
    views = drawn.map((set) => mountChart(set, clock, zoom));
    if (live) views.forEach((view) => view.show(live));
    for (const tab of tabs.querySelectorAll("button")) {
      const selected = tab.dataset.group === group;
      tab.setAttribute("aria-selected", String(selected));
      tab.tabIndex = selected ? 0 : -1;
    }
    grid.setAttribute("aria-labelledby", `tm-tab-${group}`);
    grid.replaceChildren(...views.map((view) => view.element));
  }

  const whole = button("Save all of these (SVG)", () => {
    const all = views.flatMap((view) => view.state() ?? []);
    setTimeout(() => saveSheets(all.map(drawnSheet), `charts_${opened}`)); // uPlot finds its axes a little later
  }, { class: "tool", title: "Save the charts of this tab as one vector graphic" });
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const recolour = () => views.forEach((view) => view.recolour());
  dark.addEventListener("change", recolour);
  element.append(make("div", { class: "tab-bar" }, tabs), grid, whole, hint);
  open("overview");
  return {
    renew: () => open(opened),
    show(run) {
      const before = live;
      live = run;
      views.forEach((view, k) => {
        if (!run || !before || !unchanged(drawn[k], before, run)) view.show(run);
      });
    },
    dispose() {
      dark.removeEventListener("change", recolour);
      views.forEach((view) => view.dispose());
      element.replaceChildren();
    },
  };
}

/** The charts of a group; the overview has the first of each, and others that say so. */
function chosen(sets: ChartSet[], group: Group): ChartSet[] {
  if (group === "all") return sets;
  if (group !== "overview") return sets.filter(({ chart }) => chart.group === group);
  const isFirst = (chart: Chart, k: number) => sets.findIndex((other) => other.chart.group === chart.group) === k;
  return sets.filter(({ chart }, k) => chart.overview || isFirst(chart, k));
}
