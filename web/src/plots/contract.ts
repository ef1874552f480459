// What a page of charts holds, as tmodes/report/plots.py writes it.
import type { Numbers } from "../pack";

export interface Axis {
  label: string;
  /** `asinh`: even about 0, logarithmic beyond `bend`. */
  scale: "linear" | "log" | "asinh";
  bend: number;
  /** Of rows: their names, from the top. */
  names: string[] | null;
  range: [number, number] | null;
}

/** Curves of one name have one entry in the legend; a `band` is the outline of an area. */
export interface Curve {
  name: string;
  x: Numbers;
  y: Numbers;
  kind: "line" | "band" | "dots" | "circle" | "square" | "triangle" | "ring" | "cross";
  colour: string;
  dash: number[];
}

export interface Plot {
  title: string;
  note: string;
  height: number;
  /** As long in both directions. */
  equal: boolean;
  x: Axis;
  y: Axis;
  curves: Curve[];
}

export interface PlotsPage {
  plots: Plot[];
}
