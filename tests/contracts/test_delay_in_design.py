"""Designed laws that know their delay: gains and poles of the whole loop by SciPy, of states extended by commands."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import block_diag, solve_discrete_are

from analysis.test_network_modes import PERIOD, WEIGHTS, assert_same, held, plant, robot
from contracts.test_blocks import LINK, LQG, LQR, STATES, constant, law, spong
from tmodes.errors import InputErrors
from tmodes.gradients.changes import changes_of
from tmodes.gradients.lowering import lowered
from tmodes.simulation.plan import planned

Array = NDArray[np.float64]
GONE = 2e-2
"""Poles at 0 of commands that are on their way, whose rounding is a root of its own."""

KNOWN = {"delay_in_design": True}
PLACED = {"type": "pole_placement", "poles": [[1.0, 0.7], [5.0, 0.3]], "sample_time": PERIOD}


def poles(own: Any) -> Any:
    found = own.linearize(closed=True).poles
    return found[np.abs(found) > GONE]


def gain(Ad: Any, Bd: Any, Q: Any) -> Any:
    X: Any = solve_discrete_are(Ad, Bd, Q, np.eye(1))
    return np.linalg.solve(1.0 + Bd.T @ X @ Bd, Bd.T @ X @ Ad)


def design(own: Any) -> Any:
    return block_of(own).design


def block_of(own: Any) -> Any:
    block = planned(own).plan.blocks[-1]
    return block.law.block


def order(found: Any) -> list[int]:
    return [found.plant.states.index(name) for name in STATES]


def test_gains_of_whole_periods_are_those_of_the_extended_state() -> None:
    """Two periods: Riccati's equation of x, u[k-1], u[k-2]."""
    Ad, Bd = held(*plant(), PERIOD)
    A: Any = block_diag(Ad, np.zeros((2, 2)))
    B: Any = np.zeros((6, 1))
    A[:4, 5:], A[5, 4], B[4] = Bd, 1.0, 1.0
    K = gain(A, B, block_diag(WEIGHTS, np.zeros((2, 2))))
    found = design(robot(LQR | KNOWN | {"sample_time": PERIOD}, delay=2 * PERIOD))
    assert found.K[0, [*order(found), 4, 5]] == pytest.approx(K[0], rel=1e-9)


def test_gains_of_a_part_of_a_period_weigh_the_state_in_which_commands_act() -> None:
    """One period and a half: the same with weights on x in the middle of the next period."""
    half, push = held(*plant(), PERIOD / 2)
    Ad, Bd = held(*plant(), PERIOD)
    arrive = np.hstack([Ad @ half, Bd, Ad @ push])  # u[k-2] acts for half a period, u[k-1] for a whole one
    A: Any = block_diag(Ad, np.zeros((2, 2)))
    B: Any = np.zeros((6, 1))
    A[:4, 4:5], A[:4, 5:], A[5, 4], B[4] = push, half @ push, 1.0, 1.0
    K = gain(A, B, arrive.T @ WEIGHTS @ arrive)
    found = design(robot(LQR | KNOWN | {"sample_time": PERIOD}, delay=1.5 * PERIOD))
    assert found.K[0, [*order(found), 4, 5]] == pytest.approx(K[0], rel=1e-9)


@pytest.mark.parametrize("delay", [0.0, 0.5, 1.0, 2.3])
def test_the_loop_has_the_poles_of_one_without_delay(delay: float) -> None:
    """Of the regulator, and of its estimator, apart."""
    Ad, Bd = held(*plant(), PERIOD)
    regulated: Any = np.linalg.eigvals(Ad - Bd @ gain(Ad, Bd, WEIGHTS))
    C, W = np.array([[0.0, 1.0, 0.0, 0.0]]), np.diag([LQG["process_noise"][name] for name in STATES])
    P: Any = solve_discrete_are(Ad.T, C.T, W, np.array([[1e-5]]))
    estimated: Any = np.linalg.eigvals(Ad @ (np.eye(4) - P @ C.T @ C / (C @ P @ C.T + 1e-5)))
    late = {"delay": delay * PERIOD}
    assert_same(poles(robot(LQR | KNOWN | {"sample_time": PERIOD}, **late)), regulated)
    both = np.append(regulated, estimated)
    for form in ("filter", "predictor"):
        own = robot(LQG | KNOWN | {"form": form}, **late)
        assert_same(poles(own), both[np.abs(both) > GONE], 1e-7)
    pairs: Any = [np.roots([1, 4 * np.pi * f * ratio, (2 * np.pi * f) ** 2]) for f, ratio in ((1.0, 0.7), (5.0, 0.3))]
    assert_same(poles(robot(PLACED | KNOWN, **late)), np.exp(np.concatenate(pairs) * PERIOD))


def test_integrals_and_loads_with_a_delay_end_at_the_setpoint() -> None:
    """Under a load that the design does not know; its commands 2.3 periods late."""
    late, load = {"delay": 2.3 * PERIOD}, {"loads": [{"point": "tip", "frame": "world", "force": [0.5, 0, 0]}]}
    sums = {"sample_time": PERIOD, "integral": True, "integral_weight": 200.0}
    for block in (LQR | sums, LQG | {"load_noise": 1e-6, "estimate": {}}):
        own = robot(block | KNOWN, **late)
        assert own.linearize(closed=True).is_stable
        run = own.with_(load | {"integration.duration": 8.0, "integration.output_step": 0.5}).run()
        assert run.data["q"].sel(coordinate="joint.motor")[-1] == pytest.approx(0.3, abs=2e-3)


@pytest.mark.parametrize("block", [LQR | {"sample_time": PERIOD}, LQG])
def test_past_commands_begin_with_what_holds_the_motor(block: Any) -> None:
    """The torque of a gear that is wound by 0.1 rad, and its slope by the stiffness."""
    start = {"state": "zero", "coordinates": {"joint": 0.1, "joint.motor": 0.0}}
    own = spong(constant(0.5), 1.0, 0.1, {"g": 0.0}, control=law(block | KNOWN, delay=2.3 * PERIOD), initial=start)
    here = lowered(own)
    names, first = here.model.plan.control_names, here.model.layout.controls.start
    past = [first + k for k, name in enumerate(names) if ".last" in name]
    assert len(past) == 3
    assert here.start[past] == pytest.approx(-0.1 * LINK["k"], rel=1e-12)
    path = "joints.joint.gear.stiffness"
    assert changes_of(own, here, here.recorded(), [path])[path].start[past] == pytest.approx(-0.1, rel=1e-9)


def test_a_delay_that_is_not_in_the_design_is_said() -> None:
    remark = "its gains do not know that its commands act 15 ms late"
    assert any(remark in one for one in block_of(robot(LQG, delay=1.5 * PERIOD)).remarks())
    assert not block_of(robot(LQG | KNOWN, delay=1.5 * PERIOD)).remarks()


def test_a_law_of_continuous_time_knows_no_delay() -> None:
    with pytest.raises(InputErrors) as caught:
        robot(LQR | KNOWN)
    assert "delay_in_design" in str(caught.value)
