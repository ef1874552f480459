// What is chosen in a study's page: the quantity that is looked at, the ranges that are brushed, and one case.
import type { Column, StudyPage } from "./contract";

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

/** Rows in the order of a column's values, without those that have none. */
export function ranked(store: Store, column: Column): number[] {
  const { data } = column.values;
  return [...data.keys()].filter((row) => Number.isFinite(data[row]) && store.isGood(row)).sort((a, b) =>
    data[a] - data[b]);
}
