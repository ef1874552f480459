// How a picture opens: when the robot is bent most, how many times that is enlarged, and from where it is seen best.
import type { Page } from "../contract";
import type { Scene } from "../contract_scene";
import type { Numbers } from "../pack";

export interface Opening {
  /** When the first run's robot is bent most [s]. */
  time: number;
  /** How many times that is shown, so that it is a tenth of the reach; and at most, so that links keep their length. */
  factor: number;
  most: number;
  /** Whether anything is elastic. */
  bends: boolean;
  /** From the robot to the camera: across what bends and across the robot. */
  direction: [number, number, number];
}

const SHOWN = 0.1;
const APART = 0.25; // of the reach: as far from the actual tip the commanded one is shown at most
const MOST = 0.3; // of the reach: a link of that length seems 4 % longer
const LARGEST = 1000;
const NOTHING = 1e-6; // of the reach: rounding
const ROUNDING = 1e-9; // m
const USUAL: [number, number, number] = [0.62, -1, 0.55];

export function openingOf(page: Page, reach: number): Opening {
  const bends = page.runs.map(({ scene }) => largest(scene));
  const size = Math.max(...bends.map((bend) => bend.size));
  const share = (part: number) => Math.min(LARGEST, Math.max(1, (part * reach) / size));
  const elastic = size > NOTHING * reach;
  const first = bends[0];
  const gap = Math.max(...page.runs.map(({ scene: { tip, tipCommanded } }) => farthest(tip, tipCommanded)));
  return {
    time: first.size > NOTHING * reach ? page.runs[0].scene.times.data[first.frame] : 0,
    factor: elastic ? Number(Math.max(1, Math.min(share(SHOWN), (APART * reach) / gap)).toPrecision(1)) : 1,
    most: elastic ? Number(share(MOST).toPrecision(2)) : 1,
    bends: elastic,
    direction: across(page.runs[0].scene, first.frame),
  };
}

/** The largest displacement from the robot without elasticity [m], and in which frame. */
function largest({ line, rigid }: Scene): { size: number; frame: number } {
  let [size, place] = [0, 0];
  for (let k = 0; rigid && k < line.data.length; k += 3) {
    const away = Math.hypot(...[0, 1, 2].map((c) => line.data[k + c] - rigid.data[k + c]));
    if (away > size) [size, place] = [away, k];
  }
  const [, ...shape] = line.shape;
  return { size, frame: Math.floor(place / (shape.reduce((product, count) => product * count, 1) || 1)) };
}

/** How far two paths are from each other at most [m]. */
function farthest(tip: Numbers, other: Numbers | null | undefined): number {
  let most = 0;
  for (let k = 0; other && k < tip.data.length; k += 3)
    most = Math.max(most, Math.hypot(...[0, 1, 2].map((c) => tip.data[k + c] - other.data[k + c])));
  return most;
}

/** The direction across which displacements, links and the tip's path are longest, of some obliquely from above. */
function across({ line, rigid, tip }: Scene, frame: number): [number, number, number] {
  const size = line.data.length / line.shape[0];
  const [moved, along, path]: number[][][] = [[], [], []];
  for (let k = 3; k < tip.data.length; k += 3) path.push([0, 1, 2].map((c) => tip.data[k + c] - tip.data[k + c - 3]));
  for (let k = frame * size; k < (frame + 1) * size; k += 3) {
    const at = (c: number, from = k) => line.data[from + c];
    moved.push([0, 1, 2].map((c) => at(c) - (rigid?.data[k + c] ?? at(c))));
    if (k > frame * size) along.push([0, 1, 2].map((c) => at(c) - at(c, k - 3)));
  }
  const seen = (all: number[][], n: number[]) => {
    const some = all.filter((d) => Math.hypot(...d) > ROUNDING);
    if (some.length === 0) return 1;
    const total = some.reduce((sum, d) => sum + Math.hypot(...d), 0);
    const depth = (d: number[]) => d.reduce((sum, x, c) => sum + x * n[c], 0);
    return some.reduce((sum, d) => sum + Math.sqrt(Math.max(0, Math.hypot(...d) ** 2 - depth(d) ** 2)), 0) / total;
  };
  let [best, score] = [USUAL, 0];
  for (const up of [0.55, 0.25, 1.4])
    for (let k = 0; k < 8; k++) {
      const angle = Math.atan2(USUAL[1], USUAL[0]) + (k * Math.PI) / 4;
      const way: [number, number, number] = [1.18 * Math.cos(angle), 1.18 * Math.sin(angle), up];
      const length = Math.hypot(...way);
      const n = way.map((x) => x / length);
      const found = seen(moved, n) * seen(along, n) * Math.sqrt(seen(path, n)) * (k ? 1 : 1.03);
      if (found > 1.01 * score) [best, score] = [way, found];
    }
  return best;
}
