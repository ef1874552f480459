// The form of a whole data sheet, made of its JSON Schema alone: what the schema gains appears here by itself.

import { button, make } from "../dom";
import type { Wrong } from "./api";
import { makeField, info, unitOf, words, type Field } from "./field";
import { Marks } from "./form_marks";
import { choiceRow, itemRow, nameOf, nameRow } from "./form_rows";
import type { Forms, Schema, Shape } from "./schema";
import { at, isGroup, pathOf, put, type Json, type Sheet, type Step } from "./sheet";

/** Groups that say what a sheet is, not how it behaves. */
const SILENT = new Set(["format", "kind", "imported"]);

type Group = { element: HTMLDetailsElement; open(): void };
type Choice = Extract<Shape, { kind: "choice" }>;
type List = Extract<Shape, { kind: "list" }>;

export class Form {
  private readonly fields = new Map<string, { field: Field; steps: Step[] }>();
  private readonly groups = new Map<string, Group>();
  private readonly opened = new Set<string>();
  private readonly marks = new Marks((steps, open) => this.find(steps, open));

  /** `changed` is reported whether the structure changed too, so that other fields are there than before. */
  constructor(
    private readonly element: HTMLElement,
    private readonly forms: Forms,
    private readonly sheet: Sheet,
    private units: Record<string, string>,
    private readonly changed: (structure: boolean) => void,
  ) {
    this.build();
  }

  private build(): void {
    this.fields.clear();
    this.groups.clear();
    const entries = Object.entries(this.forms.root.properties ?? {}).filter(([name]) => !SILENT.has(name));
    this.element.replaceChildren(
      ...entries.map(([name, node]) => this.part(name, node, [name], !this.forms.root.required?.includes(name))),
    );
  }

  /** Show what the sheet says now, of all fields that are there. */
  refresh(): void {
    for (const { field, steps } of this.fields.values())
      if (document.activeElement !== field.input) field.set(at(this.sheet, steps));
  }

  /** Show the units of a sheet whose structure changed. */
  tell(units: Record<string, string>): void {
    this.units = units;
    for (const { field, steps } of this.fields.values()) {
      const known = units[steps.join(".")];
      if (known !== undefined) field.unit?.(unitOf({}, known));
    }
  }

  /** Mark the fields that are wrong, and the uncertain ones. */
  mark(errors: Wrong[], notices?: Wrong[]): void {
    this.marks.show(errors, notices);
  }

  /** Bring the field at steps into sight, without the focus. */
  reveal(steps: Step[]): HTMLElement | null {
    const input = this.find(steps);
    const place = this.element.closest(".controls");
    if (!input || !place) return input;
    place.scrollTop += input.getBoundingClientRect().top - place.getBoundingClientRect().top - place.clientHeight / 3;
    place.scrollIntoView({ block: "nearest" }); // the picture stays where it is
    return input;
  }

  /** Set a part of the sheet, and show its fields. */
  give(steps: Step[], value: Json): void {
    this.set(steps, value, true);
  }

  focus(steps: Step[]): void {
    const input = this.reveal(steps);
    const inner = input?.matches("details") ? input.querySelector<HTMLElement>("summary") : input;
    inner?.focus({ preventScroll: true });
  }

  /** The field at steps, its groups opened, or the nearest group around it. */
  private find(steps: Step[], open = true): HTMLElement | null {
    let nearest: HTMLElement | null = null;
    for (let k = 1; k <= steps.length; k += 1) {
      const path = pathOf(steps.slice(0, k));
      const group = this.groups.get(path);
      if (open) group?.open();
      nearest = this.fields.get(path)?.field.input ?? group?.element ?? nearest;
    }
    return nearest;
  }

  private part(name: string, node: Schema, steps: Step[], mayLack: boolean): HTMLElement {
    const value = at(this.sheet, steps);
    const shape = this.forms.shape(node, value);
    const optional = mayLack && this.forms.optional(node);
    if (shape.kind === "fixed") return make("div", { hidden: true });
    if (
      shape.kind === "group" ||
      shape.kind === "map" ||
      shape.kind === "choice" ||
      (shape.kind === "list" && !this.short(shape, value))
    ) {
      return this.group(name, node, shape, steps, optional);
    }
    if (shape.kind === "list") return this.inline(name, shape, steps);
    const unit = unitOf(
      { ...this.forms.resolved(node), unit: shape.schema.unit ?? this.forms.resolved(node).unit },
      this.units[steps.join(".")],
    );
    const schema = { ...shape.schema, ...pick(this.forms.resolved(node)) };
    const field = makeField(name, { ...shape, schema } as Shape, unit, mayLack, (now) =>
      this.set(steps, now === undefined && typeof steps[steps.length - 1] === "number" ? null : now),
    );
    field.set(value);
    this.fields.set(pathOf(steps), { field, steps });
    return field.element;
  }

  private short(shape: List, value: Json | undefined): boolean {
    const first = this.forms.shape(shape.item(0), undefined);
    return (
      (first.kind === "number" || first.kind === "text") &&
      shape.least === shape.most &&
      shape.least <= 4 &&
      (value === undefined || value === null || Array.isArray(value))
    );
  }

  /** A few numbers in one row, such as a direction. */
  private inline(name: string, shape: List, steps: Step[]): HTMLElement {
    const box = make(
      "div",
      { class: "vector", role: "group", "aria-label": words(name) },
      make("span", { class: "vector-name", text: words(name), title: info(shape.schema) }),
    );
    for (let k = 0; k < shape.least; k += 1) box.append(this.part(String(k + 1), shape.item(k), [...steps, k], false));
    return box;
  }

  private group(name: string, node: Schema, shape: Shape, steps: Step[], optional: boolean): HTMLElement {
    const path = pathOf(steps);
    const schema = this.forms.resolved(node);
    const summary = make("summary", { title: info(schema), tabindex: "0" }, make("span", { text: words(name) }));
    const body = make("div", { class: "group" });
    const element = make("details", { "data-path": steps.join(".") }, summary, body);
    const fill = () => {
      if (body.childElementCount === 0) body.append(...this.inside(node, shape, steps, optional));
    };
    const open = () => {
      fill();
      element.open = true;
    };
    element.addEventListener("toggle", () => {
      if (element.open) fill();
      if (element.open) this.opened.add(path);
      else this.opened.delete(path);
    });
    this.groups.set(path, { element, open });
    if (this.opened.has(path)) open();
    return element;
  }

  private inside(node: Schema, shape: Shape, steps: Step[], optional: boolean): HTMLElement[] {
    const value = at(this.sheet, steps);
    const missing = value === undefined || value === null;
    if (missing && (optional || shape.kind === "choice")) {
      return [button("Add", () => this.set(steps, this.forms.fresh(node), true), { class: "add" })];
    }
    const away = optional ? [button("Remove", () => this.set(steps, undefined, true), { class: "remove" })] : [];
    if (shape.kind === "choice") return [...this.alternatives(shape, steps, value), ...away];
    if (shape.kind === "group")
      return [
        ...shape.fields.map(([name, field]) => this.part(name, field, [...steps, name], !shape.required.has(name))),
        ...away,
      ];
    if (shape.kind === "map") return [...this.entries(shape.item, steps, value), ...away];
    return shape.kind === "list" ? [...this.items(shape, steps, value), ...away] : away;
  }

  private alternatives(shape: Choice, steps: Step[], value: Json | undefined): HTMLElement[] {
    const chosen = this.forms.chosen(shape.choices, shape.key, value);
    const row = choiceRow(shape.key, shape.choices, chosen, (wanted) =>
      this.set(steps, this.forms.fresh(wanted.schema, value), true),
    );
    if (!chosen) return [row];
    const inner = this.forms.shape(chosen.schema, value);
    if (inner.kind === "group")
      return [
        row,
        ...inner.fields
          .filter(([name]) => name !== shape.key)
          .map(([name, field]) => this.part(name, field, [...steps, name], !inner.required.has(name))),
      ];
    return [row, this.part("value", chosen.schema, steps, false)];
  }

  private items(shape: List, steps: Step[], value: Json | undefined): HTMLElement[] {
    const list = Array.isArray(value) ? value : [];
    const rows = list.map((item, k) => {
      const name = nameOf(item, k);
      const part = this.part(name, shape.item(k), [...steps, k], false);
      const remove = () => this.set([...steps, k], undefined, true);
      return itemRow(name, part, list.length > shape.least ? remove : null);
    });
    const add = () =>
      this.set([...steps, list.length], this.forms.fresh(shape.item(list.length), list.at(-1) ?? null), true);
    return list.length < shape.most ? [...rows, button("Add", add, { class: "add" })] : rows;
  }

  /** Values by names of one's own, such as the factors of the actual robot. */
  private entries(item: Schema, steps: Step[], value: Json | undefined): HTMLElement[] {
    const known = isGroup(value) ? Object.keys(value) : [];
    const rows = known.map((name) =>
      itemRow(name, this.part(name, item, [...steps, name], false), () =>
        this.set([...steps, name], undefined, true),
      ),
    );
    return [...rows, nameRow((name) => this.set([...steps, name], 1, true))];
  }

  private set(steps: Step[], value: Json | undefined, structure = false): void {
    put(this.sheet, steps, value);
    if (structure) {
      steps.forEach((_, k) => this.opened.add(pathOf(steps.slice(0, k + 1))));
      this.build();
    }
    this.changed(structure);
  }
}

/** What a field reports of itself where its kind reports nothing. */
function pick(node: Schema): Schema {
  const info: Schema = {};
  for (const key of ["description", "symbol", "default", "rigid_when_infinite"] as const)
    if (node[key] !== undefined) Object.assign(info, { [key]: node[key] });
  return info;
}
