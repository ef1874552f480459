// Work for when there is time: what is not in sight, but is in a picture of the whole page.

const WAIT = 400; // ms since it was last asked for: a slider that moves is not held up

export interface Spare {
  ask(): void;
  end(): void;
}

/** `work` is done once after it was last asked for, when the browser has nothing else to do. */
export function spare(work: () => void): Spare {
  let waiting = 0;
  const idle = window.requestIdleCallback ?? ((act: () => void) => window.setTimeout(act)); // not every browser has it
  let ended = false;
  const end = () => window.clearTimeout(waiting);
  return {
    ask() {
      end();
      waiting = window.setTimeout(() => idle(() => ended || work()), WAIT);
    },
    end() {
      ended = true;
      end();
    },
  };
}
