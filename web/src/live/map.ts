// From what the sliders say to all numbers of a run: tmodes/live/map.py found the forms, here they are evaluated.

import { doubles, type FormInfo, type MapInfo } from "./bundle";

/** The numbers of a run by the names of their blocks. */
export type Blocks = Record<string, Float64Array>;

/** Where the knobs of a run stand; those of an actual robot (all but `reference`) with its factors. */
export function knobValues(map: MapInfo, values: readonly number[], run: string): number[] {
  const known = map.knobs.map((knob) => knob.start);
  const factors = map.knobs.map((knob) => knob.factor);
  map.sliders.forEach((slider, k) => {
    if (slider.real) factors[slider.knob] = values[k];
    else known[slider.knob] = values[k];
  });
  if (run === "reference") return known;
  return map.knobs.map((knob, k) => {
    const factor = factors[k];
    if (factor === null || knob.factor === null) return known[k];
    if (!knob.together) return known[k] * factor;
    return knob.factor ? known[k] * (factor / knob.factor) : known[k];
  });
}

/** All numbers of a run for values of the sliders. */
export function numbersOf(map: MapInfo, values: readonly number[], run: string): Blocks {
  const form = map.runs[run];
  const vector = evaluated(form, knobValues(map, values, run));
  const blocks: Blocks = {};
  for (const [name, place] of Object.entries(form.places)) {
    const size = place.shape.reduce((product, length) => product * length, 1);
    blocks[name] = vector.slice(place.start, place.start + size);
  }
  return blocks;
}

function evaluated(form: FormInfo, knobs: number[]): Float64Array {
  const vector = doubles(form.base).slice();
  const ratios = form.powers.map((pairs) => product(pairs, (k, p) => Math.pow(knobs[k] / form.variables[k].start, p)));
  const shares = form.powers.map((pairs) => product(pairs, (k, p) => share(form.variables[k], p, knobs[k])));
  const { products, terms, coefficients } = form;
  for (let k = 0; k < products.data.length; k += 2) vector[products.data[k]] *= ratios[products.data[k + 1]];
  for (let k = 0; k < terms.data.length; k += 2) {
    vector[terms.data[k]] += coefficients.data[k / 2] * shares[terms.data[k + 1]];
  }
  return vector;
}

function product(pairs: [number, number][], factor: (k: number, p: number) => number): number {
  return pairs.reduce((value, [k, p]) => value * factor(k, p), 1);
}

function share(one: { start: number; far: number }, p: number, value: number): number {
  const start = Math.pow(one.start, p);
  return (Math.pow(value, p) - start) / (Math.pow(one.far, p) - start);
}
