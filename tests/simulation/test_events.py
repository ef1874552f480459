"""What happened in a run at instants: contacts, dry friction, gears with play, limits, conditions; and in its file."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from command import tmodes
from simulation.sheets import arm
from simulation.test_landing import falling
from simulation.test_play import geared, hanging
from simulation.test_sticking import block
from tmodes.result import Result
from tmodes.result.run import run
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.parts import Journal

METHODS = ["dormand_prince", "dop853", "rosenbrock", "rk4"]


def shaken(**more: Any) -> Robot:
    """A block of 1 kg under 5 N at 1 Hz on dry friction of 4 N at rest and 3 N in motion."""
    signal = {"type": "sine", "amplitude": 5.0, "frequency": 1.0}
    chosen = {"duration": 3.0, "output_step": 0.05, **more}
    return block(1.0, {"coulomb": 3.0, "static_extra": 1.0}, signal=signal, integration=chosen)


SWITCHES = [0.14758361765043326, 0.5558382383054372, 0.6475836176504333, 1.0558382383054372, 1.1475836176504333,
            1.5558382383054372, 1.6475836176504333, 2.055838238305437, 2.1475836176504335, 2.555838238305437,
            2.6475836176504335]  # fmt: skip
"""Reference values computed with closed forms in pieces: it slips, sticks, slips back, and so on."""


@pytest.mark.parametrize("method", METHODS)
def test_stick_and_slip(method: str) -> None:
    found = run(shaken(method=method, step=1e-3)).events
    assert [event.time for event in found] == pytest.approx(SWITCHES, abs=1e-6)
    assert [event.kind for event in found] == (["slip", "stick"] * 6)[:11]
    assert [event.direction for event in found] == ([1, 0, -1, 0] * 3)[:11]
    assert {(event.place, event.unit) for event in found} == {("x", "m/s")}
    assert max(event.speed or 0.0 for event in found) < 1e-5


def test_touch_and_release_of_a_light_plate() -> None:
    """Reference values computed with closed forms in pieces."""
    plate = {"mass": 0.05, "stiffness": 8000.0, "damping": 6.0}
    found = run(falling(0.05, 1.5, plate, duration=0.72, output_step=0.05)).events
    assert [event.kind for event in found] == (["touch", "release"] * 4)[:7]
    times = [0.10096375546923045, 0.14804083169448412, 0.3253622809487971, 0.3730208533277815, 0.5277621533369429,
             0.5760981095519455, 0.7106672500617182]  # fmt: skip
    speeds = [0.9904544411531507, 0.8731090460262102, 0.8664276625331447, 0.7623034946221209, 0.7556956545623501,
              0.663304527394954, 0.6566202105344194]  # fmt: skip
    assert [event.time for event in found] == pytest.approx(times, abs=1e-7)
    assert [event.speed for event in found] == pytest.approx(speeds, abs=1e-6)


def test_a_floor_without_mass_and_one_that_gives_speed_back() -> None:
    """Touch after free fall, half of a swing later release; bounces by the restitution."""
    speed, rate = math.sqrt(2 * 9.81 * 0.1), math.sqrt(2e4)
    soft = run(falling(0.1, 1.0, {"stiffness": 2e4, "damping": 0.0}, duration=0.2, output_step=0.01)).events
    pressed = (2 * math.pi - 2 * math.atan2(speed * rate, 9.81)) / rate
    assert [(event.kind, event.place) for event in soft] == [("touch", "contact"), ("release", "contact")]
    assert soft[0].time == pytest.approx(speed / 9.81, abs=1e-9)
    assert soft[1].time - soft[0].time == pytest.approx(pressed, abs=1e-7)
    assert [event.speed for event in soft] == pytest.approx([speed, speed], rel=1e-6)
    heavy = {"mass": 1e9, "stiffness": 1e9, "damping": 0.0, "restitution": 0.5}
    bounces = run(falling(0.1, 1.0, heavy, duration=0.36, output_step=0.01)).events
    assert [event.kind for event in bounces] == ["touch"] * 3
    assert [event.speed for event in bounces] == pytest.approx([speed, speed / 2, speed / 4], rel=1e-6)


def test_a_point_that_sticks_on_a_belt() -> None:
    """Held by 100 N/m on a belt of 0.05 m/s under 20 N: it slips at 2.4 s, and sticks where it has the belt's speed."""
    belt = {"law": "unilateral", "stiffness": 1e6, "damping": 0.0, "friction": 0.4, "static_friction": 0.6,
            "velocity": [0.05, 0, 0],
            "shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}}  # fmt: skip
    found = run(arm(
        gravity=9.81, contact=belt,
        joints=[{"name": "x", "type": "prismatic", "child": "a", "axis": [1, 0, 0], "state": "locked",
                 "gear": {"stiffness": 100.0, "damping": 0.0}},
                {"name": "z", "type": "prismatic", "child": "b", "axis": [0, 0, 1], "state": "free"}],
        links=[{"name": "a"}, {"name": "b", "bodies": [{"name": "m", "mass": 20 / 9.81}]}],
        tip={"link": "b", "position": [0, 0, 0]}, integration={"duration": 3.2, "output_step": 0.1},
        initial={"state": "zero", "coordinates": {"z": -2e-5}, "rates": {"x": 0.05}},
    )).events  # fmt: skip
    swing = math.sqrt(100 * 9.81 / 20)
    seconds = 2 * (math.pi - math.atan2(0.04 * swing, 0.05)) / swing
    assert [(event.kind, event.place) for event in found] == [("slip", "contact"), ("stick", "contact")]
    slip, stick = (event.time for event in found)
    assert slip == pytest.approx(2.4, abs=1e-6)
    assert stick - slip == pytest.approx(seconds, abs=1e-6)


def test_teeth_of_a_gear() -> None:
    gear = {"stiffness": 1000.0, "damping": 1.0, "backlash": 0.1}
    first, then = run(geared(gear, duration=0.2, output_step=1e-2)).events
    assert (first.kind, first.place, first.unit, first.direction) == ("engage", "j.gear", "rad/s", 1)
    assert first.time == pytest.approx(0.1, abs=1e-9)
    assert first.speed == pytest.approx(1.0, abs=1e-7)
    assert (then.kind, then.place) == ("disengage", "j.gear")
    back = run(geared(gear, rate=-1.0, duration=0.2, output_step=1e-2)).events
    assert [event.direction for event in back] == [-1, -1]
    assert [event.time for event in back] == pytest.approx([first.time, then.time], abs=1e-9)


def test_limits_and_the_end_by_a_condition() -> None:
    """A mass that falls from 0.1 m past its lower limit; the run ends at 2 m/s."""
    sheet = falling(0.1, 1.0, {"stiffness": 1e-3, "damping": 0.0}, duration=1.0, output_step=0.01)
    sheet = sheet.with_({"joints.z.limits": {"lower": 0.05}, "contact": None, "integration.stop": ["tip.speed > 2"]})
    passed, end = run(sheet).events
    assert (passed.kind, passed.place, passed.unit, passed.direction) == ("limit", "z", "m/s", -1)
    assert passed.time == pytest.approx(math.sqrt(0.1 / 9.81), abs=1e-7)
    assert passed.speed == pytest.approx(math.sqrt(0.1 * 9.81), abs=1e-6)
    assert (end.kind, end.place, end.speed) == ("stop", "tip.speed > 2", None)
    assert end.time == pytest.approx(2 / 9.81, abs=1e-9)


class _Memory(Journal):
    """A journal in memory."""

    def __init__(self, given: dict[str, Any] | None = None) -> None:
        self.given, self.records = given, []

    def restore(self) -> dict[str, Any] | None:
        return self.given

    def keep(self, record: dict[str, Any], *, last: bool = False, now: bool = False) -> None:
        self.records.append({name: array.copy() for name, array in record.items()})


@pytest.mark.parametrize("sheet", [shaken(), hanging(1)], ids=["friction", "play"])
def test_events_change_no_bit_and_survive_what_a_run_survives(sheet: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not kept, in pieces, continued from a journal, and watched for a condition: the same samples and changes."""
    setup = run_setup(sheet).chosen()
    whole = run_trajectory(setup)
    assert whole.changes
    with monkeypatch.context() as patch:
        patch.setattr("tmodes.simulation.native_run._FIRST_PIECE", 3)
        patch.setattr("tmodes.simulation.native_run._PIECE_SECONDS", 0.0)
        journal = _Memory()
        pieces = run_trajectory(setup, journal=journal)
        resumed = run_trajectory(setup, journal=_Memory(journal.records[len(journal.records) // 2]))
    with monkeypatch.context() as patch:
        patch.setattr("tmodes.simulation.native_run.NativeRun.keep_changes", lambda self: None)
        bare = run_trajectory(setup)
    assert not bare.changes
    for other in (pieces, resumed, bare):
        assert other.states.tobytes() == whole.states.tobytes()
    for other in (pieces, resumed):
        for one, same in zip(other.changes, whole.changes, strict=True):
            assert one.time == same.time
            assert one.before.tobytes() == same.before.tobytes()
            assert one.after.tobytes() == same.after.tobytes()


def test_a_watched_run_has_the_events_before_its_end() -> None:
    every = run(shaken()).events
    until = run(shaken(stop=["x.position > 0.088"])).events
    assert until[-1].kind == "stop"
    before = [event for event in every if event.time < until[-1].time]
    assert [event.time for event in until[:-1]] == pytest.approx([event.time for event in before], abs=1e-9)


def test_too_many_events_are_cut_short_and_that_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    for place in ("native_run", "events"):
        monkeypatch.setattr(f"tmodes.simulation.{place}.MOST_CHANGES", 4)
    done = run(shaken())
    assert [event.time for event in done.events] == pytest.approx(SWITCHES[:4], abs=1e-6)
    assert any("list of events" in warning for warning in done.warnings)


def test_events_in_the_file_and_on_the_terminal(tmp_path: Path) -> None:
    done = run(shaken())
    done.save(tmp_path / "result.nc")
    read = Result.load(tmp_path / "result.nc")
    assert read.events == done.events
    assert read.data["event_time"].attrs["units"] == "s"
    assert read.data["event_kind"].values.tolist() == [event.kind for event in done.events]
    older: Any = read.data.drop_dims("event")
    assert Result(older).events == ()
    assert Result.of(older, "older").events == ()
    shown = tmodes("show", tmp_path, "--events").stdout
    assert shown.count("stick") == 5
    assert "0.147583618" in shown
    found = json.loads(tmodes("show", tmp_path, "--json").stdout)["events"]
    assert [event["time"] for event in found] == [event.time for event in done.events]
    still = run(shaken().with_({"drives.0.signal.amplitude": 1.0}))
    assert still.events == ()
    assert "event" not in still.data.dims


def test_bounces_are_listed_where_a_given_rate_jumps() -> None:
    """The jump of a given rate is no touch, and its own mode in the state is not that of the contact."""
    joint: dict[str, Any] = {"name": "p", "type": "revolute", "child": "l", "axis": [0, 0, 1], "state": "free"}
    table = {"type": "table", "times": [0, 0.2, 0.5], "values": [0, 0.5, 0.5], "interpolation": "linear"}
    plane = {"type": "plane", "position": [0, -0.03, 0], "normal": [0, 1, 0]}
    data = {
        "format": 1, "kind": "arm", "name": "x", "gravity": 0.0,
        "joints": [{"name": "h", "type": "revolute", "child": "hub", "axis": [0, 0, 1]},
                   joint | {"origin": {"position": [0.4, 0, 0]}}],
        "links": [{"name": "hub", "bodies": [{"mass": 1.0, "inertia": 0.01}]},
                  {"name": "l", "bodies": [{"mass": 1.0, "center": [0.3, 0, 0], "inertia": 0.01}]}],
        "tip": {"link": "l", "position": [0.5, 0, 0]}, "initial": {"state": "zero"},
        "contact": {"law": "unilateral", "shape": plane, "stiffness": 300.0, "damping": 0.0, "mass": 0.3,
                    "restitution": 0.9},
        "drives": [{"joint": "h", "command": "prescribed", "signal": table}],
        "integration": {"duration": 0.5, "output_step": 0.005, "error_estimate": False, "model_error": False},
    }  # fmt: skip
    found = [(event.kind, round(event.time, 4)) for event in run(Robot.from_data(data)).events]
    assert ("touch", 0.0622) in found
    assert ("touch", 0.1595) in found
    assert all(abs(time - 0.2) > 1e-6 for _, time in found)
