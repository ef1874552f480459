// What is shown of the runs: the page of the first one, upon which later ones are drawn with the first as ghost.

import type { Page } from "../contract";
import { make } from "../dom";
import type { LiveRun } from "../contract_parts";
import { mountPage, type PageView } from "../page";
import type { Job, StudioPage } from "./api";

export class Shown {
  private view: PageView | null = null;
  private base: StudioPage | null = null;
  private last: StudioPage | null = null;
  private job: Job | null = null;

  constructor(private readonly element: HTMLElement) {}

  /** Show a run: upon the one that is there where they are of one kind, else afresh. */
  show(page: StudioPage, job: Job): void {
    [this.last, this.job] = [page, job];
    if (this.view && this.base && alike(this.base, page)) {
      this.view.show(asLive(page, job));
      this.view.showModes([]); // those of the run before are no longer true
    } else this.mount(page);
  }

  /** The same run as is shown, whose modes and slower numbers are known by now. */
  complete(page: StudioPage): void {
    if (!this.last || !this.job || !this.view) return;
    if (this.last === this.base) return this.view.complete(page.runs[0]);
    [this.last.runs[0].modes, this.last.runs[0].facts] = [page.runs[0].modes, page.runs[0].facts];
    this.view.show({ ...asLive(this.last, this.job), vibration: "they are shown here" });
    this.view.showModes(page.runs[0].modes);
  }

  /** Whether anything is shown. */
  get empty(): boolean {
    return this.view === null;
  }

  /** Take the run that is shown as the ghost of those to come. */
  keep(): void {
    if (this.last) this.mount(this.last);
  }

  /** Show nothing of the robot before: another one comes, and its numbers are not those. */
  forget(): void {
    this.view?.dispose();
    this.view = this.base = this.last = this.job = null;
    this.element.replaceChildren(make("p", { class: "empty", text: "Nothing is shown yet." }));
  }

  private mount(page: StudioPage): void {
    const clock = this.view?.clock;
    const [time, playing, speed] = [clock?.time ?? 0, clock?.playing ?? false, clock?.speed ?? 1];
    this.view?.dispose();
    this.element.replaceChildren();
    this.base = page;
    this.view = mountPage(this.element, page);
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

function asLive(page: StudioPage, job: Job): LiveRun {
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
    facts: Object.fromEntries(
      run.facts.map(({ id, value, note, time }) => [id, { value, note, time: time ?? undefined }]),
    ),
  };
}
