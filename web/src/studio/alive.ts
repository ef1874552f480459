// Whether the studio's server is still there: a page that stays open says so, and continues when it is back.

const EVERY = 3000;
const PATIENCE = 8000;
const STOPPED =
  "The studio does not answer: it was stopped, or this machine slept. " +
  "What is shown stays here; start it again with: tmodes studio.";
const AGAIN =
  "The studio was restarted: open the address that it printed. What is shown here stays.";

export interface Listener {
  /** What to say while it is away; null: it is there. */
  away(text: string | null): void;
  /** It is there again. */
  back(): void;
}

/** Ask now and then, as long as the page is open. */
export function watch(listener: Listener): void {
  let before: string | null = null;
  const look = async () => {
    const text = await state();
    if (text !== before) listener.away(text);
    if (text === null && before !== null) listener.back();
    before = text;
    setTimeout(() => void look(), EVERY);
  };
  setTimeout(() => void look(), EVERY);
}

async function state(): Promise<string | null> {
  try {
    const answer = await fetch("api/alive", { credentials: "same-origin", signal: AbortSignal.timeout(PATIENCE) });
    return answer.ok ? null : answer.status === 401 ? AGAIN : STOPPED;
  } catch {
    return STOPPED;
  }
}
