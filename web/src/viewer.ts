// The program of a page about results: unpacks its data and mounts the parts.
import type { Page } from "./contract";
import { inflated, unpack } from "./pack";

async function main(): Promise<void> {
  const place = document.getElementById("tmodes-data");
  if (place === null) return;
  const page = unpack(await inflated(place.textContent ?? "")) as Page;
  document.title = page.title;
}

void main();
