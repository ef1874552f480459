"""``tmodes run`` of arms: files, tables, JSON, refusals, interruption."""

from __future__ import annotations

import json
import re

import pytest

from command import tmodes
from see.runs import SHEETS
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.result import Result
from tmodes.sheet import Robot

URDF = """<robot name="two"><link name="base"/>
<link name="rod"><inertial><origin xyz="0 0 -1"/><mass value="1"/>
<inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="hinge" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/></joint></robot>"""


@pytest.fixture
def files(tmp_path):
    """The sheets of the small runs, as files."""
    for name, sheet in SHEETS.items():
        (tmp_path / f"{name}.yaml").write_text(robot_to_yaml(Robot.from_data(sheet())), encoding="utf-8")
    (tmp_path / "two.urdf").write_text(URDF, encoding="utf-8")
    return tmp_path


def test_the_main_job(files):
    """One command: result and report, figures where they are asked for; a second one does not overwrite unasked."""
    out = files / "with spaces é"
    info = tmodes("run", files / "swinging.yaml", "--out", out).stdout
    assert "Error from nominal path" in info
    assert "Largest deflection of a link" in info
    assert sorted(path.name for path in out.iterdir()) == ["report.html", "result.nc"]
    page = re.sub(r"<script.*?</script>", "", (out / "report.html").read_text(encoding="utf-8"), flags=re.DOTALL)
    assert "http" not in page.replace("http-equiv", "")
    assert (out / "report.html").stat().st_size < 3_000_000
    before = (out / "result.nc").read_bytes()
    refused = tmodes("run", files / "swinging.yaml", "--out", out, "--duration", 0.01, code=4)
    assert "--overwrite" in refused.stderr
    assert (out / "result.nc").read_bytes() == before
    drawn = tmodes("figures", out, "tip_path", "--pdf").stdout
    assert f"wrote   2 files to {out / 'figures'}" in drawn
    assert sorted(path.name for path in (out / "figures").iterdir()) == ["captions.txt", "tip_path.pdf", "tip_path.svg"]
    tmodes("run", files / "pendulum.yaml", "--duration", 1, "--out", out, "--no-report", "--figures", "--overwrite")
    assert (out / "result.nc").read_bytes() != before
    assert len(list((out / "figures").glob("*.svg"))) == len(list((out / "figures").glob("*.png"))) >= 5


def test_json_and_the_options_of_integration(files):
    """F L^3/3EI = 1.0517 mm; both integrators agree."""
    info = {}
    for method in ("dormand_prince", "rk4"):
        options = ["--integrator", method, "--duration", 0.02, "--rtol", 1e-6, "--set", "integration.step=1e-5"]
        options += ["--set", "integration.output_step=0.004"]
        done = tmodes("run", files / "cantilever.yaml", "--json", "--no-report", "--out", files / method, *options)
        info[method] = json.loads(done.stdout)
        assert info[method]["status"] == "finished"
        assert info[method]["summary"]["links"]["rod"]["deflection"]["max_m"] == pytest.approx(1.0517e-3, rel=1e-3)
    assert Result.load(files / "rk4" / "result.nc").data.attrs["method"] == "rk4"
    assert float(Result.load(files / "rk4" / "result.nc").data["time"][-1]) == pytest.approx(0.02)
    assert info["rk4"]["statistics"]["real"]["steps"] == 2000


def test_a_bare_urdf_is_reported_what_it_lacks(files):
    done = tmodes("run", files / "two.urdf", "--out", files / "o", code=2)
    assert "drives" in done.stderr
    assert "joint: hinge" in done.stderr
    assert not (files / "o").exists()
    free = ["--set", "initial.coordinates.hinge=0.3", "--duration", 0.5, "--no-report"]
    done = tmodes("run", files / "two.urdf", *free, "--out", files / "o", "--json")
    assert json.loads(done.stdout)["summary"]["joints"]["hinge"]["largest"] == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("arguments", "info"),
    [
        (["pendulum.yaml", "--reading", "corrected"], "--reading"),
        (["pendulum.yaml", "--contact"], "touches nothing"),
        (["pendulum.yaml", "--integrator", "eular"], "integration.method"),
        (["pendulum.yaml", "--duration", "-1"], "integration.duration"),
        (["pendulum.yaml", "--set", "links.link.bodies.bob.mass=-1"], "mass"),
        (["nowhere.yaml"], "a file that exists"),
    ],
)
def test_refusals(files, arguments, info):
    done = tmodes("run", files / arguments[0], *arguments[1:], "--out", files / "o", code=2)
    assert info in done.stderr
    assert not (files / "o").exists()


def test_without_contact(files):
    tmodes("run", files / "swinging.yaml", "--no-contact", "--no-report", "--duration", 0.05, "--out", files / "o")
    assert "contact_force" not in Result.load(files / "o" / "result.nc").data


def test_where_the_time_went(files):
    """By stage on the terminal, as JSON and in the report; without being asked nothing that changes from run to run."""
    line = ["run", files / "cantilever.yaml", "--no-live", "--duration", 0.02, "--overwrite", "--out", files / "o"]
    shown = tmodes(*line, "--timing").stdout
    report = (files / "o" / "report.html").read_text(encoding="utf-8")
    assert "Where the time went" in report
    spent = json.loads(tmodes(*line, "--timing", "--json").stdout)["stages_s"]
    assert {"reading", "actual robot", "lines", "modes", "integration error", "saving", "report"} <= set(spent)
    assert all(stage in shown for stage in spent)
    assert all(time >= 0 for times in spent.values() for time in times.values())
    assert "stages_s" not in json.loads(tmodes(*line, "--json").stdout)
    assert "Where the time went" not in (files / "o" / "report.html").read_text(encoding="utf-8")


def test_settling_in_another_band(tmp_path):
    """By an option of the run, and of a stored result; a wrong one says what it may be."""
    line = ["run", "spong1987", "--duration", "0.4", "--no-report", "--no-error-estimate", "--out", tmp_path]
    found = json.loads(tmodes(*line, "--settling-band", "0.2mm", "--json").stdout)["summary"]["settling"]
    assert found["limit_m"] == 2e-4
    shown = json.loads(tmodes("show", tmp_path, "--settling-band", "3 %", "--json").stdout)["summary"]["settling"]
    assert shown["limit_m"] == pytest.approx(0.03 * shown["move_m"])
    assert "0.1 mm" in tmodes("show", tmp_path, "--settling-band", "3 miles", code=2).stderr
