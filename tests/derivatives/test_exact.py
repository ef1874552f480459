"""Exact derivatives by every kind of number of a sheet, against differences of sixth order."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from derivatives.test_runs import richardson
from random_sheets import random_sheet
from tmodes.errors import InputError
from tmodes.gradients.changes import changes_of, number_at
from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.gradients.lowering import Lowered, lowered
from tmodes.gradients.quantities import Functional
from tmodes.io.sheet_check import sheet_data
from tmodes.sheet import Robot
from tmodes.simulation.vary.parameters import parameters_of

Array = NDArray[np.float64]

COUNT = int(os.environ.get("TMODES_GRADIENT_ROBOTS", "2"))
"""How many random robots."""

NUMBERS = (
    "links.link.beam.length", "links.link.beam.section.thickness", "links.link.beam.section.outer_diameter",
    "links.link.beam.material.young", "links.link.beam.material.density", "links.link.beam.damping_time",
    "links.link.bodies.load.mass", "links.link.bodies.load.at", "joints.joint.gear.stiffness",
    "joints.joint.motor.inertia", "joints.joint.motor.friction.viscous", "drives.0.controller.velocity_gain",
    "drives.0.signal.start", "drives.0.signal.end", "loads.0.force.0", "contact.stiffness", "contact.damping",
    "contact.shape.position.2", "contact.shape.normal.0", "gravity", "initial.rates.joint",
    "real.joints.joint.gear.stiffness",
)  # fmt: skip
TIMES = ("drives.0.signal.duration", "loads.0.signal.time")
NAMES = ("state", "tip", "link.moment.y@0.4")
DISTANCES = ("tip_error", "deviation.x")


def arm() -> Robot:
    """A tube at rest on an elastic joint behind a surface, led to another angle, on which a force begins to act."""
    tube = {"shape": "tube", "outer_diameter": 0.02, "thickness": 0.001}
    beam = {"model": "strain", "functions": {"bend_y": 1}, "length": 0.6, "damping_time": 3e-4, "section": tube,
            "material": {"young": 1e9, "shear": 4e8, "density": 2700.0}}  # fmt: skip
    move = {"type": "trapezoid", "start": 0.1, "end": 0.4, "duration": 0.0503, "ramp_fraction": 0.3, "delay": 0.0117}
    gains = {"type": "pd", "position_gain": 90.0, "velocity_gain": 6.0}
    joint = {"name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 1, 0],
             "motor": {"side": "joint", "inertia": 0.05, "friction": {"viscous": 0.3}},
             "gear": {"stiffness": 300.0, "damping": 0.4}}  # fmt: skip
    surface = {"shape": {"type": "plane", "position": [0, 0, -0.55], "normal": [0.1, 0, 1]}, "law": "bilateral",
               "stiffness": 500.0, "damping": 5.0}  # fmt: skip
    force = {"point": "tip", "frame": "world", "force": [0.5, 0.0, -2.0],
             "signal": {"type": "step", "start": 0.0, "end": 1.0, "time": 0.0293}}  # fmt: skip
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "arm", "gravity": 9.81, "joints": [joint], "contact": surface,
        "links": [{"name": "link", "bodies": [{"name": "load", "mass": 0.3, "at": 0.8}], "beam": beam}],
        "drives": [{"joint": "joint", "command": "position", "signal": move, "controller": gains}], "loads": [force],
        "initial": {"state": "rest", "rates": {"joint": 0.1}}, "real": {"joints.joint.gear.stiffness": 0.9},
        "integration": {"duration": 0.08, "output_step": 0.0033, "method": "dormand_prince",
                        "relative_tolerance": 1e-12,
                        "absolute_tolerance": 1e-14},
    })  # fmt: skip


def measured(times: Array, info: Mapping[str, Array]) -> tuple[float, dict[str, Array]]:
    weights = {name: np.sin(1 + times)[:, None] * np.cos(np.arange(own.shape[1])) for name, own in info.items()}
    return sum(float((weights[name] * own).sum()) for name, own in info.items()), weights


def moved(sheet: Robot, ways: Mapping[str, float]) -> Callable[[float], Robot]:
    """The sheet with each number changed by so many parts of itself, or of its unit at 0."""
    data = sheet_data(sheet)
    values = {path: number_at(path, data) for path in ways}
    return lambda by: sheet.with_({path: values[path] + by * way * size(values[path]) for path, way in ways.items()})


def difference(sheet: Robot, ways: Mapping[str, float], names: tuple[str, ...] = NAMES) -> float:
    """Of what is measured on runs, along a direction."""
    other = moved(sheet, ways)

    def at(by: float) -> float:
        run = forward_sensitivities(other(by), quantities=names)
        return measured(run.times, run.info)[0]

    return float(richardson(at, 1e-3))


def size(value: float) -> float:
    return abs(value) or 1.0


@pytest.mark.nightly("paths1")
@pytest.mark.parametrize(("paths", "names"), [
    (NUMBERS, NAMES), (NUMBERS[::4], DISTANCES), *(([path], NAMES) for path in TIMES),
])  # fmt: skip
def test_the_gradient_of_a_run_is_that_of_runs_with_other_sheets(paths: list[str], names: tuple[str, ...]) -> None:
    """Amplitudes, durations, lengths, places, sections, materials, gains, contact: all numbers at once."""
    sheet, functional = arm(), Functional(names, measured)
    found, rng, data = adjoint_gradient(sheet, functional, paths), np.random.default_rng(2), sheet_data(sheet)
    ways = {path: float(rng.uniform(0.5, 1)) for path in paths}
    shares = [found.by[path] * ways[path] * size(number_at(path, data)) for path in paths]
    assert abs(sum(shares) - difference(sheet, ways, names)) <= 1e-8 * sum(map(abs, shares))


def test_of_two_signals_that_jump_at_once_only_one_is_moved() -> None:
    """The force begins when the motion does: where one of the two passes the other the rest is of second order."""
    sheet, path = arm().with_({"loads.0.signal.time": 0.0117}), "loads.0.signal.time"
    found = adjoint_gradient(sheet, Functional(NAMES, measured), [path]).by[path]
    assert found == pytest.approx(difference(sheet, {path: 1.0}) / 0.0117, rel=1e-5)


def smooth_sheet(seed: int) -> dict[str, Any]:
    """A random robot whose run has derivatives: dry friction over a range of rates, no motion with a jump."""
    sheet = random_sheet(seed, seed + 7)
    parts = [*sheet["joints"], *(joint["motor"] for joint in sheet["joints"] if "motor" in joint)]
    for part in (part for part in parts if "friction" in part):
        part["friction"] |= {"smoothing": 0.05, "stribeck_rate": 0.2}
    if "contact" in sheet:
        contact = sheet["contact"] | {"friction_velocity": 0.01, "damping": 0.0}
        sheet["contact"] = {key: value for key, value in contact.items() if key not in ("mass", "static_friction")}
    trapezoid = {"type": "trapezoid", "start": 0.1, "end": 0.3, "duration": 0.17, "ramp_fraction": 0.3, "delay": 0.02}
    for drive in sheet["drives"]:
        if drive["signal"]["type"] == "table":
            drive["signal"] = {"type": "sine", "amplitude": 0.2, "frequency": 2.0}
        elif drive["signal"]["type"] == "quintic" and seed % 2:
            drive["signal"] = trapezoid
    if seed % 2:
        sheet["initial"] = {"state": "rest"}
    return sheet


def numbers_of(one: Lowered, times: Array) -> list[Array]:
    return [one.parameters, one.start, one.setup.planned.signals.at(times).ravel()]


@pytest.mark.parametrize("seed", range(2, 2 + COUNT))
def test_all_numbers_of_random_robots_at_once(seed: int) -> None:
    """Parameters, signals at fixed times, and the start, given or at rest."""
    sheet, rng = Robot.from_data(smooth_sheet(seed)), np.random.default_rng(seed)
    here = lowered(sheet)
    try:
        replay = here.recorded()
    except InputError as error:
        pytest.skip(str(error))
    free = [one for one in parameters_of(sheet) if not one.is_structure and not one.path.startswith("integration")]
    paths = [one.path for one in free if one.value and one.low < one.value < one.high]
    ways = dict(zip(paths, rng.uniform(-1, 1, len(paths)), strict=True))
    changes, data = changes_of(sheet, here, replay, paths), sheet_data(sheet)
    times = np.sort(rng.uniform(0, here.settings.duration, 30))
    shares = np.array([ways[path] * size(number_at(path, data)) for path in paths])
    whole = [np.tensordot(shares, np.stack([np.asarray(changes[path][k]) for path in paths]), 1) for k in range(3)]
    rows, width = replay.recording.rows, here.model.plan.degree + 1
    piece = np.searchsorted(rows[:, 0], times, side="right") - 1
    powers = whole[2][piece, 1:].reshape(len(times), -1, width)
    whole[2] = (powers * (times - rows[piece, 0])[:, None, None] ** np.arange(width)).sum(axis=2).ravel()
    other = moved(sheet, ways)
    values = {k: numbers_of(lowered(other(2e-4 * k)), times) for k in (-3, -2, -1, 1, 2, 3)}
    for k, found in enumerate(whole):
        expected = richardson(lambda by, k=k: values[round(by / 2e-4)][k], 2e-4)
        least = 1e-4 if k == 0 else float(np.abs(expected).max(initial=0.0))
        scale = np.maximum(np.maximum(np.abs(expected), np.abs(numbers_of(here, times)[k])), least)
        assert (np.abs(found - expected) <= 1e-8 * scale).all()


def test_numbers_at_an_edge_have_the_derivative_of_the_one_side_that_there_is() -> None:
    sheet = arm().with_({"gear.damping": 0.0, "drives.0.signal.start": 0.0})
    here = lowered(sheet)
    changes = changes_of(sheet, here, here.recorded(), ["gear.damping", "drives.0.signal.start"])
    after = lowered(sheet.with_({"gear.damping": 1e-3}))
    assert changes["gear.damping"].parameters == pytest.approx((after.parameters - here.parameters) / 1e-3, abs=1e-9)
    assert changes["drives.0.signal.start"].rows.any()
    with pytest.raises(InputError, match="at 0 it is at an edge"):
        changes_of(sheet, here, here.recorded(), ["gear.backlash"])


def test_two_names_of_one_number_have_the_same_derivative() -> None:
    sheet, names = arm(), ("gear.stiffness", "joints.joint.gear.stiffness")
    found = adjoint_gradient(sheet, Functional(("tip",), lambda times, info: (0.0, {"tip": info["tip"]})), names)
    assert found.by[names[0]] == found.by[names[1]] != 0
