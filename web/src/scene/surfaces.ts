// How far the surfaces of links reach beyond their lines: their outermost vertices, where they are in a frame.
import { Quaternion, Vector3 } from "three";
import type { Scene, SceneMesh } from "../contract_scene";

const WAYS = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])));

const known = new WeakMap<SceneMesh, Vector3[]>();
const turn = new Quaternion();
const place = new Vector3();

/** Links that are drawn as surfaces. */
export function surfaced({ meshes }: Pick<Scene, "meshes">): Set<number> {
  return new Set(meshes.flatMap((mesh) => mesh.along ?? [mesh.link]));
}

/** Places [k, 3] on all surfaces in a frame; `more(k)`: by how much the line's component k is shown displaced. */
export function surfacesAt(scene: Scene, frame: number, more: (k: number) => number): number[] {
  const [, links, stations] = scene.line.shape;
  const found: number[] = [];
  for (const mesh of scene.meshes) {
    const along = mesh.along ?? [mesh.link];
    const first = frame * links + along[0];
    const root = 3 * first * stations;
    const ends = along[0] < 0 ? [] : [root];
    if (mesh.along) ends.push(3 * ((frame * links + along[along.length - 1] + 1) * stations - 1));
    if (ends.length) turn.fromArray(scene.roots.data, 4 * first);
    for (const vertex of outermost(mesh)) {
      place.copy(vertex);
      if (ends.length) place.applyQuaternion(turn);
      if (!ends.length) found.push(...place.toArray());
      for (const end of ends)
        found.push(...place.toArray().map((x, c) => x + scene.line.data[root + c] + more(end + c)));
    }
  }
  return found;
}

/** The vertices that are farthest in some direction. */
function outermost(mesh: SceneMesh): Vector3[] {
  const before = known.get(mesh);
  if (before) return before;
  const { data } = mesh.vertices;
  const chosen = new Set<number>();
  for (const [x, y, z] of WAYS) {
    let [most, which] = [-Infinity, -1];
    for (let k = 0; k + 2 < data.length; k += 3) {
      const far = x * data[k] + y * data[k + 1] + z * data[k + 2];
      if (far > most) [most, which] = [far, k];
    }
    if (which >= 0) chosen.add(which);
  }
  const found = [...chosen].map((k) => new Vector3(data[k], data[k + 1], data[k + 2]));
  known.set(mesh, found);
  return found;
}
