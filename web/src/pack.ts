// A page's data: one block of bytes with a JSON head and the arrays it names, as tmodes/report/pack.py writes it.

/** An array of numbers with its shape, row-major; `data` is in the units that the field says. */
export interface Numbers {
  readonly data: Float64Array | Float32Array | Int32Array | Uint8Array;
  readonly shape: readonly number[];
}

interface Info {
  dtype: "f8" | "d4" | "i4" | "u1" | "d2";
  shape: number[];
  offset: number;
  /** Only of whole numbers of two bytes: value = scale * number + start. */
  scale?: number;
  start?: number;
}

const MAGIC = "TMPK";

/** The object that a pack holds; raises an error for bytes that are no pack. */
export function unpack(bytes: Uint8Array): unknown {
  if (new TextDecoder().decode(bytes.subarray(0, 4)) !== MAGIC) throw new Error("these bytes are no data of tmodes");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(4, true);
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(8, 8 + length))) as { page: unknown; arrays: Info[] };
  const base = 8 * Math.ceil((8 + length) / 8);
  const arrays = head.arrays.map((info) => read(bytes, base, info));
  return filled(head.page, arrays);
}

function read(bytes: Uint8Array, base: number, info: Info): Numbers {
  const count = info.shape.reduce((product, size) => product * size, 1);
  const width = Number(info.dtype[1]);
  const part = bytes.slice(base + info.offset, base + info.offset + count * width).buffer;
  if (info.dtype === "f8") return { data: new Float64Array(part), shape: info.shape };
  if (info.dtype === "d4") return { data: single(new Uint8Array(part), count, info), shape: info.shape };
  if (info.dtype === "i4") return { data: new Int32Array(part), shape: info.shape };
  if (info.dtype === "u1") return { data: new Uint8Array(part), shape: info.shape };
  return { data: smooth(new Uint8Array(part), count, info), shape: info.shape };
}

/** Whole numbers of two bytes that are reported as changes from row to row, their low bytes before their high ones. */
function smooth(bytes: Uint8Array, count: number, { shape, scale = 1, start = 0 }: Info): Float32Array {
  const row = count / (shape[0] || 1) || 1;
  const whole = new Int16Array(count);
  for (let k = 0; k < count; k++) whole[k] = (bytes[k] | (bytes[count + k] << 8)) + (k >= row ? whole[k - row] : 0);
  return Float32Array.from(whole, (value) => start + scale * value);
}

/** Numbers of single precision, reported as changes of their bits from row to row, the lowest bytes of all first. */
function single(bytes: Uint8Array, count: number, { shape }: Info): Float32Array {
  const row = count / (shape[0] || 1) || 1;
  const whole = new Uint32Array(count);
  for (let k = 0; k < count; k++) {
    const step = bytes[k] | (bytes[count + k] << 8) | (bytes[2 * count + k] << 16) | (bytes[3 * count + k] << 24);
    whole[k] = step + (k >= row ? whole[k - row] : 0);
  }
  return new Float32Array(whole.buffer);
}

function filled(value: unknown, arrays: Numbers[]): unknown {
  if (Array.isArray(value)) return value.map((item) => filled(item, arrays));
  if (value === null || typeof value !== "object") return value;
  const entries = Object.entries(value);
  if (entries.length === 1 && entries[0][0] === "$array") return arrays[entries[0][1] as number];
  if (entries.length === 1 && entries[0][0] === "$sum") return sum(filled(entries[0][1], arrays) as Numbers[]);
  return Object.fromEntries(entries.map(([key, item]) => [key, filled(item, arrays)]));
}

function sum([large, small]: Numbers[]): Numbers {
  return { data: Float32Array.from(large.data, (value, k) => value + small.data[k]), shape: large.shape };
}

/** The bytes of a compressed pack that stands in the page as base64 text. */
export async function inflated(base64: string): Promise<Uint8Array> {
  const text = atob(base64.trim());
  const packed = new Uint8Array(text.length); // by `Uint8Array.from` it takes many times as long
  for (let k = 0; k < text.length; k += 1) packed[k] = text.charCodeAt(k);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
