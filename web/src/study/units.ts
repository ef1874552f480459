// Numbers of a study in SI units as a person reads them: millimetres where they are small.
import { readable } from "../format";
import type { Numbers } from "../pack";
import type { Column, StudyPage } from "./contract";

const SI = ["m", "rad", "s", "N", "N m", "Pa", "W", "J", "m/N"];

/** The same page, with each column in a unit in which its median reads well. */
export function readably(page: StudyPage): StudyPage {
  const factors = new Map<string, number>();
  for (const column of [...page.parameters, ...page.quantities]) {
    if (!SI.includes(column.unit) || column.labels) continue;
    const sizes = [...column.values.data].map(Math.abs).filter((size) => size > 0).sort((a, b) => a - b);
    const { factor, name } = readable(column.unit, sizes[sizes.length >> 1] ?? 0);
    if (factor === 1) continue;
    factors.set(column.name, factor);
    rescale(column, factor);
    column.unit = name;
  }
  for (const found of page.tornados) {
    const factor = factors.get(found.quantity) ?? 1;
    found.base *= factor;
    for (const bar of found.bars) [bar.low, bar.high] = [factor * bar.low, factor * bar.high];
    found.unit = page.quantities.find(({ name }) => name === found.quantity)?.unit ?? found.unit;
  }
  for (const limit of page.designs?.limits ?? []) limit.bound *= factors.get(limit.column) ?? 1;
  const start = page.designs?.start ?? {};
  for (const name of Object.keys(start)) start[name] *= factors.get(name) ?? 1;
  return page;
}

function rescale(column: Column, factor: number): void {
  const times = (numbers: Numbers): Numbers => ({ ...numbers, data: numbers.data.map((value) => factor * value) });
  column.values = times(column.values);
  column.edges &&= times(column.edges);
  column.percentiles = column.percentiles.map(([share, value]) => [share, factor * value]);
  if (column.nominal !== null) column.nominal *= factor;
  column.factor /= factor;
}
