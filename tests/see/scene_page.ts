// A page with nothing but the robot in space, for tests: what is in `window` is asked by them.
import { makeClock } from "../../web/src/clock";
import type { Page } from "../../web/src/contract";
import { inflated, unpack } from "../../web/src/pack";
import { Motion } from "../../web/src/scene/motion";
import { mountScene } from "../../web/src/scene/scene";

async function main(): Promise<void> {
  const page = unpack(await inflated(document.getElementById("tmodes-data")?.textContent ?? "")) as Page;
  const place = document.getElementById("place") as HTMLElement;
  const clock = makeClock(Math.max(...page.runs.map((run) => run.duration)));
  const mount = (bent = false) => mountScene(place, page, clock, bent);
  Object.assign(window, { page, place, clock, mount, Motion, view: mount(), ready: true });
}

void main();
