# pyright: reportAttributeAccessIssue=false, reportOptionalMemberAccess=false
"""Noise: what its numbers promise, and a seed of its own in each lane."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

import tmodes
from simulation.sheets import pendulum, torque
from tmodes.errors import InputError
from tmodes.kinds.signals.noise import Noise, normal_numbers
from tmodes.simulation.simulate import simulate_motion


def noise(**more):
    return Noise.model_validate({"type": "noise", "deviation": 2.0, "frequency": 50.0, "seed": 3, "mean": 5.0, **more})


def test_values_and_slopes_join():
    """Continuous with its slope at every knot; it begins at its mean, without a slope."""
    schedule = noise().schedule(1.003)
    inner = schedule.knots[1:-1]
    before = np.nextafter(inner, 0.0)
    for derivative, scale in ((0, 10.0), (1, 10.0 * 100)):
        assert np.abs(schedule.at(inner, derivative) - schedule.at(before, derivative)).max() < 1e-9 * scale
    assert (schedule.at(0.0), schedule.at(0.0, 1)) == (5.0, 0.0)
    assert schedule.knots[-1] == 1.003


def test_a_longer_run_has_the_same_noise_at_its_start():
    short, long = noise().schedule(0.5), noise().schedule(7.0)
    count = len(short.coefficients) - 1
    assert short.coefficients[:count].tobytes() == long.coefficients[:count].tobytes()


def test_deviation_and_band():
    """At the knots the deviation is that of the sheet; a fifth above the band little is left."""
    schedule = noise(mean=0.0).schedule(400.0)
    values = schedule.at(schedule.knots[1:-1])
    assert values.std() == pytest.approx(2.0, rel=4 / np.sqrt(2 * len(values)))
    assert abs(values.mean()) < 4 * 2.0 / np.sqrt(len(values))
    fine = schedule.at(np.arange(0, 400.0, 1e-3))
    power = np.abs(np.fft.rfft(fine)) ** 2
    hertz = np.fft.rfftfreq(len(fine), 1e-3)
    assert power[hertz > 100.0].sum() < 0.02 * power.sum()
    assert power[hertz < 50.0].sum() > 0.8 * power.sum()


def test_normal_numbers():
    """Moments, independence of neighbours, and a stream that stays (the first numbers, written down)."""
    x = normal_numbers(11, 40_000)
    assert [x.mean(), (x**2).mean(), (x**3).mean(), (x**4).mean()] == pytest.approx([0, 1, 0, 3], abs=0.13)
    assert abs(np.corrcoef(x[1:], x[:-1])[0, 1]) < 0.02
    assert normal_numbers(11, 7).tolist() == x[:7].tolist()
    assert normal_numbers(0, 3) == pytest.approx(FIRST, abs=1e-15)


FIRST = [-0.11777673202953289, 0.9424543399096111, 2.5141597827479694]


def test_what_is_refused():
    with pytest.raises(InputError, match="at most"):
        noise(frequency=1e5).schedule(10.0)
    for wrong in ({"seed": -1}, {"seed": 0.5}, {"deviation": -1.0}, {"frequency": 0.0}):
        with pytest.raises(ValidationError):
            noise(**wrong)


def test_each_lane_has_a_seed_of_its_own():
    """Noise on the load: the lane is the run of its sheet, the same seed gives the same bytes, another does not."""
    shaken = {
        "point": "tip",
        "frame": "world",
        "force": [1.0, 0.0, 0.0],
        "signal": noise(mean=0.0).model_dump(mode="json"),
    }
    integration = {"duration": 0.2, "output_step": 0.01}
    sheet = pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(2.0), loads=[shaken], integration=integration)
    seeds = [1, 2, 1, 7, 8, 9, 10, 11, 12]
    batch = tmodes.simulate_batch(sheet, {"loads.0.signal.seed": seeds})
    assert batch.finished.all()
    assert batch.states[0].tobytes() == batch.states[2].tobytes()
    assert np.abs(batch.states[0] - batch.states[1]).max() > 1e-4
    run = simulate_motion(sheet.with_({"loads.0.signal.seed": 12}))
    assert np.abs(batch.states[8, :, : len(run.coordinates)] - run.q).max() < 1e-12


def shaken_robot(**noise):
    """The paper's robot over 50 ms, its controller with noise on what is wanted."""
    changes = {"integration.duration": 0.05, "integration.output_step": 1e-3}
    return tmodes.load("filipovic2010").with_(changes | {f"reference.noise.{name}": x for name, x in noise.items()})


def test_noise_on_the_wanted_angle_of_the_robot():
    """The controller hears the move with the signal of the same numbers on it; the plan has none."""
    robot = shaken_robot(deviation=1e-4, frequency=200.0, seed=5)
    shaken, still = tmodes.run(robot).data, tmodes.run(shaken_robot()).data
    signal = Noise(type="noise", deviation=1e-4, frequency=200.0, seed=5).schedule(0.05)
    law, times = robot.drives[0].controller, shaken["time"].values
    apart = [(shaken[name] - still[name]).sel(coordinate="joint.motor").values for name in ("q", "v")]
    heard = law.position_gain * (signal.at(times) - apart[0]) + law.velocity_gain * (signal.at(times, 1) - apart[1])
    voltage = (shaken["voltage"] - still["voltage"]).sel(drive="joint").values
    assert np.abs(voltage - heard).max() < 1e-13
    assert np.abs(heard).max() > 0.1
    assert shaken["q_nominal"].equals(still["q_nominal"])
    assert np.abs(shaken["q"] - still["q"]).max() > 1e-6
    assert np.abs(shaken["energy_balance"]).max() < 1e-6 * np.abs(shaken["work"]).max()


def test_each_lane_of_the_robot_has_a_seed_of_its_own():
    robot = shaken_robot(deviation=1e-4)
    batch = tmodes.simulate_batch(robot, {"reference.noise.seed": [1, 2, 1, 7, 8, 9, 10, 11, 12]})
    assert batch.finished.all()
    assert batch.states[0].tobytes() == batch.states[2].tobytes()
    assert np.abs(batch.states[0] - batch.states[1]).max() > 1e-4
    run = simulate_motion(robot.with_({"reference.noise.seed": 12})).q
    assert np.abs(batch.states[8, :, : run.shape[1]] - run).max() < 1e-12


def test_noise_that_wants_too_many_pieces_is_refused_at_once():
    robot = shaken_robot(deviation=1e-4, frequency=1e9)
    for run in (lambda: tmodes.run(robot), lambda: tmodes.simulate_batch(robot, {"payload.mass": [0.5]})):
        with pytest.raises(InputError, match="at most"):
            run()
