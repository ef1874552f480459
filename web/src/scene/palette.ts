// Colours of the scene: Okabe and Ito's, which the colour-blind tell apart, and viridis for quantities.

export interface Palette {
  /** Of runs side by side, in order: those of their curves in the charts. */
  runs: string[];
  link: string;
  joint: string;
  gear: string;
  base: string;
  payload: string;
  grid: string;
  gridStrong: string;
  surface: string;
  force: string;
  reference: string;
  rigid: string;
  before: string;
  commanded: string;
  /** Of the axes x, y, z, and of the arrow of gravity. */
  axes: [string, string, string];
  gravity: string;
  real: string;
  sky: string;
  ground: string;
}

const LIGHT: Palette = {
  runs: ["#0072b2", "#d55e00", "#00875f", "#a2488f", "#8c6a00", "#2a7fb8"],
  link: "#9aa5b1", joint: "#4a5562", gear: "#c76a00", base: "#39434e", payload: "#2b333c", grid: "#c3cad1",
  gridStrong: "#8e99a4", surface: "#009e73", force: "#b3261e", reference: "#d55e00", rigid: "#6b7681",
  before: "#7a4ea3", commanded: "#1d2329", real: "#0072b2",
  axes: ["#c4372b", "#00754f", "#005a9e"], gravity: "#5b4a00", sky: "#ffffff", ground: "#b9c0c8",
}; // prettier-ignore

const DARK: Palette = {
  runs: ["#4fb0ea", "#ff8f45", "#3ecf9b", "#e08acb", "#d9b13a", "#9fd3f5"],
  link: "#8b96a3", joint: "#a9b4c0", gear: "#e69f00", base: "#6d7986", payload: "#cfd6dd", grid: "#39424c",
  gridStrong: "#5c6874", surface: "#2fbf95", force: "#ff7b70", reference: "#ff8c42", rigid: "#a3adb7",
  before: "#c79be8", commanded: "#f2f5f8", real: "#56b4e9",
  axes: ["#ff8a80", "#4fd6a5", "#7cc4f2"], gravity: "#e6cf6a", sky: "#ffffff", ground: "#5a6570",
}; // prettier-ignore

export function palette(dark: boolean): Palette {
  return dark ? DARK : LIGHT;
}

// Viridis (van der Walt and Smith 2015), 16 of its colours; between them straight lines.
const VIRIDIS =
  "440154 481a6c 472f7d 414487 39568c 31688e 2a788e 23888e 1f988b 22a884 35b779 54c568 7ad151 a5db36 d2e21b fde725";

const STEPS = 256;

/** Red, green and blue (0..1) of 256 steps from the smallest value to the largest. */
export const SCALE: Float32Array = scale();

function scale(): Float32Array {
  const knots = VIRIDIS.split(" ").map((hex) => [0, 2, 4].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255));
  const table = new Float32Array(3 * STEPS);
  for (let k = 0; k < STEPS; k++) {
    const place = (k / (STEPS - 1)) * (knots.length - 1);
    const low = Math.min(Math.floor(place), knots.length - 2);
    for (let c = 0; c < 3; c++) table[3 * k + c] = knots[low][c] + (place - low) * (knots[low + 1][c] - knots[low][c]);
  }
  return table;
}

/** Where in SCALE a share of the range is. */
export function step(share: number): number {
  return 3 * Math.max(0, Math.min(STEPS - 1, Math.round(share * (STEPS - 1))));
}

/** The scale as a CSS gradient from left to right. */
export function gradient(): string {
  return `linear-gradient(to right, ${stops().join(", ")})`;
}

/** The colours of the scale at equal distances. */
export function stops(): string[] {
  return VIRIDIS.split(" ").map((hex) => `#${hex}`);
}
