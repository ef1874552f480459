// What a viewer may choose.

export interface Settings {
  /** Id of the quantity that colours the links that bend; `run`: each robot its own colour. */
  colour: string;
  /** Displacements from the rigid arm are shown this many times as large. */
  factor: number;
  reference: boolean;
  rigid: boolean;
  traces: boolean;
  force: boolean;
  surface: boolean;
  floor: boolean;
  /** Several robots side by side instead of one in the other. */
  apart: boolean;
  quality: "auto" | "low" | "high" | "lines";
}

export const TOGGLES: [
  keyof Settings & ("reference" | "rigid" | "traces" | "force" | "surface" | "floor" | "apart"),
  string,
][] = [
  ["reference", "Nominal (ghost)"],
  ["rigid", "Undeformed (ghost)"],
  ["traces", "Paths of the tips"],
  ["force", "Contact force"],
  ["surface", "Surface"],
  ["floor", "Floor"],
  ["apart", "Side by side"],
];
