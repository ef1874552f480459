// A page of results: robot and numbers, time bar, linked charts, elastic line and modes, mounted into one element.

import { makeClock, type Clock } from "./clock";
import { mountCharts } from "./charts/charts";
import type { Mode, Page, Run } from "./contract";
import type { LiveRun, LiveScene, SceneView } from "./contract_parts";
import { make } from "./dom";
import { openLive } from "./live/live";
import { mountFacts } from "./panels/facts";
import { mountLine } from "./panels/line";
import { mountModes } from "./panels/modes";
import { follow, fragmentOf } from "./panels/address";
import { fileName, mountSave, saveMenu } from "./panels/save";
import { mountSliders } from "./panels/sliders";
import { mountTransport } from "./panels/transport";
import { mountVerdict, type Advice } from "./panels/verdict";
import { mountScene } from "./scene/scene";

/** What stands outside of the program, in words that no slider changes. */
const ORIGINAL = "main > .status, #numbers, #robot, #provenance";
const MARKED = ["tip_error.commanded", "deviation.max", "deflection.max", "gear.max"];

export interface PageView {
  readonly clock: Clock;
  /** Next to the robot, under the numbers: room for sliders. */
  readonly side: HTMLElement;
  readonly scene: SceneView;
  /** Draw another run of the first run's robot everywhere, the page's own as ghost; null: the page's own alone. */
  show(live: LiveRun | null): void;
  /** Tell other modes of the first run's robot in place of the page's own. */
  showModes(found: Mode[]): void;
  /** Tell what lessens the error of the first run most, or why that is not known; null: it is being computed. */
  advise(found: Advice[] | string | null): void;
  /** What takes longer of the page's own first run: its other numbers, its modes and their marks. */
  complete(run: Run): void;
  dispose(): void;
}

export function mountPage(root: HTMLElement, page: Page): PageView {
  const duration = Math.max(...page.runs.map((run) => run.duration));
  const clock = makeClock(duration);
  const stage = make("div", { class: "scene" });
  const facts = make("div", {
    class: "facts-panel",
    role: "region",
    tabindex: "0",
    "aria-label": "Numbers that matter",
  });
  const sliders = make("div", { class: "sliders-panel", role: "region", tabindex: "0", "aria-label": "Settings" });
  const side = make("div", { class: "side" }, facts, sliders);
  const transport = make("div", { class: "transport", role: "group", "aria-label": "Time" });
  const charts = make("section", { class: "charts", "aria-label": "Charts" });
  const of = page.runs.length > 1 ? ` of ${page.runs[0].name}` : "";
  const line = section(`Elastic line${of}`, page.runs[0].line !== null);
  const modes = section(`Modes of vibration${of}`, page.runs[0].modes.length > 0);
  const files = make("div", { class: "bar files" });
  root.classList.add("app");
  const strip = make("section", { class: "verdicts", "aria-label": "Verdict" });
  root.append(
    strip,
    make("div", { class: "stage" }, stage),
    transport,
    make("div", { class: "desk" }, side, charts, make("div", { class: "lower" }, line.element, modes.element)),
    files,
  );

  const scene = mountScene(stage, page, clock, true);
  clock.seek(page.runs[0].verdict?.time_s ?? scene.opensAt); // the instant of the sentence
  const transportView = mountTransport(transport, clock);
  const verdict = mountVerdict(strip, page, clock, scene);
  const parts: { dispose(): void }[] = [verdict, scene, transportView];
  const heights = new ResizeObserver(() => root.style.setProperty("--strip", `${strip.offsetHeight}px`));
  heights.observe(strip); // the picture has what it leaves of the window
  let factsView = mountFacts(facts, page, clock);
  const chartsView = mountCharts(charts, page, clock);
  const lineView = page.runs[0].line ? mountLine(line.body, page, clock) : null;
  let modesView = page.runs[0].modes.length ? mountModes(modes.body, page, scene, clock) : null;
  mountSave(files, page);
  // a robot at rest, without a run
  transport.hidden = charts.hidden = page.runs.every((run) => run.charts.length === 0);

  const samples = page.runs[0].charts.find((chart) => chart.abscissa === "time")?.at.data ?? [];
  const mark = (live: LiveRun | null) => {
    const times = live ? live.times : samples;
    const changed = page.runs[0].facts.flatMap(({ id, name }) => {
      const time = live?.facts[id]?.time;
      return time !== undefined && MARKED.includes(id) ? [{ time, label: `largest: ${name.toLowerCase()}` }] : [];
    });
    transportView.show(live ? changed.sort((one, other) => one.time - other.time) : page.runs[0].events, times);
  };
  mark(null);
  let pictured: LiveScene | null = null; // curves come before the picture, and both before all of a run

  function show(live: LiveRun | null): void {
    clock.setDuration(Math.max(live ? live.times[live.times.length - 1] : 0, duration));
    if ((!live || live.scene) && pictured !== (live?.scene ?? null)) {
      pictured = live?.scene ?? null;
      scene.replace(0, pictured);
      lineView?.show(live);
    }
    verdict.show(live);
    chartsView.show(live);
    factsView.show(live);
    modesView?.show(live);
    mark(live);
    for (const one of document.querySelectorAll(ORIGINAL)) one.classList.toggle("original", live !== null);
  }

  const own = fileName(page.runs[0].name);
  const settings = page.live && mountSliders(sliders, page.live, {
    open: openLive, show, advise: verdict.advise, fileName: `${own}_changed`, facts: page.runs[0].facts,
  });
  if (settings) parts.push(settings);
  else if (page.notLive)
    sliders.append(make("p", { class: "note", text: `Nothing can be changed in this page: ${page.notLive}.` }));

  const menu = saveMenu(own, scene, clock, () => fragmentOf(clock, scene, settings));
  stage.querySelector(".scene-bar")?.append(menu);
  const goBack = () => follow(location.hash, clock, scene, settings);
  addEventListener("hashchange", goBack);
  goBack();

  function showModes(found: Mode[]): void {
    modesView?.dispose();
    modes.body.replaceChildren();
    modes.element.hidden = found.length === 0;
    const [first, ...others] = page.runs;
    modesView = found.length
      ? mountModes(modes.body, { ...page, runs: [{ ...first, modes: found }, ...others] }, scene, clock)
      : null;
  }

  return {
    clock,
    side: sliders,
    scene,
    show,
    showModes,
    advise: verdict.advise,
    complete(run) {
      const [first] = page.runs;
      [first.facts, first.modes, first.verdict, first.pending] = [run.facts, run.modes, run.verdict, undefined];
      verdict.show(null);
      for (const chart of first.charts) chart.marks = run.charts.find(({ id }) => id === chart.id)?.marks ?? [];
      facts.replaceChildren();
      factsView = mountFacts(facts, page, clock);
      chartsView.renew();
      showModes(run.modes);
    },
    dispose() {
      clock.pause();
      removeEventListener("hashchange", goBack);
      heights.disconnect();
      modesView?.dispose();
      [...parts, chartsView, ...(lineView ? [lineView] : [])].forEach((part) => part.dispose());
      root.replaceChildren();
    },
  };
}

function section(title: string, there: boolean): { element: HTMLElement; body: HTMLElement } {
  const body = make("div", {});
  return {
    element: make(
      "section",
      { class: "panel", hidden: !there, "aria-label": title },
      make("h3", { text: title }),
      body,
    ),
    body,
  };
}
