"""``tmodes run --integrator --rtol --atol --check-error``: what they do, and what a run says of its integration."""

from __future__ import annotations

import json
from types import SimpleNamespace

import pytest

from command import tmodes
from tmodes.interface.summary import integration_lines
from tmodes.result import Result

SHORT = ["--duration", "0.2", "--no-contact", "--no-report"]


def test_options_and_what_is_reported(tmp_path):
    """Method and both tolerances reach the run; steps, time of computing and errors are reported."""
    options = ["--integrator", "dop853", "--rtol", 1e-8, "--atol", 1e-11, *SHORT, "--all"]
    info = tmodes("run", "filipovic2010", *options, "--out", tmp_path / "table").stdout
    for words in ("of dop853 (", "of computing for each simulated second", "error", "< ", "by a second run"):
        assert words in info
    printed = json.loads(tmodes("run", "filipovic2010", *options, "--json", "--out", tmp_path / "json").stdout)
    assert printed["statistics"]["real"]["method"] == "dop853"
    assert 0 < printed["statistics"]["real"]["smallest_step_s"] <= printed["statistics"]["real"]["mean_step_s"]
    assert printed["seconds_per_simulated_second"]["real"] > 0
    assert printed["summary"]["error"]["figures"]["deviation.max_m"] > 0
    kept = Result.load(tmp_path / "json" / "result.nc")
    assert kept.robot.integration.absolute_tolerance == 1e-11
    assert kept.timing == {}
    assert (tmp_path / "table" / "result.nc").read_bytes() == (tmp_path / "json" / "result.nc").read_bytes()


def test_check_error(tmp_path):
    info = tmodes("run", "filipovic2010", "--check-error", "--all", *SHORT, "--out", tmp_path).stdout
    assert "< " in info
    assert Result.load(tmp_path / "result.nc").robot.integration.check_error


def test_limits_of_a_robot_that_has_none(tmp_path):
    info = tmodes("run", "filipovic2010", "--stop-at-limits", "--out", tmp_path, code=2).stderr
    assert "--stop-at-limits must be given for a robot whose joints have limits, got the robot filipovic2010" in info
    assert "leave it out; --stop ends a run" in info


def test_unknown_integrator(tmp_path):
    """The known ones are listed."""
    for name, known in (("filipovic2010", ("dormand_prince", "dop853", "rk4")), ("spong1987", ("extrapolation",))):
        info = tmodes("run", name, "--integrator", "euler", "--out", tmp_path, code=2).stderr
        assert "euler" in info
        assert all(word in info for word in known)


def test_passes_of_lanes_are_reported(tmp_path):
    """Of a method that evaluates several states at once both counts are reported."""
    options = ["--integrator", "extrapolation", "--duration", "0.02", "--no-report", "--all"]
    info = tmodes("run", "spong1987", *options, "--out", tmp_path).stdout
    assert "evaluations in " in info
    assert "passes of four lanes" in info


def test_steps_of_two_methods_are_not_all_of_the_last():
    """Where a run turns out stiff, each part says by which method its steps are."""
    counts = {"rejected": 4, "evaluations": 700, "method": "extrapolation", "passes": 9, "mean_step_s": None}
    parts = {"1": {"from_s": 0.0, "method": "dormand_prince", "steps": 100},
             "2": {"from_s": 0.5, "method": "extrapolation", "steps": 1}}  # fmt: skip
    whole = "101 of extrapolation (4 rejected), 700 evaluations in 9 passes of four lanes"
    for more, first in (({"parts": parts}, "101 (4 rejected), 700 evaluations"), ({}, whole)):
        result = SimpleNamespace(statistics={"real": {"steps": 101, **counts, **more}}, timing={})
        lines = list(integration_lines(result, {"error": None, "model_error": None}))
        assert lines[0] == f"steps   {first}"
        assert len(lines) == 2 + len(more.get("parts", ()))


@pytest.mark.parametrize("method", ["auto", "extrapolation", "rosenbrock", "midpoint"])
def test_every_method_for_the_2010_robot(tmp_path, method):
    info = json.loads(
        tmodes("run", "filipovic2010", "--integrator", method, *SHORT, "--out", tmp_path, "--json").stdout
    )
    assert info["status"] == "finished"
    assert info["statistics"]["real"]["method"] == {"auto": "dormand_prince"}.get(method, method)


def test_help_teaches():
    info = " ".join(tmodes("run", "--help").stdout.split())
    for words in ("dop853: explicit, order 8", "extrapolation: implicit", "--check-error", "--atol", "Example"):
        assert words in info


def test_tolerance_below_rounding(tmp_path):
    info = tmodes("run", "filipovic2010", "--rtol", 1e-15, "--out", tmp_path, code=2).stderr
    assert "relative_tolerance" in info
    assert "1e-13" in info
