// What a run comes to, as tmodes/result/verdict.py: its numbers, and the sentence by the phrases that it is given.

import { alongSum } from "../along";
import type { Verdict } from "../contract";
import { damping, info } from "../format";
import type { Bundle } from "./bundle";
import { elementSteps } from "./causes";
import type { Engine } from "./engine";
import type { Limit } from "./load_facts";
import type { Loads } from "./loads";
import type { Regime } from "./regime";
import type { Residual } from "./residual";
import type { Seen } from "./run_series";
import { columns, range, worst, type SeriesOf } from "./series";
import { firstJump } from "./signals";
import type { Settled } from "./settling";

export type Judged = Omit<Verdict, "level" | "sentence">;

const PASSED = 1 + 1e-6; // share of a limit from which on it is passed, as tmodes/result/verdict.py
const EXACT = 1e-9; // error [m] up to which a point follows its path, and share of it below which a part is rounding

/** The error of the tip and its causes, by the curves of a run. */
export function judgedOf(
  engine: Engine, bundle: Bundle, real: Regime, [own, planned]: (Seen | undefined)[], times: Float64Array,
  series: SeriesOf, limits: Limit[],
): Judged {
  const against = series.tip_error ? "commanded" : series.deviation ? "nominal" : null;
  const parts = against === "commanded" ? series.tip_error : series.tip_error_nominal;
  const sizes = against === "nominal"
    ? series.deviation.data
    : Float64Array.from(against ? times : [], (_, k) => alongSum(parts, k, -1));
  const k = worst(sizes);
  const culprits: Judged["culprits"] = [];
  if (own && parts && sizes[k] > EXACT) {
    const movers: [number, Seen][] = against === "nominal" && planned ? [[1, own], [-1, planned]] : [[1, own]];
    const steps = elementSteps(engine, bundle, real, planned ?? own, movers, k);
    const causes = ["gears", "links", ...steps.map(({ cause }) => cause)];
    const total = range(0, 3).map((i) => range(0, parts.shape[1]).reduce(
      (sum, part) => sum + parts.data[3 * (parts.shape[1] * k + part) + i], 0));
    range(0, parts.shape[1]).forEach((part) => {
      const cause = bundle.errorParts![part] ?? "geometry";
      if (!cause.split(", ").every((one) => causes.includes(one)))
        culprits.push({ cause, element: null, value_m: alongSum(parts, k, part) });
    });
    for (const { cause, element, vector } of steps) {
      const value = vector.reduce((sum, x, i) => sum + x * total[i], 0) / Math.hypot(...total);
      culprits.push({ cause: cause.replace(/s$/, ""), element, value_m: value });
    }
  }
  return {
    point: "tip", against, largest_m: against ? sizes[k] : null, time_s: against ? times[k] : null,
    final_m: against ? sizes[times.length - 1] : null, bends: against ? null : gearOf(bundle, times, series),
    settling: { time_s: null, within_m: null, reason: "" }, residual: null, limits: ordered(limits),
    jump: jumpOf(real, times[times.length - 1]),
    culprits: culprits.filter(({ value_m: value }) => Math.abs(value) > EXACT * sizes[k])
      .sort((one, other) => Math.abs(other.value_m) - Math.abs(one.value_m)),
    tolerance_m: bundle.judged.tolerance,
  };
}

function jumpOf({ info, each }: Regime, end: number): Judged["jump"] {
  const all = info.commands.map(([joint, k]) => ({ joint, time_s: firstJump(each[k], end) }));
  const [first] = all.sort((one, other) => one.time_s - other.time_s || (one.joint < other.joint ? -1 : 1));
  return first?.time_s < Infinity ? first : null;
}

function ordered(limits: Limit[]): Limit[] {
  return [...limits].sort((one, other) => other.share - one.share);
}

function gearOf({ deformations, turning }: Bundle, times: Float64Array, series: SeriesOf): Judged["bends"] {
  const all = deformations.flatMap((name, k) => (name.endsWith(".gear") ? [k] : []));
  const turned = all.filter((k) => turning.includes(deformations[k].slice(0, -".gear".length)));
  const gears = turned.length ? turned : all; // radians and meters are not compared
  if (!gears.length) return null;
  const angles = columns(series.deformation.data, deformations.length, gears);
  const k = worst(angles);
  const element = deformations[gears[k % gears.length]].replace(/\.gear$/, "");
  const unit = turning.includes(element) ? "rad" : "m";
  return { cause: "gear", element, value: Math.abs(angles[k]), unit, time_s: times[Math.floor(k / gears.length)] };
}

/** With the stresses, and where nothing else is known of the tip the link that is deflected most. */
export function withLoads(
  judged: Judged, { links }: Loads, strengths: Record<string, number>, times: Float64Array,
): Judged {
  const stresses = links.flatMap(({ name, largest: { stress } }) => (stress && name in strengths
    ? [{ quantity: "stress", element: name, value: stress.value, limit: strengths[name], unit: "Pa",
      share: stress.value / strengths[name] }]
    : []));
  const bent = links.flatMap(({ largest: { deflection } }) => deflection ?? []).sort((a, b) => b.value - a.value)[0];
  const bends = judged.against || !bent?.value ? judged.bends : {
    cause: "link" as const, element: bent.link, value: bent.value, unit: "m", time_s: times[bent.sample],
  };
  return { ...judged, bends, limits: ordered([...stresses, ...judged.limits]) };
}

export function withRest(
  judged: Judged, { time, limit, reason }: Settled, { amplitude, modes: [mode] }: Residual,
): Judged {
  return {
    ...judged, settling: { time_s: time, within_m: limit, reason },
    residual: mode && amplitude !== null ? {
      amplitude_m: amplitude, frequency_Hz: mode.frequency / Math.sqrt(1 - mode.damping ** 2),
      damping: mode.damping,
    } : null,
  };
}

/** Of a run that is judged by another point than its tip, whose errors are found natively alone: its limits. */
export function unjudged(judged: Judged): Judged {
  const none = { against: null, largest_m: null, time_s: null, final_m: null, bends: null, jump: null, culprits: [] };
  return { ...judged, ...none, settling: { time_s: null, within_m: null, reason: "" }, residual: null };
}

/** The verdict, with its level and its sentence. */
export function verdictOf(
  { judged: { phrases } }: Bundle, found: Judged, status: string, message: string, warned: boolean,
): Verdict {
  const { tolerance_m: tolerance, largest_m: largest } = found;
  const within = !warned && found.limits.every(({ share }) => share <= PASSED);
  const level = status !== "finished" ? "bad"
    : tolerance === null || largest === null ? "neutral"
    : largest > tolerance ? "bad" : within ? "good" : "neutral";
  const known = said(found, status === "finished" ? "" : message.replaceAll("`", ""));
  const has = (text: string) => [...text.matchAll(/\{(\w+)\}/g)].every(([, name]) => known[name]);
  const words = phrases.map((part) => part.find(has) ?? "").join("");
  return { ...found, level, sentence: words.replace(/\{(\w+)\}/g, (_, name: string) => String(known[name])) };
}

/** The fields of the sentence: what is not known is empty. */
function said(found: Judged, failure: string): Record<string, string | false | null> {
  const { largest_m: largest, against, tolerance_m: tolerance, settling, residual, bends, point } = found;
  const written = (value: number | null, unit: string, count = 3) => info(value, unit, count).replace(/\u00a0/g, " ");
  const off = largest !== null && largest > EXACT;
  const [within, settled] = [settling.within_m ?? 0, settling.time_s];
  const seen = residual && (settled === null || residual.amplitude_m > within);
  const jump = seen && found.jump;
  const [passed, ...others] = found.limits.filter(({ share }) => share > PASSED);
  const judged = tolerance !== null && largest !== null;
  return {
    failure,
    subject: against && point[0].toUpperCase() + point.slice(1),
    it: against ? "it" : `the ${point.replace(/^the /, "")}`,
    path: against,
    largest: off && written(largest, "m"), final: off && written(found.final_m, "m"),
    when: off && written(found.time_s, "s"),
    link: bends?.cause === "link" && bends.element, gear: bends?.cause === "gear" && bends.element,
    deflection: bends && written(bends.value, bends.unit), at: bends && written(bends.time_s, "s"),
    kept: judged && largest <= tolerance && written(tolerance, "m"),
    missed: judged && largest > tolerance && written(tolerance, "m"),
    within: !failure && settled !== null && !settling.reason && written(within, "m"),
    settled: settled ? written(settled, "s") : false,
    reason: !failure && settled === null && settling.reason,
    frequency: seen && written(residual.frequency_Hz, "Hz"),
    damping: seen && damping(residual.damping).replace(/\u00a0/g, " "),
    jumper: jump && jump.joint,
    jumped: jump && written(jump.time_s, "s"),
    quantity: passed ? passed.quantity[0].toUpperCase() + passed.quantity.slice(1) : false,
    element: passed?.element ?? false,
    value: passed ? written(passed.value, passed.unit) : false,
    limit: passed ? written(passed.limit, passed.unit) : false,
    others: others.map(({ quantity, element }) => `${quantity} of ${element}`).join(", "),
  };
}
