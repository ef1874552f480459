// A chart as a vector graphic: its axes with units, its curves and what they are; several of them on one sheet.

import type uPlot from "uplot";
import { colour } from "./look";
import { keysOf } from "./picture";
import type { Drawn } from "./saving";

const [LINE, EDGE, GAP] = [18, 12, 28]; // px
const DIGITS = 2;

/** Width, height [px] and content of a drawn chart. */
export interface Sheet {
  width: number;
  height: number;
  content: string;
}

/** One chart. */
export function sheetOf({ plot, titled, marks, looks, pieces, abscissa }: Drawn, ratio: number): Sheet {
  const [width, tall] = [plot.width, plot.height];
  const keys = keysOf(looks);
  const box = { left: plot.bbox.left / ratio, top: plot.bbox.top / ratio + 1.5 * LINE,
    width: plot.bbox.width / ratio, height: plot.bbox.height / ratio };
  const [right, bottom] = [box.left + box.width, box.top + box.height];
  const x = (value: number) => box.left + plot.valToPos(value, "x");
  const y = (value: number) => box.top + plot.valToPos(value, "y");
  const height = tall + LINE * (keys.length + 2);
  const parts = [text(EDGE, LINE, titled, "--ink", 'font-weight="600" font-size="14"')];
  const [across, up] = plot.axes.map(ticks);
  for (const [value, word] of across) {
    if (x(value) < box.left - 1 || x(value) > right + 1) continue;
    parts.push(stroke(`M${at(x(value))} ${at(box.top)}V${at(bottom + 4)}`, "--grid"));
    parts.push(text(x(value), bottom + 17, word, "--quiet", 'text-anchor="middle"'));
  }
  for (const [value, word] of up) {
    if (y(value) < box.top - 1 || y(value) > bottom + 1) continue;
    parts.push(stroke(`M${at(box.left - 4)} ${at(y(value))}H${at(right)}`, "--grid"));
    parts.push(text(box.left - 7, y(value) + 4, word, "--quiet", 'text-anchor="end"'));
  }
  parts.push(text((box.left + right) / 2, bottom + 35, abscissa, "--quiet", 'text-anchor="middle"'));
  const curves = pieces.map((piece, k) => curve(plot, k + 1, x, y, piece));
  const marked = marks.map((one) => stroke(`M${at(x(one.at))} ${at(box.top)}V${at(bottom)}`, "--quiet", [3, 3]));
  parts.push(`<svg x="${at(box.left)}" y="${at(box.top)}" width="${at(box.width)}" height="${at(box.height)}" ` +
    `viewBox="${[box.left, box.top, box.width, box.height].map(at).join(" ")}">${curves.join("")}` +
    `${marked.join("")}</svg>`);
  keys.forEach(({ words, look }, k) => {
    const line = tall + LINE * (k + 2);
    parts.push(stroke(`M${EDGE} ${line - 4}h26`, look.property, look.dash, 2));
    parts.push(text(EDGE + 34, line, words, "--ink"));
  });
  return { width, height, content: parts.join("\n") };
}

/** Charts in rows of two, as a file. */
export function svgOf(sheets: Sheet[]): string {
  const columns = Math.min(2, sheets.length);
  const wide = Math.max(...sheets.map(({ width }) => width)) + GAP;
  let top = 0;
  const placed: string[] = [];
  for (let k = 0; k < sheets.length; k += columns) {
    const row = sheets.slice(k, k + columns);
    row.forEach((sheet, j) => placed.push(`<g transform="translate(${at(j * wide)} ${at(top)})">${sheet.content}</g>`));
    top += Math.max(...row.map(({ height }) => height)) + (sheets.length > columns ? GAP : 0);
  }
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${at(columns * wide)}" height="${at(top)}" ` +
    `viewBox="0 0 ${at(columns * wide)} ${at(top)}" font-family="system-ui, sans-serif" font-size="12">\n` +
    `<rect width="100%" height="100%" fill="${colour("--paper")}"/>\n${placed.join("\n")}\n</svg>\n`;
}

/** Places and words of an axis as uPlot has drawn it. */
function ticks(axis: uPlot.Axis): [number, string][] {
  const { _splits: splits, _values: words } = axis as { _splits?: number[]; _values?: (string | null)[] };
  return (splits ?? []).flatMap((value, k) => (words?.[k] ? [[value, words[k]] as [number, string]] : []));
}

function curve(
  plot: uPlot, k: number, x: (value: number) => number, y: (value: number) => number, piece: Drawn["pieces"][number],
): string {
  const [axis, values] = [plot.data[0], plot.data[k]];
  const { min = -Infinity, max = Infinity } = plot.scales.x;
  const points: string[] = [];
  let [first, last] = [0, 0];
  for (let j = 0; j < axis.length; j += 1) {
    const value = values[j];
    const outside = (axis[j + 1] ?? axis[j]) < min || (axis[j - 1] ?? axis[j]) > max;
    if (value === null || value === undefined || outside) continue;
    last = x(axis[j]);
    if (!points.length) first = last;
    points.push(`${at(last)} ${at(y(value))}`);
  }
  if (!points.length) return "";
  const path = `M${points.join("L")}`;
  const pale = piece.ghost ? ' opacity="0.35"' : "";
  if (!piece.filled) return `<g${pale}>${stroke(path, piece.property, piece.dash, piece.width)}</g>`;
  return `<path d="${path}L${at(last)} ${at(y(0))}L${at(first)} ${at(y(0))}Z" fill="${colour(piece.property)}"/>`;
}

function stroke(path: string, property: string, dash: number[] = [], width = 1): string {
  const dashed = dash.length ? ` stroke-dasharray="${dash.join(" ")}"` : "";
  return `<path d="${path}" fill="none" stroke="${colour(property)}" stroke-width="${width}"${dashed}/>`;
}

function text(x: number, y: number, words: string, property: string, more = ""): string {
  const safe = words.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
  return `<text x="${at(x)}" y="${at(y)}" fill="${colour(property)}" ${more}>${safe}</text>`;
}

function at(value: number): string {
  return String(Number(value.toFixed(DIGITS)));
}
