"""A run simulates and nothing else; what is asked of its result is computed when it is asked for, and once."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest

import tmodes
import tmodes.analysis.statics.equilibrium
import tmodes.chain.lowering
import tmodes.result.assemble
import tmodes.simulation.start
from arm.see.runs import swinging
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.statics.equilibrium import robot_rest
from tmodes.analysis.statics.loads import Load
from tmodes.result import Result
from tmodes.sheet import Robot


@pytest.fixture
def counts(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often the rest is solved, a sheet is lowered, and each analysis is made."""
    tmodes.analysis.statics.equilibrium._solved.clear()
    found: Counter[str] = Counter()

    def counted(module: Any, name: str) -> None:
        own = getattr(module, name)

        def counting(*arguments: Any, **named: Any) -> Any:
            found[name] += 1
            return own(*arguments, **named)

        monkeypatch.setattr(module, name, counting)

    counted(tmodes.analysis.statics.equilibrium, "equilibrium")
    counted(tmodes.chain.lowering, "lowered")
    for name in ("line_series", "frequencies_about", "after_move", "summary_errors", "end_modes"):
        counted(tmodes.result.assemble, name)
    return found


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
    assert counts == expected


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
