// One case: its numbers, how it ended, and its report, which simulates it again.
import { button, make, put } from "../dom";
import { pretty } from "../format";
import type { Column, StudyPage } from "./contract";
import { ranked, valueOf, type Store } from "./store";

const MOST_ROWS = 10;

export function mountCase(host: HTMLElement, store: Store): void {
  const title = make("h3", { "aria-live": "polite" });
  const body = make("dl", { class: "facts all" });
  const said = make("p", { class: "note" });
  const open = button("Open live report", () => void openReport(store, said), { class: "primary" });
  const at = (share: number) => () => {
    const rows = ranked(store, store.shown).filter((row) => store.inside(row));
    store.pick(rows.length ? rows[Math.round(share * (rows.length - 1))] : null);
  };
  const ways = make("div", { class: "bar" }, button("least", at(0)), button("median", at(0.5)),
    button("largest", at(1)),
    open);
  host.append(make("section", { class: "panel case-panel" }, title, ways, said, body));
  const show = () => {
    const { row, page } = store;
    put(title, row === null ? `Choose a ${page.designs ? "design" : "case"}` :
      `${store.nameOf(row)}: ${page.words[page.status.data[row]]}`);
    open.hidden = row === null || page.designs !== null;
    open.disabled = !page.report;
    said.textContent = row === null ? "Click a point or a line, or:" : page.reasons[String(row)] ?? (page.report
      ? "" : page.noReport);
    body.replaceChildren(...(row === null ? [] : store.columns.map((column) => fact(column, row))));
  };
  store.listen((change) => change === "case" && show());
  show();
}

function fact(column: Column, row: number): HTMLElement {
  return make("div", {}, make("dt", { text: column.title || column.name }),
    make("dd", {}, make("strong", { text: valueOf(column, row) })));
}

/** The report of the sheet's own run, with the numbers of a case: it simulates that case at once. */
async function openReport(store: Store, said: HTMLElement): Promise<void> {
  const { page, row } = store;
  if (row === null || !page.report) return;
  const address = URL.createObjectURL(await documentOf(page));
  const parts = new URLSearchParams({ t: "0" });
  for (const { path, factor, values, labels } of page.parameters)
    if (path && !labels && Number.isFinite(values.data[row])) parts.append("set",
      `${path}=${factor * values.data[row]}`);
  if (open(`${address}#${parts.toString()}`, "_blank") === null)
    said.textContent = "The browser did not open another window: allow this page to open one.";
}

let report: Blob | null = null;
async function documentOf(page: StudyPage): Promise<Blob> {
  const packed = Uint8Array.from(atob(page.report), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  report ??= new Blob([await new Response(stream).arrayBuffer()], { type: "text/html" });
  return report;
}

/** The cases that are largest (or least) in the quantity that is looked at, and those that did not finish. */
export function mountTable(host: HTMLElement, store: Store): void {
  const place = make("div", { class: "scroll", role: "region", tabindex: "0", "aria-label": "Cases" });
  host.append(place);
  const show = () => {
    const least = store.page.leastFirst && store.quantity === store.page.quantities[0].name;
    const all = ranked(store, store.shown).filter((row) => store.inside(row));
    const rows = (least ? all : all.reverse()).slice(0, MOST_ROWS);
    const lost = [...Array(store.size).keys()].filter((row) => !store.isGood(row)).slice(0, MOST_ROWS);
    const [one, end] = store.page.designs ? ["design", "beyond a limit"] : ["case", "that did not finish"];
    const head = [one, ...store.columns.map(({ title, name, unit }) =>
      `${title || name}${pretty(unit) ? ` [${pretty(unit)}]` : ""}`), "ended"];
    const shown = store.shown.title || store.quantity;
    place.replaceChildren(make("table", {},
      make("caption",
        { text: `${one === "case" ? "Cases" : "Designs"} with the ${least ? "least" : "largest"} value: ${shown}` +
          (lost.length ? `, and some ${end}` : "") }),
      make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col", text })))),
      make("tbody", {}, ...[...rows, ...lost].map((row) => line(store, row)))));
  };
  store.listen((change) => change !== "case" && show());
  show();
}

function line(store: Store, row: number): HTMLElement {
  const { page } = store;
  const text = page.designs ? store.nameOf(row) : String(page.case.data[row]);
  const name = button(text, () => store.pick(row), { class: "jump" });
  const ended = [page.words[page.status.data[row]], page.reasons[String(row)] ?? ""].filter(Boolean).join(": ");
  return make("tr", {}, make("th", { scope: "row" }, name),
    ...store.columns.map((column) => make("td", { text: valueOf(column, row, "") })), make("td", { text: ended }));
}
