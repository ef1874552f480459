"""The pages' model in Node: built from its source, run with values of its sliders, timed."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.report.pack import pack

__all__ = ["Missing", "in_node", "read_page"]

WEB = Path(__file__).resolve().parents[1] / "web"
ESBUILD = WEB / "node_modules" / ".bin" / "esbuild"

RUNS = """
import { readFileSync, writeFileSync } from "node:fs";
import { openLive, unpack } from "./live.mjs";
const live = await openLive(unpack(new Uint8Array(readFileSync("bundle.tmpk"))));
const reported = [];
for (const [k, values] of JSON.parse(readFileSync("jobs.json", "utf8")).entries()) {
  const [began, before] = [performance.now(), process.cpuUsage()];
  let early = 0;
  const run = await live.run(values, undefined, () => { early = performance.now() - began; });
  const [total, { user, system }, series, parts] = [performance.now() - began, process.cpuUsage(before), {}, []];
  let place = 0;
  for (const [name, { data, shape }] of Object.entries(run.series)) {
    series[name] = { place, shape };
    place += data.length;
    parts.push(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
  }
  if (process.argv[2] === "keep") writeFileSync(`run${k}.f8`, Buffer.concat(parts));
  const seconds = { curves: early / 1000, total: total / 1000, processor: (user + system) / 1e6, loops: run.seconds };
  reported.push({ ...seconds, series });
}
console.log(JSON.stringify(reported));
"""

PAGE = """
import { readFileSync } from "node:fs";
import { inflated, unpack } from "./live.mjs";
const text = /id="tmodes-data">([^<]*)</.exec(readFileSync("page.html", "utf8"))[1];
const charts = unpack(await inflated(text)).runs[0].charts.map(({ id, at, samples, abscissa, curves }) => ({
  id, abscissa, samples, drawn: at.data.length,
  extremes: curves.map(({ values }) =>
    values.data.reduce(([low, high], x) => [Math.min(low, x), Math.max(high, x)], [Infinity, -Infinity])),
}));
console.log(JSON.stringify(charts));
"""


class Missing(RuntimeError):
    """What is needed here is not installed; the sentence says what."""


def _run(program: str, folder: Path, *arguments: str) -> Any:
    node = shutil.which("node")
    if node is None or not ESBUILD.exists():
        raise Missing("needs Node and the packages of the pages: npm ci --prefix web")
    (folder / "entry.ts").write_text(
        "".join(f'export * from "{WEB.as_posix()}/src/{n}";\n' for n in ("live/live", "pack"))
    )
    (folder / "none.js").write_text('export default "";')
    shared = ("--bundle", "--format=esm", f"--alias:tmodes:worker={folder / 'none.js'}", "--outfile=live.mjs")
    subprocess.run([os.fspath(ESBUILD), "entry.ts", *shared], check=True, capture_output=True, cwd=folder)
    (folder / "program.mjs").write_text(program)
    done = subprocess.run([node, "program.mjs", *arguments], cwd=folder, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def in_node(
    bundle: dict[str, Any], jobs: list[list[float]], folder: Path, *, keep: bool = False
) -> list[dict[str, Any]]:
    """Of each list of values: seconds to the curves, in all, of processors, of the loops; if asked for, all series."""
    (folder / "bundle.tmpk").write_bytes(pack(bundle))
    (folder / "jobs.json").write_text(json.dumps(jobs))
    info = _run(RUNS, folder, "keep" if keep else "")
    for k, run in enumerate(info):
        whole = np.fromfile(folder / f"run{k}.f8") if keep else np.empty(0)
        run["series"] = {name: _part(whole, **where) for name, where in run["series"].items()} if keep else {}
    return info


def _part(whole: NDArray[np.float64], place: int, shape: list[int]) -> NDArray[np.float64]:
    return whole[place : place + int(np.prod(shape))].reshape(shape)


def read_page(page: Path, folder: Path) -> list[dict[str, Any]]:
    """Of each chart as the page reads it: samples, samples drawn, least and largest value of each curve."""
    shutil.copy(page, folder / "page.html")
    return _run(PAGE, folder)
