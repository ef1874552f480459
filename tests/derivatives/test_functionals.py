"""Gradients of what is measured on a run against differences of runs with other sheets, and against each other."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from derivatives.test_runs import SQUARES, bending_arm
from io_cases import value_of
from tmodes.errors import InputError
from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.gradients.lowering import lowered
from tmodes.gradients.quantities import Functional, tracking_error
from tmodes.robots.load import load
from tmodes.sheet import Robot

Array = NDArray[np.float64]

TOUCHED = (0.92, 0.03, 0.1)
ROBOT_PATHS = (
    "motor.resistance", "motor.torque_constant", "motor.back_emf_constant", "motor.inertia", "gear.stiffness",
    "gear.damping", "link.modes.0.length", "link.modes.0.bending_stiffness", "link.modes.0.mass_per_length",
    "link.modes.0.damping_time", "link.modes.1.length", "link.modes.1.bending_stiffness",
    "link.modes.1.mass_per_length", "link.modes.1.damping_time", "payload.mass", "payload.inertia",
    "controller.position_gain", "controller.velocity_gain", "reference.start", "reference.end",
)  # fmt: skip
ARM_PATHS = {
    "links.link.beam.section.bending_stiffness": 20.0, "links.link.beam.length": 0.6, "joints.joint.gear.damping": 0.4,
    "links.link.bodies.load.mass": 0.3, "drives.0.controller.position_gain": 90.0, "drives.0.signal.end": 0.4,
}  # fmt: skip


def sixth_order(function: Callable[[float], float], step: float) -> float:
    ways = [(function(step * k) - function(-step * k)) / (2 * step * k) for k in (1, 2, 3)]
    return (15 * ways[0] - 6 * ways[1] + ways[2]) / 10


@cache
def robot() -> Robot:
    """Steps of one length do not change with the numbers: differences of runs are differences on the same steps."""
    short = {"integration.duration": 0.25, "integration.output_step": 0.005, "integration.step": 1e-4}
    return load("filipovic2010").with_({**short, "integration.method": "rk4"})


@cache
def arm() -> Robot:
    return bending_arm(method="rk4", step=2e-4)


def measured(sheet: Any, functional: Functional) -> float:
    run = forward_sensitivities(sheet, quantities=functional.quantities)
    return functional.measure(run.times, run.info)[0]


@pytest.mark.parametrize("path", ROBOT_PATHS)
def test_the_gradient_of_a_tip_error_is_that_of_runs_with_other_sheets(path: str) -> None:
    functional, found = tracking_error("tip", TOUCHED), gradient_of_robot()
    written = value_of(robot(), path)
    value = written["xx"] if isinstance(written, dict) else written  # one inertia about all axes
    scale = value or 1.0

    def at(change: float) -> float:
        return measured(robot().with_({path: value + change * scale}), functional)

    noise = 1e-13 * found.value / (1e-3 * abs(scale))
    assert found.by[path] == pytest.approx(sixth_order(at, 1e-3) / scale, rel=1e-7, abs=noise)


@cache
def gradient_of_robot() -> Any:
    return adjoint_gradient(robot(), tracking_error("tip", TOUCHED), ROBOT_PATHS)


@pytest.mark.parametrize("quantity", ["tip", "points.tip_velocity", "gear", "a", "powers"])
def test_any_quantity_of_an_arm_can_be_followed(quantity: str) -> None:
    info = forward_sensitivities(arm(), quantities=(quantity,)).info[quantity]
    functional = tracking_error(quantity, lambda times: info + np.cos(times)[:, None] * np.abs(info).max(axis=0))
    paths = dict([*ARM_PATHS.items()][:: 1 if quantity == "tip" else 3])
    found = adjoint_gradient(arm(), functional, (*paths,))
    for path, value in paths.items():
        differences = sixth_order(
            lambda by, path=path, value=value: measured(arm().with_({path: value * (1 + by)}), functional), 2e-3
        )
        assert found.by[path] * value == pytest.approx(differences, rel=2e-7, abs=1e-10 * found.value)


def test_slopes_of_quantities_and_the_gradient_tell_the_same_number() -> None:
    names, paths = ("tip", "state", "points.tip_velocity"), (*ARM_PATHS,)
    sheet = bending_arm(method="extrapolation")
    forwards = forward_sensitivities(sheet, paths, quantities=names)
    rng = np.random.default_rng(0)
    weights = {name: rng.normal(size=forwards.info[name].shape) for name in names}
    whole = Functional(names, lambda times, info: (0.0, weights))
    gradient = adjoint_gradient(sheet, whole, paths)
    for path in paths:
        sizes = [np.abs(weights[name] * forwards.of[name][path]).sum() for name in names]
        total = sum((weights[name] * forwards.of[name][path]).sum() for name in names)
        assert abs(gradient.by[path] - total) <= 1e-11 * sum(sizes)


def test_both_kinds_of_steps_tell_one_gradient() -> None:
    tight = {"relative_tolerance": 1e-10, "absolute_tolerance": 1e-12}
    functional = tracking_error("tip", TOUCHED)
    explicit, implicit = (
        adjoint_gradient(bending_arm(method=method, **tight), functional, (*ARM_PATHS,))
        for method in ("dop853", "extrapolation")
    )
    for path, value in explicit.by.items():
        assert implicit.by[path] == pytest.approx(value, rel=1e-6)


def test_what_the_real_arm_differs_by_is_seen() -> None:
    path, factor = "joints.joint.gear.stiffness", 0.9
    sheet = arm().with_({"real": {path: factor}})
    functional = tracking_error("tip", TOUCHED)
    real = adjoint_gradient(arm().with_({path: 300.0 * factor}), functional, [path])
    found = adjoint_gradient(sheet, functional, [path])
    assert found.value == pytest.approx(real.value, rel=1e-12)
    assert found.by[path] == pytest.approx(factor * real.by[path], rel=1e-7)


def test_the_cost_is_reported() -> None:
    cost = adjoint_gradient(bending_arm(), SQUARES, (), most_bytes=5000.0).cost
    assert cost.method == "dormand_prince"
    assert cost.bytes <= 5000.0
    assert 0 < cost.checkpoints < cost.steps
    assert min(cost.forward, cost.sweep, cost.measure, cost.sheet) >= 0


def test_little_memory_keeps_one_state_and_none_is_refused() -> None:
    plenty, least = (adjoint_gradient(bending_arm(), SQUARES, (), most_bytes=most) for most in (1e8, 1.0))
    assert least.cost.checkpoints == 1 < plenty.cost.checkpoints
    assert np.abs(least.start - plenty.start).max() <= 1e-12 * np.abs(plenty.start).max()
    for most in (0.0, -1.0, float("nan")):
        with pytest.raises(InputError, match="most_bytes"):
            adjoint_gradient(bending_arm(), SQUARES, (), most_bytes=most)


def test_a_stiff_arm_is_followed_by_the_method_of_its_run() -> None:
    sheet = bending_arm(method="auto", duration=10.0, output_step=1.0).with_(
        {"links.link.beam.section.bending_stiffness": 2e9, "links.link.beam.damping_time": 0.0}
    )
    assert lowered(sheet).settings.method == "extrapolation"


def test_wrong_names_and_shapes_are_refused() -> None:
    with pytest.raises(InputError, match=r"unknown name 'tipp'.*Did you mean `tip`"):
        adjoint_gradient(arm(), tracking_error("tipp", TOUCHED))
    with pytest.raises(InputError, match="one at each sample"):
        adjoint_gradient(robot(), tracking_error("drives", TOUCHED))
    with pytest.raises(InputError, match="one for all"):
        adjoint_gradient(arm(), tracking_error("tip", np.zeros(2)))
    with pytest.raises(InputError, match=r"start\.own.*shape \(1,\)"):
        forward_sensitivities(robot(), start={"own": [1.0]})
    with pytest.raises(InputError, match="finite numbers"):
        adjoint_gradient(arm(), tracking_error("tip", (0.0, 0.0, np.nan)))
    with pytest.raises(InputError, match=r"unknown key `motor\.no_such_number`"):
        adjoint_gradient(robot(), tracking_error("tip", TOUCHED), ["motor.no_such_number"])
