// The program of worker.ts, built by itself, as text: web/build.mjs puts it there.
declare module "tmodes:worker" {
  const source: string;
  export default source;
}
