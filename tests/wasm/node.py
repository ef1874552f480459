"""Modules at work in Node: the engine as the pages have it, built from its sources or taken as it is shipped."""

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
from tmodes.live.functions import LiveModule, ModelFunctions, live_module
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.parts import sample_times

__all__ = ["built_model", "in_node", "page_states", "plain"]

ROOT = Path(__file__).resolve().parents[2]
SOURCE, ESBUILD = ROOT / "web/src/live/model.ts", ROOT / "web/node_modules/.bin/esbuild"
SHIPPED = ROOT / "src/tmodes/report/web/model.js"

HARNESS = """
import { readFileSync } from "node:fs";
import { Engine, integrate } from "./model.mjs";
const { layout, jobs } = JSON.parse(readFileSync("jobs.json", "utf8"));
const engine = await Engine.open(readFileSync("module.wasm"), layout);
const filled = (value) => value?.$f8 ? Float64Array.from(value.$f8) : value && typeof value === "object"
  ? Object.fromEntries(Object.entries(value).map(([key, item]) => [key, filled(item)])) : value;
const info = (job) => [job.sample, job.parameters, job.inputs];
const results = [];
for (const job of jobs.map(filled)) {
  try {
    if (job.run) results.push(await integrate(engine, job.run));
    else if (job.directions) results.push(engine.slopes(...info(job), job.directions, job.count));
    else results.push(engine.sample(...info(job), job.count));
  } catch (error) {
    results.push({ error: `${error.name}: ${error.message}` });
  }
}
const written = (key, value) => ArrayBuffer.isView(value) ? { $f8: Array.from(value, String) } : value;
process.stdout.write(JSON.stringify(results, written));
"""


def built_model(folder: Path) -> Path:
    """The engine as one file; the test is skipped where it is neither built nor can be."""
    target = folder / "model.mjs"
    if ESBUILD.exists():
        info = [os.fspath(ESBUILD), os.fspath(SOURCE), "--bundle", "--format=esm", f"--outfile={target}"]
        subprocess.run(info, check=True, capture_output=True)
    elif SHIPPED.exists():
        target.write_bytes(SHIPPED.read_bytes())
    else:
        pytest.skip("needs the engine of the pages: python tools/web.py")
    return target


def plain(value: Any) -> Any:
    """Plain data in which arrays are reported as such."""
    if isinstance(value, np.ndarray):
        return {"$f8": value.ravel().tolist()}
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    return value


def _filled(value: Any) -> Any:
    if isinstance(value, dict) and set(value) == {"$f8"}:
        return np.array([float(number) for number in value["$f8"]])
    if isinstance(value, dict):
        return {key: _filled(item) for key, item in value.items()}
    return value


def in_node(module: LiveModule, jobs: list[dict[str, Any]], folder: Path) -> list[dict[str, Any]]:
    """What the engine gives for each job, in one process of Node; the test is skipped where there is none."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("needs Node to run the engine of the pages")
    built_model(folder)
    (folder / "harness.mjs").write_text(HARNESS)
    (folder / "module.wasm").write_bytes(module.wasm)
    (folder / "jobs.json").write_text(json.dumps({"layout": module.layout, "jobs": [plain(job) for job in jobs]}))
    done = subprocess.run([node, "harness.mjs"], cwd=folder, capture_output=True, text=True, check=False, timeout=LONG)
    assert done.returncode == 0, done.stderr
    return [_filled(result) for result in json.loads(done.stdout)]


def page_states(setup: RunSetup, folder: Path) -> np.ndarray:
    """The states (n, size) of a run in WebAssembly, which reaches its end; of a robot that runs by `dormand_prince`."""
    settings = setup.robot.integration
    schedule = setup.planned.schedule.until(settings.duration)
    module = live_module(ModelFunctions(setup.robot.pair(), (1.0,)), [settings.method])
    (found,) = in_node(module, [{"run": {
        "loop": f"real.{settings.method}", "parameters": setup.model.numbers, "knots": schedule.knots,
        "rows": np.column_stack([schedule.knots[:-1], schedule.coefficients]), "state": setup.start,
        "times": sample_times(settings), "settings": {
            "duration": settings.duration, "relativeTolerance": settings.relative_tolerance,
            "absoluteTolerance": settings.absolute_tolerance, "step": settings.step, "maxSteps": settings.max_steps,
        },
    }}], folder)  # fmt: skip
    assert found["status"] == "finished"
    return found["states"].reshape(-1, len(setup.start))
