// The program of a page of charts: unpacks its data and mounts them.
import { make } from "./dom";
import { inflated, unpack } from "./pack";
import { forPaper } from "./paper";
import type { PlotsPage } from "./plots/contract";
import { mountPlot } from "./plots/plot";

async function main(): Promise<void> {
  const [place, root] = [document.getElementById("tmodes-data"), document.getElementById("tmodes-plots")];
  if (place === null || root === null) return;
  try {
    const page = unpack(await inflated(place.textContent ?? "")) as PlotsPage;
    root.classList.add("app-study", "study-grid");
    for (const plot of page.plots) mountPlot(root, plot);
    document.documentElement.classList.add("running");
  } catch (error) {
    const text = `The charts of this page could not start: ${error instanceof Error ? error.message : String(error)}.`;
    root.replaceChildren(make("p", { class: "status warning", role: "alert", text }));
  }
}

forPaper("details");
void main();
