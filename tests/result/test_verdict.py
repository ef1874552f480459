"""The verdict on a run: its error, whose it is, whether it settles, what limits it; in numbers and in words."""

from __future__ import annotations

import html
import json
import os
from dataclasses import replace
from typing import Any

import pytest

import tmodes
from random_sheets import random_sheet
from tmodes.cli.terminal import print_parts
from tmodes.interface.summary import _uncertain
from tmodes.io.printed import written
from tmodes.report.data import page_data
from tmodes.report.facts import Fact
from tmodes.report.rest import rest_page
from tmodes.result import Result
from tmodes.result.assemble import ending
from tmodes.result.early import early_result
from tmodes.result.run import run
from tmodes.result.verdict import PHRASES, culprit_words, damping_words, filled, verdict
from tmodes.sheet import Robot

SEEDS = [18, 24, *range(int(os.environ.get("TMODES_VERDICTS", "0")))]
"""Robots with a controller, gears, links and free joints, some of them against the error; and so many more."""

SHORT = {"integration.error_estimate": False, "integration.model_error": False}
SWING: dict[str, Any] = {
    "format": 1, "kind": "arm", "name": "swing",
    "joints": [{"name": "pivot", "type": "revolute", "child": "rod", "axis": [0, 1, 0], "friction": {"viscous": 0.1}}],
    "links": [{"name": "rod", "bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -1]}]}],
    "tip": {"link": "rod", "position": [0, 0, -1]},
    "initial": {"state": "zero", "coordinates": {"pivot": 0.3}},
    "integration": {"duration": 0.5, "error_estimate": False, "model_error": False},
}  # fmt: skip


def judged(name: str, **changes: Any) -> Result:
    return run(tmodes.load(name).with_(SHORT | {path.replace("__", "."): one for path, one in changes.items()}))


@pytest.fixture(scope="module")
def spong() -> Result:
    return judged("spong1987")


def test_the_numbers_are_those_of_the_summary(spong: Result) -> None:
    found, summary = spong.verdict, spong.summary()
    error, mode = summary["tip_error"]["commanded"], summary["vibration"]["actual"]["modes"][0]
    assert [found[name] for name in ("largest_m", "time_s", "final_m")] == [
        error[name] for name in ("max_m", "time_of_max_s", "end_m")
    ]
    assert found["settling"]["time_s"] == summary["settling"]["time_s"]
    assert found["residual"]["damping"] == mode["damping_ratio"]
    assert found["residual"]["amplitude_m"] == summary["vibration"]["actual"]["amplitude_m"]
    assert [(one["cause"], one["element"]) for one in found["culprits"]] == [("controller", None), ("gear", "joint")]
    assert summary["verdict"] == found


def test_the_sentence_says_error_end_rest_and_vibration(spong: Result) -> None:
    assert spong.verdict["sentence"] == (
        "Tip is up to 239 mm off its commanded path (1.37 s) and ends 164 mm off; it stays within 0.812 mm of its "
        "rest from 2.54 s after the move (1.25 Hz, 26 % damping)."
    )


@pytest.mark.nightly("24", "18")
@pytest.mark.parametrize("seed", SEEDS)
def test_culprits_add_up_to_the_error(seed: int) -> None:
    """Of whatever joints, gears, links and loads; named wherever a part is of elements."""
    found = run(Robot.from_data(random_sheet(seed, seed))).verdict
    if found["against"] is None or not found["culprits"]:
        return
    total = sum(one["value_m"] for one in found["culprits"])
    assert total == pytest.approx(found["largest_m"], rel=1e-6, abs=1e-12)
    assert all(one["element"] for one in found["culprits"] if one["cause"] not in ("controller", "geometry"))
    sizes = [abs(one["value_m"]) for one in found["culprits"]]
    assert sizes == sorted(sizes, reverse=True)


def test_parts_against_the_error_are_said() -> None:
    culprits = [
        {"cause": "controller", "element": None, "value_m": 0.125},
        {"cause": "gear", "element": "elbow", "value_m": -0.014},
    ]
    assert culprit_words({"culprits": culprits}) == "controller 125 mm against gear elbow -14 mm"


@pytest.mark.parametrize(
    ("tolerance", "level"), [("500 mm", "good"), ("1 mm", "bad"), (None, "neutral")], ids=["kept", "missed", "none"]
)
def test_the_level_is_by_the_tolerance_of_the_sheet(tolerance: str | None, level: str) -> None:
    found = judged("spong1987", **({"task__tolerance": tolerance} if tolerance else {})).verdict
    assert found["level"] == level
    assert ("tolerance" in found["sentence"]) == (tolerance is not None)
    assert "accura" not in found["sentence"]


def test_a_warning_a_limit_and_an_early_end_are_never_good(spong: Result) -> None:
    summary, limit = spong.summary(), {"quantity": "speed", "element": "joint", "value": 3.0, "limit": 2.0}
    passed = [limit | {"unit": "rad/s", "share": 1.5}]
    assert verdict(summary, (), 1.0)["level"] == "good"
    assert verdict(summary, (), 1.0, ["a warning"])["level"] == "neutral"
    assert verdict(summary, passed, 1.0)["level"] == "neutral"
    assert "joint" in verdict(summary, passed)["sentence"]
    kept = [passed[0] | {"share": 1 + 1e-12}]
    assert "joint" not in verdict(summary, kept)["sentence"]
    assert verdict(summary, kept, 1.0)["level"] == "good"
    assert verdict(summary | {"status": "stopped_by_condition"}, (), 1.0)["level"] == "neutral"
    assert verdict(summary | {"status": "diverged"}, (), 1.0)["level"] == "bad"


def test_limits_are_those_of_the_sheet_the_most_critical_first() -> None:
    found = judged("manutec_r3", integration__duration=0.5).verdict
    shares = [one["share"] for one in found["limits"]]
    assert shares == sorted(shares, reverse=True)
    assert {one["element"] for one in found["limits"]} == {f"joint{k}" for k in range(1, 7)}
    assert all(one["share"] == one["value"] / one["limit"] for one in found["limits"])


def test_what_is_not_commanded_is_not_judged() -> None:
    """A robot that swings freely, with and without elasticity."""
    found = run(Robot.from_data(SWING)).verdict
    assert found["against"] is found["largest_m"] is found["bends"] is None
    assert not found["culprits"]
    assert found["level"] == "neutral"
    assert found["sentence"].startswith("No path is commanded; the tip is not seen to settle")
    beam = {"model": "strain", "length": 1.0, "functions": 1, "section": {"shape": "round", "diameter": "8 mm"},
            "material": "steel", "damping_time": "1 ms"}  # fmt: skip
    bends = SWING | {"links": [{"name": "rod", "beam": beam}], "tip": {"link": "rod"}}
    found = run(Robot.from_data(bends)).verdict
    assert found["bends"]["element"] == "rod"
    assert found["bends"]["value"] > 0
    assert found["sentence"].startswith("The end of rod is deflected by up to")


def test_a_motion_without_elasticity_follows_its_path() -> None:
    drive = {"joint": "pivot", "command": "prescribed",
             "signal": {"type": "quintic", "start": 0.0, "end": 0.3, "duration": 0.3}}  # fmt: skip
    found = run(Robot.from_data(SWING | {"drives": [drive], "initial": {"state": "zero"}})).verdict
    assert found["sentence"].startswith("Tip follows its commanded path")
    assert not found["culprits"]


def test_a_run_that_fails_says_so_first() -> None:
    found = judged("spong1987", integration__max_steps=50).verdict
    assert found["level"] == "bad"
    assert found["sentence"].startswith("The run did not finish: ")
    stopped = judged("spong1987", integration__stop=["joint.position > 0.5 rad"])
    ending = stopped.message.partition(" (")[0].replace("`", "")  # without why the method was chosen
    assert stopped.verdict["sentence"].endswith(f"The run was {ending}.")
    assert "simulate longer" not in stopped.verdict["sentence"]
    assert stopped.settling is not None
    assert stopped.settling["reason"].startswith("the run ends at ")
    assert "simulate longer" not in stopped.settling["reason"]


def test_of_two_runs_that_fail_the_one_that_ended_first_is_named() -> None:
    """The result ends with it: the nominal run fails where it wants too much, the actual one before."""
    whole = judged("spong1987", integration__duration=1.0).assembly
    assert whole
    run, last = whole.run, float(whole.run.times[-1])
    assert run.reference
    early = replace(run.reference, status="stopped", message="steps are used up")
    assert ending(replace(run, reference=early)) == ("stopped", "nominal run: steps are used up")
    cut = replace(run, times=run.times[:100], status="stopped", message="time is used up")
    assert cut.times[-1] < last
    assert ending(replace(cut, reference=early)) == ("stopped", "actual robot: time is used up")


def test_another_point_than_the_tip_is_named() -> None:
    on_axis = SWING | {"tip": {"link": "rod", "position": [0, 0, 0]}}
    drive = {"joint": "pivot", "command": "position", "controller": {"type": "pd", "position_gain": 5.0,
             "velocity_gain": 1.0}, "signal": {"type": "constant", "value": 0.2}}  # fmt: skip
    found = run(Robot.from_data(on_axis | {"drives": [drive], "initial": {"state": "zero"}})).verdict
    assert found["point"] == "the centre of mass of link rod"
    assert found["sentence"].startswith("The centre of mass of link rod is up to")


def test_where_no_point_shows_the_motion_there_is_no_error() -> None:
    """A body on the axis of the only joint."""
    body = {"name": "disk", "mass": 1.0, "inertia": {"xx": 0.1, "yy": 0.1, "zz": 0.1}}
    drive = {"joint": "pivot", "command": "position", "controller": {"type": "pd", "position_gain": 5.0,
             "velocity_gain": 1.0}, "signal": {"type": "constant", "value": 0.2}}  # fmt: skip
    disk = SWING | {"links": [{"name": "rod", "bodies": [body]}], "tip": {"link": "rod"}}
    found = run(Robot.from_data(disk | {"drives": [drive], "initial": {"state": "zero"}})).verdict
    assert found["point"] == ""
    assert found["largest_m"] is None
    assert found["sentence"].startswith("No error of the tip is measured; the tip is not seen to settle: ")


def test_an_early_result_leaves_out_what_it_does_not_know() -> None:
    found = early_result(judged("spong1987")).verdict
    assert found["largest_m"] == pytest.approx(0.239, rel=1e-3)
    assert found["settling"]["time_s"] is found["residual"] is None
    assert found["sentence"].endswith("and ends 164 mm off.")
    assert {one["cause"] for one in found["culprits"]} == {"controller", "gear"}


def test_a_command_that_jumps_is_named_where_it_excites_a_vibration() -> None:
    """At the instant of the sheet's signal; no word of it where a profile, or a shaped jump, leaves no vibration."""
    jumping = tmodes.load("quanser_2dsfl")
    found = jumping.run().verdict
    assert found["jump"] == {"joint": "stage1", "time_s": 0.2}
    assert found["sentence"].endswith(
        "The command of joint stage1 jumps at 0.2 s, which excites this vibration: smooth it by a profile, such as "
        "quintic, or by a shaper."
    )
    smooth = {"type": "quintic", "start": 0.0, "end": 0.35, "duration": 1.5}
    assert jumping.with_({"drives.0.signal": smooth}).run().verdict["jump"] is None


def test_pages_carry_verdicts_and_phrases(spong: Result) -> None:
    page = page_data([spong])
    assert page["runs"][0]["verdict"] == spong.verdict
    assert page["phrases"] == PHRASES
    still = rest_page(tmodes.load("spong1987"))["runs"][0]["verdict"]
    assert still.keys() == spong.verdict.keys()
    assert still["largest_m"] is None


@pytest.mark.parametrize(
    "name",
    ["spong1987", "quanser_2dsfl", *(pytest.param(one, marks=pytest.mark.nightly)
                                     for one in ("two_link_arm", "deluca_siciliano1991"))],
)  # fmt: skip
def test_terminal_repr_notebook_json_and_page_give_the_same(name: str, spong: Result, capsys: Any) -> None:
    done = spong if name == "spong1987" else run(tmodes.load(name).with_(SHORT | {"integration.duration": 0.3}))
    shown = tmodes.Result.like(done)
    print_parts(shown.tables())
    texts = [capsys.readouterr().out, repr(shown), html.unescape(shown._repr_html_())]
    for text in texts:
        words = " ".join(text.split())
        assert done.verdict["sentence"] in words
        assert f"{culprit_words(done.verdict)}." in words
    assert json.loads(json.dumps(shown.info()))["summary"]["verdict"] == done.verdict
    assert page_data([shown])["runs"][0]["verdict"] == done.verdict


def test_every_number_of_a_verdict_is_printed_and_in_notebooks(capsys: Any) -> None:
    """Largest and final error, their time, settling, residual vibration, what limits, tolerance, and every cause."""
    limits = {"joints.joint.limits": {"speed": 1.0}, "task": {"tolerance": "1 mm"}}
    shown = tmodes.Result.like(run(tmodes.load("spong1987").with_(SHORT | limits)))
    found = shown.verdict
    residual, (limit, *_), largest = found["residual"], found["limits"], written(found["largest_m"], "m", 3)
    wanted = [
        f"{largest} off its commanded path ({written(found['time_s'], 's', 3)})",
        f"ends {written(found['final_m'], 'm', 3)} off, beyond its tolerance of {written(found['tolerance_m'], 'm')}",
        f"from {written(found['settling']['time_s'], 's', 3)} after the move",
        f"within {written(found['settling']['within_m'], 'm', 3)} of its rest",
        f"{residual['frequency_Hz']:.3g} Hz, {damping_words(residual['damping'])} damping",
        written(residual["amplitude_m"], "m"),
        f"Speed of {limit['element']} passes its limit: {written(limit['value'], 'rad/s', 3)}",
        written(100 * limit["share"], "%"),
        *(f"{' '.join(filter(None, (one['cause'], one['element'])))} {written(one['value_m'], 'm', 3)}"
          for one in found["culprits"]),
    ]  # fmt: skip
    print_parts(shown.tables())
    for text in (capsys.readouterr().out, html.unescape(shown._repr_html_())):
        words = " ".join(text.split())
        assert [one for one in wanted if one.replace("\u00a0", " ") not in words] == []
    assert str(shown) == repr(shown)


def test_a_number_that_is_not_exact_says_so(spong: Result, monkeypatch: pytest.MonkeyPatch) -> None:
    """An error of the integration that shows in the first figures is said with the number."""
    shown = tmodes.Result.like(spong)
    summary = shown.summary()
    summary["error"] = {"how": "x", "figures": {"tip_error.commanded.max_m": 0.002}, "approximate": []}
    assert "±" not in repr(shown)
    monkeypatch.setattr(shown, "summary", lambda band=None: summary)
    assert "± 2 mm" in repr(shown)
    summary["error"]["figures"] = {"tip_error.commanded.max_m": 0.5}
    assert f"below {written(0.5 + summary['tip_error']['commanded']['max_m'], 'm', 2)}" in repr(shown)


def test_a_number_and_its_error_have_one_unit() -> None:
    summary: Any = {"error": {"figures": {"deviation.max_m": 2e-9}}, "model_error": None}
    fact = Fact("deviation.max", "Error", 7.463e-8, "m")
    assert [part.split()[1] for part in _uncertain(summary, fact, "74.63 nm").split(" ± ")] == ["nm", "nm"]


def test_a_phrase_takes_the_first_alternative_that_is_known() -> None:
    phrases = (("{one} and {other}", "{one}"), (" {unknown}",), (".",))
    assert filled(phrases, {"one": "1"}) == "1."
    assert filled(phrases, {"one": "{other}", "other": "2"}) == "{other} and 2."


def test_a_file_gives_the_same_verdict(spong: Result, tmp_path: Any) -> None:
    assert Result.load(spong.save(tmp_path / "run.nc")).verdict == spong.verdict


def test_a_gear_bends_where_the_links_are_rigid() -> None:
    """Of a run whose errors are not known: a deflection of zero is not named before one of a gear."""
    found = judged("spong1987", drives=[], initial={"coordinates": {"joint": 0.3}})
    assert {one["deflection"]["max_m"] for one in found.summary()["links"].values()} <= {0.0}
    assert found.verdict["bends"]["cause"] == "gear"
    assert "Gear joint is deflected by up to " in found.verdict["sentence"]


def test_every_limit_that_is_passed_is_named() -> None:
    limits = {"joints.joint.limits": {"speed": 0.01, "effort": 0.01}}
    sentence = run(tmodes.load("spong1987").with_(SHORT | limits)).verdict["sentence"]
    assert " of joint passes its limit: " in sentence
    assert sentence.endswith(("; so do speed of joint.", "; so do effort of joint."))
