"""The robots of the pages' benchmark: the seed's, two flexible links, 54 coordinates, a long run; runs and reports."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from tmodes.report.page import write_report
from tmodes.result.run import run
from tmodes.robots.load import load
from tmodes.sheet import Robot

from .stiff_arm import stiff_arm

__all__ = ["ROBOTS", "long_arm", "progress", "result_of", "written"]

LONG = 60.0
"""Simulated seconds of the long run."""

FREQUENCIES = (1.3, 2.1, 1.7, 3.1, 2.3, 4.1)
"""How often each of its joints goes to and fro in 2 pi seconds, about: no two alike, so that no two seconds are."""

SWING = 0.25
"""How far its joints go to either side [rad]."""


@contextmanager
def progress(what: str) -> Iterator[None]:
    """Prints the stages and how long each took."""
    began = time.perf_counter()
    print(f"{what} … ", end="", file=sys.stderr, flush=True)
    yield
    print(f"{time.perf_counter() - began:.1f} s", file=sys.stderr, flush=True)


def long_arm() -> Robot:
    """The stiff arm with a function of bending more in each link, 60 coordinates, that goes to and fro for a minute."""
    arm = stiff_arm(start="rest", damping_time=2e-4, output_step=2e-3)
    drives: list[Any] = list(arm.drives)
    motors = {f"{drive.joint}.motor": drive.signal.start for drive in drives}
    changes: dict[str, Any] = {f"links.{k}.beam.functions.bend_z": 4 for k in range(len(arm.links))}
    changes["drives"] = [_swinging(drive, frequency) for drive, frequency in zip(drives, FREQUENCIES, strict=True)]
    changes["initial"] = {"state": "rest", "coordinates": motors}
    return arm.with_({**changes, "integration.duration": LONG})


def _swinging(drive: Any, frequency: float) -> dict[str, Any]:
    """From where it starts, at rest."""
    signal = {"type": "sine", "amplitude": SWING, "frequency": frequency / 6.3, "phase": -math.pi / 2,
              "offset": drive.signal.start + SWING}  # fmt: skip
    gains = {"position_gain": drive.controller.position_gain, "velocity_gain": drive.controller.velocity_gain}
    return {"joint": drive.joint, "command": "position", "signal": signal, "controller": {"type": "pd", **gains}}


ROBOTS: dict[str, tuple[str, Callable[[], Any]]] = {
    "seed": ("filipovic2010, 6 coordinates", lambda: load("filipovic2010")),
    "two links": ("deluca_siciliano1991, two flexible links", lambda: load("deluca_siciliano1991")),
    "stiff": ("54-coordinate arm", stiff_arm),
    "long": ("60-coordinate arm, 60 s", long_arm),
}
"""What each is, and its sheet."""


def result_of(sheet: Any) -> Any:
    """Its run, with all that is reported of it."""
    return run(sheet)


def written(result: Any, path: Path) -> Path:
    """Its report, with its model, as ``tmodes run`` leaves it."""
    return write_report(result, path)
