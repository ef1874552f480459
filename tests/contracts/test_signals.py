"""What every signal keeps, those of a user's script among them: a cosine is defined here."""

from __future__ import annotations

from typing import Literal

import numpy as np
import pytest
from pydantic import Field

from simulation.sheets import arm
from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import any_sign, positive
from tmodes.kinds.signals.fit import fitted
from tmodes.kinds.signals.registry import SIGNALS, Signal
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.simulate import simulate_motion


@SIGNALS.register
class Cosine(Signal):
    """amplitude cos(2 pi frequency t)."""

    type: Literal["cosine"] = Field(description="kind of signal")
    amplitude: float = any_sign("signal", "A", "amplitude")
    frequency: float = positive("Hz", "f", "frequency")

    def pieces(self, until: float) -> SignalPieces:
        """Pieces of polynomials, exact to 1e-12."""
        return fitted(lambda t: self.amplitude * np.cos(2 * np.pi * self.frequency * t), until, "frequency")


MOVE = {"start": 0.1, "end": 0.4, "duration": 0.5}
EXAMPLES = {
    "brake": {"torque": 2.0, "engaged_until": 0.3, "engage_at": 0.6, "release_delay": 0.05},
    "constant": {"value": 0.3},
    "step": {"start": 0.0, "end": 1.0, "time": 0.4},
    "trapezoid": MOVE | {"ramp_fraction": 0.2, "delay": 0.1},
    "quintic": MOVE,
    "trajectory": {
        "times": [0.0, 0.2, 0.5, 0.5, 0.7],
        "positions": [0.1, 0.2, 0.3, 0.3, 0.4],
        "velocities": [0.0, 0.5, 0.4, 0.4, 0.0],
        "accelerations": [0.0, 1.0, 0.0, 1.0, 0.0],
    },
    "septic": MOVE | {"delay": 0.2},
    "sine_squared": MOVE,
    "polynomial": MOVE | {"smooth": 3, "delay": 0.1},
    "s_curve": {"start": 0.1, "end": 0.4, "speed": 1.0, "acceleration": 5.0, "jerk": 60.0},
    "shaped": {"signal": {"type": "quintic", **MOVE}, "shaper": {"type": "zv", "frequencies": [7.0], "damping": [0.1]}},
    "sine": {"amplitude": 0.2, "frequency": 2.0},
    "table": {"times": [0.0, 0.5, 0.5, 1.0], "values": [0.0, 1.0, 2.0, 0.0], "interpolation": "linear"},
    "expression": {"formula": "0.2*sin(3*t)*exp(-t)"},
    "noise": {"deviation": 0.1, "frequency": 20.0, "seed": 1},
    "sum": {
        "signals": [{"type": "quintic", **MOVE}, {"type": "noise", "deviation": 0.01, "frequency": 9.0, "seed": 3}]
    },
    "cosine": {"amplitude": 0.2, "frequency": 1.5},
}
"""One of each signal; one without an entry fails."""


@pytest.mark.parametrize("name", sorted(SIGNALS))
def test_signal(name):
    """From 0 to the end asked for; a longer one begins the same; finite; ends where its move ends."""
    signal = Signal.of({"type": name, **EXAMPLES[name]})
    short, long = signal.schedule(1.0), signal.schedule(2.5)
    assert (short.knots[0], short.knots[-1], long.knots[-1]) == (0.0, 1.0, 2.5)
    assert (np.diff(short.knots) > 0).all()
    times = np.linspace(0, 0.999, 400)
    scale = np.abs(long.at(times)).max()
    np.testing.assert_allclose(short.at(times), long.at(times), atol=1e-11 * scale, rtol=0)
    assert np.isfinite(long.coefficients).all()
    assert signal.is_steady == (np.abs(np.diff(long.at(times), 2)).max() <= 1e-12 * scale)
    assert Signal.of(signal.model_dump()) == signal
    end = signal.move_ends()
    if ("end" in EXAMPLES[name] and name != "step") or name == "shaped":
        assert end is not None
        assert long.at([end, 2.5]).tolist() == pytest.approx([0.4, 0.4])
        assert signal.move_ends(2.0) == pytest.approx(end + (signal.length() if name == "s_curve" else 0.5))


@pytest.mark.parametrize("name", sorted(SIGNALS))
def test_any_signal_starts_later(name):
    """Its first value, then the same; a signal with a jump, or a rate, at its start is steady no more."""
    signal = Signal.of({"type": name, **EXAMPLES[name]})
    late = signal.model_copy(update={"delay": signal.delay + 0.37})
    before, after = signal.schedule(2.0), late.schedule(2.0)
    times = np.linspace(0.0, 1.6, 321)
    same = np.abs(before.knots[:, None] - times).min(axis=0) > 1e-9
    scale = max(1.0, np.abs(before.at(times)).max())
    assert after.at(times[same] + 0.37) == pytest.approx(before.at(times[same]), abs=1e-11 * scale)
    assert after.at(np.linspace(0, 0.369, 9)) == pytest.approx(float(before.at(0.0)), abs=1e-15)
    assert late.move_ends() == (None if signal.move_ends() is None else pytest.approx(signal.move_ends() + 0.37))
    assert not late.is_steady


def test_a_kind_with_its_own_schedule_is_refused():
    """It would lose the delay."""
    with pytest.raises(InputError, match="a method `pieces`"):
        type("Old", (Signal,), {"schedule": Cosine.pieces})


def test_sum_is_the_sum():
    times = np.linspace(0, 1, 301)
    whole = Signal.of({"type": "sum", **EXAMPLES["sum"]}).schedule(1.0).at(times)
    parts = sum(Signal.of(part).schedule(1.0).at(times) for part in EXAMPLES["sum"]["signals"])
    assert np.abs(whole - parts).max() < 1e-14


def test_a_signal_from_outside_moves_a_robot():
    """A torque A cos(w t) on an inertia J: angle A (1 - cos(w t))/(J w^2)."""
    joint = {
        "name": "j",
        "type": "revolute",
        "child": "l",
        "axis": [0, 0, 1],
        "motor": {"inertia": 0.5, "side": "joint"},
    }
    sheet = arm(
        gravity=0.0, joints=[joint], links=[{"name": "l"}],
        drives=[{"joint": "j", "command": "torque", "signal": {"type": "cosine", "amplitude": 0.2, "frequency": 1.5}}],
        integration={"duration": 1.0, "relative_tolerance": 1e-11, "absolute_tolerance": 1e-12},
    )  # fmt: skip
    run, rate = simulate_motion(sheet), 2 * np.pi * 1.5
    assert run.q[:, 0] == pytest.approx(0.2 * (1 - np.cos(rate * run.times)) / (0.5 * rate**2), abs=1e-9)
