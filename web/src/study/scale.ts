// Scales and ticks of a study's charts.
import { plain } from "../format";

export interface Scale {
  readonly min: number;
  readonly max: number;
  at(value: number): number;
  back(place: number): number;
  readonly ticks: [number, string][];
}

/** From values to places between `from` and `to` [px], with about `count` round ticks, or one for each label. */
export function scale(
  [min, max]: [number, number], [from, to]: [number, number], count: number, labels: string[] | null = null,
): Scale {
  const span = max - min || 1;
  return {
    min,
    max,
    at: (value) => from + ((value - min) / span) * (to - from),
    back: (place) => min + ((place - from) / (to - from)) * span,
    ticks: labels ? labelled(labels, min, max, count) : round(min, max, count).map((value) => [value, plain(value)]),
  };
}

/** The same, with values beyond its ends at them. */
export function clamped(scale: Scale): Scale {
  return { ...scale, at: (value) => scale.at(Math.min(Math.max(value, scale.min), scale.max)) };
}

/** The range of finite values, a little wider; of one value about it. */
export function rangeOf(values: ArrayLike<number>, labels: string[] | null = null, more: number[] = []): [number,
  number] {
  if (labels) return [-0.5, labels.length - 0.5];
  let [low, high] = [Infinity, -Infinity];
  for (const list of [values, more])
    for (let k = 0; k < list.length; k += 1) {
      const value = list[k];
      if (!Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  if (low > high) return [0, 1];
  const edge = 0.03 * (high - low) || 0.05 * Math.abs(high) || 0.5;
  return [low - edge, high + edge];
}

function labelled(labels: string[], min: number, max: number, count: number): [number, string][] {
  const step = Math.max(1, Math.ceil(labels.length / Math.max(count, 8)));
  const found: [number, string][] = labels.map((label, k) => [k, label]);
  return found.filter(([k]) => k >= min && k <= max && k % step === 0);
}

function round(min: number, max: number, count: number): number[] {
  const rough = (max - min) / Math.max(count, 1);
  if (!(rough > 0)) return [min];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((one) => one * power).find((one) => one >= rough * 0.999) ?? rough;
  const found = [];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; k += 1)
    found.push(Number((k * step).toPrecision(12)));
  return found;
}
