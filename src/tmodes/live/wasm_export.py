"""A robot for anybody's page: its WebAssembly, a JavaScript module with declarations, and a page that uses them."""

from __future__ import annotations

import base64
import html
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.integrate.choice import chosen_method
from tmodes.integrate.settings import Integration
from tmodes.io.atomic import file_error
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.live.functions import LiveModule, ModelFunctions, engine_settings, live_module
from tmodes.live.map import live_map
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.plan import Follow

__all__ = ["Exported", "exported"]

_HERE = Path(__file__).parent
_PROGRAM = _HERE.parent / "report" / "web" / "model.js"

_STATIONS = (0.0, 0.25, 0.5, 0.75, 1.0)


@dataclass(frozen=True)
class Exported:
    """``files`` by the end of their name (``wasm``, ``js``, ``d.ts``, ``html``); ``description``: what they tell."""

    files: Mapping[str, bytes]
    description: Mapping[str, Any]


def exported(sheet: Robot, name: str, program: Path = _PROGRAM) -> Exported:
    """The files of a robot whose names begin with ``name``.

    ``program``: the built engine. Raises :class:`tmodes.errors.ResultFileError` where that is not there.
    """
    if not program.exists():
        hint = "in a checkout of the sources: python tools/web.py (needs Node); or install the wheel, which has it"
        raise file_error(program, "no file", "the engine of the pages, built", hint)
    module, info = _described(sheet)
    description = {"name": sheet.name, "layout": module.layout} | info
    data = json.dumps(description, separators=(",", ":")).replace("<", "\\u003c")
    code = program.read_text(encoding="utf-8").rstrip() + f"\n\nexport const description = {data};\n"
    opening = (
        f'export const open = (wasm = new URL("{name}.wasm", import.meta.url)) => Model.open(wasm, description);\n'
    )
    return Exported({
        "wasm": module.wasm, "js": (code + opening).encode(), "d.ts": (_HERE / "model.d.ts").read_bytes(),
        "html": _page(sheet.name, name, code + opening, module.wasm).encode(),
    }, description)  # fmt: skip


def _described(robot: Robot) -> tuple[LiveModule, dict[str, Any]]:
    pair = robot.commanded().pair()
    functions = ModelFunctions(pair, _STATIONS)
    follows = {"reference": (pair.nominal, Follow.WANTED), "real": (pair.real, Follow.SHEET)}
    runs = {}
    setup = run_setup(pair.real)
    for name in ("reference", "real"):
        if name in functions.loops:
            which, follow = follows[name]
            moved = run_setup(which, follow)
            runs[name] = _run(moved.planned.schedule, moved.start, which.integration)
    info = _settings(pair.real.integration, setup)
    info |= {"runs": runs} | _named(pair, [*runs])
    return live_module(functions, [info["method"]], slopes=False), info


def _settings(given: Integration, setup: RunSetup) -> dict[str, Any]:
    method, _ = chosen_method(given, setup.spectrum.highest, setup.implicit)
    chosen = given.chosen(method)
    return {"method": method, "outputStep": chosen.output_step, "settings": engine_settings(chosen)}


def _named(pair: RobotPair, runs: Sequence[str]) -> dict[str, Any]:
    """Numbers of the sheet that enter the parameters of the runs and no signal of them, and how they do."""
    live = live_map(pair)
    entering, moving = (
        {path for run in runs for path in live.entering(run, *blocks)}
        for blocks in (("parameters",), ("knots", "coefficients"))
    )
    live = live.without({one.path: "" for one in live.sliders if one.path not in entering - moving})
    return {"named": {slider.path: slider.value for slider in live.sliders}, "map": _plain(live.info())}


def _plain(value: Any) -> Any:
    """Arrays as ``Numbers`` of ``web/src/pack.ts``, for JSON."""
    if isinstance(value, np.ndarray):
        return {"data": value.ravel().tolist(), "shape": list(value.shape)}
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    return [_plain(one) for one in value] if isinstance(value, list) else value


def _run(schedule: SignalPieces, state: Any, settings: Integration) -> dict[str, list[float]]:
    signals = schedule.until(settings.duration)
    rows = np.column_stack([signals.knots[:-1], signals.coefficients])
    arrays = {"knots": signals.knots, "rows": rows, "state": state}
    return {name: np.asarray(values, dtype=float).ravel().tolist() for name, values in arrays.items()}


def _page(title: str, name: str, code: str, wasm: bytes) -> str:
    """The example: all in one file, so that it opens from disk, where a page may fetch nothing."""
    info = {"TITLE": html.escape(title), "FILE": html.escape(name), "CODE": code.replace("</", "<\\/"),
            "WASM": base64.b64encode(wasm).decode()}  # fmt: skip
    page = (_HERE / "example.html").read_text(encoding="utf-8")
    return re.sub(f"%({'|'.join(info)})%", lambda found: info[found[1]], page)
