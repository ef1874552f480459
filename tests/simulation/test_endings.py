"""Each way in which a run can end says what it is: status, time, coordinate, likely cause, fix."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm
from tmodes.compile.loops.time_loop import Status
from tmodes.result.record import STATUSES
from tmodes.sheet import Robot
from tmodes.simulation.parts import LostRun
from tmodes.simulation.simulate import simulate_motion

G = 9.81


def bouncing(height: float, damping_ratio: float, **integration: Any) -> Robot:
    """A gram that falls from a height onto a surface of 1e12 N/m, which takes 0.16 per cent of its speed each time."""
    stiffness, mass = 1e12, 1e-3
    contact = {"point": "tip", "shape": {"type": "plane", "normal": [0, 0, 1], "position": [0, 0, 0]},
               "law": "unilateral", "stiffness": stiffness,
               "damping": 2 * damping_ratio * float(np.sqrt(stiffness * mass))}  # fmt: skip
    return arm(
        gravity=[0, 0, -G], links=[{"name": "ball", "bodies": [{"name": "load", "mass": mass}]}], tip={"link": "ball"},
        joints=[{"name": "slide", "type": "prismatic", "parent": "base", "child": "ball", "axis": [0, 0, 1]}],
        drives=[{"joint": "slide", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
        contact=contact, initial={"state": "zero", "coordinates": {"slide": height}},
        integration={"duration": 0.02, "output_step": 2e-4, "relative_tolerance": 1e-8, "absolute_tolerance": 1e-16,
                     **integration},
    )  # fmt: skip


@pytest.mark.parametrize("method", ["dormand_prince", "dop853"])
def test_a_bounce_whose_period_shrinks_chatters(method: str) -> None:
    """Zeno's bounce, with the limits as they are: restitution exp(-pi zeta), so that all bounces end at a known time.

    Flights of 2 v e^n / g sum up to it, with a half swing on the spring for each; the run ends a little before.
    """
    height, ratio = 1e-9, 5e-4
    run = simulate_motion(bouncing(height, ratio, method=method))
    e, first = np.exp(-np.pi * ratio), np.sqrt(2 * height / G)
    zeno = first * (1 + 2 * e / (1 - e))
    assert run.status == "chattering"
    changes = run.statistics["contact_changes"]
    touching = changes / 2 * np.pi * np.sqrt(1e-3 / 1e12)
    stopped = float(run.message.partition("t = ")[2].partition(" s")[0])
    assert 0 < zeno + touching - stopped < 1.2e-3
    # Period n is e^n times the first, so the changes so far show how near the end is.
    assert stopped - touching == pytest.approx(first * (1 + 2 * e * (1 - e ** (changes / 2)) / (1 - e)), rel=2e-2)
    for words in ("more than 1000 times within 0.001 s", "period shrinks", "give the surface damping"):
        assert words in run.message
    assert np.isfinite(run.states).all()
    assert run.times[-1] <= stopped


def test_a_bounce_that_comes_to_rest_does_not_chatter() -> None:
    """The same with a damping at which a few bounces are left: it ends as any other motion, at rest on the surface."""
    run = simulate_motion(bouncing(1e-9, 0.05, method="extrapolation", duration=2e-3, output_step=2e-5))
    assert run.status == "finished"
    assert run.statistics["contact_changes"] < 100
    assert run.contact_normal is not None
    assert run.contact_normal[-1] == pytest.approx(1e-3 * G, rel=2e-2)


@pytest.mark.parametrize(
    ("status", "acceleration", "named", "words"),
    [(Status.DIVERGED, 1e12, "diverged", "next step leaves 1e+08"),
     (Status.STEP_TOO_SMALL, np.nan, "diverged", "no number"),
     (Status.STEP_TOO_SMALL, 12.0, "step_too_small", "raise integration.relative_tolerance"),
     (Status.STEP_TOO_SMALL, 1e9, "diverged", "no step is small enough"),
     (Status.NOT_CONVERGED, 1e9, "diverged", "do not converge"),
     (Status.NOT_CONVERGED, 12.0, "not_converged", "shorten integration.step")],
)  # fmt: skip
def test_what_was_lost_is_named(status: Status, acceleration: float, named: str, words: str) -> None:
    """The status is one that results know; time, coordinate and value are reported, then what to do."""
    lost = LostRun(0.25, 1e-3, np.array([1.0, acceleration, 2.0]), ("a", "b", "c"), 1e8)
    info, message = lost.info(status)
    assert info == named
    assert info in STATUSES
    assert "at t = 0.25 s in coordinate b" in message
    assert words in message
