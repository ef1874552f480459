"""What every shaper keeps, one of a user's script among them; reference values; robots that a shaped move leaves."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import Field

import tmodes
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.shapers.registry import SHAPERS, Impulses, Shaper, residual
from tmodes.kinds.signals.registry import Signal

DATA = Path(__file__).parents[1] / "sheet" / "data" / "shaping.json"
REFERENCES = json.loads(DATA.read_text(encoding="utf-8"))
"""Reference values computed with closed forms to 40 digits, and checked by a matrix exponential and by DOP853."""

RATIOS = np.linspace(0.7, 1.3, 21)


@SHAPERS.register
class Thirds(Shaper):
    """Three equal impulses a third of a period apart, for modes without damping."""

    type: Literal["thirds"] = Field(description="kind of shaper")

    def of_mode(self, damping: Any) -> Impulses:
        """Their phasors close a triangle."""
        return Impulses(np.array([0.0, 1 / 3, 2 / 3]), np.full(3, 1 / 3))


EXAMPLES = {name: {} for name in ("zv", "zvd", "zvdd", "ei", "thirds")}
"""One of each shaper; one without an entry fails."""


def shaper(name: str, *frequencies: float, damping: Any = ()) -> Shaper:
    return Shaper.of({"type": name, "frequencies": frequencies, "damping": damping, **EXAMPLES[name]})


@pytest.mark.parametrize("name", sorted(SHAPERS))
def test_shaper(name: str) -> None:
    """Its copies add up to the motion; without damping little or nothing is left at the frequency; modes compose."""
    one = shaper(name, 2.0)
    times, sizes = one.impulses()
    assert sizes.sum() == pytest.approx(1.0, abs=1e-14)
    assert (times[0], times[-1]) == (0.0, one.delay)
    assert (np.diff(times) > 0).all()
    assert (sizes > 0).all()
    left = residual((times, sizes), 2.0)
    assert left == pytest.approx(0.05 if name == "ei" else 0.0, abs=1e-14)
    assert Shaper.of(one.model_dump()) == one
    both = shaper(name, 2.0, 5.3).impulses()
    other = residual(shaper(name, 5.3).impulses(), [2.0, 5.3])
    assert residual(both, [2.0, 5.3]) == pytest.approx(residual((times, sizes), [2.0, 5.3]) * other, abs=1e-14)


@pytest.mark.parametrize("name", [name for name in REFERENCES if name.startswith("j1")])
def test_reference_values(name: str) -> None:
    case = REFERENCES[name]
    frequencies, damping = np.atleast_1d(case["f_Hz"]), np.atleast_1d(case["zeta"])
    found = shaper(case.get("kind", "zv").lower(), *frequencies.tolist(), damping=tuple(damping.tolist())).impulses()
    order = np.argsort(found.times)
    assert found.times[order] == pytest.approx(np.array(case["times"]), abs=1e-9)
    assert found.amplitudes[order] == pytest.approx(np.array(case["amplitudes"]), abs=1e-9)
    for mode, key in enumerate(
        ["residual_percent"] if "kind" in case else [f"residual_percent_mode{k}" for k in (1, 2)]
    ):
        left = 100 * residual(found, frequencies[mode] * RATIOS, damping[mode])
        assert left == pytest.approx(np.array(case[key]), abs=1e-6)


@given(st.floats(0.01, 1e3), st.floats(0, 0.9), st.sampled_from(["zv", "zvd", "zvdd"]))
@settings(max_examples=100, deadline=None)
def test_zero_vibration_of_any_damped_mode(frequency, damping, name) -> None:
    """And zero slope, zero curvature, of the residual by the frequency of the plant."""
    found = shaper(name, frequency, damping=(damping,)).impulses()
    assert found.amplitudes.sum() == pytest.approx(1, abs=1e-14)
    assert residual(found, frequency, damping) < 1e-12
    power = len(found.times) - 1
    near = [residual(found, frequency * (1 + h), damping) for h in (1e-3, 2e-3)]
    assert near[1] == pytest.approx(near[0] * 2**power, rel=2e-2)


@given(st.floats(0, 0.5), st.floats(0.005, 0.3))
@settings(max_examples=60, deadline=None)
def test_an_extra_insensitive_shaper_is_exact(damping, tolerated) -> None:
    """The tolerated residual at the frequency, zeros on both sides of it, and more width than ZVD."""
    try:
        given = {"type": "ei", "frequencies": [1.0], "damping": [damping], "tolerated": tolerated}
        found = Shaper.of(given).impulses()
    except InputError:
        assert damping + tolerated > 0.4
        return
    assert residual(found, 1.0, damping) == pytest.approx(tolerated, abs=1e-9)
    ratios = np.linspace(0.3, 2.2, 4001)
    left = residual(found, ratios, damping)
    assert min(left[ratios < 1].min(), 1) < 1e-3
    assert min(left[ratios > 1].min(), 1) < 1e-3
    if damping < 0.3:
        flat = residual(shaper("zvd", 1.0, damping=(damping,)).impulses(), ratios, damping)
        assert (left <= tolerated * (1 + 1e-6)).sum() > (flat <= tolerated).sum()


def test_what_no_mode_has_is_refused() -> None:
    with pytest.raises(InputError, match=r"damping ratio of 0\.8"):
        shaper("ei", 1.0, damping=(0.8,)).impulses()
    move = {"type": "quintic", "start": 0.0, "end": 1.0, "duration": 1.0}
    own = {"type": "shaped", "signal": move, "shaper": {"type": "zv", "frequencies": [1.0], "damping": [0.1, 0.2]}}
    with pytest.raises(InputErrors, match="1 damping ratios, one for each frequency"):
        tmodes.load("spong1987").with_({"drives.0.signal": own})
    wrong = own | {"shaper": {"type": "zw", "frequencies": [1.0]}}
    with pytest.raises(InputErrors, match="zw"):
        tmodes.load("spong1987").with_({"drives.0.signal": wrong})
    slow = own | {"shaper": {"type": "zv", "frequencies": [1e-9]}}
    with pytest.raises(InputErrors) as caught:
        tmodes.load("spong1987").with_({"drives.0.signal": slow})
    assert caught.value.errors[0].which == "drives.0.signal.shaper.frequencies.0"


@given(st.lists(st.floats(0.5, 9.0), min_size=1, max_size=2), st.sampled_from(sorted(EXAMPLES)), st.floats(0, 2))
@settings(max_examples=40, deadline=None)
def test_a_shaped_signal_is_the_sum_of_its_copies(frequencies, name, delay) -> None:
    inner = {"type": "s_curve", "start": 0.2, "end": 1.0, "speed": 1.0, "acceleration": 4.0, "jerk": 50.0}
    own = {"type": name, "frequencies": frequencies}
    whole = Signal.of({"type": "shaped", "signal": inner, "shaper": own, "delay": delay})
    one, pieces, times = Signal.of(inner).schedule(20.0), whole.schedule(20.0), np.linspace(0, 20, 3234)
    copies = zip(*Shaper.of(own).impulses(), strict=True)
    exact = sum(size * one.at(np.maximum(times - delay - time, 0.0)) for time, size in copies)
    assert pieces.at(times) == pytest.approx(exact, abs=1e-12)
    assert pieces.at([whole.move_ends(), 20.0]) == pytest.approx(1.0, abs=1e-12)


MOVES = {
    "trapezoid": lambda m: {"type": "trapezoid", "speed": m["v"], "acceleration": m["a"]},
    "scurve": lambda m: {"type": "s_curve", "speed": m["v"], "acceleration": m["a"], "jerk": m["j"]},
    "quintic": lambda m: {"type": "quintic", "duration": m["T"]},
    "septic": lambda m: {"type": "septic", "duration": m["T"]},
    "sine2": lambda m: {"type": "sine_squared", "duration": m["T"]},
}


def slide(signal: dict, frequency: float, damping: float, duration: float) -> tmodes.Robot:
    """A mass of 2 kg behind a spring and a damper whose other end moves as the signal says: an exact oscillator."""
    omega = 2 * np.pi * frequency
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "slide", "gravity": 0,
        "joints": [{"name": "x", "type": "prismatic", "child": "car", "axis": [1, 0, 0],
                    "motor": {"inertia": 1.0, "side": "joint"},
                    "gear": {"stiffness": 2 * omega**2, "damping": 4 * damping * omega}}],
        "links": [{"name": "car", "bodies": [{"name": "body", "mass": 2.0, "center": [0, 0, 0]}]}],
        "drives": [{"joint": "x", "command": "prescribed", "signal": signal}],
        "integration": {"duration": duration, "output_step": 0.02, "relative_tolerance": 1e-11,
                        "absolute_tolerance": 1e-13}})  # fmt: skip


def left_over(robot: tmodes.Robot, frequency: float, damping: float) -> float:
    """Amplitude of the oscillator at the end of the run [m]."""
    data, omega = robot.run(error_estimate=False).data, 2 * np.pi * frequency
    (e, rate) = (float(data[name][-1, 1] - data[name][-1, 0]) for name in ("q", "v"))
    return float(np.hypot(e, (rate + damping * omega * e) / (omega * np.sqrt(1 - damping**2))))


@pytest.mark.parametrize("name", [name for name in REFERENCES if name[:2] in ("j2", "j3")])
def test_residual_and_settling_of_reference_moves(name: str) -> None:
    case = REFERENCES[name]
    (mode,) = case["modes"]
    signal = {"start": 0.0, "end": case["move"]["D"], **MOVES[case["move"]["kind"]](case["move"])}
    if "shaper" in case:
        own = case["shaper"]
        made = {"type": own["kind"].lower(), "frequencies": [own["f_Hz"]], "damping": [own["zeta"]]}
        signal = {"type": "shaped", "signal": signal, "shaper": made}
    assert Signal.of(signal).move_ends() == pytest.approx(case["T_end"], abs=1e-9)
    robot = slide(signal, mode["f_Hz"], mode["zeta"], case["T_end"])
    left = left_over(robot, mode["f_Hz"], mode["zeta"])
    assert left == pytest.approx(case["residual_amplitude"], abs=1e-8 * case["move"]["D"])
    robot = robot.with_({"integration.duration": case["T_end"] + 0.5})
    for share, wanted in ((0.02, case["t_settle_2_percent"]), (0.05, case["t_settle_5_percent"])):
        found = robot.run(settling_band=share, error_estimate=False).summary()["settling"]["time_s"]
        assert found == pytest.approx(max(wanted - case["T_end"], 0.0), abs=2e-4)
