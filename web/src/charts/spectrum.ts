// The amplitude spectrum of a live run: as tmodes/plot/spectra.py makes it (line taken off, Hann window).

import type { Chart } from "../contract";

const FINER = 4; // the grid of frequencies, finer than the lines are sharp

/**
 * Frequencies [Hz] and amplitudes of evenly sampled values within a span of time (without one: the chart's), up to the
 * chart's last frequency.
 */
export function spectrumOf(
  times: Float64Array, values: Float64Array, chart: Chart, span?: [number, number],
): { x: Float64Array; y: Float64Array } {
  const [start, end] = span ?? chart.span ?? [times[0], times[times.length - 1]];
  const slack = 1e-9 * Math.max(1, Math.abs(end));
  const inside = even(
    times,
    Array.from(times.keys()).filter((k) => times[k] >= start - slack && times[k] <= end + slack),
  );
  const part = Float64Array.from(inside, (k) => values[k]);
  const count = part.length;
  if (count < 4) return { x: new Float64Array(), y: new Float64Array() };
  const step = (times[inside[count - 1]] - times[inside[0]]) / (count - 1);
  const total = windowed(part);
  const size = 2 ** Math.ceil(Math.log2(FINER * count));
  const real = new Float64Array(size);
  const imaginary = new Float64Array(size);
  real.set(part);
  transform(real, imaginary);
  const highest = chart.at.data[chart.at.data.length - 1];
  const lines = Math.min(size / 2, Math.floor(highest * size * step) + 1);
  return {
    x: Float64Array.from({ length: lines }, (_, k) => k / (size * step)),
    y: Float64Array.from({ length: lines }, (_, k) => (2 * Math.hypot(real[k], imaginary[k])) / total),
  };
}

/** Without the last sample where that stands off the even ones. */
function even(times: Float64Array, inside: number[]): number[] {
  if (inside.length < 3) return inside;
  const step = (k: number) => times[inside[k]] - times[inside[k - 1]];
  const odd = Math.abs(step(inside.length - 1) / step(1) - 1) > 1e-6;
  return odd ? inside.slice(0, -1) : inside;
}

/** Takes the straight line of least squares off and applies the window, in place; returns the window's sum. */
function windowed(values: Float64Array): number {
  const count = values.length;
  const middle = (count - 1) / 2;
  const mean = values.reduce((sum, value) => sum + value, 0) / count;
  const spread = (count * (count * count - 1)) / 12;
  const slope = values.reduce((sum, value, k) => sum + (k - middle) * value, 0) / spread;
  let total = 0;
  for (let k = 0; k < count; k += 1) {
    const weight = 0.5 - 0.5 * Math.cos((2 * Math.PI * k) / count);
    values[k] = weight * (values[k] - mean - slope * (k - middle));
    total += weight;
  }
  return total;
}

/** Squared sizes of the lines [n/2 + 1] of the spectrum of values [n, 3] less their mean, in a Hann window, by axis. */
export function powersOf(values: Float64Array): Float64Array[] {
  const n = values.length / 3;
  const size = 2 ** Math.ceil(Math.log2(2 * n));
  const turn = (k: number) => (Math.PI * ((k * k) % (2 * n))) / n; // Bluestein: any length by one of a power of two
  const [chirpRe, chirpIm] = [new Float64Array(size), new Float64Array(size)];
  for (let k = 0; k < n; k += 1) {
    for (const at of [k, (size - k) % size]) [chirpRe[at], chirpIm[at]] = [Math.cos(turn(k)), Math.sin(turn(k))];
  }
  transform(chirpRe, chirpIm);
  return Array.from({ length: 3 }, (_, c) => {
    let mean = 0;
    for (let k = 0; k < n; k += 1) mean += values[3 * k + c] / n;
    const [re, im] = [new Float64Array(size), new Float64Array(size)];
    for (let k = 0; k < n; k += 1) {
      const value = (values[3 * k + c] - mean) * (0.5 - 0.5 * Math.cos((2 * Math.PI * k) / (n - 1)));
      [re[k], im[k]] = [value * Math.cos(turn(k)), -value * Math.sin(turn(k))];
    }
    transform(re, im);
    for (let k = 0; k < size; k += 1) // the inverse transform by swapping both parts
      [re[k], im[k]] = [re[k] * chirpIm[k] + im[k] * chirpRe[k], re[k] * chirpRe[k] - im[k] * chirpIm[k]];
    transform(re, im);
    return Float64Array.from({ length: Math.floor(n / 2) + 1 }, (__, k) => (re[k] ** 2 + im[k] ** 2) / size ** 2);
  });
}

/** Fast Fourier transform in place, of 2^n values (Cooley and Tukey, 1965). */
export function transform(real: Float64Array, imaginary: Float64Array): void {
  const size = real.length;
  for (let k = 1, mirrored = 0; k < size; k += 1) {
    let bit = size >> 1;
    for (; mirrored & bit; bit >>= 1) mirrored ^= bit;
    mirrored ^= bit;
    if (k < mirrored) {
      [real[k], real[mirrored]] = [real[mirrored], real[k]];
      [imaginary[k], imaginary[mirrored]] = [imaginary[mirrored], imaginary[k]];
    }
  }
  const turns = turnsOf(size);
  for (let length = 2; length <= size; length *= 2) butterflies(real, imaginary, length, turns);
}

let turned = new Float64Array();

/** cos and -sin of 2 pi k/size, k below size/2; those of the size before are kept, as curves of one chart share it. */
function turnsOf(size: number): Float64Array {
  if (turned.length === size) return turned;
  turned = new Float64Array(size);
  for (let k = 0; k < size / 2; k += 1) {
    turned[2 * k] = Math.cos((2 * Math.PI * k) / size);
    turned[2 * k + 1] = -Math.sin((2 * Math.PI * k) / size);
  }
  return turned;
}

function butterflies(real: Float64Array, imaginary: Float64Array, length: number, turns: Float64Array): void {
  const half = length / 2;
  const step = (2 * real.length) / length;
  for (let start = 0; start < real.length; start += length) {
    for (let k = 0; k < half; k += 1) {
      const one = start + k;
      const other = one + half;
      const cos = turns[step * k];
      const sin = turns[step * k + 1];
      const re = real[other] * cos - imaginary[other] * sin;
      const im = real[other] * sin + imaginary[other] * cos;
      real[other] = real[one] - re;
      imaginary[other] = imaginary[one] - im;
      real[one] += re;
      imaginary[one] += im;
    }
  }
}
