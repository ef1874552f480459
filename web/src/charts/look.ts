// Colours and dashes of curves: colour-blind-safe, and reported apart without colour too.

import type { Role } from "../contract";

/** Custom properties of app.css, in the order in which curves take them. */
const COLOURS = ["--blue", "--red", "--green", "--violet", "--ochre", "--sky"];
const OF_ROLE: Record<Role, string> = {
  real: "--blue",
  reference: "--red",
  rigid: "--quiet",
  stationary: "--green",
  oscillatory: "--violet",
  limit: "--quiet",
  other: "--ochre",
};
const DASHES: Record<Role, number[]> = {
  real: [],
  reference: [6, 3],
  rigid: [2, 3],
  stationary: [9, 2, 2, 2],
  oscillatory: [2, 2],
  limit: [1, 3],
  other: [10, 3],
};
const SERIES: number[][] = [[], [7, 2], [6, 2, 2, 2], [2, 2], [9, 2, 2, 2, 2, 2], [12, 4]];

export const WORDS: Record<Role, string> = {
  real: "actual",
  reference: "nominal",
  rigid: "rigid",
  stationary: "quasi-static part",
  oscillatory: "oscillatory part",
  limit: "limit",
  other: "other",
};

/** How a curve is drawn: `place` in the order of colours, `several` whether there are more curves than roles. */
export interface Look {
  property: string;
  dash: number[];
}

export function lookOf(role: Role, place: number, several: boolean, roles: number): Look {
  if (!several) return { property: OF_ROLE[role], dash: DASHES[role] };
  const dash = roles > 1 ? DASHES[role] : SERIES[place % SERIES.length];
  return { property: COLOURS[place % COLOURS.length], dash };
}

const known = new Map<string, string>();
let scheme: MediaQueryList | null = null;
let wasDark = false;

/** The colours as the page has them now, light or dark; asked of the page once, as that makes it settle its styles. */
export function colour(property: string): string {
  scheme ??= matchMedia("(prefers-color-scheme: dark)");
  const dark = scheme.matches && !document.documentElement.classList.contains("printing");
  if (dark !== wasDark) known.clear();
  wasDark = dark;
  const info = known.get(property) ?? getComputedStyle(document.documentElement).getPropertyValue(property).trim();
  known.set(property, info);
  return info || "#808080";
}
