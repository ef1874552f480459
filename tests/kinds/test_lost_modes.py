"""Modes that inputs do not reach: random systems of known parts, turned, and a robot whose law drives one joint."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from tmodes.kinds.controllers.discrete import lost_modes


@pytest.mark.parametrize("seed", range(8))
def test_as_many_as_the_kalman_decomposition_leaves(seed: int) -> None:
    """Some modes driven through a chain, others that drive it and are driven by nothing; any basis, any scale."""
    random = np.random.default_rng(seed)
    own, apart = int(random.integers(2, 6)), int(random.integers(0, 4))
    A = random.normal(size=(own + apart, own + apart))
    A[own:, :own] = 0.0
    B = np.concatenate([random.normal(size=(own, 2)), np.zeros((apart, 2))])
    turn = np.linalg.qr(random.normal(size=A.shape))[0] * 10.0 ** random.uniform(-3, 3, len(A))[:, None]
    found = lost_modes(turn @ A @ np.linalg.inv(turn), turn @ B, [f"x{k}" for k in range(len(A))])
    poles = np.linalg.eigvals(A[own:, own:])
    wanted = poles[poles.imag >= 0]
    assert np.sort_complex(np.array([one.pole for one in found], dtype=complex)) == pytest.approx(
        np.sort_complex(wanted.astype(complex)), abs=1e-6
    )


def test_equal_poles_need_as_many_inputs() -> None:
    assert len(lost_modes(-np.eye(3), np.ones((3, 1)), "abc")) == 2
    assert lost_modes(-np.eye(3), np.eye(3), "abc") == []
    double = np.array([[0.0, 1.0], [0.0, 0.0]])
    assert lost_modes(double, np.array([[0.0], [1.0]]), "xv") == []
    assert [one.state for one in lost_modes(double, np.array([[1.0], [0.0]]), "xv")] != []


def test_a_law_that_drives_one_joint_of_two_says_what_it_does_not_reach() -> None:
    """Without weight nothing ties the other motor to the world: the turn of both is not moved by inner torques."""
    weights = {"shoulder.motor": 1e8, "shoulder.motor'": 1e5}
    law = {
        "name": "law",
        "drives": ["shoulder"],
        "block": {"type": "lqr", "sample_time": 1e-3, "state_weights": weights},
    }
    free = {
        "drives.1.command": "torque",
        "drives.1.controller": None,
        "drives.1.signal": {"type": "constant", "value": 0},
    }
    robot = tmodes.load("two_link_arm").with_(
        {"gravity": 0.0, "drives.0.controller": None, "control": [law], "integration.duration": 0.05, **free}
    )
    run = robot.run(error_estimate=False, model_error=False)
    assert any("`law`: the drives do not reach the mode at 0 1/s" in warning for warning in run.warnings)
    linear = robot.linearize(inputs="elbow.torque", outputs="elbow.position")
    assert [one.state for one in linear.uncontrollable] == ["shoulder.motor"]
    assert [one.state for one in linear.unobservable] == ["shoulder.motor"]
    assert not linear.info()["uncontrollable"][0][1]
    both = robot.linearize(inputs="shoulder.torque,elbow.torque", outputs="shoulder.position,elbow.position")
    assert both.uncontrollable == both.unobservable == []
