// A part of a run that is taken again as it was where none of its numbers changed.

import type { Blocks } from "./map";

/** Keeps what was made last, by the numbers it was made of. */
export class Kept<T> {
  private last: { blocks: Blocks; made: T } | null = null;

  /** What was made of the same numbers, else what `make` gives now. */
  async of(blocks: Blocks, make: () => Promise<T>): Promise<T> {
    if (this.last && same(this.last.blocks, blocks)) return this.last.made;
    this.last = null;
    const made = await make();
    this.last = { blocks, made };
    return made;
  }
}

function same(a: Blocks, b: Blocks): boolean {
  return Object.entries(a).every(
    ([name, values]) => values.length === b[name].length && values.every((value, k) => value === b[name][k]),
  );
}
