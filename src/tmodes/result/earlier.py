"""Results of the 2010 robot that were written before it was a robot as all others: the same motion, shown as today.

The file holds the states of the run and of its reference. From them today's model gives every series; how the run
ended, its statistics, frequencies and errors stay as they were written.
"""

from __future__ import annotations

import json
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.equations.loop.layout import WORKS
from tmodes.errors import InputError, InputErrors
from tmodes.io.atomic import file_error
from tmodes.io.filipovic2010.importer import COORDINATES, to_robot
from tmodes.io.sheet_check import sheet_from_data
from tmodes.result.assemble import ResultAssembly
from tmodes.result.content import AGAIN
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.motion_run import RunData, gathered
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.plan import Follow

if TYPE_CHECKING:
    from tmodes.io.labelled import Record

__all__ = ["NOTICE", "earlier_assembly"]

NOTICE = (
    "this result was written by an earlier version: its motion is shown in the coordinates joint.motor, joint, "
    "link.azimuth1, ..., link.elevation2 instead of q, delta, gamma, vt, e, theta"
)

_WORKS = {"motor_friction": "friction"}
"""Kinds of works by the names that they have now."""


def earlier_assembly(data: Record, path: object) -> ResultAssembly:
    """What an earlier record shows, as of any run; ``path`` names it.

    Raises :class:`tmodes.errors.ResultFileError` for one whose parts do not fit together.
    """
    try:
        return _assembly(data)
    except (InputError, InputErrors, KeyError, TypeError, ValueError) as error:
        got = f"content that does not fit together ({error})"
        raise file_error(path, got, "a result of the 2010 robot", AGAIN) from error


def _assembly(data: Record) -> ResultAssembly:
    known, actual = (sheet_from_data(json.loads(data.attrs[name])) for name in ("robot", "robot_real"))
    real, nominal = run_setup(actual), run_setup(known, Follow.WANTED)
    run = replace(_run(real, data, "", "real"), reference=_run(nominal, data, "_reference", "reference"))
    made = ResultAssembly(run, known)
    kept: dict[str, Any] = {name: json.loads(data.attrs.get(name, "null")) for name in ("errors",)}
    made.__dict__ |= kept | {
        "ending": (data.attrs["status"], data.attrs["message"]),
        "_frequencies": (json.loads(data.attrs["frequencies"]), []),
        "warnings": [*json.loads(data.attrs["warnings"]), NOTICE],
    }
    return made


def _run(setup: RunSetup, data: Record, ending: str, which: str) -> RunData:
    """A run as its states are in the record; works are known of the actual robot alone."""
    layout, times = setup.model.layout, np.asarray(data["time"].values, dtype=float)
    own = to_robot(setup.model.coordinates)
    states = np.zeros((len(times), layout.size))
    for block, name in ((layout.q, "q"), (layout.v, "v")):
        states[:, block] = data[name + ending].sel(coordinate=list(COORDINATES)).values @ own.T
    if not ending:
        for kind, works in zip(data["work_kind"].values, data["work"].values.T, strict=True):
            states[:, layout.works.start + WORKS.index(_WORKS.get(str(kind), str(kind)))] = works
    statistics = json.loads(data.attrs["statistics"])
    shared = {key: value for key, value in statistics.items() if not isinstance(value, dict)}
    info = statistics.get(which, {}) | (shared if which == "real" else {})
    return gathered(setup, Trajectory(times, states, data.attrs["status"], data.attrs["message"], info))
