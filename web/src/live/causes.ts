// The error of the tip by its causes, as tmodes/analysis/error_parts.py and tmodes/result/paths.py find it.

import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { affine } from "./live_scene";
import type { Regime } from "./regime";
import { tipAt, type Seen } from "./run_series";
import { difference, shaped, type SeriesOf } from "./series";
import { valueAt } from "./signals";

const SAME = 1e-12; // m between two commanded tips up to which both robots have the same dimensions

/** Of the actual robot, and of the nominal one where there is one, the first `count` samples. */
export function causesOf(
  engine: Engine, bundle: Bundle, [real, nominal]: (Regime | undefined)[], [own, planned]: (Seen | undefined)[],
  count: number,
): SeriesOf {
  if (!bundle.errorParts || !own || !real) return {};
  const wanted = (planned ?? own).model.q.slice();
  const width = wanted.length / count;
  for (const [coordinate, signal] of [...real.info.commanded, ...real.info.exact]) {
    for (let k = 0; k < count; k += 1)
      wanted[k * width + coordinate] = valueAt(real.schedule, signal, real.run.times[k]);
  }
  const actual = steps(engine, bundle, real, own, wanted, count);
  const alike = nominal && same(nominal.blocks.chain, real.blocks.chain) ? actual[0] : undefined;
  const known = planned && nominal ? steps(engine, bundle, nominal, planned, wanted, count, alike) : actual;
  const parts = parted(actual);
  const geometry = difference(actual[0], known[0]);
  const expected = parted(known);
  if (bundle.errorParts.length > parts.length || geometry.subarray(0, 3).some((value) => Math.abs(value) > SAME)) {
    parts.push(geometry);
    expected.push(new Float64Array(geometry.length));
  }
  const series = (each: Float64Array[]) => {
    const data = new Float64Array(3 * count * each.length);
    each.forEach((part, j) => {
      for (let k = 0; k < count; k += 1)
        for (let i = 0; i < 3; i += 1) data[3 * (k * each.length + j) + i] = part[3 * k + i];
    });
    return shaped(data, count, each.length, 3);
  };
  const found: SeriesOf = { tip_commanded: shaped(known[0], count, 3), tip_error: series(parts) };
  if (planned) found.tip_error_nominal = series(parts.map((part, k) => difference(part, expected[k])));
  return found;
}

/** By which elements the error of the tip is that at sample `k`: those of the actual robot, less the nominal one's. */
export function elementSteps(
  engine: Engine, bundle: Bundle, real: Regime, against: Seen, movers: [sign: number, seen: Seen][], k: number,
): { cause: string; element: string; vector: number[] }[] {
  const width = engine.layout.coordinates.length;
  const row = (seen: Seen) => seen.model.q.slice(k * width, (k + 1) * width);
  const wanted = row(against);
  for (const [coordinate, signal] of [...real.info.commanded, ...real.info.exact])
    wanted[coordinate] = valueAt(real.schedule, signal, real.run.times[k]);
  const found = bundle.elements.map(({ cause, name }) => ({ cause, element: name, vector: [0, 0, 0] }));
  for (const [sign, seen] of movers) {
    const [actual, moved] = [row(seen), wanted.slice()];
    for (const j of seen.regime.info.driven) moved[j] = actual[j];
    const shape = affine(seen.regime.blocks.straight, moved, 1);
    const shapes = [...shape];
    for (const { own } of bundle.elements) {
      for (const j of own) shape[j] = actual[j];
      shapes.push(...shape);
    }
    const tips = tipAt(engine, seen.regime, Float64Array.from(shapes), bundle.elements.length + 1);
    found.forEach(({ vector }, e) => {
      for (let i = 0; i < 3; i += 1) vector[i] += sign * (tips[3 * e + 3 + i] - tips[3 * e + i]);
    });
  }
  return found;
}

function parted(tips: Float64Array[]): Float64Array[] {
  return tips.slice(1).map((tip, k) => difference(tip, tips[k]));
}

function same(a: Float64Array, b: Float64Array): boolean {
  return a.every((value, k) => value === b[k]);
}

/**
 * The tip [n, 3] commanded (`known`: of a robot of the same dimensions and loads), with the motors where they are, with
 * the joints where they are, and as it is.
 */
function steps(
  engine: Engine, bundle: Bundle, mover: Regime, { model: { q }, tip: own }: Seen, wanted: Float64Array, count: number,
  known?: Float64Array,
): Float64Array[] {
  const width = q.length / count;
  const [moved, joints] = [wanted.slice(), q.slice()];
  for (let k = 0; k < q.length; k += width) {
    for (const j of mover.info.driven) moved[k + j] = q[k + j];
    for (const j of bundle.bends) joints[k + j] = 0;
  }
  let [before, tip] = [q, own];
  const found = [tip];
  const straight = (shape: Float64Array) => affine(mover.blocks.straight, shape, count);
  const shapes = [joints, straight(moved), straight(wanted)];
  for (const shape of shapes) {
    if (known && shape === shapes[2]) tip = known;
    else if (!same(shape, before)) tip = tipAt(engine, mover, shape, count);
    before = shape;
    found.unshift(tip);
  }
  return found;
}
