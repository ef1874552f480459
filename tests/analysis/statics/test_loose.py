"""Robots of which a joint is loose: they sink to where they hang, or it is said, once, that they do not."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmodes.analysis.statics import at_rest
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.errors import SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup

GRAVITY = 9.81
BODY = {"mass": 1.0, "center": [0.4, 0, 0], "inertia": {"xx": 0.1, "yy": 0.1, "zz": 0.1}}


def arm(second: dict[str, Any], stiffness: float = 500.0, state: str = "zero", **start: float) -> Robot:
    """A motor at rest at 0.5 rad, an elastic gear, a link, and on its end another joint, which nothing drives."""
    first = {
        "name": "a",
        "type": "revolute",
        "axis": [0, 1, 0],
        "parent": "base",
        "child": "upper",
        "motor": {"inertia": 0.1, "side": "joint"},
        "gear": {"stiffness": stiffness, "damping": 1.0},
    }
    place = {"from": "frame", "origin": {"position": [0.5, 0, 0]}}
    second = {"name": "b", "parent": "upper", "child": "lower", "state": "free", **place} | second
    still = {"type": "quintic", "start": 0.5, "end": 0.5, "duration": 1.0}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "loose", "joints": [first, second], "gravity": GRAVITY,
        "links": [{"name": name, "bodies": [{"name": "body", **BODY}]} for name in ("upper", "lower")],
        "tip": {"link": "lower"},
        "drives": [{"joint": "a", "command": "position", "signal": still,
                    "controller": {"type": "pd", "position_gain": 100.0, "velocity_gain": 10.0}}],
        "initial": {"state": state, "coordinates": start},
        "integration": {"duration": 1.0, "output_step": 0.1},
    })  # fmt: skip


TURN = {"type": "revolute", "axis": [0, 1, 0]}
SLIDE = {"type": "prismatic", "axis": [0, 0, 1]}


@settings(max_examples=25)
@given(start=st.floats(-1.4, 4.5), gear=st.floats(-0.3, 0.3), stiffness=st.floats(50.0, 1e6))
def test_what_hangs_behind_a_gear_sinks_to_where_it_hangs(start, gear, stiffness):
    """Straight down, whatever the gear does meanwhile; the gear carries both bodies' weight there.

    From within a half turn of there, so that upright, where it balances, is not passed.
    """
    rest = robot_rest(arm(TURN, stiffness, a=0.5 + gear, b=start - 0.5 - gear))
    motor, first, second = rest.q
    assert rest.stable
    assert motor == 0.5
    assert first + second == pytest.approx(np.pi / 2, abs=1e-9)
    moment = GRAVITY * (0.4 + 0.5) * np.cos(first)  # of its own body, and of what hangs on its end
    assert stiffness * (first - motor) == pytest.approx(moment, rel=1e-9)


def test_what_falls_has_no_rest_which_is_found_out_once(monkeypatch):
    at_rest._solved.clear()
    asked = []
    own = at_rest.equilibrium

    def counting(*given: Any, **named: Any) -> Any:
        asked.append(named)
        return own(*given, **named)

    monkeypatch.setattr(at_rest, "equilibrium", counting)
    for _ in range(3):
        with pytest.raises(SimulationError, match="coordinate b has no spring and does not come to rest; hold it"):
            robot_rest(arm(SLIDE))
    assert len(asked) == 1


def test_a_run_that_is_to_start_at_rest_says_so_before_it_starts():
    with pytest.raises(SimulationError, match="static equilibrium: coordinate b has no spring"):
        run_setup(arm(SLIDE, state="rest"))
    rest = run_setup(arm(TURN, state="rest")).rest
    assert rest is not None
    assert rest.stable
