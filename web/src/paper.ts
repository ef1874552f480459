// A page on paper, which is white and shows all: what is folded is opened, and closed again afterwards.

/** `folded`: what is opened for paper; what is drawn takes the colours of the light scheme, where it asks for them. */
export function forPaper(folded: string): void {
  const page = document.documentElement;
  let opened: HTMLDetailsElement[] = [];
  addEventListener("beforeprint", () => {
    page.classList.add("printing");
    const closed = [...document.querySelectorAll<HTMLDetailsElement>(folded)].filter((part) => !part.open);
    for (const part of closed) part.open = true;
    opened = [...opened, ...closed];
  });
  addEventListener("afterprint", () => {
    page.classList.remove("printing");
    for (const part of opened) part.open = false;
    opened = [];
  });
}
