// Fields of one value: a number with its unit, a word of a list, text, yes or no.

import { make, ownId } from "../dom";
import { pretty } from "../format";
import type { Schema, Shape } from "./schema";
import type { Json } from "./sheet";

export interface Field {
  element: HTMLElement;
  input: HTMLElement;
  /** Show another value. */
  set(value: Json | undefined): void;
  /** Of a number: show another unit. */
  unit?(text: string): void;
}

export type Changed = (value: Json | undefined) => void;

/** A name as people read it. */
export function words(name: string): string {
  if (name.includes(".")) return name; // a path is itself
  const text = name.replaceAll("_", " ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/**
 * The unit as it is written; of a joint that may turn or slide both, where it is not known which; of a signal its own,
 * once that is known.
 */
export function unitOf(schema: Schema, known: string | undefined): string {
  return (known ?? schema.unit ?? "").replace(/^signal$/, "").split("|").map(pretty).join(" or ");
}

/** What a field is, for a tooltip: its meaning, its symbol, its range. */
export function info(schema: Schema): string {
  const range = [
    schema.exclusiveMinimum === undefined ? "" : `greater than ${schema.exclusiveMinimum}`,
    schema.minimum === undefined ? "" : `at least ${schema.minimum}`,
    schema.maximum === undefined ? "" : `at most ${schema.maximum}`,
    schema.rigid_when_infinite ? ".inf: rigid" : "",
  ].filter(Boolean).join(", ");
  const meaning = (schema.description ?? "").split("\n")[0].replace(/ \[[^\]]*\]$/, "");
  return [meaning, schema.symbol && schema.symbol !== "-" ? `symbol ${schema.symbol}` : "", range]
    .filter(Boolean)
    .join("; ");
}

export function makeField(name: string, shape: Shape, unit: string, optional: boolean, changed: Changed): Field {
  switch (shape.kind) {
    case "yes":
      return yes(name, shape.schema, changed);
    case "word":
      return word(name, shape.schema, shape.words, changed);
    case "number":
      return number(name, shape.schema, unit, optional, changed);
    default:
      return text(name, shape.schema, optional, changed);
  }
}

function row(name: string, schema: Schema, input: HTMLElement, after: Node | null = null): HTMLElement {
  const id = ownId("field");
  input.id = id;
  const title = info(schema);
  const label = make("label", { for: id, title }, document.createTextNode(words(name)));
  if (schema.symbol && schema.symbol !== "-")
    label.append(make("span", { class: "symbol", text: ` ${schema.symbol}` }));
  input.title = title;
  return make("div", { class: "field" }, label, make("span", { class: "entry" }, input, after));
}

function number(name: string, schema: Schema, unit: string, optional: boolean, changed: Changed): Field {
  const input = make("input", {
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    spellcheck: "false",
    class: "number",
    placeholder: optional ? "not set" : shown(schema.default),
  });
  input.addEventListener("change", () => changed(read(input.value)));
  const after = make("span", { class: "unit", text: unit });
  return {
    element: row(name, schema, input, after),
    input,
    set: (value) => {
      input.value = shown(value);
    },
    unit: (text) => {
      after.textContent = text;
    },
  };
}

/** A number as it was typed: a plain one, or text with a unit, which the server reads. */
export function read(typed: string): Json | undefined {
  const text = typed.trim();
  if (text === "") return undefined;
  const value = Number(text);
  return Number.isFinite(value) ? value : text;
}

export function shown(value: Json | undefined): string {
  return value === undefined || value === null
    ? ""
    : typeof value === "number"
      ? String(value)
      : typeof value === "string"
        ? value
        : JSON.stringify(value);
}

function text(name: string, schema: Schema, optional: boolean, changed: Changed): Field {
  const input = make("input", {
    type: "text",
    maxlength: schema.maxLength === undefined ? undefined : String(schema.maxLength),
    placeholder: optional ? "not set" : undefined,
  });
  input.addEventListener("change", () =>
    changed(input.value === "" && (optional || schema.default !== undefined) ? undefined : input.value),
  );
  return { element: row(name, schema, input), input, set: (value) => { input.value = shown(value); } };
}

function word(name: string, schema: Schema, choices: string[], changed: Changed): Field {
  const input = make(
    "select",
    {},
    ...choices.map((one) => make("option", { value: one, text: one.replaceAll("_", " ") })),
  );
  input.addEventListener("change", () => changed(input.value));
  return {
    element: row(name, schema, input),
    input,
    set: (value) => {
      input.value = String(value ?? schema.default ?? choices[0]);
    },
  };
}

function yes(name: string, schema: Schema, changed: Changed): Field {
  const input = make("input", { type: "checkbox" });
  input.addEventListener("change", () => changed(input.checked));
  return {
    element: row(name, schema, input),
    input,
    set: (value) => {
      input.checked = Boolean(value ?? schema.default);
    },
  };
}
