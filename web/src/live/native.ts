// Where a native run gives other numbers than this page, and the command that asks for it.

import type { LiveRun } from "../contract_parts";
import { info } from "../format";
import { tipOf } from "./after";
import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import type { Watch } from "./engine_run";
import { motionsOf } from "./motions";
import { runFrom, type Regime } from "./regime";
import type { Curves } from "./run";
import { difference, sizes } from "./series";

const LOST = ["chattering", "not_converged", "step_too_small", "stopped"]; // what other steps may pass
const NUDGE = 1e-13; // of coordinates [rad, m]: as large as rounding
const SIXTH = 5e-7; // of a number: where rounding moves less, its sixth digit holds
const EXACT = 1e-9; // m; what is smaller has no digits

/** The command of the changed run, as a shell takes it. */
export function commandOf({ origin, sliders }: Bundle, values: readonly number[]): string {
  const quoted = (text: string) => (/^[\w./:=+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);
  const changes = sliders.flatMap(({ path, value }, k) =>
    (values[k] === value ? [] : ["--set", quoted(`${path}=${values[k]}`)]));
  return ["tmodes run", quoted(origin), ...changes].join(" ");
}

/** Of a run that broke off here and may go on natively: that, and the command; else nothing. */
export function brokenAt(bundle: Bundle, values: readonly number[], status: string): Pick<LiveRun, "native"> {
  return LOST.includes(status)
    ? { native: `A native run, whose steps are others, may go on where this page ends: ${commandOf(bundle, values)}` }
    : {};
}

/** Why numbers of a finished run hold to fewer digits than others, and the command; nothing where they hold. */
export async function approximate(
  engine: Engine, bundle: Bundle, values: readonly number[], { real, nominal, run, judged }: Curves, watch: Watch,
): Promise<Pick<LiveRun, "native">> {
  const command = commandOf(bundle, values);
  const said = (why: string) => ({ native: `Approximate numbers: ${why}. Numbers with their errors: ${command}` });
  if (run.status !== "finished") return {};
  const method = otherMethod(engine, bundle, nominal ? [real, nominal.regime] : [real]);
  if (method) return said(`natively this run is by ${method}, here by ${bundle.settings.method}`);
  if (bundle.settings.note) return said(bundle.settings.note);
  if (!bundle.choice?.noisy.includes(bundle.settings.method)) return {};
  const start = real.run.states.slice(0, real.run.states.length / real.run.times.length);
  const given = real.info.exact.map(([k]) => real.info.state.q[0] + k);
  for (let k = real.info.state.q[0]; k < real.info.state.q[1]; k += 1) if (!given.includes(k)) start[k] += NUDGE;
  const other = await runFrom(engine, bundle, real, start, { ...watch, progress: undefined });
  if (other.status !== "finished") return said("what rounding leaves of this run does not reach its end");
  const apart = sizes(difference(tipOf(engine, real, other), tipOf(engine, real, real.run)), 3);
  const moved = apart.reduce((most, value) => Math.max(most, value), 0);
  const numbers = [judged.largest_m, judged.final_m, judged.residual?.amplitude_m].filter((one) => Number(one) > EXACT);
  return moved > SIXTH * Math.min(...numbers.map(Number), Infinity)
    ? said(`rounding moves the tip by ${info(moved, "m")} within the tolerances of ${bundle.settings.method}`)
    : {};
}

/** The method that a native run takes by its fastest motion, or by what holds its steps short; none: the page's. */
function otherMethod(engine: Engine, { choice, settings }: Bundle, regimes: Regime[]): string {
  if (!choice?.auto) return "";
  const { explicit, implicit, reach, most } = choice;
  const fastest = regimes.flatMap((one) => motionsOf(engine, one)).reduce(
    (size, { re, im }) => Math.max(size, Math.hypot(re, im)), 0);
  const stiff = fastest * settings.duration > most * reach || regimes.some(({ run: { statistics } }) =>
    settings.duration - Number(statistics.stiff_from_s ?? Infinity) > most * Number(statistics.mean_step_s));
  const method = stiff ? (implicit ?? explicit) : explicit;
  return method === settings.method ? "" : method;
}
