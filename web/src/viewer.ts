// The program of a page about results: unpacks its data and mounts the parts.
import type { Page } from "./contract";
import { make } from "./dom";
import { unpack } from "./pack";
import { mountPage } from "./page";
import { forPaper } from "./paper";

declare global {
  interface Window {
    /** The page's data, which the page began to decompress before its program was there. */
    tmodesData: Promise<ArrayBuffer>;
  }
}

async function main(): Promise<void> {
  const place = document.getElementById("tmodes-data");
  const root = document.getElementById("tmodes-app");
  if (place === null || root === null) return;
  try {
    const page = unpack(new Uint8Array(await window.tmodesData)) as Page;
    mountPage(root, page);
    document.documentElement.classList.add("running");
  } catch (error) {
    const info = error instanceof Error ? error.message : String(error);
    root.replaceChildren(
      make("p", {
        class: "status warning",
        role: "alert",
        text: `The interactive part of this page could not start: ${info}. The whole report without it follows.`,
      }),
    );
  }
}

forPaper("details");
void main();
