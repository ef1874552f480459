// What a study's page holds, as tmodes/study/page/data.py writes it.
import type { Numbers } from "../pack";

/** A parameter or a quantity: its values of all cases of the page, not-a-number where a case has none. */
export interface Column {
  name: string;
  title: string;
  unit: string;
  values: Numbers;
  /** Names of what is chosen, by value; null for a number. */
  labels: string[] | null;
  /** In the robot's own sheet, or of the sheet's own run. */
  nominal: number | null;
  /** Where the number stands in the robot's sheet, and by what it is multiplied there. */
  path: string | null;
  factor: number;
  /** Histogram of all cases of the study, of which the page may hold a part: edges and counts. */
  edges: Numbers | null;
  counts: Numbers | null;
  /** Percentiles of all cases, by percent. */
  percentiles: [number, number][];
}

/** How strongly each parameter acts on a quantity: bars from `low` to `high` about `base`. */
export interface Tornado {
  quantity: string;
  how: string;
  unit: string;
  base: number;
  bars: { name: string; low: number; high: number }[];
}

/** Sobol' indices with the ends of their confidence intervals. */
export interface Indices {
  quantity: string;
  how: string;
  names: string[];
  first: [number, number, number][];
  total: [number, number, number][];
}

/** Percentiles over time: `values` (shares, times). */
export interface Band {
  title: string;
  /** What the vertical axis measures. */
  label: string;
  unit: string;
  times: Numbers;
  shares: number[];
  values: Numbers;
  nominal: Numbers | null;
  cases: number;
}

/** Of an optimization, whose cases are designs. */
export interface Designs {
  /** Columns of the axes to begin with. */
  x: string;
  y: string;
  /** Rows that no other row beats, of several objectives. */
  front: number[];
  /** Row of the best design, or of that which exceeds its limits least; null where none has numbers. */
  best: number | null;
  /** The sheet's own design: values by column. */
  start: Record<string, number>;
  /** A column must be below (`sign` 1) or above (-1) its bound. */
  limits: { text: string; column: string; bound: number; sign: number }[];
}

export interface StudyPage {
  name: string;
  /** Cases of the study; the page may hold fewer. */
  cases: number;
  case: Numbers;
  parameters: Column[];
  quantities: Column[];
  status: Numbers;
  words: string[];
  good: boolean[];
  reasons: Record<string, string>;
  tornados: Tornado[];
  indices: Indices[];
  bands: Band[];
  /** What is found of each quantity, in words. */
  answers: Record<string, string>;
  designs: Designs | null;
  /** Whether the least values of the first quantity are the best: tables begin with them. */
  leastFirst: boolean;
  /**
   * Whether cases come as often as their distributions say; else they were chosen, and their percentiles say
   * nothing.
   */
  drawn: boolean;
  /** A report that simulates again, compressed; empty where there is none, and why. */
  report: string;
  noReport: string;
}
