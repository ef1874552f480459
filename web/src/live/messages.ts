// What page and worker say to each other.

import type { LiveRun } from "../contract_parts";
import type { Bundle } from "./bundle";

/** `port`: of who opens to their partner, and of that partner, who makes the nominal runs and answers nobody else. */
export type Asked =
  | { kind: "open"; bundle: Bundle; port?: MessagePort }
  | { kind: "partner"; bundle: Bundle; port: MessagePort }
  | { kind: "run"; id: number; values: number[] };

export type Answered =
  | { kind: "ready" }
  | { kind: "failed"; message: string }
  | { kind: "progress"; id: number; share: number }
  /** First the curves, then the picture; each time what was not reported before. */
  | { kind: "early"; id: number; run: Partial<LiveRun> }
  | { kind: "done"; id: number; run: Partial<LiveRun> }
  | { kind: "error"; id: number; cancelled: boolean; message: string };

/** What a run reports beyond what was reported early of it. */
export function beyond(run: LiveRun, early: LiveRun | null): Partial<LiveRun> {
  if (!early) return run;
  const fresh = <T extends object>(all: T, known: object) =>
    Object.fromEntries(
      Object.entries(all).filter(([name, value]) => (known as Record<string, unknown>)[name] !== value),
    );
  return { ...fresh(run, early), series: fresh(run.series, early.series) };
}

/** All of a run again. */
export function together(early: LiveRun | null, more: Partial<LiveRun>): LiveRun {
  return { ...early, ...more, series: { ...early?.series, ...more.series } } as LiveRun;
}

/** All buffers in a value, so that they are handed over and not copied. */
export function buffersIn(value: unknown, found = new Set<ArrayBuffer>()): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) {
    if (value.buffer instanceof ArrayBuffer) found.add(value.buffer);
  } else if (value !== null && typeof value === "object") {
    for (const inner of Object.values(value)) buffersIn(inner, found);
  }
  return [...found];
}
