// A robot's compiled equations in JavaScript: instantiates the module, and calls its functions over many samples.
// tmodes/live/functions.py makes module and layout; nothing here touches a page: it runs in a worker and in Node.

import { EngineError, expect, known } from "./engine_error";
import { packRows, parted, total, type Samples } from "./engine_rows";

export type { Samples } from "./engine_rows";

/** What tmodes/live/functions.py reports of a module. */
export interface Layout {
  format: number;
  cells: string[];
  options: string[];
  arguments: string[];
  statuses: Record<string, number>;
  limits: { bound: number; most_events: number; event_time: number };
  simd: boolean;
  coordinates: string[];
  /** Joints of the drives. */
  drives: string[];
  loops: Record<string, LoopLayout>;
  samples: Record<string, SampleLayout>;
}

/** A time loop: numbers of a state, of a row of signals, of parameters. */
export interface LoopLayout {
  export: string;
  method: string;
  size: number;
  row: number;
  parameters: number;
}

/** A function over samples; inputs and outputs in order with their numbers. `slopes`: along a direction as well. */
export interface SampleLayout {
  export: string;
  kind: "schedule" | "slopes";
  inputs: Record<string, number>;
  outputs: Record<string, number>;
  parameters: number;
  workspace: number;
}

/** Outputs of samples, `width` numbers each; where in them each output begins. */
export interface Rows {
  all: Float64Array;
  width: number;
  starts: Record<string, number>;
}

const FORMAT = 1;
const PAGE = 65536;

/** What the module asks of its surroundings: what WebAssembly itself has no word for. */
const GIVEN = {
  tmodes_far_sin: Math.sin,
  tmodes_far_cos: Math.cos,
  tmodes_pow: Math.pow,
};

/** An array that a function writes: `given`: reads as well; `range`: which part of it, known after the call. */
export interface Written {
  into: Float64Array;
  given?: boolean;
  range?: () => [number, number];
}

type Compiled = (...values: (number | bigint)[]) => void;

/** One module at work. A call is given copies and gives copies: nothing stays in its memory from call to call. */
export class Engine {
  private constructor(
    readonly layout: Layout,
    private readonly functions: Record<string, Compiled>,
    private readonly memory: WebAssembly.Memory,
    private readonly free: number,
  ) {}

  /** Compile and instantiate; raises an EngineError for another format, and where WebAssembly is refused. */
  static async open(wasm: BufferSource, layout: Layout): Promise<Engine> {
    if (layout.format !== FORMAT) throw new EngineError(`layout: got format ${layout.format}; expected ${FORMAT}`);
    const { instance } = await instantiated(wasm, layout);
    const { memory, heap_base: base, ...functions } = instance.exports;
    const free = (base as WebAssembly.Global).value as number;
    return new Engine(layout, functions as Record<string, Compiled>, memory as WebAssembly.Memory, free);
  }

  /** Outputs of a function at `count` samples, by name, each [count, size]; `wanted`: which of them, else all. */
  sample(name: string, parameters: Float64Array, inputs: Samples, count: number, wanted?: readonly string[]): Samples {
    const info = known(this.layout.samples, name, "function");
    expect(`${name}: parameters`, parameters.length, info.parameters);
    const out = this.schedule(info, parameters, [inputs], count);
    return parted(info.outputs, out, count, 1, wanted);
  }

  /** The same as it is in the module's memory, until the next call: rows in which each output begins at its start. */
  rows(name: string, parameters: Float64Array, inputs: Samples, count: number): Rows {
    const info = known(this.layout.samples, name, "function");
    expect(`${name}: parameters`, parameters.length, info.parameters);
    const starts: Record<string, number> = {};
    let width = 0;
    for (const [label, size] of Object.entries(info.outputs)) {
      starts[label] = width;
      width += size;
    }
    return { all: this.schedule(info, parameters, [inputs], count), width, starts };
  }

  /**
   * The same with exact derivatives along `directions` of the inputs (zero where none is given): of a function that has
   * them, whose layout's kind is `slopes`.
   */
  slopes(
    name: string,
    parameters: Float64Array,
    inputs: Samples,
    directions: Samples,
    count: number,
  ): { values: Samples; slopes: Samples } {
    const info = known(this.layout.samples, name, "function");
    if (info.kind !== "slopes")
      throw new EngineError(`${name}: got a function without derivatives; expected one with them`);
    expect(`${name}: parameters`, parameters.length, info.parameters);
    const zero = Object.fromEntries(
      Object.entries(info.inputs).map(([label, size]) => [label, new Float64Array(size)]),
    );
    const out = this.schedule(info, parameters, [inputs, { ...zero, ...directions }], count);
    const size = total(info.outputs);
    return { values: parted(info.outputs, out, count, 2), slopes: parted(info.outputs, out.subarray(size), count, 2) };
  }

  /** Call a function on arrays of doubles, whole numbers, and arrays that it writes. */
  call(name: string, values: (Float64Array | number | Written)[]): void {
    const arrays = values.map((value) =>
      typeof value === "number" ? null : value instanceof Float64Array ? value : value.into,
    );
    this.reserve(arrays.reduce((sum, array) => sum + (array?.byteLength ?? 0), this.free));
    const whole = new Float64Array(this.memory.buffer);
    let place = this.free;
    const placed = values.map((value, k) => {
      if (typeof value === "number") return BigInt(value);
      const start = place;
      if (value instanceof Float64Array || value.given) whole.set(arrays[k]!, start / 8);
      place += arrays[k]!.byteLength;
      return start;
    });
    this.functions[name](...placed);
    values.forEach((value, k) => {
      if (typeof value === "number" || value instanceof Float64Array) return;
      const [from, to] = value.range?.() ?? [0, value.into.length];
      const start = (placed[k] as number) / 8;
      value.into.set(whole.subarray(start + from, start + to), from);
    });
  }

  /** What it gives [count, sides, outputs], in the module's memory until the next call. */
  private schedule(info: SampleLayout, parameters: Float64Array, sides: Samples[], count: number): Float64Array {
    const rows = count * sides.length;
    const [wide, high] = [total(info.inputs), total(info.outputs)];
    const workspace = this.free + parameters.byteLength;
    const packed = workspace + 8 * info.workspace;
    const out = packed + 8 * rows * wide;
    this.reserve(out + 8 * rows * high);
    const whole = new Float64Array(this.memory.buffer);
    whole.set(parameters, this.free / 8);
    whole.fill(0, workspace / 8, packed / 8);
    packRows(whole.subarray(packed / 8, out / 8), info.inputs, sides, count);
    this.functions[info.export](BigInt(count), BigInt(0), this.free, workspace, packed, out);
    return whole.subarray(out / 8, out / 8 + rows * high);
  }

  private reserve(end: number): void {
    const missing = end - this.memory.buffer.byteLength;
    if (missing <= 0) return;
    try {
      this.memory.grow(Math.ceil(missing / PAGE));
    } catch {
      throw new EngineError(
        `memory: got no room for ${(end / 1e6).toFixed(0)} MB; expected a browser that has it. ` +
          "Hint: ask for fewer samples",
      );
    }
  }
}

async function instantiated(wasm: BufferSource, layout: Layout): Promise<WebAssembly.WebAssemblyInstantiatedSource> {
  try {
    return await WebAssembly.instantiate(wasm, { env: GIVEN });
  } catch (problem) {
    const needed = layout.simd ? ", with vectors (SIMD)" : "";
    throw new EngineError(`WebAssembly: got ${String(problem)}; expected a browser that allows it${needed}`);
  }
}
