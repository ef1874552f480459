"""Orders, exact knots, interruption, divergence and refusals of an arm's run."""

from __future__ import annotations

import numpy as np
import pytest

from simulation.sheets import TIGHT, ZERO, arm, pendulum, torque
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_data
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

GEAR = {"stiffness": 100.0, "damping": 0.5}
MOTOR = {"inertia": 0.3}
STEP = {"type": "step", "start": 0.0, "end": 8.0, "time": 0.2345678}
"""A jump of the torque at no multiple of any step."""


def jumped(**integration):
    drive = {"command": "torque", "signal": STEP}
    return simulate_motion(pendulum(MOTOR, GEAR, drive, initial={"state": "zero"},
                                 integration={"duration": 0.6, "output_step": 0.1, **integration}))  # fmt: skip


def test_order_of_rk4():
    """The error falls with the fourth power of the step, over a jump at no multiple of it."""
    exact = jumped(**{**TIGHT, "output_step": 0.1}).q[-1]
    steps = np.array([0.02, 0.01, 0.005])
    errors = [np.abs(jumped(method="rk4", step=float(h)).q[-1] - exact).max() for h in steps]
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(4.0, abs=0.25)


def test_order_of_dormand_prince():
    """The error falls with the fifth power of the number of steps."""
    longer = {"duration": 4.0}
    exact = jumped(**{**TIGHT, "output_step": 0.1, **longer}).q[-1]
    counts, errors = [], []
    for tolerance in (1e-6, 1e-7, 1e-8, 1e-9):
        run = jumped(relative_tolerance=tolerance, absolute_tolerance=tolerance * 1e-2, **longer)
        counts.append(run.statistics["steps"])
        errors.append(np.abs(run.q[-1] - exact).max())
    assert np.polyfit(np.log(counts), np.log(errors), 1)[0] == pytest.approx(-5.0, abs=1.0)


def test_jumps_are_exact():
    """Before the jump nothing moves at all; after it the motion is that of a fresh start."""
    run = jumped(**{**TIGHT, "output_step": 0.01})
    before = run.times < STEP["time"]
    assert not run.q[before].any()
    assert run.q[~before][0].any()
    fresh = simulate_motion(pendulum(MOTOR, GEAR, torque(8.0), initial={"state": "zero"},
                                  integration={"duration": 0.6 - STEP["time"], **TIGHT}))  # fmt: skip
    assert np.abs(run.q[-1] - fresh.q[-1]).max() < 1e-11
    assert np.array_equal(np.unique(run.wanted), [0.0, 8.0])


def test_same_bits_after_an_interruption():
    """Ctrl-C keeps what was done; going on from the journal changes no bit."""

    class Journal:
        record = None

        def restore(self):
            return self.record

        def keep(self, record, *, last=False, now=False):
            if now:
                self.record = {name: array.copy() for name, array in record.items()}

    sheet = pendulum(MOTOR, GEAR, torque(5.0), initial={"state": "zero"},
                     integration={"duration": 20.0, "output_step": 0.01, "method": "rk4", "step": 1e-4})  # fmt: skip
    whole = simulate_motion(sheet)
    journal, stop = Journal(), [True]

    def progress(stage, share):
        if stop[0] and share > 0.3:
            stop[0] = False
            raise KeyboardInterrupt

    first = simulate_motion(sheet, progress=progress, journals=lambda stage: journal)
    assert first.status == "interrupted"
    assert 0 < len(first.times) < len(whole.times)
    assert np.array_equal(first.q, whole.q[: len(first.times)])
    second = simulate_motion(sheet, journals=lambda stage: journal)
    assert second.status == "finished"
    assert np.array_equal(second.q, whole.q)


def test_unstable_step_is_reported_before_and_after():
    sheet = pendulum(MOTOR, {"stiffness": 1e6, "damping": 0.0}, torque(1.0), initial={"state": "zero"},
                     integration={"duration": 1.0, "output_step": 0.01, "method": "rk4", "step": 0.01})  # fmt: skip
    run = simulate_motion(sheet)
    assert run.status == "diverged"
    assert "joint" in run.message
    assert "dt*omega" in run.message
    highest = np.sqrt(1e6 * (1 / 0.3 + 1))
    assert run.statistics["highest_eigenvalue"] == pytest.approx(highest, rel=1e-3)
    assert any("unstable at this step" in warning for warning in run.warnings)
    assert np.isfinite(run.q).all()
    assert 1 <= len(run.times) < 101


def test_controller_that_feeds_energy_in():
    """A control of the wrong sign in the torque: the start is reported as unstable, with the coordinate."""
    drive = {"command": "voltage", "signal": ZERO}
    motor = {**MOTOR, "resistance": 1.0, "back_emf_constant": 0.1, "torque_constant": 0.1}
    standing = {"joint": float(np.pi)}
    run = simulate_motion(pendulum(motor, GEAR, drive, initial={"state": "zero", "coordinates": standing},
                                integration={"duration": 0.1, "output_step": 0.01}))  # fmt: skip
    assert any("unstable at its start" in warning for warning in run.warnings)


def test_joint_without_a_drive_is_held_and_reported():
    joints = [
        {"name": "a", "type": "revolute", "parent": "base", "child": "one", "axis": [0, 1, 0]},
        {"name": "b", "type": "revolute", "child": "two", "axis": [0, 1, 0]},
    ]
    body = {"name": "bob", "mass": 1.0, "center": [0.3, 0, 0]}
    links = [{"name": name, "bodies": [body]} for name in ("one", "two")]
    sheet = arm(joints=joints, links=links, drives=[{"joint": "a", "command": "effort", "signal": ZERO}],
                initial={"state": "zero", "coordinates": {"b": 0.4}},
                integration={"duration": 0.5, "output_step": 0.01})  # fmt: skip
    run = simulate_motion(sheet)
    assert np.array_equal(run.q[:, 1], np.full(len(run.times), 0.4))
    assert any("joint b has no drive" in warning for warning in run.warnings)
    assert np.abs(run.q[-1, 0]) > 0.5


def test_limits_of_a_joint_that_nothing_drives_are_reported():
    """A locked joint whose gear gives way swings past its limit."""
    sheet = arm(gravity=9.8, joints=[{"name": "joint", "type": "revolute", "parent": "base", "child": "link",
                "axis": [0, 1, 0], "state": "locked", "gear": {"stiffness": 5.0, "damping": 0.0},
                "limits": {"upper": 0.2}}],
                links=[{"name": "link", "bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -1]}]}],
                initial={"state": "zero", "coordinates": {"joint": 0.1}, "rates": {"joint": 2.0}},
                integration={"duration": 1.0, "output_step": 0.01})  # fmt: skip
    run = simulate_motion(sheet)
    assert run.drives == ()
    (info,) = [warning for warning in run.warnings if "limit" in warning]
    first = run.times[np.flatnonzero(run.q[:, 0] > 0.2)[0]]
    assert f"limit of position, 0.2 rad, first at t = {first:.4g} s" in info


def test_limits_are_reported_with_time_and_value():
    limits = {"lower": -1.0, "upper": 0.1, "speed": 100.0, "effort": 4.0}
    sheet = pendulum(MOTOR, GEAR, torque(5.0), initial={"state": "zero"},
                     integration={"duration": 1.0, "output_step": 0.01})  # fmt: skip
    run = simulate_motion(sheet.with_({"joints.joint.limits": limits}))
    info = [warning for warning in run.warnings if "limit" in warning]
    first = run.times[np.flatnonzero(run.q[:, 1] > 0.1)[0]]
    assert any(f"t = {first:.4g} s" in warning and f"{run.q[:, 1].max():.6g}" in warning for warning in info)
    assert any("effort" in warning for warning in info)


def test_no_reference_run_of_a_jump():
    control = {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}
    drive = {"command": "position", "signal": {**STEP, "end": 0.5}, "controller": control}
    run = simulate_motion(pendulum(MOTOR, {"stiffness": float("inf")}, drive, initial={"state": "zero"},
                                integration={"duration": 1.0, "output_step": 0.01}))  # fmt: skip
    assert run.reference is None
    assert any("no nominal run" in warning and "0.234568" in warning for warning in run.warnings)
    assert run.status == "finished"


def test_real_arm_differs_from_the_nominal_one():
    control = {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}
    signal = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.5}
    drive = {"command": "position", "signal": signal, "controller": control}
    run = simulate_motion(pendulum(MOTOR, GEAR, drive, real={"joints.joint.gear.stiffness": 0.5},
                                integration={"duration": 1.0, "output_step": 0.01}))  # fmt: skip
    assert run.reference is not None
    gear = 50 * (run.q[:, 0] - run.q[:, 1]) + 0.5 * (run.v[:, 0] - run.v[:, 1])
    assert np.allclose(run.gear_torque[:, 0], gear, atol=1e-9)
    known = run.reference
    gear = 100 * (known.q[:, 0] - known.q[:, 1]) + 0.5 * (known.v[:, 0] - known.v[:, 1])
    assert np.allclose(known.gear_torque[:, 0], gear, atol=1e-9)


def test_unknown_coordinate_is_refused():
    with pytest.raises(InputErrors, match="bend"):
        simulate_motion(pendulum(MOTOR, GEAR, torque(0.0), initial={"coordinates": {"link.bend_y1": 0.1}},
                              integration={"duration": 0.1}))  # fmt: skip


def test_too_many_samples_are_refused_before_they_are_made():
    settings = {"duration": 10.0, "output_step": 1e-5, "line_points": 2}
    with pytest.raises(InputError, match=r"1e\+06 samples, about [2-9]\.\d* GB"):
        simulate_motion(pendulum(MOTOR, GEAR, torque(0.0), initial={"state": "zero"}, integration=settings))


def test_a_tolerance_left_out_stays_left_out() -> None:
    """A changed or stored sheet still has the tolerances of the method that is chosen."""
    sheet = pendulum(MOTOR, GEAR, torque(1.0), integration={"duration": 0.5})
    again = Robot.from_data(sheet_data(sheet.with_({"gravity": 9.0})))
    for one in (sheet, again):
        assert one.integration.chosen("extrapolation").relative_tolerance == 1e-7
        assert one.integration.chosen("dop853").relative_tolerance == 1e-9
    info = again.with_({"integration.relative_tolerance": 1e-9}).integration
    assert info.chosen("extrapolation").relative_tolerance == 1e-9
