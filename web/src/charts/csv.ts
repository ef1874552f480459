// The data of a chart as comma-separated values, as spreadsheets read them.

import { aligned, type Entry } from "./series";

export function csvOf(entries: Entry[], abscissa: string, unit: string): string {
  const [axis, ...columns] = aligned(entries, false);
  const severalRuns = new Set(entries.map((entry) => entry.run)).size > 1;
  const heads = entries.map((entry) => {
    const words = [severalRuns ? entry.runName : "", entry.label, entry.part, entry.ghost ? "original" : ""];
    return `${words.filter(Boolean).join(" ")} [${unit || "-"}]`;
  });
  const rows = Array.from(axis, (at, k) => [at, ...columns.map((column) => column[k] ?? "")].map(shortest).join(","));
  return `${[abscissa, ...heads].map(quoted).join(",")}\n${rows.join("\n")}\n`;
}

/** Nine digits: what single precision holds, and no more. */
function shortest(value: number | string): string {
  return typeof value === "string" ? value : String(Number(value.toPrecision(9)));
}

/** In quotes, and never a formula to a spreadsheet. */
function quoted(text: string): string {
  const harmless = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return `"${harmless.replaceAll('"', '""')}"`;
}
