"""What is computed of a run after it can fail, or be interrupted, alone: the run and all else are there and stored."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
import tmodes.plot.contents
import tmodes.report.data
import tmodes.report.facts
import tmodes.result.assemble
import tmodes.result.settling
import tmodes.result.summary
import tmodes.simulation.solve
from see.runs import HOLD, cantilever, sheet, swinging
from tmodes.report.data import page_data
from tmodes.report.folder import RunFolder
from tmodes.result import Result, assemble_result
from tmodes.result.derived import is_unfinished
from tmodes.result.settling import after_move
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion

FAILS = "it is broken"


@cache
def moved() -> tuple[RunData, Robot]:
    pair = Robot.from_data(swinging()).pair()
    return simulate_motion(pair), pair.nominal


@cache
def undisturbed() -> Any:
    return assemble_result(*moved()).record


def breaks(*arguments: object, **named: object) -> Any:
    del arguments, named
    raise IndexError(FAILS)


def fixed(**more: Any) -> dict[str, Any]:
    """A free joint with a bob off its axis, and whatever else."""
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 1, 0], "friction": {"viscous": 0.1}}
    links = [{"name": "l", "bodies": [{"name": "b", "mass": 1.0, "center": [0, 0, -0.3], "inertia": 0.01}]}]
    return sheet(joints=[joint | more.pop("joint", {})], links=links, gravity=9.81) | more


LOOSE = {"initial": {"state": "zero", "coordinates": {"j": 0.2}}}
BARE: dict[str, dict[str, Any]] = {
    "no signal at all": fixed(joint={"state": "free"}, **LOOSE),
    "no drives": fixed(**LOOSE),
    "a locked joint": fixed(joint={"state": "locked", "gear": {"stiffness": 50.0, "damping": 0.1}}, **LOOSE),
    "a rigid drive": fixed(drives=[{"joint": "j", "command": "prescribed", "signal": HOLD}]),
    "one step": fixed(**LOOSE, integration={"duration": 0.01, "output_step": 0.01}),
    "an early end": fixed(**LOOSE, integration={"duration": 1.0, "output_step": 0.01, "stop": ["j.position < 0.19"]}),
    "an end of steps": fixed(**LOOSE, integration={"duration": 1.0, "output_step": 0.01, "max_steps": 5}),
    "a beam, all joints locked": cantilever()
    | {"joints": [{"name": "hub", "type": "revolute", "child": "rod", "axis": [0, 0, 1], "state": "locked"}],
       "drives": [], "initial": {"state": "zero"}},
}  # fmt: skip
"""Robots that have less than most."""


COMPUTED = {
    "line_series": {"lines", "model_errors"}, "error_series": {"paths"}, "frequencies_about": {"frequencies"},
    "end_modes": {"end_frequencies"}, "after_move": {"settling", "vibration", "vibration.nominal"},
    "plain_vibration": {"vibration", "vibration.nominal"}, "summary_errors": {"errors"},
    "model_errors": {"model_errors"}, "element_errors": {"elements"}, "implausible_numbers": {"checks"},
    "move_end": {"move_end"},
}  # fmt: skip
"""What computes a number of a run, and what is missing without it."""

KEPT = ("errors", "model_errors", "frequencies", "end_frequencies", "elements", "move_end", "settling")
FEWER = {"line_series": {"errors"}, "error_series": {"errors", "model_errors"}, "move_end": {"settling"}}
"""Attributes that are as they were, and those that have fewer numbers, by what failed."""


@pytest.mark.parametrize("name", COMPUTED)
def test_each_can_fail_alone(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The file holds the motion and all others as they are, and says what is missing and why; the page too."""
    whole = undisturbed()
    monkeypatch.setattr(tmodes.result.assemble, name, breaks)
    made = assemble_result(*moved())
    made.complete(lambda stage, share: None).save(tmp_path / "result.nc")
    read = Result.load(tmp_path / "result.nc")
    missing = read.not_computed
    assert {*missing} == COMPUTED[name]
    assert all(FAILS in reason for reason in missing.values())
    assert any(FAILS in one for one in read.warnings)
    assert made.warnings == read.warnings
    for series in ("q", "v", "tip", "energy", "effort", "contact_force"):
        assert (read.record[series].values == whole[series].values).all()
    kept = {*KEPT} - missing.keys() - FEWER.get(name, set())
    assert [key for key in kept if read.record.attrs.get(key) != whole.attrs.get(key)] == []
    summary = read.summary()
    assert json.dumps(summary, allow_nan=False)
    assert summary["not_computed"] == missing
    page = page_data([read])["runs"][0]
    assert any(FAILS in one for one in page["warnings"])
    assert {chart["id"] for chart in page["charts"]} >= {"tip_x", "energy_balance"}


def test_a_series_that_is_not_finite_is_left_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Else no file could hold the run."""
    own = tmodes.result.assemble.line_series

    def spoilt(*arguments: Any) -> Any:
        lines, *others = own(*arguments)
        dims, values, unit, text = lines["stress"]
        return lines | {"stress": (dims, values * np.nan, unit, text)}, *others

    monkeypatch.setattr(tmodes.result.assemble, "line_series", spoilt)
    made = assemble_result(*moved())
    made.save(tmp_path / "result.nc")
    read = Result.load(tmp_path / "result.nc")
    assert {*read.not_computed} == {"lines", "model_errors"}
    assert "stress" not in read.record


def test_groups_of_the_summary_fail_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a stored result too, as its numbers are computed when it is read."""
    monkeypatch.setitem(tmodes.result.summary._GROUPS, "links", (breaks, lambda reason: {}))
    found = assemble_result(*moved()).summary()
    assert found["links"] == {}
    assert FAILS in found["not_computed"]["links"]
    assert found["joints"]


def test_parts_of_the_page_fail_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Charts, numbers, modes: the others are there, and what is missing is said."""
    monkeypatch.setitem(tmodes.plot.contents._CHARTS, "tip", breaks)
    monkeypatch.setattr(tmodes.report.facts, "tracking_facts", breaks)
    monkeypatch.setattr(tmodes.report.data, "modes_of", breaks)
    page = page_data([assemble_result(*moved())])["runs"][0]
    said = next(one for one in page["warnings"] if FAILS in one)
    assert all(words in said for words in ("charts of the tip", "numbers of the tip", "modes"))
    assert {fact["id"] for fact in page["facts"]} >= {"deflection.max", "energy.residual"}
    assert "energy_balance" in {chart["id"] for chart in page["charts"]}


def test_what_is_stored_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The motion is in its file before anything is computed of it, and can be read if nothing follows."""
    path = tmp_path / "result.nc"

    def looks(*arguments: object, **named: object) -> Any:
        assert Result.load(path).status == "finished"
        raise SystemExit

    monkeypatch.setattr(tmodes.result.assemble.ResultAssembly, "whole", looks)
    with pytest.raises(SystemExit), RunFolder(tmp_path, Robot.from_data(BARE["no drives"])) as folder:
        folder.simulate(lambda stage, share: None)
    first = Result.load(path)
    assert is_unfinished(first.record)
    assert first.summary()["settling"]["reason"]
    assert page_data([first])["runs"][0]["charts"]


@pytest.mark.parametrize("stage", ["lines", "settling", "integration error", "checks", "saving"])
def test_interrupted_after_the_run(stage: str, tmp_path: Path) -> None:
    """Ctrl-C then leaves the whole run; the same again computes the rest, to the bytes of one that nobody disturbed."""
    robot, pressed = Robot.from_data(BARE["no drives"]), []

    def press(name: str, share: float) -> None:
        if name == stage and not pressed:
            pressed.append(share)
            raise KeyboardInterrupt

    with RunFolder(tmp_path / "a", robot) as folder:
        if stage == "saving":
            with pytest.raises(KeyboardInterrupt):
                folder.simulate(press)
        else:
            cut = folder.simulate(press)
            assert cut.status == "finished"
            assert is_unfinished(Result.load(folder.result_file).record)
    assert pressed
    left = tmp_path / "a" / ".checkpoint-reference"
    assert not left.exists()  # no record was due in so short a run
    left.touch()  # as by a process that was killed after it had stored the result
    for place in ("a", "b"):
        with RunFolder(tmp_path / place, robot) as folder:
            folder.simulate(lambda stage, share: None)
    one, other = ((tmp_path / place / "result.nc").read_bytes() for place in ("a", "b"))
    assert one == other
    assert not left.exists()


def test_ctrl_c_is_heard_by_who_asks_in_python(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where nothing is stored it is raised, and what was asked for can be asked for again."""

    def press(*arguments: object, **named: object) -> Any:
        raise KeyboardInterrupt

    made, own = assemble_result(*moved()), tmodes.result.assemble.after_move
    monkeypatch.setattr(tmodes.result.assemble, "after_move", press)
    for ask in (lambda: made.record, lambda: made.settling):
        with pytest.raises(KeyboardInterrupt):
            ask()
    monkeypatch.setattr(tmodes.result.assemble, "after_move", own)
    assert "not_computed" not in made.record.attrs


@pytest.mark.parametrize("name", BARE)
def test_robots_that_have_less(name: str, tmp_path: Path) -> None:
    """Of no signal, no drive, no link that bends, one sample, an early end: all there is can be computed."""
    made = tmodes.run(Robot.from_data(BARE[name]))
    made.complete(lambda stage, share: None).save(tmp_path / "result.nc")
    assert Result.load(tmp_path / "result.nc").not_computed == {}
    assert page_data([made])["runs"][0]["charts"]


def test_the_search_for_settling_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """At most half of the steps of the run itself, and where that was not enough the number says so."""
    monkeypatch.setattr(tmodes.result.settling, "_NEGLIGIBLE", 0)
    taken, own = [], tmodes.simulation.solve.solve

    def counted(*arguments: Any, **named: Any) -> Any:
        done = own(*arguments, **named)
        taken.append(done.statistics["steps"] + done.statistics["rejected"])
        return done

    monkeypatch.setattr(tmodes.simulation.solve, "solve", counted)
    robot = Robot.from_data(fixed(joint={"state": "free"}, tip={"link": "l", "position": [0, 0, -0.3]}, **LOOSE))
    run, shares = simulate_motion(robot.with_({"integration.duration": 2.0})), []
    found = after_move(run, 0.0, shares.append)
    statistics = run.statistics
    assert taken
    assert sum(taken) <= (statistics["steps"] + statistics["rejected"]) / 2
    assert shares
    info = found.settling()
    assert info["cut"]
    assert info["continued_s"] == pytest.approx(found.times[-1] - 2.0)
    assert info["continued_s"] > 0.2
