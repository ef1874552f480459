// The live model of a page: runs the robot's own equations with the sliders' values, in a worker where there is one.

import source from "tmodes:worker";
import type { LiveBundle } from "../contract";
import type { Live, LiveRun } from "../contract_parts";
import type { Bundle } from "./bundle";
import { Cancelled } from "./engine_run";
import { together, type Answered, type Asked } from "./messages";
import { openRunner } from "./runner";
import { sheetText } from "./sheet";

/** A run that a newer one ended. */
export class Superseded extends Error {
  override name = "Superseded";
}

type Progress = (share: number) => void;
type Early = (run: LiveRun) => void;

/** Who does the work; `run` rejects with Superseded where another call came. */
interface Doer {
  run(values: number[], progress: Progress, early: Early): Promise<LiveRun>;
  close(): void;
}

/** Open the live model of a page; raises an error where this browser cannot run it. */
export async function openLive(given: LiveBundle): Promise<Live> {
  const bundle = given as Bundle;
  const doer = (await inWorker(bundle)) ?? (await inPage(bundle));
  const check = (values: number[]) => {
    if (values.length !== bundle.sliders.length || !values.every(Number.isFinite)) {
      throw new Error(
        `values: got ${values.length}; expected ${bundle.sliders.length} finite numbers, one of each slider`,
      );
    }
  };
  return {
    sliders: bundle.sliders,
    async run(values, progress = () => undefined, early = () => undefined) {
      check(values);
      return doer.run(values, progress, early);
    },
    sheet(values) {
      check(values);
      return sheetText(bundle.sheet, values);
    },
    close: () => doer.close(),
  };
}

async function inPage(bundle: Bundle): Promise<Doer> {
  const runner = await openRunner(bundle);
  let latest = 0;
  let before: Promise<unknown> = Promise.resolve();
  return {
    async run(values, progress, early) {
      const id = (latest += 1);
      const cancelled = () => id !== latest;
      const own = before.then(() => {
        if (cancelled()) throw new Superseded("a newer run began");
        return runner.run(values, { cancelled, progress }, early);
      });
      before = own.catch(() => undefined);
      try {
        return await own;
      } catch (problem) {
        throw problem instanceof Cancelled ? new Superseded(problem.message) : problem;
      }
    },
    close: () => (latest += 1),
  };
}

/** A worker that is ready, with a partner where that saves time; or null where this page may have none. */
async function inWorker(bundle: Bundle): Promise<Doer | null> {
  if (typeof Worker === "undefined" || typeof document === "undefined") return null;
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  const workers: Worker[] = [];
  try {
    const begun = () => {
      workers.push(new Worker(address));
      return workers[workers.length - 1];
    };
    const worker = begun();
    const port = bundle.runs.reference && navigator.hardwareConcurrency > 1 ? withPartner(begun(), bundle) : undefined;
    if (await ready(worker, bundle, port)) return hired(worker, workers);
  } catch {
    // A page that may have no worker works by itself.
  } finally {
    URL.revokeObjectURL(address);
  }
  workers.forEach((worker) => worker.terminate());
  return null;
}

/** The way to a worker that makes the nominal runs. */
function withPartner(worker: Worker, bundle: Bundle): MessagePort {
  const { port1, port2 } = new MessageChannel();
  worker.postMessage({ kind: "partner", bundle, port: port2 } satisfies Asked, [port2]);
  return port1;
}

function ready(worker: Worker, bundle: Bundle, port?: MessagePort): Promise<boolean> {
  return new Promise((resolve) => {
    worker.onmessage = ({ data }: MessageEvent<Answered>) => resolve(data.kind === "ready");
    worker.onerror = () => resolve(false);
    worker.postMessage({ kind: "open", bundle, port } satisfies Asked, port ? [port] : []);
  });
}

/** `all`: it, and who helps it. */
function hired(worker: Worker, all: Worker[]): Doer {
  let latest = 0;
  let info: LiveRun | null = null;
  let waiting: { resolve(run: LiveRun): void; reject(problem: Error): void; progress: Progress; early: Early } | null =
    null;
  const ended = (problem: Error) => {
    waiting?.reject(problem);
    waiting = null;
  };
  worker.onerror = (event) => ended(new Error(event.message));
  worker.onmessage = ({ data }: MessageEvent<Answered>) => {
    if (!("id" in data) || data.id !== latest || !waiting) return;
    if (data.kind === "progress") waiting.progress(data.share);
    else if (data.kind === "early") waiting.early((info = together(info, data.run)));
    else if (data.kind === "error") ended(new Error(data.message));
    else if (data.kind === "done") {
      waiting.resolve(together(info, data.run));
      waiting = null;
    }
  };
  return {
    run(values, progress, early) {
      ended(new Superseded("a newer run began"));
      latest += 1;
      info = null;
      worker.postMessage({ kind: "run", id: latest, values } satisfies Asked);
      return new Promise((resolve, reject) => (waiting = { resolve, reject, progress, early }));
    },
    close() {
      ended(new Superseded("the live model was closed"));
      all.forEach((one) => one.terminate());
    },
  };
}
