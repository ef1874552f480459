// How a run of a compiled time loop ended, in words, as tmodes/simulation/parts.py states it.

import { digits } from "../format";
import type { Layout } from "./engine";

/** A run as it ended. */
export interface Ended {
  layout: Layout;
  settings: { duration: number; maxSteps: number };
  /** Of the layout's statuses. */
  status: number;
  time: number; // s
  lastStep: number; // s
  /** Rates of the state at its end. */
  rates: () => Float64Array;
}

/** Status and message of a run that ended, or that was stopped. */
export function ending(run: Ended): [string, string] {
  const { settings, status } = run;
  const { statuses, limits } = run.layout;
  const t = `t = ${digits(run.time, 6)} s`;
  if (status === statuses.finished) return ["finished", `completed at t = ${digits(settings.duration, 6)} s`];
  if (status === statuses.running) {
    return [
      "stopped",
      `stopped at ${t} of ${digits(settings.duration, 6)} s: ` +
        `integration.max_steps = ${settings.maxSteps} is used up`,
    ];
  }
  if (status === statuses.chattering) {
    const often = `more than ${limits.most_events} times within ${limits.event_time} s`;
    return [
      "chattering",
      `stopped at ${t}: the contact started or ended ${often}; give the surface damping, or a lower stiffness`,
    ];
  }
  return lost(run, t);
}

/** Where the motion could not be followed: the coordinate of largest acceleration, and what is likely the cause. */
function lost({ layout, status, lastStep, rates }: Ended, at: string): [string, string] {
  const { statuses, coordinates, limits } = layout;
  const count = coordinates.length;
  const sizes = Array.from(rates().subarray(count, 2 * count), (a) =>
    Number.isFinite(a) ? Math.abs(a) : Infinity,
  );
  const k = sizes.indexOf(Math.max(...sizes));
  const followed = sizes[k] < limits.bound;
  const kind = !followed
    ? "diverged"
    : status === statuses.not_converged
      ? "not_converged"
      : status === statuses.step_too_small
        ? "step_too_small"
        : "diverged";
  const value = `its acceleration is ${digits(sizes[k], 3)} rad/s^2`;
  const words = kind.replaceAll("_", " ");
  return [
    kind,
    `${words} at ${at} in coordinate ${coordinates[k]}: ${value}; ` +
      `its last step was of ${digits(lastStep, 3)} s`,
  ];
}
