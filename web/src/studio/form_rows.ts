// The rows of a form that change what is in the sheet: a choice of kinds, an item that can be removed, another name.

import { button, make, ownId } from "../dom";
import { words } from "./field";
import type { Choice } from "./schema";
import { isGroup, type Json } from "./sheet";

/** Which of several kinds a value is; `key`: the word that reports them apart. */
export function choiceRow(
  key: string, choices: Choice[], chosen: Choice | undefined, choose: (wanted: Choice) => void,
): HTMLElement {
  const id = ownId("choice");
  const select = make(
    "select",
    { id },
    ...choices.map((one) =>
      make("option", { value: one.name, text: one.name.replaceAll("_", " "), selected: one === chosen }),
    ),
  );
  select.addEventListener("change", () => {
    const wanted = choices.find((one) => one.name === select.value);
    if (wanted) choose(wanted);
  });
  return make(
    "div",
    { class: "field" },
    make("label", { for: id, text: words(key || "kind") }),
    make("span", { class: "entry" }, select),
  );
}

/** A part of a list or a map; `remove`: takes it away, null where it has to stay. */
export function itemRow(name: string, part: HTMLElement, remove: (() => void) | null): HTMLElement {
  const away = remove && button("Remove", remove, { class: "remove", "aria-label": `Remove ${name}` });
  return make("div", { class: "item" }, part, away);
}

/** Where another name is added to a map. */
export function nameRow(add: (name: string) => void): HTMLElement {
  const id = ownId("name");
  const wanted = make("input", {
    id,
    type: "text",
    spellcheck: "false",
    autocomplete: "off",
    placeholder: "gear.stiffness",
  });
  const adding = button(
    "Add",
    () => {
      if (wanted.value.trim()) add(wanted.value.trim());
    },
    { class: "add" },
  );
  return make(
    "div",
    { class: "field" },
    make("label", { for: id, text: "Another name" }),
    make("span", { class: "entry" }, wanted, adding),
  );
}

/** What an item of a list is called: by itself, else by its number. */
export function nameOf(item: Json, index: number): string {
  if (isGroup(item))
    for (const key of ["name", "joint", "point", "type"]) if (typeof item[key] === "string") return item[key];
  return String(index + 1);
}
