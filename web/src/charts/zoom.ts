// The stretch of time that all charts show.

export interface Zoom {
  readonly range: [number, number] | null;
  set(range: [number, number] | null): void;
  subscribe(listener: () => void): () => void;
}

export function makeZoom(): Zoom {
  const listeners = new Set<() => void>();
  const state: { range: [number, number] | null } = { range: null };
  return {
    get range() {
      return state.range;
    },
    set(range) {
      const same = range === state.range || (range && state.range && range.every((end, k) => end === state.range?.[k]));
      if (same) return;
      state.range = range;
      listeners.forEach((listener) => listener());
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
