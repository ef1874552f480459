"""``tmodes batch``: sweeps and Monte Carlo studies as a user meets them."""

from __future__ import annotations

import json

import numpy as np
import pytest

from command import tmodes
from tmodes.robots.load import load
from tmodes.simulation.batch.result import load_batch
from tmodes.study import ranges
from tmodes.study.ranges import drawn_study, grid_study
from tmodes.study.read import read_study

BATCH = ["batch", "filipovic2010", "--duration", "0.02"]


def tmodes_batch(*arguments, code=0):
    return tmodes(*BATCH, *arguments, code=code)


def test_sweep_into_a_folder(tmp_path):
    """All combinations; the table shows the spread and the worst lane, the folder holds all samples."""
    out = tmp_path / "with spaces é"
    vary = ["--vary", "payload.mass=0.4:0.6:3", "--vary", "gear.damping=0:4:3"]
    info = tmodes_batch(*vary, "--out", out).stdout
    assert "9 of 9 runs finished" in info
    assert "Largest tip difference" in info
    batch = load_batch(out)
    assert batch.size == 9
    assert batch.values["payload.mass"].tolist() == np.repeat([0.4, 0.5, 0.6], 3).tolist()
    # The middle one is the sheet itself, which parts from itself by nothing.
    data = json.loads(tmodes_batch(*vary, "--json").stdout)
    assert data["each"][4]["tip_difference_m"] < 1e-12
    assert data["tip_difference_m"]["max"] == data["worst"]["tip_difference_m"] > 1e-4
    # Reduced in the loops, or of the samples in the folder: the same within the tolerance of the integration.
    assert batch.tips is not None
    far = np.linalg.norm(batch.tips - batch.tips[4], axis=2)
    for key, numbers in {"tip_difference_m": far.max(axis=1), "tip_difference_at_end_m": far[:, -1]}.items():
        assert [each[key] for each in data["each"]] == pytest.approx(numbers.tolist(), abs=2e-9)
    assert "new folder" in tmodes_batch(*vary, "--out", out, code=4).stderr


def test_draws_are_the_same_for_the_same_seed():
    options = ["--draw", "payload.mass=0.4:0.6", "--runs", 5, "--json"]
    first, again, other = (tmodes_batch(*options, "--seed", seed, "--threads", k).stdout
                           for seed, k in ((3, 1), (3, 2), (4, 1)))  # fmt: skip
    assert first == again != other


def test_lanes_that_fail_are_reported_and_the_exit_code_says_so():
    """A gear that is too stiff for the fixed step."""
    vary = ["--vary", "gear.stiffness=4700:4.7e9:2", "--integrator", "rk4", "--set", "integration.step=1e-3"]
    done = tmodes_batch(*vary, code=3)
    assert "1 of 2 runs finished" in done.stdout
    assert "case 1 (gear.stiffness = 4.7e+09) diverged" in done.stderr
    data = json.loads(tmodes_batch(*vary, "--json", code=3).stdout)
    assert [each["status"] for each in data["each"]] == ["finished", "diverged"]
    assert data["each"][1]["tip_difference_m"] is None


WRONG = {
    "--vary, --draw must be one of them, got neither": [],
    "got both": ["--vary", "payload.mass=1:2:3", "--draw", "payload.mass=1:2"],
    "PATH=LOW:HIGH:COUNT": ["--vary", "payload.mass=1:2"],
    "must be PATH=LOW:HIGH, got": ["--draw", "payload.mass=1:nan"],
    "whole COUNT": ["--vary", "payload.mass=1:2:2.5"],
    "at most 1000000": ["--vary", "payload.mass=1:2:1001", "--vary", "gravity=9:10:1001"],
    "case 0: payload.mass must be a number not less than 0 [kg], got -1.0": ["--vary", "payload.mass=-1:2:2"],
    "Did you mean": ["--draw", "payload.mas=1:2"],
    "the lower number first": ["--draw", "payload.mass=2:1"],
    "write --set payload.mass=1": ["--draw", "payload.mass=1:1"],
    "payload.mass twice": ["--vary", "payload.mass=1:2:2", "--vary", "payload.mass=3:4:2"],
    "case 2: payload.mass must be a number not less than 0 [kg], got -1.0": ["--vary", "payload.mass=1:-1:3"],
    "one integration": ["--vary", "integration.duration=1:2:3"],
}


@pytest.mark.parametrize("info", list(WRONG))
def test_wrong_lines_are_refused(info, monkeypatch):
    """Before anything runs."""
    monkeypatch.setattr("tmodes.simulation.batch.executor.Processor.run", lambda *_: pytest.fail("it runs"))
    assert info in tmodes_batch(*WRONG[info], code=2).stderr


@pytest.mark.parametrize(("stage", "duration"), [("preparing", 1), ("running", 2000), ("tips", 1)])
def test_interrupted_before_the_batch_has_begun(stage, duration, tmp_path, monkeypatch):
    """Ctrl-C during the sheet's own run ends the command; nothing is left behind."""

    def interrupts(self, info, share):
        if info == stage:
            raise KeyboardInterrupt

    monkeypatch.setattr("tmodes.cli.terminal.Stages.__call__", interrupts)
    out = tmp_path / "batch"
    line = ["batch", "filipovic2010", "--duration", duration, "--set", "integration.output_step=1.0"]
    done = tmodes(*line, "--vary", "payload.mass=0.4:0.6:3", "--out", out, code=130)
    assert done.stderr == "tmodes: interrupted\n"
    assert not out.exists()


def cases_of(study):
    values = study.design().values
    return {one.path: values[:, k] for k, one in enumerate(study.sheet.parameters.values())}


ROBOT = load("filipovic2010")


def test_grid_is_all_combinations():
    paths = "payload.mass", "gear.damping", "gravity"
    values = cases_of(grid_study(ROBOT, dict(zip(paths, map(np.array, ([0, 0.5, 1], [5.0], [9.5, 9])), strict=True))))
    assert [*zip(*(values[path].tolist() for path in paths), strict=True)] == [
        (a, 5.0, c) for a in (0.0, 0.5, 1.0) for c in (9.5, 9.0)
    ]


def test_a_longer_draw_begins_with_the_shorter_one():
    """More runs, or another path next to, change no number that was drawn."""
    own, other = {"payload.mass": (0.0, 2.0)}, {"gear.damping": (5.0, 6.0)}
    short, long = cases_of(drawn_study(ROBOT, own, 10, 7)), cases_of(drawn_study(ROBOT, other | own, 1000, 7))
    mass, damping = long["payload.mass"], long["gear.damping"]
    assert mass[:10].tolist() == short["payload.mass"].tolist()
    assert np.all((damping >= 5.0) & (damping < 6.0))
    assert mass.mean() == pytest.approx(1.0, abs=4 * 2 / np.sqrt(12 * 1000))
    assert np.corrcoef(mass, damping)[0, 1] == pytest.approx(0.0, abs=0.15)


def test_paths_that_differ_in_what_no_name_can_have_stay_apart():
    names = ranges._names(["links.a-b.mass", "links.a_b.mass", "*"])
    assert len({*names}) == 3
    assert all(name[0].isalpha() for name in names)


def test_a_batch_cut_into_parts_is_the_same(monkeypatch):
    """Cases are computed some at a time, so that memory is bounded; numbers stay but for rounding."""
    short = ROBOT.with_({"integration.duration": 0.02})
    study = drawn_study(short, {"payload.mass": (0.4, 0.6)}, 40, 1)
    whole = ranges.computed(study, 1, lambda *_: None)
    monkeypatch.setattr(ranges, "_TOGETHER", 16)
    parts = ranges.computed(study, 1, lambda *_: None)
    assert whole.case.tolist() == parts.case.tolist() == [*range(40)]
    for name, values in whole.quantities.items():
        assert parts.quantities[name] == pytest.approx(values, rel=1e-9, abs=1e-12)


def test_a_batch_is_the_study_it_is_short_for(tmp_path):
    """The same numbers as of the study written out."""
    data = json.loads(tmodes_batch("--draw", "payload.mass=0.4:0.6", "--runs", 5, "--json").stdout)
    file = tmp_path / "study.yaml"
    file.write_text(STUDY, encoding="utf-8")
    rows = read_study(file).evaluate(0, read_study(file).design().values)
    assert [each["tip_difference_m"] for each in data["each"]] == rows.quantities["far"].tolist()


STUDY = """
format: 1
kind: study
name: the-same
robot: filipovic2010
set: {integration.duration: 0.02}
parameters: {payload_mass: {path: payload.mass, distribution: {type: uniform, low: 0.4, high: 0.6}}}
plan: {type: monte_carlo, runs: 5}
quantities: {far: {series: tip_difference, reduce: max}}
"""


def test_a_folder_that_is_taken_is_refused_before_anything_runs(tmp_path, monkeypatch):
    (tmp_path / "batch.json").write_text("{}")
    monkeypatch.setattr("tmodes.simulation.batch.executor.Processor.run", lambda *_: pytest.fail("it runs"))
    done = tmodes_batch("--vary", "gravity=9:10:2", "--out", tmp_path, code=4)
    assert "a batch that is there" in done.stderr


def test_seeds_of_noise_are_a_sweep():
    noise = ["--set", "reference.noise.deviation=1e-4", "--vary", "reference.noise.seed=1:3:3", "--json"]
    data = json.loads(tmodes_batch(*noise).stdout)
    assert [each["values"] for each in data["each"]] == [{"reference.noise.seed": seed} for seed in (1.0, 2.0, 3.0)]
    assert len({each["tip_difference_m"] for each in data["each"]}) == 3
