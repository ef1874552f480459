"""Integrators of stiff arms: orders by fitted slopes, interpolation, agreement, energy over long runs, and faults."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm, beam, pendulum, torque
from tmodes.compile.loops.extrapolation_rows import difference_weights
from tmodes.errors import CompileError
from tmodes.sheet import Robot
from tmodes.simulation import native_run
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.simulate import simulate_motion

FINE = {"method": "dormand_prince", "relative_tolerance": 1e-12, "absolute_tolerance": 1e-14}


def stiff(damping_time: float = 1e-3, **integration: Any) -> Robot:
    """Two thin tubes on elastic joints that are not parallel, driven; fastest eigenvalue about 1e5 1/s."""
    links = [
        {"name": f"l{k}", "beam": beam({"bend_y": 1, "bend_z": 2}, 0.3, 60.0, 0.5, damping_time=damping_time),
         "bodies": [{"name": "load", "mass": 0.3, "inertia": {"xx": 1e-3, "yy": 1e-3, "zz": 1e-3}, "at": 1.0}]}
        for k in range(2)
    ]  # fmt: skip
    joints = [
        {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis,
         "motor": {"side": "joint", "inertia": 0.1, "friction": {"viscous": 0.2}},
         "gear": {"stiffness": 800.0, "damping": 0.1}}
        for k, axis in enumerate(([0, 0, 1], [0, 0.8, 0.6]))
    ]  # fmt: skip
    drives = [
        {"joint": f"j{k}", "command": "position",
         "controller": {"type": "pd", "position_gain": 150.0, "velocity_gain": 8.0},
         "signal": {"type": "sine", "amplitude": 0.2, "frequency": 2.0 + k, "offset": 0.3}}
        for k in range(2)
    ]  # fmt: skip
    return arm(
        gravity=9.81, joints=joints, links=links, drives=drives,
        integration={"duration": 0.1, "output_step": 1e-3, **integration},
    )  # fmt: skip


def swinging(**integration: Any) -> Robot:
    """An undamped flexible double pendulum that swings: nothing brings energy in or takes it out."""
    links = [
        {"name": f"l{k}", "beam": beam({"bend_z": 2}, 0.5, 40.0, 0.6),
         "bodies": [{"name": "load", "mass": 0.4, "at": 1.0}]} for k in range(2)
    ]  # fmt: skip
    joints = [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1]} for k in range(2)]
    drives = [{"joint": f"j{k}", "command": "effort", "signal": {"type": "constant", "value": 0.0}} for k in range(2)]
    return arm(
        gravity=[0.0, -9.81, 0.0], joints=joints, links=links, drives=drives,
        initial={"state": "zero", "coordinates": {"j0": -0.9, "j1": 0.3}},
        integration={"duration": 1.0, "output_step": 1e-2, **integration},
    )  # fmt: skip


def path(sheet: Robot, **more: Any) -> Trajectory:
    """The run of the real arm alone."""
    return run_trajectory(run_setup(sheet), **more)


def difference(one: Trajectory, other: Trajectory, coordinates: int) -> float:
    """Largest difference of the coordinates at any sample [rad]."""
    return float(np.abs(one.states - other.states)[:, :coordinates].max())


def slope(steps: list[float], errors: list[float]) -> float:
    """Fitted order of convergence."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


@pytest.mark.parametrize(("method", "factor"), [("extrapolation", 20.0), ("rosenbrock", 20.0)])
@pytest.mark.parametrize("damping_time", [0.0, 1e-5, 1e-3])
def test_path_stays_within_the_tolerance(method: str, factor: float, damping_time: float) -> None:
    """Undamped, lightly damped and over-damped links; samples every 0.1 ms lie between the ends of steps."""
    info = {"duration": 0.03, "output_step": 1e-4}
    exact = path(stiff(damping_time, **info, **FINE))
    for tolerance in (1e-5, 1e-7):
        run = path(stiff(damping_time, **info, method=method, relative_tolerance=tolerance,
                         absolute_tolerance=tolerance / 100))  # fmt: skip
        assert run.status == "finished"
        assert difference(run, exact, 10) < factor * tolerance
    assert run.statistics["steps"] < 0.7 * len(run.times)  # so samples are interpolated


def test_samples_do_not_cut_the_steps_of_extrapolation() -> None:
    runs = [path(stiff(method="extrapolation", output_step=step)) for step in (0.05, 1e-4)]
    counts = [run.statistics["evaluations"] for run in runs]
    assert counts[0] == counts[1]
    assert np.array_equal(runs[0].states[-1], runs[1].states[-1])


def test_difference_weights_find_the_derivatives_of_polynomials() -> None:
    """Rows of k steps are exact for polynomials of degree k - 1, here with values from the polynomial itself."""
    rows, values = 5, np.polynomial.Polynomial([0.3, -1.2, 0.7, 2.1, -0.4])
    for order in range(1, rows):
        weights = difference_weights(rows, order)
        found = sum(weight * values(-1.0 + (done / row if row else 0.0)) for (row, done), weight in weights.items())
        assert found == pytest.approx(values.coef[order], abs=1e-10)


def test_order_of_the_midpoint_rule_is_two() -> None:
    steps = [2e-4, 1e-4, 5e-5]
    exact = path(swinging(duration=0.1, **FINE))
    runs = [path(swinging(duration=0.1, method="midpoint", step=step)) for step in steps]
    errors = [difference(run, exact, 2) for run in runs]
    assert slope(steps, errors) == pytest.approx(2.0, abs=0.1)


def test_order_of_rodas5p_is_five_or_better() -> None:
    """Steps needed for each error, over four decades of the tolerance."""
    exact = path(swinging(duration=0.2, **FINE))
    counts, errors = [], []
    for tolerance in (1e-5, 1e-6, 1e-7, 1e-8):
        run = path(swinging(duration=0.2, method="rosenbrock", relative_tolerance=tolerance,
                            absolute_tolerance=tolerance / 100))  # fmt: skip
        counts.append(run.statistics["steps"])
        errors.append(difference(run, exact, 2))
    assert -7.0 < slope(counts, errors) < -4.7


def test_energy_of_an_undamped_arm_does_not_drift() -> None:
    """Over 25,000 steps of the midpoint rule the error of the energy stays a band whose width is that of h^2."""
    widths = []
    for step in (2e-3, 1e-3):
        run = simulate_motion(swinging(duration=50.0, output_step=0.05, method="midpoint", step=step))
        assert run.status == "finished"
        moved = np.ptp(run.energies["kinetic"])
        error = run.energy_balance / moved
        widths.append(np.abs(error).max())
        drift = np.polyfit(run.times, error, 1)[0] * run.times[-1]
        assert abs(drift) < 0.2 * widths[-1]
    assert widths[0] < 2e-6
    assert widths[0] / widths[1] == pytest.approx(4.0, rel=0.2)


@pytest.mark.parametrize("tolerance", [1e-4, 1e-6])
def test_energy_of_stiff_undamped_links_stays_within_the_tolerance(tolerance: float) -> None:
    run = simulate_motion(stiff(0.0, duration=0.3, method="extrapolation", relative_tolerance=tolerance,
                             absolute_tolerance=tolerance / 100))  # fmt: skip
    assert np.abs(run.energy_balance).max() < tolerance * np.ptp(run.energies["kinetic"])


def test_energy_of_an_undamped_arm_by_extrapolation() -> None:
    run = simulate_motion(swinging(duration=2.0, method="extrapolation", relative_tolerance=1e-8,
                                absolute_tolerance=1e-10))  # fmt: skip
    assert np.abs(run.energy_balance).max() < 1e-7 * np.ptp(run.energies["kinetic"])


def test_methods_agree_on_an_arm_that_is_not_stiff() -> None:
    sheet = {"motor": {"inertia": 0.3}, "gear": {"stiffness": 100.0, "damping": 0.5}, "drive": torque(2.0)}
    info = {"duration": 1.0, "output_step": 0.01, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}
    runs = [
        path(pendulum(**sheet, integration={**info, "method": method}))
        for method in ("dormand_prince", "extrapolation", "rosenbrock")
    ]
    assert difference(runs[1], runs[0], 2) < 2e-8
    assert difference(runs[2], runs[0], 2) < 2e-8


def test_a_motor_that_follows_its_signal_is_where_it_must_be() -> None:
    """A prescribed motor behind a stiff gear: implicit steps take it, and the spring, where the step ends."""
    drive = {"command": "prescribed", "signal": {"type": "sine", "amplitude": 0.4, "frequency": 1.5, "offset": 0.0}}
    info = {"duration": 0.4, "output_step": 0.01}
    sheets = [
        pendulum({"inertia": 0.3}, {"stiffness": 5e3, "damping": 1.0}, drive, integration={**info, **more})
        for more in (FINE, {"method": "extrapolation", "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11})
    ]
    exact, found = (simulate_motion(sheet) for sheet in sheets)
    assert np.abs(exact.q).max() > 0.3
    assert np.abs(found.q - exact.q).max() < 2e-8


def test_same_bits_whatever_the_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """The loop called for one step at a time, and called for many."""
    for method in ("midpoint", "rosenbrock", "extrapolation"):
        sheet = stiff(method=method, step=1e-3, duration=0.02)
        whole = path(sheet)
        with monkeypatch.context() as patch:
            patch.setattr(native_run, "_FIRST_PIECE", 1)
            patch.setattr(native_run, "_PIECE_SECONDS", 0.0)
            pieces = path(sheet)
        assert pieces.statistics == whole.statistics
        assert np.array_equal(pieces.states, whole.states)


def test_iterations_that_do_not_converge_end_the_run() -> None:
    """A step so long that the geometry turns several times within it."""
    run = path(swinging(method="midpoint", step=2.0, duration=20.0, output_step=2.0))
    assert run.status == "not_converged"
    assert "iterations of a step of 2 s do not converge; shorten integration.step" in run.message
    assert "in coordinate" in run.message
    assert np.isfinite(run.states).all()


@pytest.mark.parametrize("method", ["extrapolation", "midpoint", "rosenbrock"])
def test_a_motion_that_is_lost_is_reported_with_time_and_coordinate(method: str) -> None:
    """A torque so large that what it moves is soon no motion any more."""
    sheet = pendulum(
        {"inertia": 0.3}, {"stiffness": 100.0}, torque(1e11),
        integration={"duration": 1.0, "output_step": 0.01, "method": method, "step": 1e-3},
    )  # fmt: skip
    run = path(sheet)
    assert run.status == "diverged"
    assert "in coordinate joint" in run.message
    assert "t = " in run.message
    assert np.isfinite(run.states).all()


def test_rosenbrock_refuses_what_its_memory_cannot_hold() -> None:
    many = {
        "joints": [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1]} for k in range(151)],
        "links": [{"name": f"l{k}", "bodies": [{"name": "b", "mass": 1.0, "center": [0.1, 0, 0]}]} for k in range(151)],
    }
    info = {"duration": 0.01, "output_step": 0.01, "method": "rosenbrock"}
    with pytest.raises(CompileError, match="only up to 300; take extrapolation"):
        path(arm(**many, gravity=0.0, initial={"state": "zero"}, integration=info))
