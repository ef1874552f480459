"""Modes under blocks of `control`, samples and delays are the poles of the whole loop, which SciPy finds by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm, solve_continuous_are, solve_discrete_are

import tmodes
from contracts.test_blocks import LINK, LQG, LQR, PD, PID, SHAPED, STATES, constant, law, spong
from simulation.test_closed_start import random_robot
from tmodes.live.places import vibrations_info
from tmodes.model.model import Model
from tmodes.simulation.initial_state import run_setup

Array = NDArray[np.float64]
GONE = 1e-6
PERIOD, TURN = 0.01, 0.3
WEIGHTS = np.diag([400.0, 100.0, 5.0, 1.0])


def robot(block: dict[str, Any], **more: Any) -> Any:
    made = spong(constant(TURN), 1.0, 0.1, initial={}, control=law(block, **more))
    return tmodes.Robot.from_data(made.model_dump(mode="json", by_alias=True, exclude_none=True))


def poles(of: Any) -> Any:
    return np.array([complex(*one) for one in of.modes().found["real"].poles])


def assert_same(found: Any, truth: Any, share: float = 1e-8) -> None:
    """As sets."""
    assert len(found) == len(truth)
    size = np.abs(truth).max()
    assert all(np.abs(found - one).min() <= share * size for one in truth)
    assert all(np.abs(truth - one).min() <= share * size for one in found)


def assert_those_of_linear(of: Any, share: float = 1e-8) -> None:
    """Motions that a sample ends are in none of them."""
    found, linear = poles(of), of.linearize(closed=True)
    truth = linear.poles
    if linear.period:
        found, truth = np.exp(found * linear.period), truth[np.abs(truth) > GONE]
    assert_same(found[np.abs(found) > GONE] if linear.period else found, truth, share)


def plant() -> tuple[Array, Array]:
    """Spong's joint about its rest with the motor at 0.3 rad."""
    p, q = LINK, TURN
    for _ in range(50):
        q -= (p["m"] * p["g"] * p["l"] * np.sin(q) + p["k"] * (q - TURN)) / (
            p["m"] * p["g"] * p["l"] * np.cos(q) + p["k"])  # fmt: skip
    weight = p["m"] * p["g"] * p["l"] * np.cos(q)
    A = np.zeros((4, 4))
    A[:2, 2:] = np.eye(2)
    A[2] = np.array([-weight - p["k"], p["k"], -p["d"], p["d"]]) / p["I"]
    A[3] = np.array([p["k"], -p["k"], p["d"], -p["d"] - p["b"]]) / p["J"]
    return A, np.array([[0.0], [0.0], [0.0], [1 / p["J"]]])


def held(A: Array, B: Array, time: float) -> tuple[Array, Array]:
    found: Any = expm(np.block([[A, B], [np.zeros((1, 5))]]) * time)
    return found[:4, :4], found[:4, 4:]


def test_a_continuous_regulator() -> None:
    A, B = plant()
    K = B.T @ solve_continuous_are(A, B, WEIGHTS, np.eye(1))
    assert_same(poles(robot(LQR)), np.linalg.eigvals(A - B @ K))


def test_a_regulator_with_an_estimator_and_a_delay() -> None:
    """Its commands 1.5 periods late: x, the estimate, and two commands that are on their way."""
    A, B = plant()
    Ad, Bd = held(A, B, PERIOD)
    half, push = held(A, B, PERIOD / 2)
    X = solve_discrete_are(Ad, Bd, WEIGHTS, np.eye(1))
    K = np.linalg.solve(1.0 + Bd.T @ X @ Bd, Bd.T @ X @ Ad)
    C, W = np.array([[0.0, 1.0, 0.0, 0.0]]), np.diag([LQG["process_noise"][name] for name in STATES])
    P = solve_discrete_are(Ad.T, C.T, W, np.array([[1e-5]]))
    M = P @ C.T / (C @ P @ C.T + 1e-5)
    still = np.eye(4) - M @ C  # xf = still xp + M C x, u = -K xf
    loop = np.zeros((10, 10))
    loop[:4, :4], loop[:4, 8:9], loop[:4, 9:] = Ad, push, half @ push  # u[k-1] in the second half, u[k-2] before
    loop[4:8, :4], loop[4:8, 4:8] = (Ad - Bd @ K) @ M @ C, (Ad - Bd @ K) @ still
    loop[8, :4], loop[8, 4:8] = (-K @ M @ C)[0], (-K @ still)[0]
    loop[9, 8] = 1.0
    truth, own = np.linalg.eigvals(loop), robot(LQG, delay=1.5 * PERIOD)
    found = np.exp(poles(own) * PERIOD)
    assert_same(found[np.abs(found) > GONE], truth[np.abs(truth) > GONE])
    assert_those_of_linear(own)
    controlled = own.modes().states["controlled"]
    assert {mode["element"] for mode in controlled} == {"joint.controller", "joint.gear"}
    assert not own.modes().warnings


LAWS = {
    "sampled regulator": (LQR | {"sample_time": PERIOD}, {}),
    "loop shaping": (SHAPED, {}),
    "late loop shaping": (SHAPED | {"sample_time": PERIOD}, {"delay": 0.013}),
    "late PID": (PID, {"delay": 1.5e-3}),
}


@pytest.mark.parametrize("name", LAWS)
def test_laws_of_blocks(name: str) -> None:
    block, more = LAWS[name]
    assert_those_of_linear(robot(block, **more))


def test_a_drive_that_samples_and_is_late() -> None:
    drive = {"controller": PD, "sample_time": PERIOD, "delay": 0.5 * PERIOD}
    made = spong(constant(TURN), 1.0, 0.1, initial={}, drive=drive)
    assert_those_of_linear(tmodes.Robot.from_data(made.model_dump(mode="json", by_alias=True, exclude_none=True)))


def test_a_block_has_the_modes_of_the_same_law_at_the_drive() -> None:
    """Where that has no sample its modes are found in another way."""
    own = {key: value for key, value in PID.items() if key not in ("sample_time", "limit")} | {"type": "pid"}
    at_drive = spong(constant(TURN), 1.0, 0.1, initial={}, drive={"controller": own})
    at_drive = tmodes.Robot.from_data(at_drive.model_dump(mode="json", by_alias=True, exclude_none=True))
    assert_same(poles(robot(own)), poles(at_drive), 1e-4)  # whose rest is with the motor at its setpoint


@pytest.mark.parametrize("seed", range(4))
def test_random_robots_under_random_gains(seed: int) -> None:
    rng, made = np.random.default_rng(seed), random_robot(seed)
    data = made.model_dump(mode="json", by_alias=True, exclude_none=True) | {"contact": None}
    names, control = made.chain().coordinates, []
    for drive in data["drives"]:
        if drive["command"] not in ("position", "prescribed"):
            continue
        drive |= {"command": "position", "controller": None, "noise": None}
        control.append(drive["joint"])
    weights = {name: float(rng.uniform(1.0, 1e3)) for name in (*names, *(f"{one}'" for one in names))}
    block = {"type": "lqr", "state_weights": weights, "sample_time": (None, 2e-3)[seed % 2]}
    own = tmodes.Robot.from_data(data | {"control": [{"name": "law", "drives": control, "block": block}]})
    assert_those_of_linear(own, 1e-6)


def test_a_page_says_that_it_does_not_find_them() -> None:
    own = robot(LQR)
    info = vibrations_info(own, own, run_setup(own).planned.plan, Model(own.chain()))
    assert info["modes"] is None
    assert "blocks of `control`" in info["noModes"]


def test_laws_keep_their_gains_at_other_poses() -> None:
    """At a pose other than that of its design a law has the gains of its design."""
    own = robot(LQR)
    (gain,) = own.modes(at={"joint": 0.0}).states["controlled"][:1]
    assert gain["frequency_Hz"] == pytest.approx(own.modes().states["controlled"][0]["frequency_Hz"], rel=0.05)
    assert own.modes(angle=0.5).states.keys() == {"locked", "free"}
