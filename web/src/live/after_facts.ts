// Settling and residual vibration in words, as tmodes/result/summary.py and tmodes/report/facts.py tell them.

import { digits, info } from "../format";
import type { AfterMove } from "./after";
import type { Facts } from "./facts";
import type { Oscillation } from "./exponentials";
import type { Residual } from "./residual";
import type { Settled } from "./settling";

const SAID = 0.005; // share of the energy of a vibration from which on it is said
const [MOST_MODES, WEAK] = [3, 0.01];

const joined = (parts: string[], by = "; ") => parts.filter(Boolean).join(by);
const percent = (share: number) => `${Math.round(100 * share)} %`;

export function settlingFact({ time, limit, reason }: Settled, { cut }: AfterMove, within: string): Facts[string] {
  if (time === null) return { value: null, note: `not seen: ${joined([reason, reason.includes(cut) ? "" : cut])}` };
  return { value: time, note: reason || `within ${info(limit, "m")} of its rest, ${within}` };
}

/** `elements`: of each mode. */
export function vibrationFact(found: Residual, { cut }: AfterMove, elements: string[]): Facts[string] {
  const said = [found.reason];
  if (found.amplitude !== null && found.largest) {
    const axes = [..."xyz"].flatMap((axis, c) => (found.along[c] ? [`${axis} ${info(found.along[c], "m")}`] : []));
    said.push(`farthest from its mean ${info(found.largest, "m")} (${axes.join(", ")})`);
  }
  const named = found.modes.filter(({ amplitude }) => amplitude > WEAK * (found.amplitude ?? 0)).slice(0, MOST_MODES);
  if (named.length) {
    said.push(named.map((mode) => modeWords(mode, elements[found.modes.indexOf(mode)] ?? "")).join(", "));
    const further = found.modes.reduce((sum, mode) => sum + (named.includes(mode) ? 0 : mode.share), 0);
    said.push(`${percent(further)} in weaker modes, ${percent(found.unexplained)} in no mode`);
  }
  return { value: found.amplitude, note: joined([...said, cut]) };
}

/** Its natural frequency [Hz]. */
export function naturalOf({ frequency, damping }: Oscillation): number {
  return frequency / Math.sqrt(1 - damping ** 2);
}

/** `gear elbow` for the element `elbow.gear`, as tmodes/io/words.py. */
function elementWords(name: string): string {
  const [, owner, own] = /^(?:(.*)\.)?(.*)$/.exec(name)!;
  if (["gear", "spring", "controller", "motor"].includes(own)) return `${own} ${owner}`;
  return owner ? `link ${owner} (${own})` : name;
}

function modeWords(mode: Oscillation, element: string): string {
  const more = joined([
    elementWords(element),
    mode.drift ? `${digits(mode.drift[0], 3)} to ${digits(mode.drift[1], 3)} Hz as it decays` : "",
    mode.share >= SAID ? percent(mode.share) : "",
  ], ", ");
  return `${info(mode.amplitude, "m")} at ${digits(naturalOf(mode), 3)} Hz${more && ` (${more})`}`;
}
