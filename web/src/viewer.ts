// The program of a page about results: unpacks its data and mounts the parts.
import type { Page } from "./contract";
import { make } from "./dom";
import { inflated, unpack } from "./pack";
import { mountPage } from "./page";

async function main(): Promise<void> {
  const place = document.getElementById("tmodes-data");
  const root = document.getElementById("tmodes-app");
  if (place === null || root === null) return;
  try {
    const page = unpack(await inflated(place.textContent ?? "")) as Page;
    mountPage(root, page);
    document.documentElement.classList.add("running");
  } catch (error) {
    const told = error instanceof Error ? error.message : String(error);
    root.replaceChildren(
      make("p", {
        class: "status warning",
        role: "alert",
        text: `The interactive part of this page could not start: ${told}. The whole report without it follows.`,
      }),
    );
  }
}

// Paper is white and shows all: what is folded is opened, and what is drawn takes the colours of the light scheme.
addEventListener("beforeprint", () => {
  document.documentElement.classList.add("printing");
  for (const part of document.querySelectorAll("details")) part.open = true;
});
addEventListener("afterprint", () => document.documentElement.classList.remove("printing"));
void main();
