/* tmodes, built from 4e8049afcb3d1bc8; BSD-3-Clause */

// src/live/engine_error.ts
var EngineError = class extends Error {
  name = "EngineError";
};
function known(entries, name, what) {
  if (!Object.hasOwn(entries, name)) {
    throw new EngineError(`${what}: got ${name}; expected one of ${Object.keys(entries).join(", ")}`);
  }
  return entries[name];
}
function expect(which, got, expected) {
  if (got !== expected) throw new EngineError(`${which}: got ${got} numbers; expected ${expected}`);
}

// src/live/engine_rows.ts
function total(sizes) {
  return Object.values(sizes).reduce((sum, size) => sum + size, 0);
}
function stride(label, size, given, count) {
  if (given === void 0) throw new EngineError(`${label}: got nothing; expected ${size} numbers for each sample`);
  if (given.length === count * size) return size;
  expect(label, given.length, size);
  return 0;
}
function packRows(into, sizes, sides, count) {
  const width = total(sizes);
  const row = sides.length * width;
  const varying = [];
  let start = 0;
  for (const side of sides) {
    for (const [label, size] of Object.entries(sizes)) {
      if (stride(label, size, side[label], count)) varying.push([side[label], start, size]);
      else into.set(side[label], start);
      start += size;
    }
  }
  if (varying.length < Object.keys(sizes).length * sides.length) repeated(into, row, count);
  for (const [from, place, size] of varying) copied(from, size, 0, into, row, place, size, count);
}
function repeated(into, row, count) {
  for (let filled = row; filled < count * row; filled *= 2)
    into.copyWithin(filled, 0, Math.min(filled, count * row - filled));
}
function parted(sizes, out, count, every, wanted = Object.keys(sizes)) {
  const width = every * total(sizes);
  const parts = {};
  let start = 0;
  for (const [label, size] of Object.entries(sizes)) {
    if (wanted.includes(label)) {
      parts[label] = new Float64Array(count * size);
      copied(out, width, start, parts[label], size, 0, size, count);
    }
    start += size;
  }
  return parts;
}
function copied(from, fromRow, fromStart, into, intoRow, intoStart, size, count) {
  if (fromRow === size && intoRow === size) {
    into.set(from.subarray(fromStart, fromStart + count * size), intoStart);
    return;
  }
  for (let k = 0; k < count; k++) {
    const source = k * fromRow + fromStart;
    const target = k * intoRow + intoStart;
    for (let j = 0; j < size; j++) into[target + j] = from[source + j];
  }
}

// src/live/engine.ts
var FORMAT = 1;
var PAGE = 65536;
var GIVEN = {
  tmodes_far_sin: Math.sin,
  tmodes_far_cos: Math.cos,
  tmodes_pow: Math.pow
};
var Engine = class _Engine {
  constructor(layout, functions, memory, free) {
    this.layout = layout;
    this.functions = functions;
    this.memory = memory;
    this.free = free;
  }
  layout;
  functions;
  memory;
  free;
  /** Compile and instantiate; raises an EngineError for another format, and where WebAssembly is refused. */
  static async open(wasm, layout) {
    if (layout.format !== FORMAT) throw new EngineError(`layout: got format ${layout.format}; expected ${FORMAT}`);
    const { instance } = await instantiated(wasm, layout);
    const { memory, heap_base: base, ...functions } = instance.exports;
    const free = base.value;
    return new _Engine(layout, functions, memory, free);
  }
  /** Outputs of a function at `count` samples, by name, each [count, size]; `wanted`: which of them, else all. */
  sample(name, parameters, inputs, count, wanted) {
    const info = known(this.layout.samples, name, "function");
    expect(`${name}: parameters`, parameters.length, info.parameters);
    const out = this.schedule(info, parameters, [inputs], count);
    return parted(info.outputs, out, count, 1, wanted);
  }
  /** The same as it is in the module's memory, until the next call: rows in which each output begins at its start. */
  rows(name, parameters, inputs, count) {
    const info = known(this.layout.samples, name, "function");
    expect(`${name}: parameters`, parameters.length, info.parameters);
    const starts = {};
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
  slopes(name, parameters, inputs, directions, count) {
    const info = known(this.layout.samples, name, "function");
    if (info.kind !== "slopes")
      throw new EngineError(`${name}: got a function without derivatives; expected one with them`);
    expect(`${name}: parameters`, parameters.length, info.parameters);
    const zero = Object.fromEntries(
      Object.entries(info.inputs).map(([label, size2]) => [label, new Float64Array(size2)])
    );
    const out = this.schedule(info, parameters, [inputs, { ...zero, ...directions }], count);
    const size = total(info.outputs);
    return { values: parted(info.outputs, out, count, 2), slopes: parted(info.outputs, out.subarray(size), count, 2) };
  }
  /** Call a function on arrays of doubles, whole numbers, and arrays that it writes. */
  call(name, values) {
    const arrays = values.map(
      (value) => typeof value === "number" ? null : value instanceof Float64Array ? value : value.into
    );
    this.reserve(arrays.reduce((sum, array) => sum + (array?.byteLength ?? 0), this.free));
    const whole = new Float64Array(this.memory.buffer);
    let place = this.free;
    const placed = values.map((value, k) => {
      if (typeof value === "number") return BigInt(value);
      const start = place;
      if (value instanceof Float64Array || value.given) whole.set(arrays[k], start / 8);
      place += arrays[k].byteLength;
      return start;
    });
    this.functions[name](...placed);
    values.forEach((value, k) => {
      if (typeof value === "number" || value instanceof Float64Array) return;
      const [from, to] = value.range?.() ?? [0, value.into.length];
      const start = placed[k] / 8;
      value.into.set(whole.subarray(start + from, start + to), from);
    });
  }
  /** What it gives [count, sides, outputs], in the module's memory until the next call. */
  schedule(info, parameters, sides, count) {
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
  reserve(end) {
    const missing = end - this.memory.buffer.byteLength;
    if (missing <= 0) return;
    try {
      this.memory.grow(Math.ceil(missing / PAGE));
    } catch {
      throw new EngineError(
        `memory: got no room for ${(end / 1e6).toFixed(0)} MB; expected a browser that has it. Hint: ask for fewer samples`
      );
    }
  }
};
async function instantiated(wasm, layout) {
  try {
    return await WebAssembly.instantiate(wasm, { env: GIVEN });
  } catch (problem) {
    const needed = layout.simd ? ", with vectors (SIMD)" : "";
    throw new EngineError(`WebAssembly: got ${String(problem)}; expected a browser that allows it${needed}`);
  }
}

// src/format.ts
function digits(value, count = 4) {
  return value === 0 ? "0" : String(Number(value.toPrecision(count)));
}

// src/live/engine_ending.ts
function ending(run) {
  const { settings, status } = run;
  const { statuses, limits } = run.layout;
  const t = `t = ${digits(run.time, 6)} s`;
  if (status === statuses.finished) return ["finished", `completed at t = ${digits(settings.duration, 6)} s`];
  if (status === statuses.running) {
    return [
      "stopped",
      `stopped at ${t} of ${digits(settings.duration, 6)} s: integration.max_steps = ${settings.maxSteps} is used up`
    ];
  }
  if (status === statuses.chattering) {
    const often = `more than ${limits.most_events} times within ${limits.event_time} s`;
    return [
      "chattering",
      `stopped at ${t}: the contact started or ended ${often}; give the surface damping, or a lower stiffness`
    ];
  }
  return lost(run, t);
}
function lost({ layout, status, lastStep, rates }, at) {
  const { statuses, coordinates, limits } = layout;
  const count = coordinates.length;
  const sizes = Array.from(
    rates().subarray(count, 2 * count),
    (a) => Number.isFinite(a) ? Math.abs(a) : Infinity
  );
  const k = sizes.indexOf(Math.max(...sizes));
  const followed = sizes[k] < limits.bound;
  const kind = !followed ? "diverged" : status === statuses.not_converged ? "not_converged" : status === statuses.step_too_small ? "step_too_small" : "diverged";
  const value = `its acceleration is ${digits(sizes[k], 3)} rad/s^2`;
  const words = kind.replaceAll("_", " ");
  return [
    kind,
    `${words} at ${at} in coordinate ${coordinates[k]}: ${value}; its last step was of ${digits(lastStep, 3)} s`
  ];
}

// src/live/engine_run.ts
var FIXED_STEP = ["rk4", "midpoint"];
var FIRST_PIECE = 500;
var EngineRun = class {
  constructor(engine, spec) {
    this.engine = engine;
    this.spec = spec;
    const info = known(engine.layout.loops, spec.loop, "loop");
    expect(`${spec.loop}: parameters`, spec.parameters.length, info.parameters);
    expect(`${spec.loop}: state`, spec.state.length, info.size);
    expect(`${spec.loop}: rows`, spec.rows.length, (spec.knots.length - 1) * info.row);
    this.method = info.method;
    this.memory = new Float64Array(engine.layout.cells.length);
    this.state = spec.state.slice();
    this.slope = new Float64Array(info.size);
    this.states = new Float64Array(spec.times.length * info.size);
    this.states.set(spec.state);
    this.put({ sample: 1, fresh: 1, old_error: 1e-4 });
  }
  engine;
  spec;
  method;
  memory;
  state;
  slope;
  states;
  /** Time that is reached [s]. */
  get time() {
    return this.cell("t");
  }
  /** Whether something is left to do. */
  get running() {
    return this.cell("status") === this.engine.layout.statuses.running && this.tried < this.spec.settings.maxSteps;
  }
  get tried() {
    return this.cell("steps") + this.cell("rejected");
  }
  cell(name) {
    return this.memory[this.engine.layout.cells.indexOf(name)];
  }
  put(values) {
    for (const [name, value] of Object.entries(values)) this.memory[this.engine.layout.cells.indexOf(name)] = value;
  }
  /** Do at most so many steps. */
  advance(steps) {
    const { layout } = this.engine;
    const { settings, knots, rows, times, parameters } = this.spec;
    const most = Math.max(1, Math.min(steps, settings.maxSteps - this.tried));
    const chosen = {
      step: settings.step,
      rtol: settings.relativeTolerance,
      atol: settings.absoluteTolerance,
      chunk: most,
      bound: layout.limits.bound,
      watch: 0,
      most_events: layout.limits.most_events,
      event_time: layout.limits.event_time,
      looks: 0
    };
    const before = this.cell("sample");
    const fresh = (into) => ({
      into,
      range: () => [before * this.state.length, this.cell("sample") * this.state.length]
    });
    const both = (into) => ({ into, given: true });
    const given = {
      memory: both(this.memory),
      y: both(this.state),
      k1: both(this.slope),
      p: parameters,
      knots,
      rows,
      times,
      out: fresh(this.states),
      options: Float64Array.from(layout.options, (name) => chosen[name]),
      seen: new Float64Array(1),
      segments: knots.length - 1,
      samples: times.length
    };
    this.engine.call(layout.loops[this.spec.loop].export, layout.arguments.map((name) => given[name]));
  }
  /** The run as far as it came. */
  result() {
    const done = this.cell("sample");
    const size = this.state.length;
    const [status, message] = ending({
      layout: this.engine.layout,
      settings: this.spec.settings,
      status: this.cell("status"),
      time: this.time,
      lastStep: this.cell("h"),
      rates: () => this.rates()
    });
    return {
      status,
      message,
      times: this.spec.times.slice(0, done),
      states: this.states.slice(0, done * size),
      statistics: this.statistics()
    };
  }
  statistics() {
    const [steps, smallest, t] = [this.cell("steps"), this.cell("smallest"), this.time];
    const mean = steps ? t / steps : null;
    const info = {
      steps,
      rejected: this.cell("rejected"),
      evaluations: this.cell("evaluations"),
      method: this.method,
      mean_step_s: mean,
      smallest_step_s: smallest > 0 ? smallest : mean
    };
    if (this.cell("stiff_time") > 0) info.stiff_from_s = this.cell("stiff_time");
    if (FIXED_STEP.includes(this.method)) info.step = this.cell("h");
    if (this.cell("passes")) info.passes = this.cell("passes");
    if (this.cell("events")) info.contact_changes = this.cell("events");
    return info;
  }
  rates() {
    const { loop, parameters, rows } = this.spec;
    const { row } = this.engine.layout.loops[loop];
    const segment = Math.min(this.cell("segment"), rows.length / row - 1);
    const inputs = {
      time: Float64Array.of(this.time),
      state: this.state,
      row: rows.slice(segment * row, (segment + 1) * row),
      step: new Float64Array(1)
    };
    return this.engine.sample(`${loop.slice(0, loop.lastIndexOf("."))}.rate`, parameters, inputs, 1).rate;
  }
};
var Cancelled = class extends EngineError {
  name = "Cancelled";
};
async function integrate(engine, spec, watch = {}) {
  const run = new EngineRun(engine, spec);
  const wanted = 1e3 * (watch.piece ?? 0.05);
  let piece = FIRST_PIECE;
  let since = performance.now();
  while (run.running) {
    const began = performance.now();
    run.advance(piece);
    const now = performance.now();
    piece = Math.max(1, Math.floor(piece * Math.min(4, wanted / Math.max(now - began, 1e-3))));
    if (now - since < wanted) continue;
    watch.progress?.(run.time / spec.settings.duration);
    await new Promise((resolve) => setTimeout(resolve, 0));
    if (watch.cancelled?.()) throw new Cancelled(`the run was given up at t = ${digits(run.time, 6)} s`);
    since = performance.now();
  }
  return run.result();
}
function sampleTimes(duration, outputStep) {
  const count = Math.floor(duration / outputStep * (1 + 1e-12));
  const whole = duration - count * outputStep <= 1e-9 * outputStep;
  const times = Float64Array.from({ length: count + (whole ? 1 : 2) }, (_, k) => k * outputStep);
  times[times.length - 1] = duration;
  return times;
}

// src/live/bundle.ts
function doubles(info) {
  return info.data instanceof Float64Array ? info.data : Float64Array.from(info.data);
}

// src/live/map.ts
var NOTHING = 1e-60;
var OPERATIONS = {
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mul: (a, b) => a * b,
  div: (a, b) => a / b,
  neg: (a) => -a,
  pow: Math.pow,
  abs: Math.abs,
  sqrt: Math.sqrt,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  exp: Math.exp,
  log: Math.log,
  arcsin: Math.asin,
  arccos: Math.acos,
  arctan: Math.atan,
  arctan2: Math.atan2,
  hypot: Math.hypot,
  tanh: Math.tanh,
  fmin: Math.min,
  fmax: Math.max
};
function numbersOf(map, values, run) {
  const registers = computed(map, values);
  const vector = doubles(map.base).slice();
  const { data, shape: [, count] } = map.moving;
  for (let k = 0, place = 0, register = 0; k < count; k += 1) {
    vector[place += data[k]] = registers[register += data[count + k]];
  }
  return Object.fromEntries(Object.entries(map.runs[run]).map(([name, { start, shape }]) => [name, vector.slice(start, shape.reduce((product, length) => product * length, 1) + start)]));
}
function computed(map, values) {
  const { data: code, shape: [, count] } = map.code;
  const first = values.length + map.constants.data.length;
  const registers = new Float64Array(first + count);
  registers.set(values.map((value, k) => value === 0 && map.start[k] !== 0 ? NOTHING : value));
  registers.set(map.constants.data, values.length);
  const operations = map.operations.map((name) => OPERATIONS[name]);
  for (let k = 0, r = first; k < count; k += 1, r += 1) {
    registers[r] = operations[code[k]](registers[r - code[count + k]], registers[r - code[2 * count + k]]);
  }
  const guards = map.guards.data;
  for (let k = 0; k < guards.length; k += 3) {
    const [a, b] = [registers[guards[k + 1]], registers[guards[k + 2]]];
    const kind = guards[k] >> 1;
    const holds = kind === 0 ? a < b : kind === 1 ? a <= b : kind === 2 ? a === b : Number.isFinite(a);
    if (holds === Boolean(guards[k] & 1)) refuse(map, values, guards[k + 1], guards[k + 2]);
  }
  return registers;
}
function refuse(map, values, ...registers) {
  const { data: code, shape: [, count] } = map.code;
  const first = values.length + map.constants.data.length;
  const acting = new Set(registers);
  for (const r of acting) if (r >= first) for (const k of [1, 2]) acting.add(r - code[k * count + r - first]);
  const moved = [...acting].filter((r) => r < values.length && values[r] !== map.start[r]).sort((a, b) => a - b);
  if (moved.length)
    throw new EngineError(
      `${moved.map((k) => `${map.paths[k]} = ${values[k]}`).join(", ")}: expected numbers that the data sheet takes and that leave the equations as they are; move it back, or run it natively, by \`tmodes run --set PATH=VALUE\``
    );
}

// src/live/series.ts
function columns(rows, width, which) {
  const count = rows.length / width;
  const found = new Float64Array(count * which.length);
  for (let k = 0; k < count; k += 1) {
    for (let j = 0; j < which.length; j += 1) found[k * which.length + j] = rows[k * width + which[j]];
  }
  return found;
}
function range(start, end) {
  return Array.from({ length: end - start }, (_, k) => start + k);
}
var AS_LARGE = 1 - 1e-9;

// src/live/model.ts
var Model = class _Model {
  constructor(engine, description) {
    this.engine = engine;
    this.description = description;
  }
  engine;
  description;
  /** From the module's bytes, or from where they are fetched. */
  static async open(wasm, description) {
    const bytes = typeof wasm === "string" || wasm instanceof URL ? await (await fetch(wasm)).arrayBuffer() : wasm;
    return new _Model(await Engine.open(bytes, description.layout), description);
  }
  /** Names of the coordinates, in which a state begins; their rates follow in the same order. */
  get coordinates() {
    return this.description.layout.coordinates;
  }
  /** Names of the runs. */
  get runs() {
    return Object.keys(this.description.runs);
  }
  /** Numbers of the data sheet that may be changed, by their paths; `real:` is actual over nominal. */
  parameters() {
    return { ...this.description.named };
  }
  /** Run from the described state; a long run lets the page go on meanwhile. */
  async run(run = "real", changes = {}, watch = {}) {
    const info = known(this.description.runs, run, "run");
    const settings = { ...this.description.settings, ...changes.settings };
    if (settings.duration > this.description.settings.duration) {
      throw new EngineError(
        `duration: got ${settings.duration} s; expected at most ${this.description.settings.duration} s, for which there are signals`
      );
    }
    const { knots, rows } = until(info, settings.duration);
    return integrate(this.engine, {
      loop: `${run}.${this.description.method}`,
      parameters: this.numbers(run, changes),
      knots,
      rows,
      state: Float64Array.from(changes.state ?? info.state),
      times: sampleTimes(settings.duration, changes.outputStep ?? this.description.outputStep),
      settings
    }, watch);
  }
  /** What is observed of a run at its samples, by name (`model.observed(run)` reports the numbers of each). */
  observe(result, run = "real", changes = {}) {
    const info = known(this.description.runs, run, "run");
    const count = result.times.length;
    const inputs = {
      time: result.times,
      state: result.states,
      row: rowsAt(info, result.times),
      step: new Float64Array(1)
    };
    const found = this.engine.sample(`${run}.observe`, this.numbers(run, changes), inputs, count);
    const { q, v, a } = found;
    const { chain, base } = this.blocks(run, changes);
    const { points } = this.engine.sample("inertia", chain, { q, v, a, base }, count);
    return { ...found, tip: columns(points, points.length / count, range(9, 9 + 3)) };
  }
  /** Names of what is observed, with how many numbers each has. */
  observed(run = "real") {
    return { ...known(this.description.layout.samples, `${run}.observe`, "function").outputs, tip: 3 };
  }
  numbers(run, changes) {
    const { parameters = {} } = changes;
    return "length" in parameters ? Float64Array.from(parameters) : this.blocks(run, changes).parameters;
  }
  blocks(run, { parameters = {} }) {
    const { named, map } = this.description;
    const given = "length" in parameters ? {} : parameters;
    const unknown = Object.keys(given).find((name) => !(name in named));
    if (unknown !== void 0)
      throw new EngineError(
        `parameter: got ${unknown}; expected one of ${Object.keys(named).join(", ") || "none: no number has a name"}`
      );
    return numbersOf(map, Object.values({ ...named, ...given }), run);
  }
};
function until(info, end) {
  const pieces = Math.max(1, info.knots.filter((knot, k) => k < info.knots.length - 1 && knot < end).length);
  const width = info.rows.length / (info.knots.length - 1);
  return {
    knots: Float64Array.from([...info.knots.slice(0, pieces), end]),
    rows: Float64Array.from(info.rows.slice(0, pieces * width))
  };
}
function rowsAt(info, times) {
  const pieces = info.knots.length - 1;
  const width = info.rows.length / pieces;
  const rows = new Float64Array(times.length * width);
  let piece = 0;
  times.forEach((time, k) => {
    while (piece < pieces - 1 && info.knots[piece + 1] <= time) piece += 1;
    for (let j = 0; j < width; j++) rows[k * width + j] = info.rows[piece * width + j];
  });
  return rows;
}
export {
  Cancelled,
  Engine,
  EngineError,
  EngineRun,
  Model,
  integrate,
  sampleTimes
};
