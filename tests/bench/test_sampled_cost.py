"""What control at samples costs, in numbers of evaluations, which no busy machine changes."""

from __future__ import annotations

import numpy as np
from benchmarks.sampled import controlled

from tmodes.robots.load import load
from tmodes.simulation.simulate import simulate_motion


def test_a_law_at_1_khz_takes_at_most_twice_the_evaluations_of_motors_that_follow_exactly() -> None:
    """Six axes, LQG from encoders with noise, resolution and limits: a step of most samples, seven evaluations."""
    robots = dict(controlled("manutec_r3"))
    free, law = (simulate_motion(robots[name]) for name in ("motors follow exactly", "LQG at 1 kHz, noise, limits"))
    assert free.status == law.status == "finished"
    assert law.statistics["evaluations"] < 8 * 2000 < 2 * free.statistics["evaluations"]


def test_stiff_arms_take_samples_by_few_rows() -> None:
    """Five passes of most steps in place of nine, within the tolerance of the coordinates."""
    arm = load("two_link_arm").with_({"integration.duration": 0.5, "integration.method": "extrapolation"})
    sampled = arm.with_({f"drives.{k}.sample_time": 1e-3 for k in range(2)})
    run = simulate_motion(sampled)
    exact = simulate_motion(
        sampled.with_({"integration.relative_tolerance": 1e-10, "integration.absolute_tolerance": 1e-12})
    )
    assert run.statistics["steps"] < 1.02 * 500
    assert run.statistics["passes"] < 6.5 * run.statistics["steps"]
    assert np.abs(run.q - exact.q).max() < 1e-7
    assert simulate_motion(arm).statistics["passes"] % 9 == 0
