// Designs of an optimization as points over two of their numbers, with limits as lines, the start and the best one.
import { make, put } from "../dom";
import type { Column, Designs } from "./contract";
import { axes, chart, crosses, dots, gutter, line, named, svg, type Box } from "./draw";
import { clamped, scale, type Scale } from "./scale";
import { nearestRow, spanOf, valueOf, type Store } from "./store";

const LEGEND: [string, string, string][] = [
  ["●", "points", "within all limits"], ["×", "beyond", "beyond a limit"], ["●", "front", "none better in both"],
  ["★", "best", "best"], ["◇", "start", "start: as in the sheet"],
];

interface Place {
  box: Box;
  x: Scale;
  y: Scale;
}

export function mountDesigns(host: HTMLElement, store: Store, designs: Designs): void {
  const chosen = { x: designs.x, y: designs.y };
  let place: Place | null = null;
  const columns = () => [store.column(chosen.x), store.column(chosen.y)] as const;
  const at = (row: number): [number, number] | null => {
    const [left, top] = columns().map(({ values }) => values.data[row]);
    return place && Number.isFinite(left) && Number.isFinite(top) ? [place.x.at(left), place.y.at(top)] : null;
  };
  const view = chart(host, "Designs", 420, (root, width, height) => {
    const [one, two] = columns();
    const y = clamped(scale(spanOf(store, two, marked(designs, two)), [height - 40, 14], 6, two.labels));
    const box: Box = { left: gutter(y), top: 14, right: width - 14, bottom: height - 40 };
    const ends: [number, number] = [box.left, box.right];
    const x = clamped(scale(spanOf(store, one, marked(designs, one)), ends, Math.max(3, width / 90), one.labels));
    place = { box, x, y };
    axes(root, box, x, y, [named(one), named(two)]);
    limits(root, designs, place, chosen);
    const all = [...Array(store.size).keys()];
    const of = (rows: number[]) => rows.map(at).filter((one) => one !== null);
    root.append(svg("path", { d: crosses(of(all.filter((row) => !store.isGood(row)))), class: "points beyond" }),
      svg("path", { d: dots(of(all.filter((row) => store.isGood(row)))), class: "points kept" }));
    const front = of([...designs.front].sort((a, b) => one.values.data[a] - one.values.data[b]));
    const discrete = store.page.parameters.some(({ labels }) => labels);
    if (!discrete) root.append(svg("path", { d: line(front), class: "front" }));
    for (const [left, top] of front) root.append(svg("circle", { cx: left, cy: top, r: 4.5, class: "front-point" }));
    marks(root, store, designs, place, chosen, at);
  });
  const { element } = view;
  const area = element.querySelector<HTMLElement>(".study-area")!;
  const shown = make("div", { class: "hover", hidden: true });
  area.append(shown);
  const near = (event: MouseEvent) => {
    const frame = area.getBoundingClientRect();
    return nearestRow(store, at, event.clientX - frame.left, event.clientY - frame.top);
  };
  area.onpointermove = (event) => {
    const row = near(event);
    const spot = row === null ? null : at(row);
    shown.hidden = !spot;
    if (row === null || !spot) return;
    shown.replaceChildren(...words(store, row, columns()).map((text) => make("div", { text })));
    shown.style.top = `${spot[1] + 10}px`;
    const left = spot[0] > area.clientWidth / 2;
    [shown.style.left, shown.style.right] = left ? ["", `${area.clientWidth - spot[0] + 10}px`] :
      [`${spot[0] + 10}px`, ""];
  };
  area.onpointerleave = () => (shown.hidden = true);
  area.onclick = (event) => store.pick(near(event) ?? store.row);
  element.querySelector(".tools")?.prepend(...(["y", "x"] as const).map((axis) => choice(store, chosen, axis, () => {
    view.redraw();
    note();
  })));
  const about = make("p", { class: "note" });
  const note = () => {
    const spans = columns().map((column) =>
      [column.values.data, ...spanOf(store, column, marked(designs, column))] as const);
    const outside = [...Array(store.size).keys()].filter((row) => spans.some(([data, low, high]) =>
      data[row] < low || data[row] > high)).length;
    put(about, outside ? `${outside} designs beyond a limit lie outside of these axes and are drawn at an edge.` : "");
  };
  element.append(legend(store, designs), about);
  note();
  store.listen((change) => change === "case" && view.redraw());
}

/** Values of limits and of the start, which an axis must show. */
function marked(designs: Designs, column: Column): number[] {
  const bounds = designs.limits.filter((one) => one.column === column.name).map(({ bound }) => bound);
  return column.name in designs.start ? [...bounds, designs.start[column.name]] : bounds;
}

/** What a pointer over a design shows: its name, its numbers on both axes, how it stands with its limits. */
function words(store: Store, row: number, columns: readonly Column[]): string[] {
  const { page } = store;
  const state = page.words[page.status.data[row]];
  return [store.nameOf(row), ...columns.map((column) => `${column.title || column.name} ${valueOf(column, row)}`),
    [state, page.reasons[String(row)]].filter(Boolean).join(": ")];
}

function limits(root: SVGSVGElement, designs: Designs, { box, x, y }: Place, chosen: { x: string; y: string }): void {
  let above = 0;
  for (const { text, column, bound, sign } of designs.limits) {
    if (column === chosen.x) {
      const [at, side] = [x.at(bound), sign > 0 ? box.right : box.left];
      const right = at < (box.left + box.right) / 2;
      root.append(svg("rect", { x: Math.min(at, side), y: box.top, width: Math.abs(side - at),
        height: box.bottom - box.top, class: "forbidden" }),
      svg("path", { d: `M${at} ${box.top}V${box.bottom}`, class: "limit" }),
      svg("text", { x: at + (right ? 5 : -5), y: box.top + 12 + 15 * above++,
        "text-anchor": right ? "start" : "end", class: "name" }, text));
    } else if (column === chosen.y) {
      const [at, side] = [y.at(bound), sign > 0 ? box.top : box.bottom];
      root.append(svg("rect", { x: box.left, y: Math.min(at, side), width: box.right - box.left,
        height: Math.abs(side - at), class: "forbidden" }),
      svg("path", { d: `M${box.left} ${at}H${box.right}`, class: "limit" }),
      svg("text", { x: box.right - 4, y: at + (at > box.top + 30 ? -5 : 14), "text-anchor": "end", class: "name" },
        text));
    }
  }
}

function marks(root: SVGSVGElement, store: Store, designs: Designs, { box, x, y }: Place,
  chosen: { x: string; y: string }, at: (row: number) => [number, number] | null): void {
  const named = (spot: [number, number], kind: string, shape: string, text: string) => {
    const right = spot[0] < (box.left + box.right) / 2;
    root.append(svg("text", { x: spot[0], y: spot[1] + 6, "text-anchor": "middle", class: `sign ${kind}` }, shape),
      svg("text", { x: spot[0] + (right ? 11 : -11), y: spot[1] - 8, "text-anchor": right ? "start" : "end",
        class: `name ${kind}` }, text));
  };
  const { [chosen.x]: left, [chosen.y]: top } = designs.start;
  if (left !== undefined && top !== undefined) named([x.at(left), y.at(top)], "start", "◇", "start");
  const best = designs.best === null ? null : at(designs.best);
  const [{ title, name }] = store.page.quantities;
  if (best && designs.best !== null) named(best, "best", "★",
    `${store.nameOf(designs.best)}${designs.front.length ? `: best ${title || name}` : ""}`);
  const own = store.row === null ? null : at(store.row);
  if (own) root.append(svg("circle", { cx: own[0], cy: own[1], r: 8, class: "chosen" }));
}

function choice(store: Store, chosen: { x: string; y: string }, axis: "x" | "y", act: () => void): HTMLElement {
  const select = make("select", { "aria-label": { x: "Across", y: "Up" }[axis] }, ...store.columns.map((column) =>
    make("option", { value: column.name, text: column.title || column.name, selected: column.name === chosen[axis] })));
  select.onchange = () => {
    chosen[axis] = select.value;
    act();
  };
  return make("label", { text: axis === "x" ? " over " : "" }, select);
}

function legend(store: Store, designs: Designs): HTMLElement {
  const there = (kind: string) => kind === "front" ? designs.front.length : kind !== "start" ||
    Object.keys(designs.start).length;
  const good = [...Array(store.size).keys()].filter((row) => store.isGood(row)).length;
  const counts: Record<string, number> = { points: good, beyond: store.size - good };
  const shown = LEGEND.filter(([, kind]) => there(kind));
  const others: Record<string, string> = designs.limits.length ? {} : { points: "finished", beyond: "failed" };
  return make("p", { class: "note signs" }, ...shown.map(([shape, kind, text]) =>
    make("span", {}, make("span", { class: `sign ${kind}`, text: shape }),
      make("span", { text: ` ${kind in counts ? `${counts[kind].toLocaleString("en")} ` : ""}${
        others[kind] ?? text}` }))));
}
