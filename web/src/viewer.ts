// The program of a page about results: unpacks its data and mounts the parts.
import type { Page } from "./contract";
import { make } from "./dom";
import { inflated, unpack } from "./pack";
import { mountPage } from "./page";
import { forPaper } from "./paper";

async function main(): Promise<void> {
  const place = document.getElementById("tmodes-data");
  const root = document.getElementById("tmodes-app");
  if (place === null || root === null) return;
  try {
    const page = unpack(await inflated(place.textContent ?? "")) as Page;
    mountPage(root, page);
    document.documentElement.classList.add("running");
  } catch (error) {
    const info = error instanceof Error ? error.message : String(error);
    root.replaceChildren(
      make("p", {
        class: "status warning",
        role: "alert",
        text: `The interactive part of this page could not start: ${info}. The whole report without it follows.`,
      }),
    );
  }
}

forPaper("details");
void main();
