// Stress at the outer fibre of a bending link, from what its sections carry, as tmodes/analysis/line/stress.py.

import type { Carried } from "./balance";
import type { Reals } from "./space";

const ROUND = 1e-9; // relative difference of stiffnesses below which a section is a circle or a ring

/** The link's numbers for stress at S places: what each part of the load is multiplied by. */
export interface Fibre {
  young: number;
  ring: boolean;
  perMomentY: Reals;
  perMomentZ: Reals;
  perForce: Reals;
  /** Shear stress for one of torsional moment. */
  perTorsion: Reals;
}

export interface Stress {
  strain: Reals;
  mises: Reals;
}

/** From the numbers at `start`: moduli, outer fibres along y and z, stiffnesses at the places. */
export function fibreOf(numbers: Reals, start: number, places: number): Fibre {
  const [young, shear, outerY, outerZ] = numbers.subarray(start, start + 4);
  const [bendY, bendZ, area, torsion] = [0, 1, 2, 3].map((k) =>
    numbers.subarray(start + 4 + k * places, start + 4 + (k + 1) * places),
  );
  const near = (a: number, b: number) => Math.abs(a - b) <= ROUND * Math.abs(b);
  const ring =
    outerY === outerZ && shear > 0 && torsion.every((value, k) => near(value / shear, (bendY[k] + bendZ[k]) / young));
  const lever = ring ? outerY : Math.min(2 * Math.min(outerY, outerZ), Math.hypot(outerY, outerZ));
  const per = (factor: number, stiffness: Reals) => stiffness.map((one) => (one > 0 ? factor / one : 0));
  return {
    young, ring, perMomentY: per(outerZ, bendY), perMomentZ: per(outerY, bendZ), perForce: per(1, area),
    perTorsion: per(shear * lever, torsion),
  };
}

/** Largest strain of the outer fibre, and von Mises stress [Pa], of each place. */
export function stressed(
  { young, ring, perMomentY, perMomentZ, perForce, perTorsion }: Fibre,
  { moment, axial }: Carried,
  into: Stress,
): void {
  for (let p = 0; p < axial.length; p += 1) {
    const [y, z] = [Math.abs(moment[3 * p + 1]) * perMomentY[p], Math.abs(moment[3 * p + 2]) * perMomentZ[p]];
    into.strain[p] = (ring ? Math.sqrt(y * y + z * z) : y + z) + Math.abs(axial[p]) * perForce[p];
    const [normal, shear] = [young * into.strain[p], Math.abs(moment[3 * p]) * perTorsion[p]];
    into.mises[p] = Math.sqrt(normal * normal + 3 * shear * shear);
  }
}
