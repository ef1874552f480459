"""``tmodes view`` and the viewer in notebooks: pages of stored results, side by side, and of a robot at rest."""

from __future__ import annotations

import base64
import gzip
import html
import json
import os
import re
import tempfile
from pathlib import Path

import pytest

import tmodes
from command import tmodes as command
from see.runs import result_of
from tmodes.errors import InputError, ResultFileError
from tmodes.report.differences import differences, names_by_difference, run_names
from tmodes.report.notebook import rest_page, show
from tmodes.result import Result


def viewed(*arguments: object, **more):
    return command("view", "--no-open", *arguments, **more)


def head_of(document: str) -> dict:
    """The plain part of a page's data."""
    packed = re.search(r'id="tmodes-data"[^>]*>([^<]*)<', document)
    assert packed
    content = gzip.decompress(base64.b64decode(packed[1]))
    return json.loads(content[8 : 8 + int.from_bytes(content[4:8], "little")])["page"]


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    folder = tmp_path_factory.mktemp("runs")
    paths = [folder / "soft", folder / "stiff"]
    robot = tmodes.load("filipovic2010").with_({"integration.duration": 0.2})
    for stiffness, path in zip((400.0, 900.0), paths, strict=True):
        path.mkdir()
        tmodes.run(robot.with_({"gear.stiffness": stiffness})).save(path / "result.nc")
    return paths


def test_two_runs_side_by_side(runs, tmp_path):
    """Runs of one robot are named by what differs, which a table lists; the page asks for nothing outside."""
    out = tmp_path / "a page.html"
    info = json.loads(viewed(*runs, "--out", out, "--json").stdout)
    document = out.read_text(encoding="utf-8")
    head = head_of(document)
    assert [run["name"] for run in head["runs"]] == info["runs"]
    assert info["runs"] == ["gear.stiffness 400", "gear.stiffness 900"]
    sheet, numbers = document.split("<h2>Differences</h2>")[1].split("<table>")[1:3]
    assert re.findall(r'<th scope="row">([^<]*)', sheet) == ["joints.joint.gear.stiffness.0"]
    one, two = (
        next(iter(run.summary()["tip_error"].values()))["max_m"]
        for run in map(Result.load, (path / "result.nc" for path in runs))
    )
    assert f"−{100 * (one - two) / one:.3g}\u00a0%" in html.unescape(numbers)
    assert "default-src 'none'" in html.unescape(document[:1000])
    assert not re.search(r"(?:src|href)=[\"']?https?:", document)


def test_a_page_is_not_replaced_unasked(runs, tmp_path):
    out = tmp_path / "page.html"
    out.write_text("mine", encoding="utf-8")
    assert "--overwrite" in viewed(runs[0], "--out", out, code=4).stderr
    assert out.read_text(encoding="utf-8") == "mine"
    viewed(runs[0] / "result.nc", "--out", out, "--overwrite")
    assert head_of(out.read_text(encoding="utf-8"))["title"]


def test_without_a_file_the_page_is_temporary_and_stays(runs, tmp_path):
    page = Path(viewed(runs[0], env=os.environ | {"TMPDIR": str(tmp_path)}).stdout.split(maxsplit=1)[1].strip())
    assert page.parent.parent == tmp_path
    assert os.name == "nt" or page.parent.stat().st_mode & 0o777 == 0o700  # others share the temporary folder
    assert page.read_text(encoding="utf-8").startswith("<!doctype html>")
    none = viewed(runs[0], "--out", tmp_path / "no folder" / "x.html", code=4)
    assert "no folder" in none.stderr


def test_what_cannot_be_viewed(runs, tmp_path):
    (tmp_path / "result.nc").write_bytes((runs[0] / "result.nc").read_bytes()[:-9])
    assert "seal" in viewed(runs[0], tmp_path, code=4).stderr
    assert "at most 6" in viewed(*[runs[0]] * 7, code=2).stderr
    assert "none is missing, expected a result file" in viewed(tmp_path / "none", code=4).stderr
    assert "tmodes run spong1987" in viewed("spong1987", code=4).stderr
    assert "got a folder" in viewed(runs[0], "--out", tmp_path, "--overwrite", code=4).stderr


def test_names_apart():
    """By robots, by folders, by numbers where one file is given twice; short in any case."""
    paths = [Path("/a/one/result.nc"), Path("/b/one/result.nc"), Path("/b/two.nc")]
    one, other = result_of("cantilever"), tmodes.run(tmodes.load("spong1987").with_({"integration.duration": 0.1}))
    assert run_names([one, other], paths[:2]) == ["test", "spong1987"]
    assert run_names([one, other, one], paths) == ["a/one", "b/one", "b/two"]
    assert run_names([one, one], [paths[0], paths[0]]) == ["test 1", "test 2"]
    assert run_names([one, one], [Path(f"/{k}{40 * 'long'}.nc") for k in range(2)]) == ["test 1", "test 2"]


@pytest.mark.nightly
def test_a_result_in_a_notebook():
    """An iframe whose whole document is in it, escaped; the same as the page that can be saved."""
    shown = show(result_of("cantilever"), height=500)
    frame = shown._repr_html_()
    assert 'height="500"' in frame
    inside = re.search(r'srcdoc="([^"]*)"', frame)
    assert inside
    assert html.unescape(inside[1]) == shown.document
    assert head_of(shown.document)["runs"][0]["status"] == "finished"
    with tempfile.TemporaryDirectory() as folder:
        path = shown.save(Path(folder) / "x.html")
        assert path.read_text(encoding="utf-8") == shown.document
        with pytest.raises(ResultFileError):
            shown.save(path)


def test_results_side_by_side_in_a_notebook():
    result = result_of("cantilever")
    assert [run["name"] for run in head_of(show(result, result).document)["runs"]] == ["test 1", "test 2"]
    named = show(result, result, names=["a", "<script>"])
    assert [run["name"] for run in head_of(named.document)["runs"]] == ["a", "<script>"]
    assert "<script>," not in named.document
    robot = tmodes.load("filipovic2010")
    for wrong in ((), (robot, robot), (result, robot)):
        with pytest.raises(InputError):
            show(*wrong)
    with pytest.raises(InputError, match="names"):
        show(result, names=["a", "b"])


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
def test_a_robot_at_rest_has_its_modes(name):
    """The frequencies of the modes that can be shown are those of `tmodes modes`, with no run and no charts."""
    robot = tmodes.load(name)
    run = rest_page(robot)["runs"][0]
    assert run["charts"] == []
    assert run["modes"]
    assert all(mode["frequency"] > 0 for mode in run["modes"])
    assert head_of(robot.show().document)["title"] == name


@pytest.mark.parametrize("name", ["filipovic2010", "spong1987"])
def test_a_robot_with_a_fixed_step_is_shown_too(name):
    """Its step is longer than the instant in which it is looked at."""
    assert rest_page(tmodes.load(name).with_({"integration.method": "rk4"}))["runs"][0]["modes"]


def test_an_arm_that_nothing_moves_is_shown_too():
    arm = tmodes.load("spong1987").with_({"drives": []})
    assert rest_page(arm)["runs"][0]["status"] == "at rest"


def test_runs_are_named_by_the_fewest_values_that_tell_them_apart(runs):
    """Equal sheets have no such names; where one value differs between two runs, the third needs another."""
    soft, stiff = (Result.load(path / "result.nc") for path in runs)
    heavy = tmodes.run(stiff.robot.with_({"payload.mass": 0.7, "integration.output_step": 0.02}))
    assert names_by_difference([soft, soft]) is None
    assert names_by_difference([soft]) is None
    assert [one.path.rpartition(".")[2] for one in differences([stiff, heavy])] == ["mass", "output_step"]
    assert names_by_difference([stiff, heavy]) == ["payload.mass 0.5 kg", "payload.mass 0.7 kg"]
    names = names_by_difference([soft, stiff, heavy])
    assert names
    assert [name.split(", ")[1] for name in names] == [f"mass {m}" for m in (0.5, 0.5, 0.7)]
    assert max(map(len, names)) <= 24
    assert 'title="filipovic2010: 2 runs compared"' in show(stiff, heavy)._repr_html_()
