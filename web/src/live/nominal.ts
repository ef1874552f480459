// The nominal run, by this worker itself or by a partner that makes it while this one makes the actual run.

import type { Bundle } from "./bundle";
import type { Engine } from "./engine";
import { Cancelled, type Watch } from "./engine_run";
import type { Facts } from "./facts";
import { numbersOf } from "./map";
import { buffersIn } from "./messages";
import { moved, type Regime } from "./regime";
import { plannedOf, type Seen } from "./run_series";

/** The nominal robot in motion, and what was seen of all its samples. */
export interface Nominal {
  regime: Regime;
  seen: Seen;
  /** Its vibration after the move, once that is asked for. */
  vibration?: Facts[string];
}

/** Who makes it; raises an error where it cannot start, and Cancelled. */
export interface Planner {
  /** Whether that is done at the same time as what is done here. */
  readonly apart: boolean;
  plan(values: readonly number[], watch: Watch): Promise<Nominal>;
}

/** What a partner is asked: `id` 0 ends what is not wanted any more. */
interface Order {
  id: number;
  values: readonly number[];
}

type Reply =
  | { id: 0 }
  | { id: number; share: number }
  | { id: number; nominal: Nominal }
  | { id: number; cancelled: boolean; message: string };

const LOOK = 20; // ms between two looks at whether the run is still wanted

export function planHere(engine: Engine, bundle: Bundle): Planner {
  return {
    apart: false,
    async plan(values, watch) {
      const blocks = numbersOf(bundle.map, values, "reference");
      const regime = await moved(engine, bundle, values, "reference", blocks, watch);
      return { regime, seen: plannedOf(engine, regime, regime.run.times.length) };
    },
  };
}

/** By the partner at the other end of `port`; by `own` as long as that is not ready. */
export function planThere(port: MessagePort, own: Planner): Planner {
  let [ready, latest] = [false, 0];
  let answer: ((reply: Reply) => void) | null = null;
  port.onmessage = ({ data }: MessageEvent<Reply>) => {
    if (data.id === 0) ready = true;
    else if (data.id === latest) answer?.(data);
  };
  return {
    get apart() {
      return ready;
    },
    async plan(values, watch) {
      if (!ready) return own.plan(values, watch);
      latest += 1;
      const send = (order: Order) => port.postMessage(order);
      let looking: ReturnType<typeof setInterval> | undefined;
      try {
        return await new Promise<Nominal>((resolve, reject) => {
          answer = (reply) => {
            if ("share" in reply) watch.progress?.(reply.share);
            else if ("nominal" in reply) resolve(reply.nominal);
            else if ("message" in reply)
              reject(reply.cancelled ? new Cancelled(reply.message) : new Error(reply.message));
          };
          looking = setInterval(() => {
            if (!watch.cancelled?.()) return;
            send({ id: 0, values: [] });
            reject(new Cancelled("a newer run began"));
          }, LOOK);
          send({ id: latest, values });
        });
      } finally {
        clearInterval(looking);
        answer = null;
      }
    },
  };
}

/** Makes nominal runs for whoever asks at the other end of `port`, one at a time. */
export function serve(port: MessagePort, planner: Planner): void {
  let wanted = 0;
  let before: Promise<void> = Promise.resolve();
  const send = (reply: Reply, transfer: ArrayBuffer[] = []) => port.postMessage(reply, transfer);
  async function made({ id, values }: Order): Promise<void> {
    const watch = { cancelled: () => id !== wanted, progress: (share: number) => send({ id, share }) };
    try {
      if (watch.cancelled()) throw new Cancelled("a newer run began");
      const nominal = await planner.plan(values, watch);
      const { regime, seen } = nominal;
      send({ id, nominal }, buffersIn([regime.run.times, regime.run.states, seen.model, seen.tip]));
    } catch (problem) {
      const message = problem instanceof Error ? problem.message : String(problem);
      send({ id, cancelled: problem instanceof Cancelled, message });
    }
  }
  port.onmessage = ({ data }: MessageEvent<Order>) => {
    wanted = data.id;
    if (data.id) before = before.then(() => made(data));
  };
  send({ id: 0 });
}
