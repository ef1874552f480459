// From a sheet to a page's data: one run at a time, the newest wish counts, a long run can be ended.

import { api, Refused, type Job, type StudioChange, type StudioPage, type Upon, type Wish, type Wrong } from "./api";
import { copy } from "./sheet";

/** A run that takes longer is ended when something else is wanted [ms]. */
const PATIENCE = 300;
const POLL = 0.25;
/** Without another wish for so long, the modes are asked for too [ms]. */
const CALM = 500;

export interface Listener {
  begun(): void;
  /** The page upon which a change of its numbers can be drawn; null: all of a page is needed. */
  upon(): Upon | null;
  progress(job: Job, milliseconds: number): void;
  done(page: StudioPage, job: Job, milliseconds: number): void;
  /** The same of a change of what is shown. */
  changed(change: StudioChange, job: Job, milliseconds: number): void;
  /** The same run with its modes. */
  whole(page: StudioPage): void;
  wrong(errors: Wrong[]): void;
  cancelled(): void;
}

export class Runner {
  readonly client = crypto.randomUUID();
  private wanted: Wish | null = null;
  private calm = 0;
  private running: { job: string | null; since: number; unwanted: boolean } | null = null;

  constructor(private readonly listener: Listener) {}

  /** Simulate this sheet as soon as may be; sheets in between are left out. */
  want(wish: Wish): void {
    clearTimeout(this.calm);
    this.wanted = { sheet: copy(wish.sheet), looks: wish.looks };
    if (this.running === null) void this.next();
    else if (performance.now() - this.running.since > PATIENCE) this.end();
    else
      setTimeout(
        () => this.wanted && this.running && performance.now() - this.running.since > PATIENCE && this.end(),
        PATIENCE + 10,
      );
  }

  /** End the run in progress, and wish for nothing. */
  async cancel(): Promise<void> {
    this.wanted = null;
    this.end();
  }

  private end(): void {
    if (this.running === null || this.running.unwanted) return;
    this.running.unwanted = true;
    if (this.running.job !== null) void api.cancel(this.running.job).catch(() => undefined);
  }

  private async next(): Promise<void> {
    while (this.wanted !== null) {
      const wish = this.wanted;
      this.wanted = null;
      const began = performance.now();
      this.running = { job: null, since: began, unwanted: false };
      try {
        await this.run(wish, began);
      } catch (error) {
        this.listener.wrong(
          error instanceof Refused
            ? error.errors
            : [{ path: "", message: String(error), got: "", expected: "", hint: "", where: "", steps: null }],
        );
      }
      this.running = null;
    }
  }

  private async run(wish: Wish, began: number): Promise<void> {
    this.listener.begun();
    const upon = this.listener.upon();
    let job = await this.watched(upon ? "change" : "curves", wish, began, upon?.series);
    const other = upon !== null && job.state === "done" && job.info.structure !== upon.structure;
    if (other) job = await this.watched("curves", wish, began); // of another structure: the server has its run
    if (job.state === "error") this.listener.wrong(job.errors);
    else if (job.state === "cancelled") {
      if (this.wanted === null) this.listener.cancelled();
    } else {
      if (upon && !other) {
        const change = await api.change(job.job);
        this.listener.changed(change, job, performance.now() - began);
      } else this.listener.done(await api.page(job.job), job, performance.now() - began);
      this.calm = window.setTimeout(() => void this.modes(wish), CALM);
    }
  }

  /** A job up to its end, which may be ended meanwhile. */
  private async watched(product: string, wish: Wish, began: number, series?: string[]): Promise<Job> {
    let job = await api.begin(product, wish, this.client, series);
    if (this.running) this.running.job = job.job;
    if (this.running?.unwanted) await api.cancel(job.job);
    while (job.state === "waiting" || job.state === "running") {
      job = await api.look(job.job, POLL);
      if (job.state === "running") this.listener.progress(job, performance.now() - began);
    }
    return job;
  }

  /** The modes of a run that is shown, of which nothing has changed since; who lacks them misses no curve. */
  private async modes(wish: Wish): Promise<void> {
    const calm = this.calm;
    try {
      const job = await this.over("page", wish, () => undefined);
      if (job.state !== "done") return;
      const page = await api.page(job.job);
      if (this.calm === calm && this.running === null && this.wanted === null) this.listener.whole(page);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
    }
  }

  private async over(product: string, wish: Wish, progress: (job: Job) => void): Promise<Job> {
    let job = await api.begin(product, wish, this.client);
    while (job.state === "waiting" || job.state === "running") {
      job = await api.look(job.job, POLL);
      progress(job);
    }
    return job;
  }

  /** A file of the sheet's run: its report or its data; null where it was ended before. */
  async file(product: "report" | "data", wish: Wish, progress: (job: Job) => void): Promise<Uint8Array | null> {
    const job = await this.over(product, { ...wish, sheet: copy(wish.sheet) }, progress);
    if (job.state === "cancelled") return null;
    if (job.state !== "done") throw new Refused(job.errors, 422);
    return api.bytes(job.job);
  }
}
