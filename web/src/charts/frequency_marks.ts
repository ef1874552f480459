// The frequencies that a spectrum marks: those of the run as it was, or of the live model's own robot.

import type { Chart } from "../contract";
import type { LiveRun } from "../contract_parts";
import type { Entry } from "./series";

/** Marks of the live model's own robot, where it reports them; null where those of the page hold. */
export function changedMarks(chart: Chart, run: LiveRun | null): Chart["marks"] | null {
  if (chart.group !== "spectrum" || chart.id === "spectrum_tip_nominal") return null; // marks of the actual robot
  return typeof run?.vibration === "object" ? run.vibration.marks : null;
}

/** Marks as far as the curves go. */
export function marksWithin(marks: Chart["marks"], entries: Entry[]): Chart["marks"] {
  const last = Math.max(0, ...entries.map((entry) => entry.x[entry.x.length - 1] ?? 0));
  return marks.filter(({ at }) => at <= last);
}
