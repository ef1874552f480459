"""The errors of link models: bounds that hold against links with many more functions, from the same equations."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from arm.run.sheets import arm, beam
from tmodes.cli.summary_text import model_error_of
from tmodes.kinds.links.beam_functions import softened
from tmodes.result.assemble import Assembly
from tmodes.result.model_errors import compared_chain
from tmodes.simulation.simulate import simulate_motion

MANY = 7


def slewing(count: int, *, torque: float, model_error: bool = True, **more: object):
    """A link on a hub under a torque to and fro; under 3 N*m its tip lags by more than half its length."""
    hub = {"name": "hub", "mass": 1e-3, "center": [0, 0, 0], "at": 0.0,
           "inertia": dict.fromkeys(("xx", "yy", "zz"), 6e-4)}  # fmt: skip
    shape = beam({"bend_z": count}, 0.9, 3.687, 0.1649) | {"damping_time": 1e-3} | more
    signal = {"type": "expression", "formula": f"{torque}*sin(2*pi*t/0.8)"}
    return arm(
        gravity=0.0, initial={"state": "zero"},
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 0, 1]}],
        links=[{"name": "link", "bodies": [hub], "beam": shape}],
        drives=[{"joint": "hub", "command": "effort", "signal": signal}],
        integration={"duration": 1.0, "output_step": 5e-3, "model_error": model_error},
    )  # fmt: skip


def assembled(count: int, **more: object) -> Assembly:
    """What a run shows."""
    robot = slewing(count, **more)  # pyright: ignore[reportArgumentType]
    return Assembly(simulate_motion(robot), robot)


@pytest.mark.parametrize("torque", [0.3, 3.0])
def test_the_bounds_hold_against_many_functions(torque: float):
    """Of the tip over the whole run, with few functions and more, under small and large deflection."""
    truth = assembled(MANY, torque=torque, model_error=False).run.points.position[:, 0]
    bounds = []
    for functions in (2, 3):
        made = assembled(functions, torque=torque)
        error = float(np.linalg.norm(made.run.points.position[:, 0] - truth, axis=1).max())
        bounds.append(made.model_errors["figures"]["tip_m"])
        assert error < bounds[-1] < 100 * error
    assert bounds[1] < bounds[0] / 2  # one function more is seen to help


def test_the_compared_robot_is_of_the_same_code():
    """Other numbers, the same structure: nothing is compiled for the second run."""
    chain = slewing(3, torque=0.3).chain()
    other = compared_chain(chain)
    assert other is not None
    numbers = [one.nodes[0].link.numbers(()) for one in (chain, other)]
    assert numbers[0].structure == numbers[1].structure
    assert np.any(numbers[0].stiffness != numbers[1].stiffness)


def test_models_that_cannot_be_compared_say_nothing():
    """Segments converge to no beam; a link without functions has no model to judge; and what is not asked for."""
    for changes in ({"model": "segments", "segments": 2, "functions": None}, {"functions": {}}):
        robot = slewing(2, torque=0.3, model_error=True, **changes)
        assert compared_chain(robot.chain()) is None
    assert not assembled(2, torque=0.3, model_error=False).model_errors


def test_a_bound_is_shown_in_its_unit():
    """With a sign that it is a bound; nothing where there is none."""
    summary = {"model_error": {"how": "", "figures": {"tip_m": 2e-5}}}
    assert model_error_of(summary, "tip_m", 1e3, "mm") == "< 2.0e-02 mm"
    assert not model_error_of(summary, "other", 1e3, "mm")
    assert not model_error_of({"model_error": None}, "tip_m", 1e3, "mm")


@given(st.integers(1, 6), st.integers(0, 2**31))
def test_softening_doubles_what_the_last_functions_add(size: int, seed: int):
    """To the energy of any load: once more what the last functions add beyond the others."""
    rng = np.random.default_rng(seed)
    root, load, first = rng.normal(size=(size, size + 3)), rng.normal(size=size), int(rng.integers(size))
    stiffness = root @ root.T
    alone = float(load[:first] @ np.linalg.solve(stiffness[:first, :first], load[:first]))
    whole, more = (
        float(load @ np.linalg.solve(matrix, load)) for matrix in (stiffness, softened(stiffness, size - first))
    )
    assert more - whole == pytest.approx(whole - alone, rel=1e-6, abs=1e-9 * whole)
