// What a page shows of the loads along a robot's links: the panel of the elastic line, and what colours the links.

import type { LinePanel } from "../contract";
import type { Scene } from "../contract_scene";
import type { LinkLoads } from "./loads";
import type { Bundle } from "./bundle";
import { sizes } from "./series";

const PLANES = ["y", "z"];
const QUANTITIES = [
  { id: "deflection", of: "deflection", label: "Deflection", unit: "m", planes: PLANES },
  { id: "slope", of: "slope", label: "Slope", unit: "rad", planes: PLANES },
  { id: "moment", of: "moment", label: "Moment", unit: "N m", planes: ["torsion", ...PLANES] },
  { id: "shear_force", of: "shear", label: "Shear force", unit: "N", planes: PLANES },
] as const;

/** The elastic line of each link that bends at m frames; null where none bends. */
export function linePanel(bundle: Bundle, links: LinkLoads[], m: number): LinePanel | null {
  if (!links.length) return null;
  const stations = bundle.stations.data;
  const [L, S] = [links.length, stations.length];
  const places = Float64Array.from({ length: L * S }, (_, k) => links[Math.floor(k / S)].length * stations[k % S]);
  return {
    links: links.map((link) => link.name), places: { data: places, shape: [L, S] },
    quantities: QUANTITIES.map(({ id, of, label, unit, planes }) => {
      const data = new Float64Array(m * L * S * planes.length);
      links.forEach((link, l) => spread(link[of], data, m, l, L, S * planes.length));
      return { id, label, unit, planes: [...planes], values: { data, shape: [m, L, S, planes.length] } };
    }),
  };
}

/** As tmodes/report/scene_parts.py: of all links of the scene, 0 on those that do not bend. */
export function loadColours(bundle: Bundle, loads: LinkLoads[], m: number): Scene["colours"] {
  const [L, S] = [bundle.links.length, bundle.stations.data.length];
  const over = (id: string, label: string, unit: string, value: (link: LinkLoads) => Float64Array | null) => {
    const data = new Float64Array(m * L * S);
    bundle.links.forEach((drawn, l) => {
      const link = drawn.bends ? loads.find((one) => one.name === drawn.name) : undefined;
      const values = link && value(link);
      if (values) spread(values, data, m, l, L, S);
    });
    return { id, label, unit, values: { data, shape: [m, L, S] } };
  };
  if (!loads.length) return [];
  const bending = ({ moment }: LinkLoads) =>
    Float64Array.from({ length: m * S }, (_, k) => Math.sqrt(moment[3 * k + 1] ** 2 + moment[3 * k + 2] ** 2));
  const found = [
    over("bending_moment", "Bending moment", "N m", bending),
    over("torsion", "Torsional moment", "N m", ({ moment }) =>
      Float64Array.from({ length: m * S }, (_, k) => Math.abs(moment[3 * k])),
    ),
    over("deflection", "Deflection from the root's tangent", "m", ({ deflection }) => sizes(deflection, 2)),
  ];
  if (!loads.some((link) => link.stress)) return found;
  return [
    ...found,
    over("stress", "Largest stress (von Mises)", "Pa", ({ stress }) => stress && stress.mises),
    over("strain", "Largest strain", "1", ({ stress }) => stress && stress.strain),
  ];
}

/** Rows of one link [m, width] into those of all [m, L, width]. */
function spread(values: Float64Array, into: Float64Array, m: number, link: number, links: number, width: number): void {
  for (let k = 0; k < m; k += 1) into.set(values.subarray(k * width, (k + 1) * width), (k * links + link) * width);
}
