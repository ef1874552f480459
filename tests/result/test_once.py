"""A run simulates and nothing else; what is asked of its result is computed when it is asked for, and once."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest

import command
import tmodes
import tmodes.analysis.statics.at_rest
import tmodes.chain.lowering
import tmodes.io.yaml_file
import tmodes.result.assemble
import tmodes.result.result
import tmodes.simulation.initial_state
from see.runs import swinging
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.loads import Load
from tmodes.result import Result
from tmodes.sheet import Robot


@pytest.fixture
def counts(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often the rest is solved, a sheet is lowered, and each analysis is made."""
    tmodes.analysis.statics.at_rest._solved.clear()
    found: Counter[str] = Counter()

    count(found, monkeypatch, tmodes.analysis.statics.at_rest, "equilibrium")
    count(found, monkeypatch, tmodes.chain.lowering, "lowered")
    for name in ("line_series", "frequencies_about", "after_move", "summary_errors", "end_modes"):
        count(found, monkeypatch, tmodes.result.assemble, name)
    return found


def count(counts: Counter[str], monkeypatch: pytest.MonkeyPatch, module: Any, name: str) -> None:
    """Count the calls of a function of a module."""
    own = getattr(module, name)

    def counting(*arguments: Any, **named: Any) -> Any:
        counts[name] += 1
        return own(*arguments, **named)

    monkeypatch.setattr(module, name, counting)


def short(**more: Any) -> Robot:
    """An arm with an elastic gear, a link that bends, contact and a reference."""
    return Robot.from_data(swinging() | more)


def test_a_run_only_simulates(counts):
    """One chain and one rest for the robot as known, one for the actual one where it differs; no analysis."""
    same, differing = short(real={}), short()
    counts.clear()  # a sheet is lowered where it is checked
    result = tmodes.run(same)
    assert counts == {"equilibrium": 1, "lowered": 1}
    assert result.success
    assert set(result.motion["tip"].dims) == {"time", "axis"}
    assert counts == {"equilibrium": 1, "lowered": 1}
    counts.clear()
    pair = differing.pair()
    counts.clear()
    tmodes.run(pair)
    assert counts == {"equilibrium": 2, "lowered": 2}


def test_a_rest_is_solved_once_for_run_modes_and_page(counts):
    """Also where a robot is read again; other numbers, loads and commands have another rest."""
    robot = short(real={})
    result = tmodes.run(robot)
    assert result.frequencies
    sheet_frequencies(Robot.from_data(swinging() | {"real": {}}))
    assert counts["equilibrium"] == 1
    for change in ({"links.0.beam.length": 0.61}, {"gravity": 3.0}):
        sheet_frequencies(robot.with_(change))
    assert counts["equilibrium"] == 3
    robot_rest(robot, [Load("tip", (0.0, 0.0, -0.1))])
    assert counts["equilibrium"] == 4


def test_each_analysis_is_made_once(counts, tmp_path):
    """Frequencies about the rest that the run had; what a file holds is not computed again."""
    result = tmodes.run(short(real={}))
    counts.clear()
    first = result.frequencies
    assert counts == {"frequencies_about": 1}
    assert result.settling is not None
    assert result.warnings == result.warnings
    assert result.summary() == result.summary()
    result.save(tmp_path / "result.nc")
    assert result.frequencies == first
    once = {"frequencies_about": 1, "line_series": 1, "after_move": 2, "summary_errors": 1}
    expected = once | {"end_modes": 2, "equilibrium": 4}  # of both robots where their runs end, and with softer links
    assert counts == expected
    back = Result.load(tmp_path / "result.nc")
    assert isinstance(back, Result)
    assert back.summary() == result.summary()
    assert back.settling == result.settling
    assert back.frequencies == first
    assert counts == expected | {"lowered": 1}  # its sheet is read and checked, for its limits


def test_a_summary_is_made_once_and_belongs_to_who_asked(monkeypatch):
    """What is done to it changes no later one; of a dataset that its owner may change it is made each time."""
    result = tmodes.run(short(real={}))
    made: list[Any] = []
    own = tmodes.result.result.summarise_result

    def counting(*given: Any) -> Any:
        made.append(given)
        return own(*given)

    monkeypatch.setattr(tmodes.result.result, "summarise_result", counting)
    first = result.summary()
    first["joints"].clear()
    assert result.summary()["joints"]
    assert len(made) == 1
    assert result.summary(0.01)["settling"]["band"] == 0.01
    assert len(made) == 2
    result.data.attrs["status"] = "stopped"
    assert result.summary()["status"] == "stopped"


@pytest.mark.parametrize(("name", "rests"), [("spong1987", 3), ("filipovic2010", 4)])
def test_a_whole_command_computes_each_quantity_once(name, rests, counts, monkeypatch, tmp_path):
    """The file read, the summary, each robot's chain; rests: at the start and at the end, actual and nominal robot."""
    robots: list[Robot] = []
    own = tmodes.chain.lowering.lowered

    def lowered(robot: Robot) -> Any:
        robots.append(robot)
        return own(robot)

    monkeypatch.setattr(tmodes.chain.lowering, "lowered", lowered)
    for module, called in ((tmodes.io.yaml_file, "parse_yaml"), (tmodes.result.result, "summarise_result")):
        count(counts, monkeypatch, module, called)
    command.tmodes("run", name, "--out", tmp_path / "run")
    assert (tmp_path / "run" / "report.html").exists()
    once = {one: counts[one] for one in ("parse_yaml", "summarise_result", "line_series", "summary_errors")}
    assert once == dict.fromkeys(once, 1)
    assert counts["equilibrium"] == rests
    assert len({id(robot) for robot in robots}) == len(robots)


def test_frequencies_missing_in_a_file_follow_from_its_sheet(counts):
    """A record without them is completed from the data sheet of the actual robot."""
    result = tmodes.run(short())
    data = result.data.copy()
    known = result.frequencies
    data.attrs = {key: value for key, value in data.attrs.items() if key != "frequencies"}
    again = Result(data).frequencies
    assert again.keys() == known.keys()
    for state, modes in known.items():
        assert [mode["frequency_Hz"] for mode in again[state]] == pytest.approx(
            [mode["frequency_Hz"] for mode in modes], rel=1e-9
        )


def test_a_rest_that_is_taken_again_has_the_names_of_the_robot_that_asks(counts):
    def with_point(name: str) -> Robot:
        return short(points=[*swinging()["points"], {"name": name, "link": "rod"}])

    names = [[point.name for point in robot_rest(with_point(name)).model.chain.points] for name in ("eye", "ear")]
    assert counts["equilibrium"] == 1
    assert [last for *_, last in names] == ["eye", "ear"]
