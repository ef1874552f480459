"""The live model at work in Node, built from its sources: what it gives for values of its sliders."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import LONG
from tmodes.live.map import LiveMap
from tmodes.live.sliders import MOST
from tmodes.report.pack import pack

__all__ = ["built_page", "drawn", "in_node", "live_in_node", "worst_difference"]

ROOT = Path(__file__).resolve().parents[2]
WEB = ROOT / "web"
ESBUILD = WEB / "node_modules/.bin/esbuild"

ENTRY = """
export * from "{web}/src/live/live";
export * from "{web}/src/live/runner";
export * from "{web}/src/pack";
"""

HARNESS = """
import { readFileSync } from "node:fs";
import { openLive, unpack } from "./live.mjs";
const live = await openLive(unpack(new Uint8Array(readFileSync("bundle.tmpk"))));
const results = [];
for (const values of JSON.parse(readFileSync("jobs.json", "utf8"))) {
  try {
    results.push({ ...(await live.run(values)), sheet: live.sheet(values) });
  } catch (error) {
    results.push({ error: `${error.name}: ${error.message}` });
  }
}
const written = (key, value) => ArrayBuffer.isView(value) ? { $f8: Array.from(value, String) } : value;
process.stdout.write(JSON.stringify(results, written));
"""


def drawn(live: LiveMap, count: int, seed: int, others: float = 0.1) -> list[list[float]]:
    """Random values of all sliders at once for which the program holds.

    The first ones anywhere between their ends, ``others`` by that share of the way to them.
    """
    generator, found = np.random.default_rng(seed), list[list[float]]()
    reach = np.where(np.arange(len(live.sliders)) < MOST, 1.0, others)
    for _ in range(count):
        shares = reach * generator.uniform(-1.0, 1.0, len(reach))
        while True:
            ends = [one.high if share > 0 else one.low for one, share in zip(live.sliders, shares, strict=True)]
            values = [
                one.value + abs(share) * (end - one.value)
                for one, share, end in zip(live.sliders, shares.tolist(), ends, strict=True)
            ]
            if live.holds(values):
                break
            shares *= 0.8
        found.append(values)
    return found


def built_live(folder: Path) -> Path:
    """The live model as one module; the test is skipped where it cannot be built."""
    if not ESBUILD.exists():
        pytest.skip("needs the packages of the pages: npm ci in web/")
    (folder / "entry.ts").write_text(ENTRY.replace("{web}", WEB.as_posix()))
    (folder / "none.js").write_text('export default "";')
    target = folder / "live.mjs"
    info = [os.fspath(ESBUILD), "entry.ts", "--bundle", "--format=esm", f"--alias:tmodes:worker={folder / 'none.js'}"]
    subprocess.run([*info, f"--outfile={target}"], check=True, capture_output=True, cwd=folder)
    return target


def built_page(entry: str, folder: Path) -> str:
    """A program of a page, with the worker's in it, from its source; the test is skipped where it cannot be built."""
    if not ESBUILD.exists():
        pytest.skip("needs the packages of the pages: npm ci in web/")
    (folder / "page.ts").write_text(entry.replace("{web}", WEB.as_posix()))
    worker, shared = folder / "worker.js", ("--bundle", "--format=iife", "--minify", "--charset=utf8")
    subprocess.run(
        [ESBUILD, WEB / "src/live/worker.ts", *shared, f"--outfile={worker}"], check=True, capture_output=True
    )
    (folder / "source.js").write_text(f"export default {json.dumps(worker.read_text(encoding='utf-8'))};")
    info = [ESBUILD, "page.ts", *shared, f"--alias:tmodes:worker={folder / 'source.js'}", "--outfile=page.js"]
    subprocess.run(info, check=True, capture_output=True, cwd=folder)
    return (folder / "page.js").read_text(encoding="utf-8").replace("</script", "<\\/script")


def live_in_node(bundle: dict[str, Any], jobs: list[list[float]], folder: Path) -> list[dict[str, Any]]:
    """What the live model gives for each list of values, with the sheet; skipped where there is no Node."""
    (folder / "jobs.json").write_text(json.dumps(jobs))
    return [_filled(result) for result in in_node(HARNESS, bundle, folder)]


def in_node(program: str, bundle: dict[str, Any], folder: Path) -> Any:
    """What a program that imports ``./live.mjs`` and reads ``bundle.tmpk`` prints as JSON; skipped without Node."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("needs Node to run the live model")
    built_live(folder)
    (folder / "program.mjs").write_text(program)
    (folder / "bundle.tmpk").write_bytes(pack(bundle))
    done = subprocess.run([node, "program.mjs"], cwd=folder, capture_output=True, text=True, check=False, timeout=LONG)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def _filled(value: Any) -> Any:
    if isinstance(value, dict) and set(value) == {"$f8"}:
        return np.array([float(number) for number in value["$f8"]])
    if isinstance(value, dict) and set(value) == {"data", "shape"}:
        return _filled(value["data"]).reshape(value["shape"])
    if isinstance(value, dict):
        return {key: _filled(item) for key, item in value.items()}
    return [_filled(item) for item in value] if isinstance(value, list) else value


def worst_difference(series: dict[str, Any], data: Any, scales: dict[str, float]) -> tuple[float, str]:
    """The largest difference of any series from the result's, over the largest value of it (or ``scales``)."""
    found = []
    for name, values in series.items():
        true = data[name].values
        assert values.shape == true.shape, name
        scale = scales.get(name) or float(np.abs(true).max()) or 1.0
        found.append((float(np.abs(values - true).max()) / scale, name))
    return max(found)
