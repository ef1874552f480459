"""A robot for anybody's page: its WebAssembly, a JavaScript module with declarations, and a page that uses them."""

from __future__ import annotations

import base64
import html
import json
import math
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
from tmodes.simulation.plan import Follow
from tmodes.simulation.start import RunSetup, run_setup

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
    data = json.dumps(description, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    code = program.read_text(encoding="utf-8").rstrip() + f"\n\nexport const description = {data};\n"
    opening = (
        f'export const open = (wasm = new URL("{name}.wasm", import.meta.url)) => Model.open(wasm, description);\n'
    )
    return Exported({
        "wasm": module.wasm, "js": (code + opening).encode(), "d.ts": (_HERE / "model.d.ts").read_bytes(),
        "html": _page(sheet.name, name, code + opening, module.wasm).encode(),
    }, description)  # fmt: skip


def _described(robot: Robot) -> tuple[LiveModule, dict[str, Any]]:
    pair = robot.pair()
    functions = ModelFunctions(pair, _STATIONS)
    follows = {"reference": (pair.nominal, Follow.WANTED), "real": (pair.real, Follow.SHEET)}
    runs = {}
    setup = run_setup(pair.real)
    for name in ("reference", "real"):
        if name in functions.loops:
            which, follow = follows[name]
            moved = run_setup(which, follow)
            runs[name] = _run(moved.planned.schedule, moved.start, which.integration)
    base = functions.passes["chain"].at_rest(gravity=0.0)
    info = _settings(pair.real.integration, setup)
    info |= {"runs": runs, "base": base.tolist()} | _named(pair, [*runs])
    return live_module(functions, [info["method"]], slopes=False), info


def _settings(given: Integration, setup: RunSetup) -> dict[str, Any]:
    method, _ = chosen_method(given, setup.spectrum.highest, setup.implicit)
    chosen = given.chosen(method)
    return {"method": method, "outputStep": chosen.output_step, "settings": engine_settings(chosen)}


def _named(pair: RobotPair, runs: Sequence[str]) -> dict[str, Any]:
    """Numbers of the sheet that enter the parameters of the runs and no signal of them, and how they do."""
    live, forms = live_map(pair), {}
    entering, moving = set[int](), set[int]()
    for name in runs:
        form, places = live.forms[name], live.places[name]
        ends = {block: (one["start"], one["start"] + math.prod(one["shape"])) for block, one in places.items()}
        entering |= form.acting(*ends["parameters"])
        last = ends["chain"][1]
        for block, place in ends.items():
            if block.startswith(("knots", "coefficients")):
                moving |= form.acting(*place)
        known = {block: places[block] for block, (_, end) in ends.items() if end <= last}
        forms[name] = form.part(0, last).info() | {"places": known}
    kept = [slider for slider in live.sliders if slider.knob in entering - moving]
    sliders = [{"knob": slider.knob, "real": slider.real} for slider in kept]
    info = live.info() | {"sliders": sliders, "runs": forms}
    return {"named": {slider.path: slider.value for slider in kept}, "map": _plain(info)}


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
