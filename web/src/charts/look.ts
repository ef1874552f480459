// Colours and dashes of curves: colour-blind-safe, and reported apart without colour too.

/** Custom properties of app.css, in the order in which curves take them. */
const COLOURS = ["--blue", "--red", "--green", "--violet", "--ochre", "--sky"];
const SERIES: number[][] = [[], [7, 2], [6, 2, 2, 2], [2, 2], [9, 2, 2, 2, 2, 2], [12, 4]];

/** How a curve is drawn: the custom property of its colour, its dashes. */
export interface Look {
  property: string;
  dash: number[];
}

/** Of curves that are compared, by their place. */
export function lookOf(place: number): Look {
  return { property: COLOURS[place % COLOURS.length], dash: SERIES[place % SERIES.length] };
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
