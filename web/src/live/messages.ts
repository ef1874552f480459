// What page and worker say to each other.

import type { LiveRun } from "../contract";
import type { Bundle } from "./bundle";

export type Asked = { kind: "open"; bundle: Bundle } | { kind: "run"; id: number; values: number[] };

export type Answered =
  | { kind: "ready" }
  | { kind: "failed"; message: string }
  | { kind: "progress"; id: number; share: number }
  | { kind: "early"; id: number; run: LiveRun }
  | { kind: "done"; id: number; run: LiveRun }
  | { kind: "error"; id: number; cancelled: boolean; message: string };

/** All buffers in a value, so that they are handed over and not copied. */
export function buffersIn(value: unknown, found = new Set<ArrayBuffer>()): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) {
    if (value.buffer instanceof ArrayBuffer) found.add(value.buffer);
  } else if (value !== null && typeof value === "object") {
    for (const inner of Object.values(value)) buffersIn(inner, found);
  }
  return [...found];
}
