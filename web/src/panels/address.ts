// The fragment of an address that leads back to a view: time, camera, enlargement, and the settings that were changed.

import type { Clock } from "../clock";
import type { SceneView } from "../contract_parts";

export interface Settings {
  /** By the paths of the sliders, those that are not the run's own. */
  changed(): Record<string, number>;
  give(values: Record<string, number>): void;
}

const few = (value: number) => String(Number(value.toPrecision(6)));

export function fragmentOf(clock: Clock, scene: SceneView, settings: Settings | null): string {
  const { pose, factor } = scene.view;
  const parts = new URLSearchParams({ t: few(clock.time), camera: pose.map(few).join(" "), scale: few(factor) });
  for (const [path, value] of Object.entries(settings?.changed() ?? {})) parts.append("set", `${path}=${value}`);
  return `#${parts.toString()}`;
}

/** Go where a fragment leads; one that is none of these, such as a section's, is left alone. */
export function follow(fragment: string, clock: Clock, scene: SceneView, settings: Settings | null): void {
  const parts = new URLSearchParams(fragment.replace(/^#/, ""));
  const number = (name: string) => Number.parseFloat(parts.get(name) ?? "");
  if (!Number.isFinite(number("t"))) return;
  const factor = number("scale");
  const pose = (parts.get("camera") ?? "").split(" ").map(Number);
  scene.view = { pose, factor: Number.isFinite(factor) ? factor : scene.view.factor };
  const values = parts.getAll("set")
    .map((one) => [one.slice(0, one.lastIndexOf("=")), Number(one.slice(one.lastIndexOf("=") + 1))] as const)
    .filter(([, value]) => Number.isFinite(value));
  if (settings && values.length) settings.give(Object.fromEntries(values));
  clock.pause();
  clock.seek(number("t"));
}
