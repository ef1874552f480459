// The program of a study's page: unpacks its data and mounts the charts.
import { make, put } from "./dom";
import { inflated, unpack } from "./pack";
import { forPaper } from "./paper";
import { mountBand } from "./study/bands";
import { mountBars } from "./study/bars";
import { mountCase, mountTable } from "./study/cases";
import type { StudyPage } from "./study/contract";
import { mountDesigns } from "./study/designs";
import { mountHistogram } from "./study/histogram";
import { mountParallel } from "./study/parallel";
import { mountResponses } from "./study/responses";
import { Store } from "./study/store";
import { readably } from "./study/units";

async function main(): Promise<void> {
  const [place, root] = [document.getElementById("tmodes-data"), document.getElementById("tmodes-study")];
  if (place === null || root === null) return;
  try {
    mount(root, readably(unpack(await inflated(place.textContent ?? "")) as StudyPage));
    document.documentElement.classList.add("running");
  } catch (error) {
    const text = `The charts of this page could not start: ${error instanceof Error ? error.message : String(error)}.`;
    root.replaceChildren(make("p", { class: "status warning", role: "alert", text }));
  }
}

function mount(root: HTMLElement, page: StudyPage): void {
  const store = new Store(page);
  const choice = make("select", {}, ...page.quantities.map(({ name, title }) => make("option", { value: name,
    text: title || name })));
  const answer = make("p", { class: "answer", "aria-live": "polite" });
  choice.addEventListener("change", () => {
    store.look(choice.value);
    put(answer, page.answers[choice.value] ?? "");
  });
  const label = make("label", { text: "Quantity " });
  label.append(choice);
  const [shown, all] = [page.case.data.length, page.cases].map((count) => count.toLocaleString("en"));
  const part = page.case.data.length < page.cases ? `Charts show ${shown} of ${all} cases.` : "";
  const bar = make("div", { class: "bar study-bar" }, label, make("span", { class: "note", text: part }));
  const top = make("div", { class: "study-top" });
  const [first, second] = [make("div", { class: "study-grid" }), make("div", {})];
  top.append(first, second);
  root.classList.add("app-study");
  root.append(bar, answer, top);
  if (page.designs) mountDesigns(first, store, page.designs);
  else if (page.drawn) mountHistogram(first, store);
  else mountResponses(first, store);
  if (!page.designs) mountBars(first, store);
  mountCase(second, store);
  mountParallel(root, store);
  const wide = make("div", { class: "study-grid" });
  for (const band of page.bands) mountBand(wide, band);
  if (wide.childElementCount) root.append(wide);
  if (page.drawn || page.designs) mountResponses(root, store);
  mountTable(root, store);
}

forPaper("details");
void main();
