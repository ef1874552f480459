// The worker of a live page: one bundle, one run at a time; a newer one ends an older one at its next look around.

import type { LiveRun } from "../contract_parts";
import { Cancelled } from "./engine_run";
import { beyond, buffersIn, type Answered, type Asked } from "./messages";
import { openPlanner, openRunner, type Runner } from "./runner";

interface Scope {
  onmessage: ((event: MessageEvent<Asked>) => void) | null;
  postMessage(answer: Answered, transfer?: Transferable[]): void;
}

const scope = self as unknown as Scope;
let runner: Runner | null = null;
let latest = -1;
let before: Promise<void> = Promise.resolve();

scope.onmessage = ({ data }) => {
  if (data.kind === "open") {
    openRunner(data.bundle, data.port).then(
      (opened) => {
        runner = opened;
        scope.postMessage({ kind: "ready" });
      },
      (problem) => scope.postMessage({ kind: "failed", message: String(problem) }),
    );
    return;
  }
  if (data.kind === "partner") {
    openPlanner(data.bundle, data.port).catch(() => undefined); // who asks then makes nominal runs without a partner
    return;
  }
  const { id, values } = data;
  latest = id;
  before = before.then(() => made(id, values));
};

async function made(id: number, values: number[]): Promise<void> {
  const cancelled = () => id !== latest;
  try {
    if (!runner) throw new Error("the live model is not open");
    // Several values of a dragged slider may wait: messages are read first, and all but the last are given up.
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (cancelled()) throw new Cancelled("a newer run began");
    const watch = { cancelled, progress: (share: number) => scope.postMessage({ kind: "progress", id, share }) };
    let known: LiveRun | null = null;
    const run = await runner.run(values, watch, (info, needed) => {
      const more = beyond(info, known);
      known = info;
      const kept = new Set(buffersIn(needed));
      scope.postMessage({ kind: "early", id, run: more }, buffersIn(more).filter((buffer) => !kept.has(buffer)));
    });
    const more = beyond(run, known);
    scope.postMessage({ kind: "done", id, run: more }, buffersIn(more));
  } catch (problem) {
    const message = problem instanceof Error ? problem.message : String(problem);
    scope.postMessage({ kind: "error", id, cancelled: problem instanceof Cancelled, message });
  }
}
