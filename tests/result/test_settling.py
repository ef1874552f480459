# pyright: reportOptionalSubscript=false
"""When the tip has settled: the run is continued beyond its end, against the closed form of one damped vibration."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

import tmodes
from random_robots import random_robot
from see.runs import sheet
from tmodes.analysis.vibration import farthest, residual_vibration, settled_after
from tmodes.errors import InputError, InputErrors
from tmodes.integrate.conditions import BAND, Band
from tmodes.result import Result
from tmodes.result.assemble import ResultAssembly
from tmodes.result.settling import after_move, at_rest_from, move_end
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.simulate import simulate_motion

COUNT = int(os.environ.get("TMODES_RANDOM_RUNS", "0"))
"""Random robots of each kind; of 0 two."""

STIFFNESS, INERTIA, RATIO, LENGTH = 40.0, 0.4, 0.1, 0.5
FREQUENCY = np.sqrt(STIFFNESS / INERTIA)
STEP = 0.02
"""Angle [rad] by which the motor jumps at once: the arm rings about it, with a known envelope."""


def ringing(duration: float, damping: float = 2 * RATIO * np.sqrt(STIFFNESS * INERTIA), **more: object) -> Robot:
    """A mass on a rigid link behind an elastic gear whose motor moves by a short quintic and then stands still."""
    move = {"type": "quintic", "start": 0.0, "end": STEP, "duration": 0.01}
    motor = {"inertia": 1.0, "side": "joint", "resistance": 1.0, "back_emf_constant": 1.0, "torque_constant": 1.0,
             "inductance": 0.0}  # fmt: skip
    return Robot.from_data(sheet(
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
                 "motor": motor, "gear": {"stiffness": STIFFNESS, "damping": damping}}],
        links=[{"name": "rod", "bodies": [{"name": "bob", "mass": INERTIA / LENGTH**2, "center": [LENGTH, 0, 0]}]}],
        tip={"link": "rod", "position": [LENGTH, 0, 0]},
        drives=[{"joint": "hub", "command": "position", "signal": move,
                 "controller": {"type": "pd", "position_gain": 3e4, "velocity_gain": 400.0}}],
        real={"joints.hub.gear.stiffness": 1.05},
    ) | {"integration": {"duration": duration, "output_step": 1e-3, "relative_tolerance": 1e-9} | more})  # fmt: skip


def test_a_short_run_settles_as_a_long_one():
    """The continuation finds what a run that is long enough shows in its samples."""
    short, long = tmodes.run(ringing(0.6)), tmodes.run(ringing(8.0))
    info = short.settling
    assert info
    assert info["reason"] == ""
    time, tip = long.motion["time"].values, long.motion["tip"].values
    outside = time[np.linalg.norm(tip - info["rest_m"], axis=1) > info["limit_m"]]
    assert outside[-1] > 0.8  # beyond the end of the short run
    assert info["limit_m"] == pytest.approx(BAND * info["move_m"])
    assert info["time_s"] == pytest.approx(outside[-1] - 0.01, abs=2e-3)
    assert long.settling["time_s"] == pytest.approx(info["time_s"], abs=2e-3)
    assert short.summary()["settling"] == info
    for band in (0.5, 0.01, 3e-3):  # another band continues the run as well
        other = short.summary(band)["settling"]
        outside = time[np.linalg.norm(tip - other["rest_m"], axis=1) > other["limit_m"]]
        assert other["band"] == band
        assert other["time_s"] == pytest.approx(max(outside[-1] - 0.01, 0.0), abs=2e-3)


def test_a_band_is_a_share_or_a_length(tmp_path: Path) -> None:
    """Of the sheet, and of who asks: in time when the distance from rest is last that large."""
    long = tmodes.run(ringing(9.0, settling_band="0.1 mm"))
    time, tip = long.motion["time"].values, long.motion["tip"].values
    far = np.linalg.norm(tip - long.settling["rest_m"], axis=1)
    assert long.settling["limit_m"] == 1e-4
    assert long.settling["band"] is None
    for band, limit in ((None, 1e-4), ("0.05mm", 5e-5), ("2 %", 0.02 * far.max()), (0.02, 0.02 * far.max())):
        for result in (long, Result.load(long.save(tmp_path / "result.nc", overwrite=True))):
            info = result.summary(band)["settling"]
            assert info["limit_m"] == pytest.approx(limit, rel=1e-3)
            assert info["time_s"] == pytest.approx(time[far > limit][-1] - 0.01, abs=3e-3)
    assert long.summary("1 mm")["settling"]["within"] == "1 mm"
    assert long.summary(0.02)["settling"]["band"] == 0.02


@pytest.mark.parametrize("wrong", ["5 furlongs", "120 %", "0", "-1 mm", "mm", 1.5, "", "1e999 mm", "nan"])
def test_bands_that_are_none(wrong: str | float) -> None:
    with pytest.raises(InputError):
        Band.parsed(wrong)
    with pytest.raises((InputError, InputErrors)):
        ringing(1.0, settling_band=wrong)


def trapezoid(time: np.ndarray, angle: float, duration: float, ramp: float) -> tuple[np.ndarray, float]:
    """Angles of a motor whose speed is a trapezoid, and its largest speed."""
    speed = angle / (duration - ramp)
    t = np.clip(time, 0, duration)
    up, down = np.minimum(t, ramp), np.maximum(t - duration + ramp, 0)
    return speed * (t - up + up**2 / (2 * ramp) - down**2 / (2 * ramp)), speed


def rung(time: np.ndarray, omega: float, ratio: float, speed: float, duration: float, ramp: float) -> np.ndarray:
    """Error of an inertia behind a spring and damper, whose motor moves so, after the move: steps of acceleration."""
    damped = omega * np.sqrt(1 - ratio**2)
    total = np.zeros_like(time)
    for sign, since in ((-1, 0.0), (1, ramp), (1, duration - ramp), (-1, duration)):
        t = time - since
        swing = np.cos(damped * t) + ratio * omega / damped * np.sin(damped * t)
        total += sign * speed / ramp / omega**2 * (1 - np.exp(-ratio * omega * t) * swing)
    return total


@pytest.mark.parametrize(("omega", "ratio"), [(17.0, 0.04), (23.0, 0.02)])
def test_closed_form_of_a_trapezoid(omega, ratio):
    """Amplitude of the vibration at the end of the move, and when it stays within bands; also slightly softer."""
    angle, duration, ramp = 0.9, 0.8, 0.15
    time = np.linspace(duration, 8.0, 7201)
    error = rung(time, omega, ratio, trapezoid(time, angle, duration, ramp)[1], duration, ramp)
    angles = trapezoid(time, angle, duration, ramp)[0] + error
    slope = np.gradient(error, time, edge_order=2)[0]
    damped = omega * np.sqrt(1 - ratio**2)
    envelope = np.hypot(error[0], (slope + ratio * omega * error[0]) / damped)
    found = residual_vibration(time, angles[:, None], duration)
    assert found.amplitude == pytest.approx(envelope, rel=1e-3)
    assert (found.modes[0].frequency_Hz, found.modes[0].damping_ratio) == pytest.approx(
        (damped / (2 * np.pi), ratio), rel=1e-4
    )
    for share in (0.02, 0.005):
        outside = time[np.abs(error) > share * angle]
        expected = outside[-1] - duration if len(outside) else 0.0
        assert settled_after(time, angles[:, None], [angle], share * angle, duration) == pytest.approx(
            expected, abs=1e-3
        )


@pytest.mark.parametrize("amplitude", [0.0, 2e-5, 3e-3])
def test_creeping_is_no_vibration(amplitude):
    """A tip that creeps by 15 mm to its rest, and what swings about it."""
    time = np.linspace(0, 3.0, 1501)
    creep, swing = 0.015 * np.exp(-time / 0.6), amplitude * np.exp(-1.2 * time) * np.cos(31 * time + 0.4)
    tip = np.stack([1 + creep, 0.2 * creep + swing, 0 * time], axis=1)
    found = residual_vibration(time, tip)
    assert found.amplitude == pytest.approx(amplitude, rel=1e-3, abs=1e-7)
    noisy = residual_vibration(time, tip + 1e-5 * np.random.default_rng(1).normal(size=tip.shape))
    if amplitude > 1e-3:
        assert noisy.amplitude == pytest.approx(amplitude, rel=0.02)


def test_what_cannot_be_separated_is_not_given():
    """Too few samples, less than a period, noise alone."""
    time = np.linspace(0, 1, 400)
    assert residual_vibration(time[:10], np.zeros((10, 3))).amplitude is None
    slow = residual_vibration(time, np.cos(4 * time)[:, None])
    assert slow.amplitude is None
    assert "period" in slow.reason
    noise = np.random.default_rng(2).normal(size=(400, 1))
    assert residual_vibration(time, noise).amplitude is None


def test_what_does_not_decay_is_not_continued():
    """Without damping nothing settles: the samples alone are looked at, and say so."""
    info = tmodes.run(ringing(0.6, damping=0.0)).settling
    assert info["time_s"] is None
    assert "does not decay" in info["reason"]


def test_a_run_that_ends_within_the_move():
    result = tmodes.run(ringing(0.008, output_step=1e-3))
    assert result.settling["time_s"] is None
    assert "simulate longer" in result.settling["reason"]
    short = tmodes.run(tmodes.load("spong1987").with_({"integration.duration": 0.003}))
    assert short.settling["reason"].startswith("the run ends at 0.003 s, the move at 1 s")  # however short
    assert json.loads(result.data.attrs["settling"]) == result.settling


def sprung(output_step: float, duration: float = 1.5) -> Robot:
    """An inertia behind a gear whose motor moves by a given trapezoid of speed; the band is 6 mm."""
    move = {"type": "trapezoid", "start": 0.0, "end": 1.2, "duration": 1.0, "ramp_fraction": 0.2}
    return Robot.from_data(sheet(
        joints=[{"name": "hub", "type": "revolute", "child": "rod", "axis": [0, 0, 1],
                 "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 140.0, "damping": 0.5}}],
        links=[{"name": "rod", "bodies": [{"name": "bob", "mass": 1.0, "inertia": 0.5}]}],
        tip={"link": "rod", "position": [1.0, 0, 0]},
        drives=[{"joint": "hub", "command": "prescribed", "signal": move}],
    ) | {"integration": {"duration": duration, "output_step": output_step, "settling_band": "6 mm"}})  # fmt: skip


@pytest.mark.parametrize("output_step", [1e-3, 1e-2, 0.05, 0.3])
def test_the_output_step_does_not_matter(output_step: float) -> None:
    """Against the closed form, whose tip is last at the band 3.616731380921 s after the move."""
    for duration in (1.5, 3.1):
        info = tmodes.run(sprung(output_step, duration)).settling
        assert info["time_s"] == pytest.approx(3.616731380921, abs=1e-5)


@pytest.mark.parametrize("kind", ["gears", "segments", "sampled"])
def test_random_robots_settle_alike_at_any_output_step(kind: str) -> None:
    """To a thousandth of the period of what vibrates; without a vibration, to a millisecond."""
    for seed in range(COUNT or 2):
        robot = random_robot(kind, 900 + seed).with_({"integration.error_estimate": False, "drives.0.signal.end": 0.7})
        step, found = robot.integration.output_step, []
        for factor in (1, 2, 5):
            made = ResultAssembly(simulate_motion(robot.with_({"integration.output_step": factor * step})), robot)
            found.append(made.settling)
        modes = made.vibration["actual"]["modes"]
        least = 1e-3 / modes[0]["frequency_Hz"] if modes else 1e-3
        times = [info["time_s"] for info in found]
        if None not in times:
            assert times == pytest.approx([times[0]] * 3, abs=least)


def test_sampled_control_is_continued_at_its_own_samples() -> None:
    """A run that ends between two samples of its controller continues as a longer run does."""
    robot = random_robot("sampled", 7002).with_({"integration.error_estimate": False})
    length = robot.integration.duration
    run = simulate_motion(robot)
    after = after_move(run, move_end(run.planned))
    longer = simulate_motion(robot.with_({"integration.duration": 2 * length}))
    later = (after.times > length) & (after.times < 2 * length)
    assert later.sum() > 100
    place = np.stack([np.interp(after.times[later], longer.times, column) for column in longer.points.position[:, 0].T])
    assert np.abs(place.T - after.tip[later]).max() < 1e-8


def moved(time: np.ndarray, rate: float, decay: float, phase: float) -> tuple[np.ndarray, np.ndarray]:
    """Places and rates (n, 2) of a decaying vibration about (2, 2)."""
    pole = rate * (-decay + 1j)
    turned = np.outer(np.exp(pole * time + 1j * phase), [1.0, 0.4j])
    return 2.0 + turned.real, (pole * turned).real


def test_the_last_exit_between_samples() -> None:
    """Of decaying vibrations at any phase, against samples a thousand times as near: to a 500th of a period."""
    random = np.random.default_rng(3)
    for _ in range(60):
        rate, decay, phase = random.uniform(5, 60), random.uniform(0.02, 0.2), random.uniform(0, 6)
        coarse, fine = (np.linspace(0.0, 6 / (decay * rate), count) for count in (int(8 / decay), int(8000 / decay)))
        limit = random.uniform(0.01, 0.3)
        far = np.linalg.norm(moved(fine, rate, decay, phase)[0] - 2.0, axis=1)
        expected = fine[far > limit][-1]
        values, rates = moved(coarse, rate, decay, phase)
        assert settled_after(coarse, values, [2.0, 2.0], limit, 0.0, rates) == pytest.approx(
            expected, abs=2 * np.pi / rate / 500
        )
        assert farthest(coarse, values, rates, np.array([2.0, 2.0])) == pytest.approx(far.max(), rel=1e-3)


def test_noise_ends_where_a_run_is_continued():
    """A robot whose setpoint is disturbed comes to rest; all other signals keep their values."""
    noisy = {"reference.noise.deviation": 1e-3, "reference.noise.seed": 3}
    setup = run_setup(tmodes.load("filipovic2010").with_(noisy).pair().real)
    noise = [drive.noise for drive in setup.planned.plan.drives if drive.noise >= 0]
    assert noise
    before = setup.planned.signals.at(1.5)
    still, _ = at_rest_from(setup, 1.5, setup.start, 2.0)
    for time in (0.0, 0.7, 2.0):
        after = still.planned.signals.at(time)
        assert np.all(before[noise] != 0)
        assert np.all(after[noise] == 0)
        assert np.delete(after, noise) == pytest.approx(np.delete(before, noise), rel=1e-12)
