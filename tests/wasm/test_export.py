"""``tmodes export --wasm``: files that run elsewhere, in Node, in a page from disk, and as their types say."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import LONG, WAIT
from simulation.sheets import pendulum
from tmodes import load, run
from tmodes.errors import ResultFileError
from tmodes.live.wasm_export import Exported, exported
from wasm.node import ROOT, built_model

SCRIPT = """
import { readFileSync } from "node:fs";
import { open, Cancelled } from "./robot.mjs";
const model = await open(readFileSync("robot.wasm"));
const run = await model.run();
const mass = "links.link.bodies.payload.mass";
const heavy = await model.run("real", { parameters: { [mass]: 2 * model.parameters()[mass] } });
const short = await model.run("reference", { settings: { duration: 0.05 }, outputStep: 0.02 });
const wrong = await model.run("real", { parameters: { weight: 1 } }).catch((error) => error.message);
const late = await model.run("real", { settings: { duration: 9 } }).catch((error) => error.message);
const given = await model.run("real", {}, { cancelled: () => true, piece: 0 }).catch((error) => error);
const tip = model.observe(run).tip;
console.log(JSON.stringify({
  status: run.status, states: [...run.states], tip: [...tip], observed: model.observed(), heavy: [...heavy.states],
  short: [...short.times], wrong, late, ended: given instanceof Cancelled, runs: model.runs,
}));
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("export")


@pytest.fixture(scope="module")
def seed() -> Any:
    return load("filipovic2010").with_({"name": "<script>", "integration.duration": 0.1})


@pytest.fixture(scope="module")
def made(seed: Any, folder: Path) -> Exported:
    return exported(seed, "robot", built_model(folder))


def test_it_runs_in_node_as_natively(made: Exported, seed: Any, folder: Path) -> None:
    if (node := shutil.which("node")) is None:
        pytest.skip("needs Node to run what is exported")
    for end, name in {"js": "robot.mjs", "wasm": "robot.wasm"}.items():
        (folder / name).write_bytes(made.files[end])
    (folder / "use.mjs").write_text(SCRIPT)
    done = subprocess.run([node, "use.mjs"], cwd=folder, capture_output=True, text=True, check=False, timeout=LONG)
    assert done.returncode == 0, done.stderr
    info, native = json.loads(done.stdout), run(seed).data
    states = np.array(info["states"]).reshape(native.sizes["time"], -1)
    assert (info["status"], info["runs"]) == ("finished", ["reference", "real"])
    np.testing.assert_allclose(states[:, :6], native["q"].values, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.array(info["tip"]).reshape(-1, 3), native["tip"].values, rtol=0, atol=1e-12)
    assert info["observed"]["tip"] == 3
    assert np.abs(np.array(info["heavy"]).reshape(states.shape) - states)[:, :6].max() > 1e-5
    assert info["short"] == [0, 0.02, 0.04, 0.05]
    assert info["wrong"].startswith("parameter: got weight; expected one of ")
    assert info["late"].startswith("duration: got 9 s; expected at most 0.1 s")
    assert info["ended"]


def test_the_example_runs_from_disk(made: Exported, seed: Any, folder: Path, chromium: str) -> None:
    playwright = pytest.importorskip("playwright.sync_api", reason="needs playwright to look at the page")
    page = folder / "example.html"
    page.write_bytes(made.files["html"])
    said: list[str] = []
    with playwright.sync_playwright() as engine:
        browser = engine.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        window = browser.new_page()
        window.set_default_timeout(WAIT)
        window.on("console", lambda message: said.append(message.text))
        window.on("pageerror", lambda error: said.append(str(error)))
        window.goto(page.as_uri())
        window.wait_for_function("document.getElementById('info').textContent !== ''")
        info, title = window.inner_text("#info"), window.inner_text("h1")
        browser.close()
    assert said == []
    assert title == "<script>"
    assert info.startswith("finished: completed at t = 0.1 s")
    last = float(run(seed).data["q"].values[-1, 0])
    assert float(info.rpartition(" ")[2]) == pytest.approx(last, rel=1e-10)


def test_an_arm_is_exported_as_well(folder: Path) -> None:
    signal = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.1}
    gains = {"type": "pd", "position_gain": 50.0, "velocity_gain": 5.0}
    arm = pendulum(
        {"inertia": 0.5}, {"stiffness": 80.0},
        {"command": "position", "signal": signal, "controller": gains}, integration={"duration": 0.1},
    )  # fmt: skip
    made = exported(arm, "arm", built_model(folder))
    assert [*made.description["runs"]] == ["reference", "real"]
    assert {"reference.dormand_prince", "real.dormand_prince"} <= set(made.description["layout"]["loops"])


def test_the_types_are_those_of_the_program(folder: Path) -> None:
    compiler = ROOT / "web/node_modules/.bin/tsc"
    if not compiler.exists():
        pytest.skip("needs TypeScript to compare the types: npm ci in web/")
    declared, program = ROOT / "src/tmodes/live/model.d.ts", ROOT / "web/src/live/model"
    (folder / "types.ts").write_text(
        f'import type * as info from "{declared.with_suffix("").with_suffix("")}";\n'
        f'import type * as real from "{program}";\n'
        "export const same = (model: real.Model, watch: info.Watch, changes: info.Changes) => {\n"
        "  const shown: Pick<info.Model, keyof info.Model> = model;\n"
        "  const result: Promise<info.RunResult> = model.run('real', changes, watch);\n"
        "  return [shown, result];\n};\n"
    )
    options = ["--noEmit", "--strict", "--target", "ES2022", "--module", "ESNext", "--moduleResolution", "bundler"]
    info = [os.fspath(compiler), *options, "--lib", "ES2022,DOM", "--skipLibCheck", "types.ts"]
    done = subprocess.run(info, cwd=folder, capture_output=True, text=True, check=False, timeout=LONG)
    assert done.returncode == 0, done.stdout


def test_without_the_engine_it_says_so(seed: Any, tmp_path: Path) -> None:
    with pytest.raises(ResultFileError, match=r"must be the engine of the pages, built, got no file.*web\.py"):
        exported(seed, "robot", tmp_path / "model.js")


def _command(*arguments: str, folder: Path) -> Any:
    line = [sys.executable, "-m", "tmodes.cli.main", "export", *arguments]
    return subprocess.run(line, cwd=folder, capture_output=True, text=True, check=False, timeout=LONG)


def test_nothing_is_replaced_unasked(tmp_path: Path) -> None:
    asked = _command("filipovic2010", folder=tmp_path)
    assert (asked.returncode, "write: tmodes export filipovic2010 --wasm" in asked.stderr) == (2, True)
    (tmp_path / "filipovic2010.js").write_text("mine")
    done = _command("filipovic2010", "--wasm", folder=tmp_path)
    assert done.returncode == 4
    assert [path.name for path in tmp_path.iterdir()] == ["filipovic2010.js"]
    assert (tmp_path / "filipovic2010.js").read_text() == "mine"
