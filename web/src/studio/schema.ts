// The JSON Schema of data sheets, and what kind of field each of its nodes is.

import { isGroup, type Json } from "./sheet";

export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  type?: string;
  title?: string;
  description?: string;
  unit?: string;
  symbol?: string;
  const?: Json;
  enum?: string[];
  default?: Json;
  examples?: Json[];
  anyOf?: Schema[];
  oneOf?: Schema[];
  discriminator?: { propertyName: string };
  properties?: Record<string, Schema>;
  additionalProperties?: boolean | Schema;
  required?: string[];
  items?: Schema;
  prefixItems?: Schema[];
  minItems?: number;
  maxItems?: number;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  maxLength?: number;
  rigid_when_infinite?: boolean;
}

/** One of several kinds of a value, reported apart by a word in it or by its type. */
export interface Choice {
  name: string;
  schema: Schema;
}

export type Shape =
  | { kind: "number"; schema: Schema; whole: boolean }
  | { kind: "text"; schema: Schema }
  | { kind: "yes"; schema: Schema }
  | { kind: "fixed"; schema: Schema }
  | { kind: "word"; schema: Schema; words: string[] }
  | { kind: "group"; schema: Schema; fields: [string, Schema][]; required: Set<string> }
  | { kind: "map"; schema: Schema; item: Schema }
  | { kind: "list"; schema: Schema; item: (index: number) => Schema; least: number; most: number }
  | { kind: "choice"; schema: Schema; choices: Choice[]; key: string };

export class Forms {
  constructor(readonly root: Schema) {}

  /** A node with what its reference leads to; what the node says itself counts more. */
  resolved(node: Schema): Schema {
    if (node.$ref === undefined) return node;
    const { $ref, ...own } = node;
    const target = this.resolved(this.root.$defs?.[$ref.replace("#/$defs/", "")] ?? {});
    return { ...target, ...own };
  }

  /** Whether a field may be left empty. */
  optional(node: Schema): boolean {
    return (this.resolved(node).anyOf ?? []).some((one) => this.resolved(one).type === "null");
  }

  /** What kind of field a node is; where it may be several things, the value that is there decides. */
  shape(node: Schema, value: Json | undefined): Shape {
    const schema = this.resolved(node);
    if (schema.const !== undefined) return { kind: "fixed", schema };
    if (schema.enum) return { kind: "word", schema, words: schema.enum };
    if (schema.oneOf) return this.choice(schema, schema.oneOf);
    if (schema.anyOf) return this.shape(this.branch(schema, schema.anyOf, value), value);
    switch (schema.type) {
      case "object":
        return this.object(schema);
      case "array":
        return this.list(schema);
      case "number":
      case "integer":
        return { kind: "number", schema, whole: schema.type === "integer" };
      case "boolean":
        return { kind: "yes", schema };
      default:
        return { kind: "text", schema };
    }
  }

  private object(schema: Schema): Shape {
    if (schema.properties) {
      return {
        kind: "group",
        schema,
        fields: Object.entries(schema.properties),
        required: new Set(schema.required ?? []),
      };
    }
    const item = schema.additionalProperties;
    return { kind: "map", schema, item: typeof item === "object" ? { unit: schema.unit, ...item } : {} };
  }

  private list(schema: Schema): Shape {
    const first = schema.prefixItems;
    const info = { unit: schema.unit, symbol: schema.symbol };
    const item = (index: number) => ({ ...info, ...(first?.[index] ?? schema.items ?? {}) });
    return { kind: "list", schema, item, least: schema.minItems ?? 0, most: schema.maxItems ?? 1000 };
  }

  /** The branch that a value means; text with a unit is a number too. */
  private branch(schema: Schema, branches: Schema[], value: Json | undefined): Schema {
    const known = branches.map((one) => this.resolved(one)).filter((one) => one.type !== "null");
    const numeric = (one: Schema): boolean =>
      one.type === "number" || one.type === "integer" || (one.anyOf ?? []).some(numeric);
    const real = known.filter(
      (one) =>
        !(one.type === "string" && known.some((other) => other !== one && (numeric(other) || other.type === "array"))),
    );
    const fits = (one: Schema) =>
      Array.isArray(value)
        ? one.type === "array"
        : isGroup(value)
          ? (one.type === "object" && this.agrees(one, value)) || one.oneOf !== undefined
          : typeof value === "number" || typeof value === "string"
            ? numeric(one) || one.type === "string" || one.enum !== undefined || one.oneOf !== undefined
            : false;
    const { anyOf, ...own } = schema;
    void anyOf;
    return { ...(real.find(fits) ?? real[0] ?? {}), ...described(own) };
  }

  /** Whether the words of a value, such as its model, are those of a group. */
  private agrees(group: Schema, value: Record<string, Json>): boolean {
    return Object.entries(group.properties ?? {}).every(([key, field]) => {
      const { const: fixed, enum: words } = this.resolved(field);
      const own = value[key];
      return own === undefined || ((fixed === undefined || fixed === own) && (!words || words.includes(String(own))));
    });
  }

  private choice(schema: Schema, members: Schema[]): Shape {
    const resolved = members.map((one) => this.resolved(one));
    const key = schema.discriminator?.propertyName ?? this.commonConstant(resolved);
    const choices = resolved.map((one) => ({ name: this.nameOf(one, key), schema: one }));
    return { kind: "choice", schema, choices, key };
  }

  private commonConstant(members: Schema[]): string {
    const keys = members.flatMap((one) =>
      Object.entries(one.properties ?? {})
        .filter(([, field]) => this.resolved(field).const !== undefined)
        .map(([key]) => key),
    );
    return keys[0] ?? "";
  }

  private nameOf(member: Schema, key: string): string {
    const field = member.properties?.[key];
    const info = field ? this.resolved(field).const : undefined;
    return typeof info === "string"
      ? info
      : member.type === "string"
        ? "by name"
        : (member.title ?? "given").toLowerCase();
  }

  /** Which of the choices a value is. */
  chosen(choices: Choice[], key: string, value: Json | undefined): Choice | undefined {
    if (typeof value === "string") return choices.find((one) => one.schema.type === "string");
    if (!isGroup(value)) return undefined;
    const info = value[key];
    const named = choices.find((one) => info !== undefined && one.name === info);
    return named ?? choices.find((one) => one.schema.type !== "string" && one.schema.properties?.[key] === undefined);
  }

  /** A value to begin with: what is known under the same name, an example, defaults, and the least that is needed. */
  fresh(node: Schema, before?: Json): Json {
    const schema = this.resolved(node);
    const shape = this.shape(node, before);
    if (shape.kind === "fixed") return schema.const ?? null;
    if (schema.default !== undefined && schema.default !== null) return schema.default;
    if (shape.kind === "word") return shape.words[0];
    if (shape.kind === "choice") return this.fresh(shape.choices[0].schema, before);
    if (shape.kind === "number") return allowed(shape.schema);
    if (shape.kind === "yes") return false;
    if (shape.kind === "text") return "";
    if (shape.kind === "map") return {};
    if (shape.kind === "list") return Array.from({ length: shape.least }, (_, index) => this.fresh(shape.item(index)));
    if (shape.kind !== "group") return null;
    const group = shape;
    const kept = isGroup(before) ? before : {};
    const [example] = schema.examples ?? [];
    const begun = isGroup(example) ? example : {};
    const entries = group.fields
      .filter(
        ([name, field]) =>
          group.required.has(name) ||
          name in begun ||
          this.resolved(field).const !== undefined ||
          (name in kept && this.shape(field, kept[name]).kind !== "fixed"),
      )
      .map(
        ([name, field]) =>
          [
            name,
            name in kept && this.resolved(field).const === undefined ? kept[name] : (begun[name] ?? this.fresh(field)),
          ] as const,
      );
    return Object.fromEntries(entries);
  }
}

/** A number that a field may hold: nothing where that may be, else one, or what is nearest to it. */
function allowed({ exclusiveMinimum = -Infinity, minimum = -Infinity, maximum = Infinity }: Schema): number {
  if (exclusiveMinimum < 0 && minimum <= 0 && maximum >= 0) return 0;
  return Math.max(Math.min(1, maximum), minimum);
}

/** What a node reports of itself, apart from what it is. */
function described(node: Schema): Schema {
  const info: Schema = {};
  for (const key of ["title", "description", "unit", "symbol", "default", "rigid_when_infinite"] as const) {
    if (node[key] !== undefined) Object.assign(info, { [key]: node[key] });
  }
  return info;
}
