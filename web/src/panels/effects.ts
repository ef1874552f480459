// Which settings matter most: what one per cent of each changes in the number that the page leads with.

import type { Fact, Slider } from "../contract";
import type { LiveRun } from "../contract_parts";
import { digits } from "../format";
import type { SliderRow } from "./slider";
import type { Advice } from "./verdict";

/** A number that can be changed. */
export interface Setting {
  value: number;
  slider: Pick<Slider, "path" | "label" | "group" | "min" | "max" | "design">;
}

/** What makes runs, as `Live`. */
export interface Runs {
  run(values: number[], progress?: undefined, early?: (run: LiveRun) => void): Promise<Pick<LiveRun, "facts">>;
}

const LEADING = ["tip_error.commanded", "deviation.max", "deflection.max", "gear.max"];
const FIRST = LEADING.slice(0, 2); // those that come with the curves, before which none counts
const STEP = 0.01;
const PATIENCE = 6000; // ms that all runs may take
const NOTHING = 1e-6; // a share that is rounding
const FEWEST = 4; // settings that are worth the trouble

/** The leading number's fact, its value, and its changes by the settings; none where they are not measured. */
export interface Effects {
  number: string;
  whole: number;
  shares: (number | undefined)[];
}

/** Rows that are shown at first: of each kind the first, then the next of each. */
export function byKind(rows: SliderRow[], count: number): SliderRow[] {
  const kinds = [...new Set(rows.map((row) => row.slider.group))];
  const places = new Map(rows.map((row) => {
    const { group } = row.slider;
    const own = rows.filter((other) => other.slider.group === group);
    return [row, own.indexOf(row) * kinds.length + kinds.indexOf(group)];
  }));
  return [...rows].sort((one, other) => (places.get(one) ?? 0) - (places.get(other) ?? 0)).slice(0, count);
}

/**
 * Changes of the leading number, as shares of it, for one per cent more of each of the first `count` settings; where
 * that takes long of fewer, design variables first. Why not, where it cannot be; null where another run is wanted.
 */
export async function effects(
  live: Runs, rows: Setting[], count: number, wanted: () => boolean,
): Promise<Effects | string | null> {
  const own = rows.map((row) => row.value);
  const began = performance.now();
  const facts = await early(live, own, FIRST);
  const id = LEADING.find((name) => facts[name]?.value);
  if (!id) return "no error or deflection of this run is known";
  const whole = Number(facts[id].value);
  const most = Math.floor(PATIENCE / (performance.now() - began));
  const order = [...rows.slice(0, count).keys()];
  if (most < order.length) order.sort((j, k) => Number(designed(rows[k])) - Number(designed(rows[j])));
  if (most < Math.min(FEWEST, order.length)) return "measuring it would take more than 6 s";
  const shares: Effects["shares"] = [];
  for (const k of order.slice(0, most)) {
    if (!wanted()) return null;
    const { slider } = rows[k];
    const more = own[k] * (1 + STEP);
    const step = more <= slider.max && more >= slider.min ? STEP : -STEP;
    const values = own.map((value, j) => (j === k ? value * (1 + step) : value));
    const found = own[k] === 0 ? whole : ((await early(live, values, [id]))[id]?.value ?? whole);
    const share = (Math.sign(step) * (found - whole)) / Math.abs(whole);
    shares[k] = Math.abs(share) > NOTHING ? share : 0;
  }
  return { number: id, whole, shares };
}

const TIMES = 2; // as much a setting is changed to lessen the error
const LEAST = 1.1; // as much it can at least be changed to be worth a word
const TRIED = 4; // settings of a kind
const NAMED = 2;
const TASK = ["move", "payload"]; // groups of what the user of the robot chooses

export interface Change<Row extends Setting = Setting> {
  row: Row;
  value: number;
  /** Of the leading number, as a share of it. */
  change: number;
}

/**
 * Twice or half of which settings lessens the leading number most: design variables first, then the task; what nobody
 * chooses (constants of a material, surroundings) where the robot has no design variable; null as with `effects`.
 */
export async function lessening<Row extends Setting>(
  live: Runs, rows: Row[], { number, whole, shares }: Effects, wanted: () => boolean,
): Promise<Change<Row>[] | null> {
  const own = rows.map((row) => row.value);
  const best: Change<Row>[] = [];
  const share = (k: number) => shares[k] ?? 0;
  const order = rows.map((_, k) => k).filter((k) => share(k) && !rows[k].slider.path.startsWith("real:"));
  order.sort((j, k) => Math.abs(share(k)) - Math.abs(share(j)));
  const kinds = rows.some(designed) ? [designed, ofTask] : [designed, ofTask, (row: Setting) => !ofTask(row)];
  for (const kind of kinds) {
    const found: Change<Row>[] = [];
    for (const k of order.filter((j) => kind(rows[j])).slice(0, TRIED)) {
      if (!wanted()) return null;
      const { min, max } = rows[k].slider;
      const value = Math.min(Math.max(own[k] * (share(k) < 0 ? TIMES : 1 / TIMES), min), max);
      if (Math.max(value / own[k], own[k] / value) < LEAST) continue;
      const facts = await early(live, own.map((other, j) => (j === k ? value : other)), [number]);
      const change = (Number(facts[number]?.value ?? whole) - whole) / Math.abs(whole);
      if (change < -STEP) found.push({ row: rows[k], value, change });
    }
    for (const one of found.sort((a, b) => a.change - b.change))
      if (best.every(({ row }) => !overlap(row, one.row))) best.push(one);
    if (best.length >= NAMED) break;
  }
  return best.slice(0, NAMED);
}

/** Whether one of two settings moves the other's number, among all of its kind. */
function overlap(...[one, other]: [Setting, Setting]): boolean {
  const [some, own] = [one.slider.path, other.slider.path].map((path) => path.split("."));
  return some.length === own.length && some.every((step, k) => [step, own[k]].includes("*") || step === own[k]);
}

function designed({ slider }: Setting): boolean {
  return slider.design === true;
}

function ofTask({ slider }: Setting): boolean {
  return !slider.design && TASK.includes(slider.group);
}

/** `gear stiffness ×2: −21 %`, and what applies it. */
export function adviceOf({ row, value, change }: Change, apply: () => void): Advice {
  const times = value > row.value ? `×${digits(value / row.value, 2)}` : `÷${digits(row.value / value, 2)}`;
  const name = row.slider.label.replace(/: factor$/, "");
  return { text: `${name} ${times}: −${digits(-100 * change, 2)} %`, apply };
}

/**
 * The facts that a run gives first, if one of those named is among them, else those that come with its picture; none of
 * one that is refused. Rejects where somebody else wants a run.
 */
async function early(live: Runs, values: number[], named: string[]): Promise<LiveRun["facts"]> {
  return new Promise((resolve, reject) => {
    const heard = (run: LiveRun) => {
      if (run.scene || named.some((id) => run.facts[id]?.value)) resolve(run.facts);
    };
    live.run(values, undefined, heard).then((run) => resolve(run.facts), (problem: Error) => {
      if (problem.name === "Superseded") reject(problem);
      else resolve({});
    });
  });
}

export function nameOf(id: string, facts: Fact[]): string {
  return (facts.find((fact) => fact.id === id)?.name ?? id).toLowerCase();
}
