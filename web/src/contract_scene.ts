// The robot over time as a page draws it: part of the contract of contract.ts, whose rules of units and shapes hold.

import type { Numbers } from "./pack";

/** The robot over time, at m display frames. */
export interface Scene {
  times: Numbers; // [m] s
  /** Of a robot those of the result's `link`; after them, perhaps, links without length that only carry meshes. */
  links: SceneLink[];
  /** Elastic lines in the world [m, L, S, 3] m. */
  line: Numbers;
  /** The same without any elasticity, and of the nominal robot; null where there is none. */
  rigid: Numbers | null;
  reference: Numbers | null;
  /** The nominal robot without elasticity, about which its deformation is enlarged; null or none: `rigid` serves. */
  referenceRigid?: Numbers | null;
  /** Rotation of each link's root as quaternions x, y, z, w [m, L, 4]. */
  roots: Numbers;
  /** What may colour the links: at least one; values [m, L, S], 0 on links that do not bend. */
  colours: { id: string; label: string; unit: string; values: Numbers }[];
  tip: Numbers; // [m, 3]
  tipReference: Numbers | null; // [m, 3]
  /** The tip that the setpoints mean [m, 3]; null or none: nothing is commanded. */
  tipCommanded?: Numbers | null;
  /** In the world [m/s²]; none: not known. */
  gravity?: number[];
  contact: SceneContact | null;
  joints: SceneJoint[];
  meshes: SceneMesh[];
}

export interface SceneLink {
  name: string;
  /** The link on which it stands; -1: the base. */
  parent: number;
  bends: boolean;
  /** Length of the unbent link [m]. */
  length: number;
  /**
   * Half-widths of its section at the stations along y and z of the section [S, 2] m, round or a box; null: unknown.
   * `guessed`: the sheet reports only its stiffness and mass, so it is drawn as a solid bar of metal that has both.
   */
  section: { shape: "round" | "box"; sizes: Numbers; guessed: boolean } | null;
}

/** A joint at the root of a link; its axis in the axes of that root. */
export interface SceneJoint {
  name: string;
  link: number;
  drawing: "cylinder" | "box" | "ball" | "none";
  axis: [number, number, number];
  /** An elastic gear turns here. */
  elastic: boolean;
}

export interface SceneContact {
  /** Force by the tip on the surface [m, 3] N. */
  force: Numbers;
  /** Where it acts [m, 3]. */
  at: Numbers;
  surface:
    | { kind: "plane"; position: [number, number, number]; normal: [number, number, number] }
    | { kind: "ball"; center: [number, number, number]; radius: number; inside: boolean }
    | {
        kind: "cylinder";
        center: [number, number, number];
        axis: [number, number, number];
        radius: number;
        inside: boolean;
      };
}

/**
 * A surface of a link, in the axes of its root (link -1: of the base, in the world); `vertices` [k, 3] m, `faces` [f,
 * 3].
 */
export interface SceneMesh {
  link: number;
  /** Of a link that bends: the links whose lines bend it, its vertices being in the frame of the root of the first. */
  along?: number[];
  colour: string;
  vertices: Numbers;
  faces: Numbers;
}
