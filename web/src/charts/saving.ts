// A chart taken along: as a picture, as a vector graphic, as data.

import uPlot from "uplot";
import { button, save, savePicture } from "../dom";
import { csvOf } from "./csv";
import type { Look } from "./look";
import { chartPicture } from "./picture";
import type { PlotLine } from "./plot";
import type { Entry } from "./series";
import { sheetOf, svgOf, type Sheet } from "./svg";

/** A chart as it is drawn now; `pieces` are its plot's lines, `looks` those of its curves. */
export interface Drawn {
  id: string;
  titled: string;
  unit: string;
  abscissa: string;
  plot: uPlot;
  marks: { at: number }[];
  pieces: PlotLine[];
  looks: [Entry, Look][];
}

/** `drawn` gives null where there is no room to draw. */
export function saveButtons(drawn: () => Drawn | null): HTMLElement[] {
  const saver = (words: string, title: string, act: (one: Drawn) => void) => button(words, () => {
    const one = drawn();
    if (one) setTimeout(() => act(one)); // uPlot finds its axes a little later
  }, { class: "tool", title });
  return [
    saver("PNG", "Save this chart as a picture", ({ plot, titled, looks, id }) =>
      savePicture(chartPicture(plot.ctx.canvas, uPlot.pxRatio, titled, looks), id)),
    saver("SVG", "Save this chart as a vector graphic", (one) => saveSheets([drawnSheet(one)], one.id)),
    saver("CSV", "Save the data of this chart as CSV", ({ looks, abscissa, unit, id }) =>
      save(csvOf(looks.map(([entry]) => entry), abscissa, unit), `${id}.csv`, "text/csv")),
  ];
}

export function drawnSheet(one: Drawn): Sheet {
  return sheetOf(one, uPlot.pxRatio);
}

export function saveSheets(sheets: Sheet[], name: string): void {
  if (sheets.length) save(svgOf(sheets), `${name}.svg`, "image/svg+xml");
}
