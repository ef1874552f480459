// What the server is asked, and what it answers.

import { unpack } from "../pack";
import type { Page } from "../contract";
import type { Numbers } from "../pack";
import type { Schema } from "./schema";
import type { Json, Sheet, Step } from "./sheet";

/** One wrong value: where, what was got, what is expected, how to hint it. */
export interface Wrong {
  path: string;
  message: string;
  got: string;
  expected: string;
  hint: string;
  /** File and line, of files alone. */
  where: string;
  steps: Step[] | null;
  /** `exists`: a file of this name is there. */
  kind?: string;
}

/** A number, or several in proportion, that are worth a slider. */
export interface Knob {
  /** What `--set` takes. */
  path: string;
  label: string;
  symbol: string;
  unit: string;
  group: string;
  /** The designer of the robot chooses it. */
  design: boolean;
  min: number;
  max: number;
  log: boolean;
  /** Whether the slider is a factor on the bases of all targets. */
  together: boolean;
  targets: { steps: Step[]; base: number }[];
}

export interface SheetInfo {
  name: string;
  sheet: Sheet;
  units: Record<string, string>;
  warnings: string[];
  sliders: Knob[];
  /** Where the shapes of its links come from; the server knows what it means. */
  looks: string;
}

/** What is to be simulated, and where its looks come from. */
export interface Wish {
  sheet: Sheet;
  looks: string;
}

export interface Job {
  job: string;
  state: "waiting" | "running" | "done" | "error" | "cancelled";
  stage: string;
  share: number;
  /**
   * `unseen`: shapes of links that cannot be shown; `offer`: drives that would move a robot that nothing moves;
   * `structure`: the same for runs of which one can be drawn upon another's page.
   */
  info: {
    status?: string; success?: boolean; message?: string; seconds?: Record<string, number>; unseen?: Wrong[];
    offer?: Json[]; structure?: string;
  };
  errors: Wrong[];
}

/** A page's data with the series that its curves are drawn of. */
export interface StudioPage extends Page {
  times: Numbers;
  series: Record<string, Numbers>;
}

/** What of it changes with a number: no charts, whose curves are the series, and of the scene what moves. */
export interface StudioChange {
  runs: [ChangedRun];
  times: Numbers;
  series: Record<string, Numbers>;
}

type ChangedRun =
  Pick<Page["runs"][0], "name" | "status" | "success" | "message" | "verdict" | "warnings" | "facts" | "line"> & {
    scene: Omit<Page["runs"][0]["scene"], "links" | "joints" | "meshes">;
  };

/** The page upon which a change is drawn, as the server knows it, and the series that its charts are drawn of. */
export interface Upon {
  structure: string;
  series: string[];
}

export class Refused extends Error {
  constructor(readonly errors: Wrong[], readonly status: number) {
    super(errors.map((one) => one.message).join("; "));
  }
}

async function asked(address: string, method = "GET", body?: unknown): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(address, {
      method,
      credentials: "same-origin",
      ...(body === undefined ? {} : { headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) }),
    });
  } catch {
    throw new Refused([wrong("The studio does not answer: it was stopped, or this machine slept. Start it again.")], 0);
  }
  if (answer.ok) return answer;
  const info = (await answer.json().catch(() => null)) as { errors?: Wrong[] } | null;
  throw new Refused(info?.errors ?? [wrong(`The studio answered ${answer.status}.`)], answer.status);
}

function wrong(message: string): Wrong {
  return { path: "", message, got: "", expected: "", hint: "", where: "", steps: null };
}

async function json<T>(address: string, method = "GET", body?: unknown): Promise<T> {
  return (await (await asked(address, method, body)).json()) as T;
}

const named = encodeURIComponent;
const client = crypto.randomUUID(); // a newer check of this page ends the one before

export const api = {
  robots: () => json<{ robots: { name: string; title: string }[] }>("api/robots"),
  robot: (name: string) => json<SheetInfo>(`api/robots/${named(name)}`),
  schema: () => json<Schema>("api/schema"),
  check: (sheet: Sheet) => json<SheetInfo>("api/check", "POST", { sheet, client }),
  yaml: (sheet: Sheet) => json<{ yaml: string }>("api/yaml", "POST", { sheet }),
  studies: () => json<{ folder: string; studies: string[] }>("api/studies"),
  study: (name: string) => json<SheetInfo>(`api/studies/${named(name)}`),
  save: (name: string, sheet: Sheet, looks: string, overwrite: boolean) =>
    json<{ saved: string }>(`api/studies/${named(name)}`, "PUT", { sheet, looks, overwrite }),
  upload: (files: { name: string; content: string }[]) => json<SheetInfo>("api/upload", "POST", { files }),
  begin: (product: string, wish: Wish, client: string, series?: string[]) =>
    json<Job>("api/jobs", "POST", { product, ...wish, client, ...(series ? { series } : {}) }),
  look: (job: string, wait: number) => json<Job>(`api/jobs/${named(job)}?wait=${wait}`),
  cancel: (job: string) => json<Job>(`api/jobs/${named(job)}`, "DELETE"),
  bytes: async (job: string) => new Uint8Array(await (await asked(`api/jobs/${named(job)}/content`)).arrayBuffer()),
  page: async (job: string) => unpack(await api.bytes(job)) as StudioPage,
  change: async (job: string) => unpack(await api.bytes(job)) as StudioChange,
};
