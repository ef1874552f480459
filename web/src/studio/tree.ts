// The structure of a robot as a tree: joints with their gears, motors and controllers, links with their bodies.

import { button, make } from "../dom";
import { at, isGroup, type Json, type Sheet, type Step } from "./sheet";

export interface Node {
  label: string;
  /** What stands there in the sheet, and the link or joint that shows it. */
  steps: Step[];
  element: string | null;
  /** Shown in the same row, and below it. */
  parts: Node[];
  children: Node[];
}

type Item = { item: { [key: string]: Json }; steps: Step[] };

const OWN = ["motor", "gear"];
const LAST = ["payload", "tip", "contact"];

/** Links and joints from the base on; what is led to by no joint at the end. */
export function structureOf(sheet: Sheet): Node[] {
  const [joints, links, drives] = ["joints", "links", "drives"].map((key) => itemsOf(sheet, key));
  const seen = new Set<string>();
  const of = (label: string, steps: Step[], element: string | null): Node =>
    ({ label, steps, element, parts: [], children: [] });
  const link = (name: string): Node[] => {
    const found = links.find(({ item }) => item.name === name);
    if (!found || seen.has(name)) return [];
    seen.add(name);
    const bodies = itemsOf(found.item, "bodies").map(({ item, steps }, k) =>
      of(String(item.name ?? `body ${k + 1}`), [...found.steps, ...steps], name));
    const beam = isGroup(found.item.beam) ? [of("beam", [...found.steps, "beam"], name)] : [];
    return [{ ...of(name, found.steps, name), parts: [...beam, ...bodies],
      children: joints.filter(({ item }) => item.parent === name).flatMap(joint) }];
  };
  const joint = ({ item, steps }: Item): Node[] => {
    const name = String(item.name);
    const drive = drives.filter((one) => one.item.joint === name);
    const parts = [...OWN.filter((key) => isGroup(item[key])).map((key) => of(key, [...steps, key], name)),
      ...drive.map((one) => one.item.controller ? of("controller", [...one.steps, "controller"], name)
        : of("drive", one.steps, name))];
    return [{ ...of(name, steps, name), parts, children: link(String(item.child)) }];
  };
  const known = new Set(links.map(({ item }) => item.name));
  const roots = joints.filter(({ item }) => !known.has(item.parent)).flatMap(joint);
  const rest = links.flatMap(({ item }) => link(String(item.name)));
  const tip = isGroup(sheet.tip) && typeof sheet.tip.link === "string" ? sheet.tip.link : null;
  return [...roots, ...rest, ...LAST.filter((key) => isGroup(sheet[key])).map((key) => of(key, [key], tip))];
}

function itemsOf(group: { [key: string]: Json }, key: string): Item[] {
  const list = at(group, [key]);
  const items = Array.isArray(list) ? list : [];
  return items.flatMap((item, k) => (isGroup(item) ? [{ item, steps: [key, k] }] : []));
}

/** Every node, each before those within it. */
function flat(nodes: Node[]): Node[] {
  return nodes.flatMap((node) => [node, ...node.parts, ...flat(node.children)]);
}

export class Tree {
  private nodes: Node[] = [];
  private readonly buttons = new Map<Node, HTMLButtonElement>();

  /** `chosen` hears of a node that was clicked. */
  constructor(private readonly place: HTMLElement, private readonly chosen: (node: Node) => void) {}

  show(sheet: Sheet): void {
    this.nodes = structureOf(sheet);
    this.buttons.clear();
    this.place.replaceChildren(this.list(this.nodes));
  }

  /** The node of a link, one of whose pieces may be meant (`link.1`), or of a joint. */
  named(element: string): Node | null {
    const of = (name: string) => flat(this.nodes).find((node) => node.label === name && node.element === name) ?? null;
    return of(element) ?? of(element.replace(/\.\d+$/, ""));
  }

  /** The innermost node that something of the sheet belongs to. */
  about(steps: Step[]): Node | null {
    const shared = (node: Node) => node.steps.findIndex((step, k) => String(step) !== String(steps[k]));
    const size = (node: Node) => (shared(node) < 0 ? node.steps.length + 0.5 : shared(node));
    const nearer = (one: Node | null, node: Node) => (one && size(one) >= size(node) ? one : node);
    const best = flat(this.nodes).reduce<Node | null>(nearer, null);
    return best && size(best) >= Math.min(2, best.steps.length) ? best : null;
  }

  mark(node: Node | null): void {
    for (const [one, element] of this.buttons) element.setAttribute("aria-current", String(one === node));
  }

  private list(nodes: Node[]): HTMLElement {
    return make("ul", {}, ...nodes.map((node) => {
      const row = make("span", { class: "row" }, this.button(node), ...node.parts.map((part) => this.button(part)));
      return make("li", {}, row, node.children.length ? this.list(node.children) : null);
    }));
  }

  private button(node: Node): HTMLButtonElement {
    const own = node.label === node.element;
    const element = button(node.label, () => this.chosen(node), { class: own ? "node" : "node part",
      "data-steps": node.steps.join(".") });
    this.buttons.set(node, element);
    return element;
  }
}
