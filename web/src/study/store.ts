// What is chosen in a study's page: the quantity that is looked at, the ranges that are brushed, and one case.
import { plain, pretty } from "../format";
import type { Column, StudyPage } from "./contract";
import { rangeOf } from "./scale";

export type Change = "quantity" | "brush" | "case";

export class Store {
  quantity: string;
  row: number | null = null;
  readonly brushes = new Map<string, [number, number]>();
  private readonly listeners: ((change: Change) => void)[] = [];

  constructor(readonly page: StudyPage) {
    this.quantity = page.quantities[0].name;
  }

  get columns(): Column[] {
    return [...this.page.parameters, ...this.page.quantities];
  }

  get shown(): Column {
    return this.column(this.quantity);
  }

  column(name: string): Column {
    const found = this.columns.find((one) => one.name === name);
    if (!found) throw new Error(`this study has no ${name}`);
    return found;
  }

  get size(): number {
    return this.page.case.data.length;
  }

  isGood(row: number): boolean {
    return this.page.good[this.page.status.data[row]];
  }

  /** What was chosen from lists, or the number of the case. */
  nameOf(row: number): string {
    const { page } = this;
    const chosen = page.parameters.flatMap(({ labels, values }) => labels?.[values.data[row]] ?? []);
    return page.designs ? chosen.join(" + ") || `Design ${page.case.data[row]}` : `Case ${page.case.data[row]}`;
  }

  /** Whether a case lies in all brushed ranges. */
  inside(row: number): boolean {
    for (const [name, [low, high]] of this.brushes) {
      const value = this.column(name).values.data[row];
      if (!(value >= low && value <= high)) return false;
    }
    return true;
  }

  listen(act: (change: Change) => void): void {
    this.listeners.push(act);
  }

  look(quantity: string): void {
    this.quantity = quantity;
    this.say("quantity");
  }

  brush(name: string, range: [number, number] | null): void {
    if (range) this.brushes.set(name, range);
    else this.brushes.delete(name);
    this.say("brush");
  }

  clear(): void {
    this.brushes.clear();
    this.say("brush");
  }

  pick(row: number | null): void {
    this.row = row;
    this.say("case");
  }

  private say(change: Change): void {
    for (const act of this.listeners) act(change);
  }
}

/** A value of a case in words. */
export function valueOf(column: Column, row: number, unit = pretty(column.unit)): string {
  const value = column.values.data[row];
  if (!Number.isFinite(value)) return "–";
  return column.labels ? column.labels[value] ?? "–" : `${plain(value)}\u00a0${unit}`.trimEnd();
}

const NEAR = 14;

/** The case whose place `at` is the nearest to a point [px], null where none is near. */
export function nearestRow(
  store: Store, at: (row: number) => [number, number] | null, left: number, top: number,
): number | null {
  let [best, nearest]: [number | null, number] = [null, NEAR];
  for (let row = 0; row < store.size; row += 1) {
    const [x, y] = at(row) ?? [Infinity, Infinity];
    const apart = Math.hypot(x - left, y - top);
    if (apart < nearest) [best, nearest] = [row, apart];
  }
  return best;
}

/**
 * What an axis of a column shows: all good cases and `more`; others, whose numbers may be of any size, as far as they
 * lie within twice that range.
 */
export function spanOf(store: Store, column: Column, more: number[] = []): [number, number] {
  const all = [...column.values.data].filter((value) => Number.isFinite(value));
  const good = [...column.values.data].filter((value, row) => store.isGood(row) && Number.isFinite(value));
  if (column.labels || !good.length) return rangeOf(all, column.labels, more);
  const [low, high] = rangeOf(good, null, more);
  const [inside, edge] = [all.filter((value) => value > 2 * low - high && value < 2 * high - low), 0.02 * (high - low)];
  const [least, most] = [inside.reduce((a, b) => Math.min(a, b)), inside.reduce((a, b) => Math.max(a, b))];
  return [Math.min(low, least - edge), Math.max(high, most + edge)];
}

/** Rows in the order of a column's values, without those that have none. */
export function ranked(store: Store, column: Column): number[] {
  const { data } = column.values;
  return [...data.keys()].filter((row) => Number.isFinite(data[row]) && store.isGood(row)).sort((a, b) =>
    data[a] - data[b]);
}
