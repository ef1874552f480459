// What is shown of the runs: the page of the first one, upon which later ones are drawn with the first as ghost.

import type { Page } from "../contract";
import { make } from "../dom";
import type { LiveRun } from "../contract_parts";
import { LATER } from "../live/later";
import { mountPage, type PageView } from "../page";
import type { Advice } from "../panels/verdict";
import type { Job, StudioChange, StudioPage, Upon } from "./api";

export class Shown {
  private view: PageView | null = null;
  private base: StudioPage | null = null;
  /** The run that is shown: all of a page, or what changed upon the one before. */
  private last: StudioPage | StudioChange | null = null;
  private job: Job | null = null;
  private keeping = false; // whether the next page is the ghost of those to come

  private marked: string | null = null;

  /** `picked` hears of the link or joint that was clicked in the picture. */
  constructor(private readonly element: HTMLElement, private readonly picked: (element: string) => void) {}

  /** Mark a link or a joint in the picture; null: none. */
  highlight(element: string | null): void {
    this.marked = element;
    this.view?.scene.highlight(element);
  }

  /** The page upon which a change of its numbers can be drawn; null: there is none, or another one is wanted. */
  get upon(): Upon | null {
    const structure = this.job?.info.structure;
    if (!this.view || !this.base?.runs[0].charts.length || !structure || this.keeping) return null;
    return { structure, series: Object.keys(this.base.series) };
  }

  /** Show a run: upon the one that is there where they are of one kind, else afresh. */
  show(page: StudioPage, job: Job): void {
    const upon = this.view && !this.keeping && this.base && alike(this.base, page) ? this.view : null;
    if (upon) this.draw(upon, page, job);
    else {
      [this.last, this.job] = [page, job];
      if (page.runs[0].charts.length) page.runs[0].pending = LATER; // not of a robot at rest
      this.mount(page);
    }
  }

  /** Show a run upon the page that is there. */
  change(change: StudioChange, job: Job): void {
    if (this.view) this.draw(this.view, change, job);
  }

  private draw(view: PageView, page: StudioPage | StudioChange, job: Job): void {
    [this.last, this.job] = [page, job];
    view.show(asLive(page, job));
    view.showModes([]); // those of the run before are no longer true
  }

  /** The same run as is shown, whose modes and slower numbers are known by now. */
  complete(page: StudioPage): void {
    if (!this.last || !this.job || !this.view || !this.base) return;
    if (this.last === this.base) return this.view.complete(page.runs[0]);
    this.last = page;
    if (!alike(this.base, page)) return this.mount(page);
    this.view.show({ ...asLive(page, this.job), vibration: "they are shown here", pending: undefined });
    this.view.showModes(page.runs[0].modes);
  }

  /** Tell what lessens the error most, or why that is not known; null: it is being computed. */
  advise(found: Advice[] | string | null): void {
    this.view?.advise(found);
  }

  /** Whether anything is shown. */
  get empty(): boolean {
    return this.view === null;
  }

  /** Take the run that is shown as the ghost of those to come; false: not all of it is here, but of the next one. */
  keep(): boolean {
    if (this.last && !whole(this.last)) this.keeping = true;
    else if (this.last) this.mount(this.last);
    return !this.keeping;
  }

  /** Show nothing of the robot before: another one comes, and its numbers are not those. */
  forget(): void {
    this.view?.dispose();
    this.view = this.base = this.last = this.job = this.marked = null;
    this.keeping = false;
    this.element.replaceChildren(make("p", { class: "empty", text: "Nothing is shown yet." }));
  }

  private mount(page: StudioPage): void {
    const clock = this.view?.clock;
    const [time, playing, speed] = [clock?.time ?? 0, clock?.playing ?? false, clock?.speed ?? 1];
    this.view?.dispose();
    this.element.replaceChildren();
    this.base = page;
    this.keeping = false;
    this.view = mountPage(this.element, page);
    this.view.scene.onPick(this.picked);
    this.view.scene.highlight(this.marked);
    this.view.clock.speed = speed;
    if (clock) this.view.clock.seek(time);
    if (playing) this.view.clock.play();
  }
}

/** Whether one run can be drawn in the charts and upon the robot of another. */
function alike(base: Page, page: Page): boolean {
  const [one, other] = [base.runs[0], page.runs[0]];
  const charts = (run: Page["runs"][0]) =>
    run.charts.map((chart) => `${chart.id}:${chart.curves.map((curve) => curve.label).join()}`).join(";");
  const links = (run: Page["runs"][0]) =>
    [run.scene.line.shape.slice(1), run.scene.links.map((link) => link.name), run.scene.contact === null].join(":");
  return (
    one.name === other.name &&
    charts(one) === charts(other) &&
    links(one) === links(other) &&
    (one.line === null) === (other.line === null)
  );
}

function whole(page: StudioPage | StudioChange): page is StudioPage {
  return "title" in page;
}

function asLive(page: StudioPage | StudioChange, job: Job): LiveRun {
  const run = page.runs[0];
  const series = Object.entries(page.series).map(
    ([name, values]) =>
      [name, { data: Float64Array.from(values.data), shape: [...values.shape] }] as [string, LiveRun["series"][string]],
  );
  return {
    status: run.status,
    message: run.message,
    seconds: job.info.seconds?.simulate ?? 0,
    times: Float64Array.from(page.times.data),
    series: Object.fromEntries(series),
    scene: run.scene,
    line: run.line,
    verdict: run.verdict,
    pending: LATER,
    facts: Object.fromEntries(
      run.facts.map(({ id, value, note, time }) => [id, { value, note, time: time ?? undefined }]),
    ),
  };
}
