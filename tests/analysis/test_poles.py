"""Frequencies and damping ratios of modes are those of poles: eigenvalues of all matrices, controllers included."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import eigh
from scipy.optimize import linear_sum_assignment

from contracts.test_controllers import robot
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.analysis.modes.shapes import assigned
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup


def gain(least: float, most: float) -> st.SearchStrategy[float]:
    return st.floats(np.log(least), np.log(most)).map(lambda x: float(np.exp(x)))


PD = st.fixed_dictionaries({"type": st.just("pd"), "position_gain": gain(5, 5e3), "velocity_gain": gain(0.1, 200)})
PID = st.fixed_dictionaries({"type": st.just("pid"), "position_gain": gain(50, 5e3), "integral_gain": gain(1, 20),
                             "velocity_gain": gain(1, 200), "limit": st.just(1e3)})  # fmt: skip
ALL = st.fixed_dictionaries({
    "type": st.just("state_feedback"),
    "position_gains": st.fixed_dictionaries({"hub.motor": gain(50, 5e3), "beam.bend_z1": st.floats(-50, 50)}),
    "velocity_gains": st.fixed_dictionaries({"hub.motor": gain(1, 200), "hub": st.floats(0, 5)}),
})  # fmt: skip


def poles_of(matrix: np.ndarray) -> np.ndarray:
    values: Any = np.linalg.eigvals(matrix)
    return values[values.imag > 1e-7 * np.abs(values)]


def assert_of_poles(modes: list[dict[str, Any]], exact: Any) -> None:
    """Each mode that rings is one pole, no pole is left out; damping and damped frequency are that pole's."""
    ringing = [mode for mode in modes if mode["damped_frequency_Hz"]]
    found: Any = np.array([complex(*mode["pole"]) for mode in ringing])
    assert len(found) == len(exact)
    order, other = np.argsort(found.imag), np.argsort(exact.imag)
    assert found[order] == pytest.approx(exact[other], rel=1e-6)
    for mode, pole in zip(ringing, found, strict=True):
        assert mode["damping_ratio"] == pytest.approx(-pole.real / abs(pole), rel=1e-9, abs=1e-12)
        assert mode["damped_frequency_Hz"] == pytest.approx(pole.imag / (2 * np.pi), rel=1e-12)


@settings(max_examples=12, deadline=None)
@given(law=st.one_of(PD, PID, ALL))
def test_modes_under_control_are_poles_of_the_closed_loop(law: dict[str, Any]) -> None:
    """Random gains: the eigenvalues of the exact Jacobian of what a run integrates."""
    sheet: Robot = robot(law)
    setup, found = run_setup(sheet), vibrations(sheet)
    exact = setup.spectrum.eigenvalues
    ours = np.array([complex(*pole) for pole in found.poles])
    for pole in ours:
        assert np.abs(exact - pole).min() <= 1e-6 * max(abs(pole), 1.0)
    assert_of_poles(found.states["controlled"], exact[exact.imag > 1e-7 * np.abs(exact)])
    for mode in found.states["controlled"]:
        if mode["damped_frequency_Hz"]:
            assert mode["frequency_Hz"] == pytest.approx(abs(complex(*mode["pole"])) / (2 * np.pi), rel=1e-12)
            assert mode["damped_frequency_Hz"] <= mode["frequency_Hz"]


@settings(max_examples=8, deadline=None)
@given(damper=gain(0.01, 50), stiffness=gain(50, 3e3), decay=gain(1e-6, 1e-2))
def test_modes_with_locked_motors_are_poles(damper: float, stiffness: float, decay: float) -> None:
    """A damper in the gear, and one along the beam, damp unlike masses and springs, whose natural frequencies stay."""
    sheet = robot({"type": "pd", "position_gain": 80.0, "velocity_gain": 9.0}).with_({
        "joints.hub.gear": {"stiffness": stiffness, "damping": damper}, "links.beam.beam.damping_time": decay,
    })  # fmt: skip
    rest = robot_rest(sheet)
    mass, damping, spring = (matrix[np.ix_(rest.free, rest.free)] for matrix in Model(sheet.chain()).linearize(rest.q))
    zero, eye = np.zeros_like(mass), np.eye(len(mass))
    matrix = np.block([[zero, eye], [-np.linalg.solve(mass, spring), -np.linalg.solve(mass, damping)]])
    modes = vibrations(sheet).states["locked"]
    assert_of_poles(modes, poles_of(matrix))
    natural = np.sqrt(eigh(spring, mass, eigvals_only=True)) / (2 * np.pi)
    undamped = [one for mode in modes if (one := mode["undamped_frequency_Hz"]) is not None]
    assert sorted(undamped) == pytest.approx(natural, rel=1e-9)


@given(st.integers(0, 10_000))
def test_pairs_of_the_largest_sum(seed: int) -> None:
    """As SciPy's, also with ties and with more rows than columns."""
    generator = np.random.default_rng(seed)
    worth = np.round(generator.normal(size=generator.integers(1, 12, 2)), int(generator.integers(0, 6)))
    found, (rows, columns) = assigned(worth), linear_sum_assignment(-worth)
    chosen = found >= 0
    assert chosen.sum() == min(worth.shape) == len(set(found[chosen].tolist()))
    assert worth[chosen, found[chosen]].sum() == pytest.approx(worth[rows, columns].sum())


@pytest.mark.parametrize(
    "law", [{"type": "pd"}, {"type": "pid", "integral_gain": 30.0}, {"type": "sampled_pid", "sample_time": 1e-3}]
)
def test_the_controller_is_a_spring_whatever_the_inductance(law: dict[str, Any]) -> None:
    """Its stiffness is K C_M/R behind a winding with inductance too: in shares and undamped frequencies."""
    found = []
    for more in ({}, {"inductance": 0.01}):
        winding = {"resistance": 1.6, "torque_constant": 2.0, "back_emf_constant": 2.0, **more}
        motor = {"inertia": 0.1, "side": "joint", **winding}
        hinge = {"name": "hinge", "type": "revolute", "axis": [0, 1, 0], "child": "rod", "motor": motor}
        signal = {"type": "constant", "value": 0.0}
        gains = {"position_gain": 20.0, "velocity_gain": 2.0, **law}
        drive = {"joint": "hinge", "command": "position", "signal": signal, "controller": gains}
        body = {"name": "body", "mass": 1.0, "center": [0.5, 0, 0], "inertia": 0.1}
        sheet = Robot.from_data(
            {
                "format": 1, "kind": "arm", "name": "one", "gravity": 0.0, "drives": [drive],
                "joints": [hinge | {"gear": {"stiffness": 300.0, "damping": 0.1}}],
                "links": [{"name": "rod", "bodies": [body]}],
            }
        )  # fmt: skip
        modes = vibrations(sheet).states["controlled"]
        ordered = sorted((mode for mode in modes if mode["undamped_frequency_Hz"]), key=lambda mode: mode["element"])
        found.append([(mode["undamped_frequency_Hz"], *sorted(mode["shares"].items())) for mode in ordered])
    stiffness = np.array([[25.0 + 300.0, -300.0], [-300.0, 300.0]])
    squares, shapes = eigh(stiffness, np.diag([0.1, 0.35]))
    for one in found:
        assert [2 * np.pi * frequency for frequency, *_ in one] == pytest.approx(np.sqrt(squares), rel=1e-6)
        named = [dict(shares)["hinge.controller"] for _, *shares in one]
        assert named == pytest.approx(25.0 * shapes[0] ** 2 / squares, rel=1e-6)
