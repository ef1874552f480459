// Motions in time as pieces of polynomials, as tmodes/kinds/signals/schedule.py keeps them.

/** Pieces of powers of t - knots[k]: `rows` [pieces, signals, degree + 1]. */
export interface Schedule {
  knots: Float64Array; // [pieces + 1] s
  coefficients: Float64Array;
  signals: number;
  degree: number;
}

const SAME = 1e-12;

/** One signal; `coefficients` [pieces, degree + 1]. */
export function schedule(knots: Float64Array, coefficients: Float64Array): Schedule {
  return { knots, coefficients, signals: 1, degree: coefficients.length / (knots.length - 1) - 1 };
}

/** The same motion of one signal to `end` [s]: cut short, or held in its last position. */
export function until(one: Schedule, end: number): Schedule {
  const width = one.degree + 1;
  const pieces = one.knots.length - 1;
  let kept = 0;
  while (kept < pieces && one.knots[kept] < end) kept += 1;
  const last = one.knots[pieces];
  const knots = [...one.knots.subarray(0, kept)];
  const coefficients = [...one.coefficients.subarray(0, kept * width)];
  if (end > last) {
    knots.push(last);
    coefficients.push(valueIn(one, pieces - 1, 0, last), ...new Array<number>(one.degree).fill(0));
  }
  return schedule(Float64Array.from([...knots, end]), Float64Array.from(coefficients));
}

function valueIn(one: Schedule, piece: number, signal: number, time: number): number {
  const width = one.degree + 1;
  const start = (piece * one.signals + signal) * width;
  const tau = time - one.knots[piece];
  let value = 0;
  for (let power = one.degree; power >= 0; power -= 1) value = value * tau + one.coefficients[start + power];
  return value;
}

function pieceAt(knots: Float64Array, time: number): number {
  let [low, high] = [0, knots.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (knots[middle] <= time) low = middle;
    else high = middle;
  }
  return low;
}

/** The value of a signal at a time [s]; at a jump, the later piece counts. */
export function valueAt(one: Schedule, signal: number, time: number): number {
  return valueIn(one, pieceAt(one.knots, time), signal, time);
}

/** What compiled loops read: of each piece its start and all coefficients. */
export function rowsOf(one: Schedule): Float64Array {
  return rowsAtPieces(one, one.knots.length - 1, (k) => k);
}

/** The same of the piece at each time [s]. */
export function rowsAt(one: Schedule, times: Float64Array): Float64Array {
  return rowsAtPieces(one, times.length, (k) => pieceAt(one.knots, times[k]));
}

function rowsAtPieces(one: Schedule, count: number, pieceOf: (k: number) => number): Float64Array {
  const width = one.signals * (one.degree + 1);
  const rows = new Float64Array(count * (width + 1));
  for (let k = 0, place = 0; k < count; k += 1) {
    const piece = pieceOf(k);
    rows[place++] = one.knots[piece];
    for (let j = piece * width; j < (piece + 1) * width; j += 1) rows[place++] = one.coefficients[j];
  }
  return rows;
}

/** Several signals on all their knots, each held in its last value up to the end of the longest. */
export function merged(all: Schedule[]): Schedule {
  if (!all.length) return { knots: Float64Array.of(0, 1), coefficients: new Float64Array(0), signals: 0, degree: 0 };
  const end = Math.max(...all.map((one) => one.knots[one.knots.length - 1]));
  const whole = all.map((one) => (one.knots[one.knots.length - 1] < end ? until(one, end) : one));
  const knots = commonKnots(whole.flatMap((one) => [...one.knots]));
  const degree = Math.max(...whole.map((one) => one.degree));
  const coefficients = new Float64Array((knots.length - 1) * all.length * (degree + 1));
  whole.forEach((one, signal) => {
    for (let piece = 0; piece < knots.length - 1; piece += 1) {
      const place = (piece * all.length + signal) * (degree + 1);
      shifted(one, knots, piece, coefficients.subarray(place, place + degree + 1));
    }
  });
  return { knots, coefficients, signals: all.length, degree };
}

function commonKnots(all: number[]): Float64Array {
  const sorted = [...new Set(all)].sort((a, b) => a - b);
  const span = sorted[sorted.length - 1] - sorted[0];
  const kept = sorted.filter((knot, k) => k === 0 || knot - sorted[k - 1] > SAME * span);
  kept[kept.length - 1] = sorted[sorted.length - 1];
  return Float64Array.from(kept);
}

/** Coefficients of a signal about the start of a new piece. */
function shifted(one: Schedule, knots: Float64Array, piece: number, into: Float64Array): void {
  const old = pieceAt(one.knots, (knots[piece] + knots[piece + 1]) / 2);
  const given = knots[piece] - one.knots[old];
  const shift = Math.abs(given) <= SAME * (knots[knots.length - 1] - knots[0]) ? 0 : given;
  for (let power = 0; power <= one.degree; power += 1) {
    const own = one.coefficients[old * (one.degree + 1) + power];
    let binomial = 1; // of power over power - lower
    for (let lower = power; lower >= 0; lower -= 1) {
      into[lower] += binomial * own * Math.pow(shift, power - lower);
      binomial = (binomial * lower) / (power - lower + 1);
    }
  }
}

const STILL = 1e-9; // change within a piece, over the largest value, that is rounding
const JUMP = 1e-6; // change between two pieces, likewise

/**
 * When the last of some signals stops changing [s]; null where one changes up to the end of what is known of it. Each
 * is given uncut: a move that ends with the run, or after it, is then known to end. As tmodes/result/settling.py.
 */
export function moveEnd(each: Schedule[]): number | null {
  const ends = each.map(lastChange);
  return ends.includes(null) ? null : Math.max(0, ...(ends as number[]));
}

/** The first time before `end` at which a signal jumps [s]; Infinity: it does not. */
export function firstJump(one: Schedule, end: number): number {
  const later = [...one.knots.subarray(1, -1)].find((time, k) => time < end && jumps(one, k + 1, sizeOf(one)));
  return later ?? Infinity;
}

function jumps(one: Schedule, k: number, size: number): boolean {
  return Math.abs(one.coefficients[k * (one.degree + 1)] - valueIn(one, k - 1, 0, one.knots[k])) > JUMP * size;
}

/** The largest value at the start of a piece. */
function sizeOf({ knots, coefficients, degree }: Schedule): number {
  return Array.from(knots.subarray(1), (_, k) => Math.abs(coefficients[k * (degree + 1)]))
    .reduce((a, b) => Math.max(a, b), 1e-12);
}

function lastChange(one: Schedule): number | null {
  const { knots, coefficients, degree } = one;
  const pieces = knots.length - 1;
  const width = degree + 1;
  const size = sizeOf(one);
  for (let k = pieces - 1; k >= 0; k -= 1) {
    const length = knots[k + 1] - knots[k];
    for (let power = 1; power < width; power += 1) {
      if (Math.abs(coefficients[k * width + power]) * length ** power <= STILL * size) continue;
      return k === pieces - 1 ? null : knots[k + 1];
    }
    if (k && jumps(one, k, size)) return knots[k];
  }
  return 0;
}
