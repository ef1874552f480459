"""The errors of link models: bounds that hold against links with many more functions, from the same equations."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from simulation.sheets import arm, beam
from tmodes.chain.chain import Chain
from tmodes.interface.summary import integration_lines, model_error_of
from tmodes.kinds.links.beam_functions import softened
from tmodes.kinds.links.segment import Segment
from tmodes.result.assemble import ResultAssembly
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


def assembled(count: int, **more: object) -> ResultAssembly:
    """What a run shows."""
    robot = slewing(count, **more)  # pyright: ignore[reportArgumentType]
    return ResultAssembly(simulate_motion(robot), robot)


@cache
def true_tip(torque: float):
    """The tip with many functions."""
    return assembled(MANY, torque=torque, model_error=False).run.points.position[:, 0]


def bound_over_error(torque: float, **link: Any) -> tuple[float, float]:
    """The bound of the tip over the whole run, and that over the true error."""
    made = assembled(torque=torque, **link)
    bound = made.model_errors["figures"]["tip_m"]
    return bound, bound / float(np.linalg.norm(made.run.points.position[:, 0] - true_tip(torque), axis=1).max())


@pytest.mark.nightly("0.3")
@pytest.mark.parametrize("torque", [0.3, 3.0])
def test_the_bounds_hold_against_many_functions(torque: float):
    """With few functions and more, under small and large deflection."""
    bounds, ratios = zip(*(bound_over_error(torque, count=count) for count in (2, 3)), strict=True)
    assert all(1 < ratio < 30 for ratio in ratios)
    assert bounds[1] < bounds[0] / 2  # one function more is seen to help


@pytest.mark.parametrize("count", [1, 2, 3, 5])
@given(ratio=st.floats(1e-10, 1.0))
def test_what_is_missing_counts_more_on_a_beam_that_is_bent(count: int, ratio: float):
    """By the square of the angle and the root of the ratio, where the error of a straight beam goes with the ratio."""
    (link,) = (node.link for node in slewing(count, torque=1.0).chain().nodes if node.link.bends)
    straight, *bent = (link.uncertainty("bend_z", ratio, angle) for angle in (0.0, 0.5, 1.0))
    assert straight <= bent[0] <= bent[1]
    assert bent[1] >= 0.3 * ratio**0.5
    if straight < 0.01 * ratio**0.5:
        assert bent[1] == pytest.approx(4 * bent[0])


def test_the_bounds_of_lumped_links_hold_against_beams():
    """A segment, whose masses and springs are compared with those that are nearer to a beam's."""
    assert 1 < bound_over_error(0.3, count=2, model="segments", segments=1, functions=None)[1] < 30


@pytest.mark.parametrize("model", ["segments", "modes"])
def test_a_compared_lump_has_the_inertia_of_the_beam(model: str):
    """By a rod at the tip: the beam's when rigid, and the first frequency of a cantilever, 3.516, to 2 %."""
    beam, mass = slewing(1, torque=0.3, functions={"bend_y": 1, "bend_z": 1}).links[0].beam, 0.1649 * 0.9
    assert beam is not None
    lump: Any = beam.variant(model, 1).lowered(()).links[0].compared()  # pyright: ignore[reportOptionalMemberAccess]
    (rod,) = lump.bodies_at(1.0)
    assert (rod.mass, rod.center[0]) == pytest.approx((mass, -0.45))
    about_root = rod.inertia[2, 2] + rod.mass * (lump.length + rod.center[0]) ** 2
    assert about_root == pytest.approx(mass * 0.9**2 / 3)
    turned = 1.5 / lump.length  # of the tip's section, per deflection
    moved = rod.mass * (1 + turned * rod.center[0]) ** 2 + rod.inertia[2, 2] * turned**2
    spring = lump.numbers(()).stiffness[0] / lump.length**2
    assert np.sqrt(spring / moved * mass * 0.9**3 / 3.687) == pytest.approx(3.516, rel=0.02)


def test_the_compared_robot_is_of_the_same_code():
    """Other numbers, the same structure: nothing is compiled for the second run."""
    chain = slewing(3, torque=0.3).chain()
    other = compared_chain(chain)
    assert isinstance(other, Chain)
    numbers = [one.nodes[0].link.numbers(()) for one in (chain, other)]
    assert numbers[0].structure == numbers[1].structure
    assert np.any(numbers[0].stiffness != numbers[1].stiffness)


def test_models_that_cannot_be_compared_say_why():
    """Energies of a system are those of its own links; nothing where nothing bends, and where it is not asked for."""
    chain = slewing(2, torque=0.3).chain()
    assert compared_chain(slewing(2, torque=0.3, functions={}).chain()) == ""
    assert compared_chain(replace(chain, equations="mine")) == "the equations `mine` are stated for these links alone"
    lump = Segment(1.0, 1.0, 1.0)  # of which no beam is known
    stretched = replace(cast("Any", chain.nodes[0].link), bend_z=0, stretch=1)
    for link in (lump, stretched):
        other = replace(chain, nodes=(replace(chain.nodes[0], link=link),))
        assert f"link (`{link.kind}`) has no other numbers" in str(compared_chain(other))
    assert not assembled(2, torque=0.3, model_error=False).model_errors


def test_a_bound_is_shown_in_its_unit():
    """With a sign that it is a bound; nothing where there is none."""
    summary = {"model_error": {"how": "", "figures": {"tip_m": 2e-5}}}
    assert model_error_of(summary, "tip_m", 1e3, "mm") == "< 2.0e-02 mm"
    assert not model_error_of(summary, "other", 1e3, "mm")
    assert not model_error_of({"model_error": None}, "tip_m", 1e3, "mm")
    untold = {"error": None, "model_error": {"how": "", "figures": {}, "why": "no beam"}}
    assert not model_error_of(untold, "tip_m", 1e3, "mm")
    shown = integration_lines(SimpleNamespace(statistics={}), untold)
    assert [*shown][-1] == "model error   not estimated: no beam"


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
