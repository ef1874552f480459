// Bundles the pages' programs: each entry with all it needs, minified, into the folder given (or that of the package).
import { build } from "esbuild";
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const out = process.argv[2] ?? `${here}../src/tmodes/report/web`;
const origin = `/* tmodes, built from ${process.argv[3] ?? "?"}; BSD-3-Clause */`;
const license = (name) => `/* ${name}\n${readFileSync(`${here}node_modules/${name}/LICENSE`, "utf8").trim()}\n*/`;
// ml-matrix by its sources, of which only what is imported is taken: its own bundle is one piece.
const alias = { "ml-matrix": `${here}node_modules/ml-matrix/src/index.js` };
const shared = { alias, bundle: true, minify: true, charset: "utf8", legalComments: "none", target: "es2022", logLevel: "warning" };
const within = ["three", "uplot", "ml-matrix", "is-any-array", "ml-array-rescale", "ml-array-max", "ml-array-min"];
const banner = { js: [origin, ...within.map(license)].join("\n") };

// The live model's worker is built by itself, and stands as text in the program that starts it.
const worker = {
  name: "worker",
  setup(own) {
    own.onResolve({ filter: /^tmodes:worker$/ }, () => ({ path: "worker", namespace: "worker" }));
    own.onLoad({ filter: /.*/, namespace: "worker" }, async () => {
      const made = await build({ ...shared, entryPoints: [`${here}src/live/worker.ts`], format: "iife", write: false });
      return { contents: made.outputFiles[0].text, loader: "text" };
    });
  },
};

// A page's program is one classic script; the live model is also a module for anybody's page.
const entries = [
  { entryPoints: [`${here}src/viewer.ts`], outfile: `${out}/viewer.js`, format: "iife", banner },
  { entryPoints: [`${here}src/studio.ts`], outfile: `${out}/studio.js`, format: "iife", banner },
  { entryPoints: [`${here}src/study.ts`], outfile: `${out}/study.js`, format: "iife", banner: { js: origin } },
  { entryPoints: [`${here}src/plots.ts`], outfile: `${out}/plots.js`, format: "iife", banner: { js: origin } },
  { entryPoints: [`${here}src/live/model.ts`], outfile: `${out}/model.js`, format: "esm", banner: { js: origin }, minify: false },
];
for (const entry of entries) if (existsSync(entry.entryPoints[0])) await build({ ...shared, plugins: [worker], ...entry });
