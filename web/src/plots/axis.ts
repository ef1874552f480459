// Scales of a chart's axes: even, logarithmic, logarithmic to both sides, rows with names.
import { plain } from "../format";
import { rangeOf, scale, type Scale } from "../study/scale";
import type { Axis } from "./contract";

type Ends = [number, number];

const APART = 30; // of the first tick from 0 where an axis is logarithmic to both sides [px]

/** The scale of an axis that shows `values`, on the places between `ends` [px]. */
export function axisScale(axis: Axis, values: number[], ends: Ends, count: number, most = Infinity): Scale {
  if (axis.names) return rows(axis.names, ends, most);
  if (axis.scale === "linear") return scale(axis.range ?? rangeOf(values), ends, count);
  const { bend } = axis;
  const [to, from] = axis.scale === "log" ? [Math.log10, (place: number) => 10 ** place] :
    [(value: number) => Math.asinh(value / bend), (place: number) => bend * Math.sinh(place)];
  const shown = axis.range ?? values.filter((value) => axis.scale !== "log" || value > 0);
  const [low, high] = rangeOf(shown.map(to));
  const even = scale(axis.range ? [to(axis.range[0]), to(axis.range[1])] : [low, high], ends, count);
  const apart = (value: number) => axis.scale === "log" || !value || Math.abs(even.at(to(value)) - even.at(0)) > APART;
  return { min: from(even.min), max: from(even.max), at: (value) => even.at(to(value)),
    back: (place) => from(even.back(place)),
    ticks: ticks(axis, [from(even.min), from(even.max)], count).filter(apart).map((value) => [value, plain(value)]) };
}

/** Powers of ten, of few decades 2 and 5 times these, too; of both signs and zero. */
function ticks({ scale: kind, bend }: Axis, [low, high]: Ends, count: number): number[] {
  const size = Math.max(Math.abs(low), Math.abs(high));
  const first = Math.floor(Math.log10(kind === "log" ? low : bend) + 1e-9);
  const decades = Math.log10(size) - first;
  const step = Math.max(1, Math.ceil(((kind === "log" ? 1 : 2) * decades) / (2 * count)));
  const parts = kind === "log" && decades < count / 3 ? [1, 2, 5] : [1];
  const found: number[] = [];
  for (let power = first; power <= Math.log10(size); power += step)
    found.push(...parts.map((part) => part * 10 ** power));
  const all = kind === "log" ? found : [...found.map((value) => -value).reverse(), 0, ...found];
  const slack = 1e-9 * size;
  return all.filter((value) => value >= low - Math.min(slack, Math.abs(low) * 1e-9) && value <= high + slack);
}

function rows(names: string[], [bottom, top]: Ends, most: number): Scale {
  const even = scale([names.length - 0.5, -0.5], [bottom, top], 1);
  const short = (name: string) => name.length > most ? `${name.slice(0, most - 1)}…` : name;
  return { ...even, ticks: names.map((name, k) => [k, short(name)]) };
}

/** Ranges of two axes, wider where needed, so that one unit is as long in both directions. */
export function alike(x: Ends, y: Ends, width: number, height: number): [Ends, Ends] {
  const unit = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height);
  const wider = ([low, high]: Ends, room: number): Ends => {
    const [middle, half] = [(low + high) / 2, (unit * room) / 2];
    return [middle - half, middle + half];
  };
  return [wider(x, width), wider(y, height)];
}
