"""Outputs of a result by name: what is stored, else by the equations of the run at its stored states."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.layout import WORKS
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, Output, Outputs
from tmodes.errors import InputError
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.plan import planned

if TYPE_CHECKING:
    from tmodes.io.labelled import Record
    from tmodes.sheet import Robot
    from tmodes.simulation.motion_run import RunData

__all__ = ["output_values"]

Array = NDArray[np.float64]

_REFERENCES = {DEVIATION: "tip_nominal", COMMANDED: "tip_commanded"}
"""Variables of a result with the places from which distances are."""


def output_values(data: Record, robot: Robot, run: RunData | None, name: str) -> tuple[Output, Array]:
    """The output of a name of an actual ``robot``, with its values (n,) at the times of a result.

    ``run``: of a result that was made just now. Raises :class:`tmodes.errors.InputError` for an unknown name, and for
    one that does not follow from what is stored.
    """
    output = robot_outputs(robot).find(name, "output")
    found = _stored(data, output)
    return output, _computed(data, robot, run, name) if found is None else found


def _stored(data: Any, output: Output) -> Array | None:
    """The values that a result holds; None where it has none."""
    variable, *labels = output.stored or ("",)
    if variable not in data:
        return None
    dims = data[variable].dims[1:]
    try:
        return np.asarray(data[variable].sel(**dict(zip(dims, labels, strict=True))).values, dtype=float)
    except (KeyError, ValueError):
        return None


def _computed(data: Record, robot: Robot, run: RunData | None, name: str) -> Array:
    """The values by the equations of the run, at its states or at those that are stored."""
    times = np.asarray(data["time"].values, dtype=float)
    native = not run.setup.callback if run else "mean_step_s" in json.loads(data.attrs["statistics"])["real"]
    if not native:
        raise _not_there(name, "the run of a Python controller, which only has what is stored of it")
    plan = run.planned if run else planned(robot)
    model = run.setup.model if run else LoopModel(plan.plan)
    states = run.states[: len(times)] if run else _states(data, model)
    given = {head: data[place].values for head, place in _REFERENCES.items() if place in data}
    outputs = Outputs(model.loop, tuple(given))
    if name not in outputs:
        raise _not_there(name, "a run without the place that it is compared with")
    table, rows = np.concatenate([np.zeros((len(times), 0)), *given.values()], axis=1), plan.schedule.rows_at(times)
    if not run and _lacks(model, outputs[name], table.shape[1]):
        raise _not_there(name, "a stored run in which something sticks or slips: which, is not stored")
    return model.seen([outputs[name]], times, states, rows, table, after=None if run else False)[:, 0]


def _not_there(name: str, got: str) -> InputError:
    return InputError("output", f"`{name}` of {got}", "an output of a run that has it", "take another output")


def _states(data: Record, model: LoopModel) -> Array:
    """The states (n, size) of a stored run, without what sticks and slips; controllers are after their samples."""
    plan, layout = model.plan, model.layout
    found = np.zeros((data.sizes["time"], layout.size))
    parts: list[tuple[slice, str, dict[str, Any]]] = [
        (layout.q, "q", {"coordinate": list(model.coordinates)}),
        (layout.v, "v", {"coordinate": list(model.coordinates)}),
        (layout.currents, "current", {"drive": list(plan.currents)}),
        (layout.controls, "controller_states", {"controller_state": list(plan.control_names)}),
        (layout.works, "work", {"work_kind": list(WORKS)}),
    ]
    for place, variable, labels in parts:
        if place.stop > place.start:
            found[:, place] = data[variable].sel(**labels).values
    if plan.surface_names:
        found[:, layout.surface] = np.stack([data[f"surface_{one}"].values for one in ("displacement", "velocity")], 1)
    return found


def _lacks(model: LoopModel, output: Output, given: int) -> bool:
    """Whether an output depends on what sticks and what slips, which is not stored."""
    schedule, modes = model.series((output,), given, lean=False).schedule, model.layout.modes
    return schedule.reads(schedule.inputs["state"].part(modes.start, modes.stop - modes.start))
