// A live run comes twice: early, without what takes longer, and whole.

import type { LiveRun } from "../contract_parts";

const PATIENCE = 300; // ms after which a reader is reported that more is to come; sooner it would flicker

export function isEarly(live: LiveRun | null): boolean {
  return live !== null && live.vibration === undefined;
}

/** `act` is called once, a while after the first `begin`, where no `end` comes before. */
export function patience(act: () => void): { begin(): void; end(): void } {
  let waiting = 0;
  return {
    begin() { waiting ||= window.setTimeout(act, PATIENCE); },
    end() {
      clearTimeout(waiting);
      waiting = 0;
    },
  };
}
