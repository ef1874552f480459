// A chart as a picture that can be taken along: its title, its curves, and what they are.

import { colour, type Look } from "./look";
import type { Entry } from "./series";

const [LINE, EDGE] = [18, 12]; // px

/** Of a plot's canvas, `ratio` of whose pixels are one of the page; `looks` are those of the curves that are shown. */
export function chartPicture(
  plot: HTMLCanvasElement, ratio: number, title: string, looks: [Entry, Look][],
): HTMLCanvasElement {
  const keys = keysOf(looks);
  const canvas = document.createElement("canvas");
  const [width, height] = [plot.width / ratio, plot.height / ratio];
  canvas.width = plot.width;
  canvas.height = plot.height + ratio * LINE * (keys.length + 2);
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  context.fillStyle = colour("--paper");
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(plot, 0, ratio * 1.5 * LINE);
  context.scale(ratio, ratio);
  context.fillStyle = colour("--ink");
  context.font = "600 14px system-ui, sans-serif";
  context.fillText(title, EDGE, LINE, width - 2 * EDGE);
  context.font = "12px system-ui, sans-serif";
  keys.forEach(({ words, look }, k) => {
    const y = height + LINE * (k + 2);
    context.strokeStyle = colour(look.property);
    context.lineWidth = 2;
    context.setLineDash(look.dash);
    context.beginPath();
    context.moveTo(EDGE, y - 4);
    context.lineTo(EDGE + 26, y - 4);
    context.stroke();
    context.fillText(words, EDGE + 34, y, width - EDGE - 40);
  });
  return canvas;
}

/** What the curves are, each once. */
export function keysOf(looks: [Entry, Look][]): { words: string; look: Look }[] {
  const known = new Set<string>();
  return looks.filter(([{ ghost }]) => !ghost).flatMap(([entry, look]) => {
    const words = entry.role === "real" ? entry.label : `${entry.label}, ${entry.part}`;
    return known.size < known.add(words).size ? [{ words, look }] : [];
  });
}
