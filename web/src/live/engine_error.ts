// What goes wrong on purpose with a module, and the checks that tell it.

/** What goes wrong on purpose; the message reports which, what was got, what is expected. */
export class EngineError extends Error {
  override name = "EngineError";
}

/** The entry of a name; raises an EngineError that lists those there are. */
export function known<T>(entries: Record<string, T>, name: string, what: string): T {
  if (!Object.hasOwn(entries, name)) {
    throw new EngineError(`${what}: got ${name}; expected one of ${Object.keys(entries).join(", ")}`);
  }
  return entries[name];
}

/** Raise an EngineError where an array is not as long as it must be. */
export function expect(which: string, got: number, expected: number): void {
  if (got !== expected) throw new EngineError(`${which}: got ${got} numbers; expected ${expected}`);
}
