"""What a page computes from its sliders is what the data sheet gives for the same numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmodes.live.map as map_module
from simulation.sheets import arm
from tmodes import load
from tmodes.live.map import live_map
from tmodes.live.numbers import follow_of, run_numbers, whole_moves
from tmodes.live.sheet_numbers import sheet_numbers
from tmodes.live.sliders import MOST
from tmodes.model.parameters import STRUCTURE
from tmodes.sheet import Robot
from tmodes.simulation.loop import whole

from .chain import chain
from .node import drawn

SHEETS = (
    "filipovic2010",
    "spong1987",
    "quanser_2dsfl",
    "flexarm1990",
    "deluca_siciliano1991",
    pytest.param("manutec_r3", marks=pytest.mark.nightly),
)
REACH = 1e4
PLACES = (0.0, 0.5, 1.0)


@pytest.mark.parametrize("name", SHEETS)
def test_numbers_are_those_of_the_changed_sheet(name: str) -> None:
    """Every block of every run, at random values of all sliders at once."""
    sheet = load(name)
    live = live_map(sheet.pair(), PLACES)
    for values in drawn(live, 2, seed=3, others=0.3):
        pair = sheet.with_(live.changes(values)).pair()
        for run, of in {"reference": pair.nominal, "real": pair.real}.items():
            if not (found := live.numbers(values, run)):
                continue
            until, places = whole_moves(sheet, REACH), PLACES if run == "real" else ()
            true = run_numbers(of, follow_of(sheet, run), until, places)
            assert list(found) == list(true)
            size = np.abs(whole(true)[0]).max()
            for block, numbers in true.items():
                near = max(1e-12 * np.abs(numbers).max(initial=0.0), 1e-15 * size)
                assert found[block] == pytest.approx(numbers, rel=1e-12, abs=near), (run, block)


@pytest.mark.parametrize("name", SHEETS)
def test_every_number_has_a_slider_or_a_reason(name: str) -> None:
    """A slider that goes up or down, as far as the checks of the sheet; else it is structure, or it changes nothing."""
    sheet = load(name)
    live = live_map(sheet.pair())
    for number in sheet_numbers(sheet):
        if number.path.split(".")[0] not in STRUCTURE:
            assert number.path in live.targets or number.path in live.left_out, number.path
    for k, slider in enumerate(live.sliders):
        assert slider.low <= slider.value <= slider.high
        assert slider.low < slider.high
        assert slider.label
        assert slider.unit
        assert slider.group
        for end in {slider.low, slider.high} if k < MOST else ():
            values = [*live.start]
            values[k] = end
            assert live.holds(values), slider.path
            sheet.with_(live.changes(values)).pair()


def test_a_program_holds_where_the_sheet_does_and_its_structure() -> None:
    """Beyond the ends of what is a length, a damping or a time: refused, or of other equations."""
    sheet = load("deluca_siciliano1991")
    live = live_map(sheet.pair())
    paths = [slider.path for slider in live.sliders]
    for path, value in {
        "links.forearm.beam.length": -0.1, "links.forearm.beam.section.mass_per_length": -1.0,
        "drives.0.signal.duration": 0.0, "links.forearm.bodies.payload.mass": -0.1,
    }.items():  # fmt: skip
        values = [*live.start]
        values[paths.index(path)] = value
        assert live.holds(live.start)
        assert not live.holds(values), path


BEAM = "links.l.beam"
AT = "links.l.bodies.m.at"


def tube() -> Robot:
    """A beam that turns as prescribed, with a body on the way and one at its tip."""
    bodies = [{"name": "m", "mass": 0.3, "at": 0.6, "inertia": 1e-4}, {"name": "tip", "mass": 0.2}]
    beam = {
        "model": "strain", "functions": {"bend_y": 2, "bend_z": 2}, "length": 0.8, "damping_time": 1e-3,
        "section": {"shape": "tube", "outer_diameter": 0.03, "thickness": 0.002}, "material": "aluminium_6061",
    }  # fmt: skip
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1], "origin": {"position": [0.1, 0, 0.2]}}
    move = {"type": "trapezoid", "start": 0.0, "end": 0.5, "duration": 0.4, "ramp_fraction": 0.3}
    return arm(
        joints=[joint], links=[{"name": "l", "beam": beam, "bodies": bodies}],
        drives=[{"joint": "j", "command": "prescribed", "signal": move}],
        integration={"duration": 1.0, "output_step": 0.01, "line_points": 5},
    )  # fmt: skip


def test_lengths_durations_sections_and_places_have_sliders() -> None:
    """What entered no simple form: a beam's length, its section, a body's place on it, the times of signals."""
    sheet = tube()
    live = live_map(sheet.pair(), PLACES)
    paths = [slider.path for slider in live.sliders]
    assert {
        f"{BEAM}.length", f"{BEAM}.section.outer_diameter", f"{BEAM}.section.thickness", f"{BEAM}.material.density",
        AT, "joints.j.origin.position.0", "drives.0.signal.duration", "drives.0.signal.ramp_fraction",
    } <= {*paths}  # fmt: skip
    for values in drawn(live, 3, seed=1, others=0.2):
        stays = [*values]
        stays[paths.index(AT)] = live.start[paths.index(AT)]
        for given, without in ((values, {"line"}), (stays, set[str]())):  # the places along a link move with its body
            robot = sheet.with_(live.changes(given)).pair().real
            true = run_numbers(robot, follow_of(sheet, "real"), whole_moves(sheet, REACH), PLACES)
            for block, numbers in live.numbers(given, "real").items():
                near = 1e-12 * np.abs(true[block]).max(initial=0.0)
                assert block in without or numbers == pytest.approx(true[block], rel=1e-12, abs=near), block


def test_sliders_of_the_2010_robot_are_what_one_wants_to_change() -> None:
    """Payload, gear and link, nominal and actual, speed of the move, gains, environment come first."""
    live = live_map(load("filipovic2010").pair())
    paths = [slider.path for slider in live.sliders]
    assert {"links.link.bodies.payload.mass", "links.link.beam.modes.1.bending_stiffness", "drives.0.signal.duration",
            "drives.0.controller.position_gain", "contact.stiffness"} <= {*paths[:MOST]}  # fmt: skip
    assert any(path.startswith("real:joints.joint.gear.stiffness") for path in paths[:MOST])
    length = paths.index("links.link.beam.modes.0.length")
    values = [value * (0.7 if k == length else 1.0) for k, value in enumerate(live.start)]
    changed = load("filipovic2010").with_(live.changes(values))  # in which the surface follows
    assert changed.model_dump()["contact"]["shape"]["radius"] == pytest.approx(0.72)
    real = changed.pair().real
    numbers = run_numbers(real, follow_of(changed, "real"), whole_moves(changed, REACH))["parameters"]
    assert live.numbers(values, "real")["parameters"] == pytest.approx(numbers, rel=1e-12)
    (duration,) = (slider for slider in live.sliders if slider.path == "drives.0.signal.duration")
    assert (duration.low, duration.high) == (duration.value / 2, 2 * duration.value)  # beyond the end of the run


@pytest.mark.parametrize("count", [2, 3])
def test_a_real_robot_without_a_damping_has_a_map(count: int) -> None:
    """Factor 0 on what has a slider of its own (2 joints), and on what moves in proportion (3)."""
    sheet = chain(count).with_({f"real.joints.j{k}.gear.damping": 0.0 for k in range(count)})
    live = live_map(sheet.pair())
    assert any(slider.path.endswith("gear.damping") for slider in live.sliders)
    (values,) = drawn(live, 1, seed=3)
    pair = sheet.with_(live.changes(values)).pair()
    true = run_numbers(pair.real, follow_of(sheet, "real"), whole_moves(sheet, REACH))
    for block, numbers in live.numbers(values, "real").items():
        assert numbers == pytest.approx(true[block], rel=1e-12, abs=1e-12), block


def test_a_map_is_found_once(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The same sheet, kinds and program: it is read again, to the bit; another sheet has its own."""
    (tmp_path / "cache").mkdir(mode=0o700)
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))
    sheet = load("spong1987")
    first = live_map(sheet.pair())
    noted, asked = map_module.case_program, []
    monkeypatch.setattr(map_module, "case_program", lambda *given: asked.append(given) or noted(*given))
    again = live_map(sheet.pair())
    assert not asked
    assert (again.sliders, again.targets, again.left_out) == (first.sliders, first.targets, first.left_out)
    (values,) = drawn(first, 1, seed=5)
    for run in ("reference", "real"):
        assert np.array_equal(whole(first.numbers(values, run))[0], whole(again.numbers(values, run))[0])
    live_map(sheet.with_({"gravity": 9.7}).pair())
    assert asked
    asked.clear()
    monkeypatch.setattr(map_module, "outside_digest", lambda: "another kind")
    live_map(sheet.pair())
    assert asked


def test_samples_of_a_planner_are_no_sliders() -> None:
    """Columns of a hundred rows would be hundreds of sliders; the list itself is said to be left out."""
    rows = np.linspace(0.0, 1.0, 100)
    columns = {"times": rows, "positions": rows**2, "velocities": 2 * rows, "accelerations": np.full(100, 2.0)}
    signal = {"type": "trajectory", **{name: column.tolist() for name, column in columns.items()}}
    live = live_map(load("spong1987").with_({"drives.joint.signal": signal}).pair())
    assert {name for name in columns if f"drives.0.signal.{name}" in live.left_out} == {*columns}
    assert not [path for path in live.targets if ".signal." in path]
    assert [one.path for one in live.sliders if one.path.endswith("position_gain")]
