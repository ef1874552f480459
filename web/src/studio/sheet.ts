// A data sheet as plain data, read and changed by the keys and numbers that lead to a value.

export type Step = string | number;
export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Sheet = { [key: string]: Json };

export function isGroup(value: Json | undefined): value is { [key: string]: Json } {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** The value at steps; undefined where there is none. */
export function at(sheet: Json, steps: readonly Step[]): Json | undefined {
  let value: Json | undefined = sheet;
  for (const step of steps) {
    if (Array.isArray(value)) value = value[Number(step)];
    else if (isGroup(value)) value = Object.hasOwn(value, step) ? value[step] : undefined;
    else return undefined;
  }
  return value;
}

/** Put a value at steps; undefined takes it away. Groups on the way are made where they are missing. */
export function put(sheet: Sheet, steps: readonly Step[], value: Json | undefined): void {
  let inner: Json = sheet;
  steps.slice(0, -1).forEach((step, k) => {
    let next = at(inner, [step]);
    if (next === undefined || next === null) {
      next = typeof steps[k + 1] === "number" ? [] : {};
      assign(inner, step, next);
    }
    inner = next;
  });
  assign(inner, steps[steps.length - 1], value);
}

function assign(inner: Json, step: Step, value: Json | undefined): void {
  if (Array.isArray(inner)) {
    if (value === undefined) inner.splice(Number(step), 1);
    else inner[Number(step)] = value;
  } else if (isGroup(inner)) {
    if (value === undefined) delete inner[step];
    else inner[step] = value;
  }
}

export function copy<T extends Json>(value: T): T {
  return JSON.parse(JSON.stringify(value)) as T;
}

/** A key for maps. */
export function pathOf(steps: readonly Step[]): string {
  return steps.join("\u0000");
}
