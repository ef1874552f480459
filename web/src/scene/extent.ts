// How large a scene is: the box about all that moves in all runs, and the sizes that follow from it.
import { Box3, Vector3 } from "three";
import type { Page } from "../contract";
import type { Scene } from "../contract_scene";
import type { Widths } from "./links";
import { openingOf, type Opening } from "./opening";
import { forceScale } from "./shown";
import { surfaced, surfacesAt } from "./surfaces";
import { sectionAxes } from "./sweep";
import { round125 } from "./units";

export interface Extent extends Widths {
  /** About all lines and tips over all times [m]. */
  box: Box3;
  /** Length of the longest robot from root to tip, at least a thousandth of a meter. */
  reach: number;
  /** Side of a square of the floor. */
  cell: number;
  opening: Opening;
}

const FRAMES = 60;
const BASE = 3; // half-widths of a usual link: that of the base
const AXES = new Float32Array(9); // of the section at hand
const WIDE = 0.04; // of the reach: half-widths up to which the margin of a picture holds links
const SURFACED = 4; // of so many of these frames one, for surfaces: they have many places

/** Places [k, 3] that a picture of all runs has to show, with their elasticity so many times enlarged. */
export function placesOf(page: Page, factor: number, { reach, floor, usual }: Extent): number[] {
  const scale = forceScale(page.runs, reach);
  const found: number[] = [];
  for (const { scene } of page.runs) {
    const { line, rigid, contact, tipCommanded } = scene;
    const [frames, links, stations] = line.shape;
    const every = Math.max(1, Math.ceil(frames / FRAMES));
    const more = (k: number) => (factor - 1) * (line.data[k] - (rigid?.data[k] ?? line.data[k]) || 0); // no links: 0
    for (const x of [-BASE * usual, BASE * usual])
      for (const y of [-BASE * usual, BASE * usual])
        if (line.data.length) found.push(line.data[0] + x, line.data[1] + y, floor);
    for (let frame = 0; frame < frames; frame += every) {
      for (let place = 0; place < links * stations; place += Math.max(1, stations >> 1))
        {
        const at = 3 * (frame * links * stations + place);
        const here = [0, 1, 2].map((c) => line.data[at + c] + more(at + c));
        found.push(...here, ...cornersAt(scene, frame, place, reach, here));
      }
      const end = 3 * ((frame + 1) * links * stations - 1);
      for (let c = 0, k = 3 * frame; c < 3; c++, k++) {
        const tip = contact ? contact.at.data[k] + scale * contact.force.data[k] : scene.tip.data[k];
        found.push(tip + more(end + c));
      }
      for (let c = 0, k = 3 * frame; tipCommanded && c < 3; c++, k++)
        found.push(factor * tipCommanded.data[k] - (factor - 1) * scene.tip.data[k] + more(end + c));
      if (frame % (SURFACED * every) === 0) found.push(...surfacesAt(scene, frame, more));
    }
  }
  return found;
}

/** The corners of a wide section about a place of its line, `here` as it is shown. */
function cornersAt(scene: Scene, frame: number, place: number, reach: number, here: number[]): number[] {
  const [, links, stations] = scene.line.shape;
  const [link, s] = [Math.floor(place / stations), place % stations];
  const section = scene.links[link]?.section;
  if (!section || surfaced(scene).has(link)) return [];
  const { data, shape } = section.sizes;
  const row = 2 * Math.round((s / Math.max(stations - 1, 1)) * (shape[0] - 1));
  if (Math.max(data[row], data[row + 1]) < WIDE * reach) return [];
  const first = 4 * (frame * links + link);
  sectionAxes(AXES, Float32Array.from(scene.roots.data.subarray(first, first + 4)), 0);
  return [-1, 1].flatMap((y) => [-1, 1].flatMap((z) =>
    here.map((x, c) => x + y * data[row] * AXES[3 + c] + z * data[row + 1] * AXES[6 + c])));
}

export function extentOf(page: Page): Extent {
  const box = new Box3();
  const point = new Vector3();
  let reach = 1e-3;
  let widest = 0;
  for (const { scene } of page.runs) {
    for (const array of [scene.line, scene.tip]) {
      for (let k = 0; k + 2 < array.data.length; k += 3) box.expandByPoint(point.fromArray(array.data, k));
    }
    reach = Math.max(reach, length(scene.line.data, scene.line.shape));
    for (const link of scene.links) link.section?.sizes.data.forEach((size) => (widest = Math.max(widest, size)));
  }
  if (box.isEmpty()) box.expandByPoint(point.set(0, 0, 0));
  const span = Math.max(reach, box.getSize(point).length() / 2);
  const usual = Math.min(Math.max(widest, 0.012 * reach), 0.022 * reach);
  const floor = floorBelow(box, page, reach);
  for (const { scene } of page.runs)
    if (scene.line.data.length) box.expandByPoint(point.fromArray(scene.line.data).setZ(floor));
  return { box, reach, cell: round125(span / 5), usual, least: 0.006 * reach, floor, opening: openingOf(page, reach) };
}

/** Length along all links in the first frame. */
function length(line: ArrayLike<number>, [, links, stations]: readonly number[]): number {
  let sum = 0;
  for (let link = 0; link < links; link++)
    for (let s = 1; s < stations; s++) {
      const k = 3 * (link * stations + s);
      sum += Math.hypot(line[k] - line[k - 3], line[k + 1] - line[k - 2], line[k + 2] - line[k - 1]);
    }
  return sum;
}

/** The floor is at z = 0 where the robot stands on or above it, else a round height below all that moves. */
function floorBelow(box: Box3, page: Page, reach: number): number {
  const root = page.runs[0]?.scene.line.data[2] ?? 0;
  const stands = box.max.z - box.min.z > 0.2 * reach && root < reach;
  if (box.min.z >= -1e-3 * reach && stands) return 0;
  const step = round125(0.1 * reach);
  return Math.floor((Math.min(box.min.z, root) - 0.12 * reach) / step) * step;
}

/** Whether all runs are of one robot, as far as is seen: the same links on the same base, to be drawn in one place. */
export function alike({ runs }: Page, { reach }: Extent): boolean {
  const names = runs.map(({ scene: { links } }) => links.map(({ name }) => name).join());
  const bases = runs.map(({ scene: { line } }) => [0, 1, 2].map((c) => line.data[c] - runs[0].scene.line.data[c]));
  return new Set(names).size === 1 && bases.every((away) => Math.hypot(...away) < 0.01 * reach);
}
