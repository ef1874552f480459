// What lessens the error of the run that is shown most, found by runs of the server with settings changed.

import { adviceOf, effects, lessening } from "../panels/effects";
import type { Advice } from "../panels/verdict";
import { spare } from "../spare";
import type { LiveRun } from "../contract_parts";
import { api, type SheetInfo, type Wish } from "./api";
import { copy } from "./sheet";
import { apply, valueOf } from "./sliders";

const POLL = 0.25; // s

export interface Adviser {
  /** Another run is wanted: what is known is of the one before. */
  forget(): void;
  /** The run of a sheet is there, all of it. */
  ask(of: SheetInfo): void;
}

/** `client`: whose newer runs end those made here; `show` gets what is found; `changed`: a setting was applied. */
export function adviser(client: string, show: (found: Advice[] | string | null) => void, changed: () => void): Adviser {
  let asked = 0;
  let of: SheetInfo | null = null;
  const ranking = spare(() => of && rank(of, asked).catch(() => undefined)); // it fails where another run is wanted

  async function rank(info: SheetInfo, own: number): Promise<void> {
    const rows = info.sliders.flatMap((slider) => {
      const value = valueOf(slider, info.sheet);
      return value === null ? [] : [{ slider, value }];
    });
    const wanted = () => own === asked;
    const run = async (values: number[]) => {
      const wish = { sheet: copy(info.sheet), looks: info.looks };
      rows.forEach(({ slider, value }, k) => { if (values[k] !== value) apply(slider, wish.sheet, values[k]); });
      return tried(client, wish);
    };
    const found = rows.length ? await effects({ run }, rows, rows.length, wanted) : "there are no sliders";
    if (found === null || !wanted()) return;
    if (typeof found === "string") return show(found);
    const less = await lessening({ run }, rows, found, wanted);
    if (less && wanted()) show(less.map((one) => adviceOf(one, () => {
      apply(one.row.slider, info.sheet, one.value);
      changed();
    })));
  }

  return {
    forget() {
      asked += 1;
      of = null;
      show(null);
    },
    ask(info) {
      of = info;
      ranking.ask();
    },
  };
}

/** The facts of the run of a sheet; raises where it is refused, and `Superseded` where another one is wanted. */
async function tried(client: string, wish: Wish): Promise<Pick<LiveRun, "facts" | "scene">> {
  let job = await api.begin("change", wish, client, []);
  while (job.state === "waiting" || job.state === "running") job = await api.look(job.job, POLL);
  if (job.state !== "done")
    throw Object.assign(new Error(job.state), { name: job.state === "cancelled" ? "Superseded" : "Refused" });
  const [run] = (await api.change(job.job)).runs;
  return { facts: Object.fromEntries(run.facts.map(({ id, value, note }) => [id, { value, note }])) };
}
