# pyright: reportArgumentType=false, reportCallIssue=false
"""``tmodes modes`` of an arm."""

from __future__ import annotations

import json
import re
from importlib import resources

import numpy as np
import pytest
from scipy.optimize import brentq

from analysis.sheets import clamped_sheet, locked_sheet
from command import tmodes
from tmodes import load
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import equilibrium
from tmodes.model.model import Model


def test_json():
    info = json.loads(tmodes("modes", "spong1987", "--json").stdout)
    assert 2 * np.pi * info["real"]["locked"][0]["frequency_Hz"] == pytest.approx(np.sqrt(109.8), rel=1e-9)
    assert set(info["real"]) == {"locked", "free", "controlled"}
    assert "nominal" not in info


def test_real_and_known_arm():
    info = tmodes("modes", "spong1987", "--set", "real.joints.joint.gear.stiffness=0.8").stdout
    assert "actual robot, motor locked" in info
    assert "nominal robot, motor locked" in info


@pytest.mark.parametrize("arguments", [["--angle", "1e4"], ["--contact"], ["--reading", "printed"]])
def test_what_an_arm_has_not_is_refused(arguments):
    assert arguments[0] in tmodes("modes", "spong1987", *arguments, code=2).stderr


def test_table_and_json_have_the_same_frequencies_and_damping():
    rows = [line.split() for line in tmodes("modes", "spong1987").stdout.splitlines() if line.strip()]
    modes = json.loads(tmodes("modes", "spong1987", "--json").stdout)["real"]
    assert modes["locked"][0]["damping_ratio"] >= 0
    for mode in (*modes["locked"], *modes["controlled"]):
        rings = [f"{mode['frequency_Hz']:.4g}", f"{mode['damping_ratio']:.4f}"]
        numbers = [f"{mode['time_constant_s']:.3g}"] if mode["time_constant_s"] else rings
        assert any(row[0] == mode["element"] and set(numbers) <= set(row) for row in rows), mode


def test_a_robot_without_a_motor_has_one_table(tmp_path):
    file = tmp_path / "beam.yaml"
    file.write_text(json.dumps(clamped_sheet()), encoding="utf-8")
    assert [*json.loads(tmodes("modes", file, "--json").stdout)["real"]] == ["locked"]
    assert tmodes("modes", file).stdout.count("damping ratio") == 1


def test_at_an_angle_of_the_motor():
    """Spring and weight: 100 (q - 0.5) + 9.8 sin q = 0 at rest, about which w^2 = 100 + 9.8 cos q."""
    info = json.loads(tmodes("modes", "spong1987", "--angle", "0.5", "--json").stdout)
    angle = brentq(lambda q: 100 * (q - 0.5) + 9.8 * np.sin(q), 0, 0.5)
    hertz = info["real"]["locked"][0]["frequency_Hz"]
    assert 2 * np.pi * hertz == pytest.approx(np.sqrt(100 + 9.8 * np.cos(angle)), rel=1e-8)


@pytest.mark.parametrize("command", ["describe", "static", "modes"])
def test_nothing_moves(command, tmp_path):
    """A locked joint and a rigid rod: said in words, not a fault."""
    file = tmp_path / "locked.yaml"
    file.write_text(json.dumps(locked_sheet()), encoding="utf-8")
    done = tmodes(command, file)
    assert "nothing in it moves or bends" in done.stdout + done.stderr
    assert json.loads(tmodes(command, file, "--json").stdout)


def test_modes_that_are_not_converged_are_marked(tmp_path):
    """Three functions: 5.596 and 35.07 Hz exact, the third 6 % high; links are reported in table and JSON."""
    file = tmp_path / "clamped.yaml"
    file.write_text(json.dumps(clamped_sheet(functions={"bend_y": 3}, basis="tip_weighted")), encoding="utf-8")
    done = tmodes("modes", file)
    assert "! +6" in done.stdout
    assert "model holds" in done.stdout
    assert "not converged" in done.stderr
    info = json.loads(tmodes("modes", file, "--json").stdout)
    assert [mode["converged"] for mode in info["real"]["locked"]] == [True, True, False]
    assert info["links"]["real"][0]["verdict"] == "good"


def test_growth_is_reported_in_seconds(tmp_path):
    """A hanging meter whose 200 N pull upwards: 100 N*m/rad are too soft, it tips over."""
    text = (resources.files("tmodes.robots") / "spong1987.yaml").read_text(encoding="utf-8")
    file = tmp_path / "tipping.yaml"
    file.write_text(re.sub(r"(?m)^gravity:.*$", "gravity: [0, 0, 200]", text), encoding="utf-8")
    out = tmodes("modes", file).stdout
    assert "UNSTABLE" in out
    assert "grows by e in" in out


@pytest.mark.parametrize("pose", ["joint1=0.3,joint2=-20deg,joint3=1.1", "joint3.motor=-0.5"])
def test_at_a_pose_and_up_to_a_frequency(pose: str) -> None:
    """The same as with drives that begin there."""
    values = {name.removesuffix(".motor"): value for name, value in (part.split("=") for part in pose.split(","))}
    starts = {f"drives.{int(name[-1]) - 1}.signal": {"type": "constant", "value": value}
              for name, value in values.items()}  # fmt: skip
    given = vibrations(load("manutec_r3").with_(starts).pair().real).states
    asked = json.loads(tmodes("modes", "manutec_r3", "--at", pose, "--json").stdout)["real"]
    for state, rows in given.items():
        found = [row["frequency_Hz"] for row in asked[state]]
        assert found == pytest.approx([row["frequency_Hz"] for row in rows], rel=1e-9, abs=1e-9)
    few = json.loads(tmodes("modes", "manutec_r3", "--at", pose, "--max-frequency", 26, "--json").stdout)["real"]
    for rows in few.values():
        assert [row["frequency_Hz"] for row in rows] == [x for x in (r["frequency_Hz"] for r in rows) if x <= 26]
    assert 0 < len(few["locked"]) < 3


@pytest.mark.parametrize(("arguments", "words"), [
    (("--at", "joint9=1"), "--at must be joints that move: joint1"),
    (("--at", "joint1"), "--at must be COORDINATE=VALUE"),
    (("--at", "joint1=2m"), "--at joint1"),
    (("--max-frequency", "0"), "a frequency > 0 Hz"),
])  # fmt: skip
def test_poses_that_are_none(arguments: tuple[str, ...], words: str) -> None:
    assert words in tmodes("modes", "manutec_r3", *arguments, code=2).stderr


def test_at_a_pose_of_static_and_describe() -> None:
    rest = json.loads(tmodes("static", "spong1987", "--at", "joint=0.5", "--json").stdout)
    assert rest["coordinates"]["joint.motor"] == 0.5
    sag = json.loads(tmodes("describe", "spong1987", "--at", "joint=0.5", "--json").stdout)["sag"]
    assert sag["displacement_size_m"] == pytest.approx(rest["points"][0]["displacement_size_m"], rel=1e-9)


def test_a_pose_means_the_same_to_every_command_and_in_python():
    """A joint behind an elastic gear is held by its motor: 100 (q - 0.5) + 9.8 sin q = 0."""
    angle = brentq(lambda q: 100 * (q - 0.5) + 9.8 * np.sin(q), 0, 0.5)
    robot = load("spong1987")
    poses = [
        robot_rest(robot, held={"joint": 0.5}).named,
        robot_rest(robot, held={"joint.motor": 0.5}).named,
        equilibrium(Model(robot), held={"joint": 0.5}).named,
        *(json.loads(tmodes("static", "spong1987", option, "joint=0.5", "--json").stdout)["coordinates"]
          for option in ("--at", "--hold")),
    ]  # fmt: skip
    for pose in poses:
        assert pose["joint.motor"] == 0.5
        assert pose["joint"] == pytest.approx(angle, rel=1e-9)
    both = robot_rest(robot, held={"joint": 0.5, "joint.motor": 0.25}).named
    assert (both["joint"], both["joint.motor"]) == (0.5, 0.25)


def test_tables_are_headed_with_what_they_are_of():
    for command in ("modes", "static", "describe"):
        printed = " ".join(tmodes(command, "spong1987", "--at", "joint=0.5").stdout.split())
        assert "free space, gravity 9.8" in printed
        assert "at joint=0.5" in printed


def test_tables_without_the_contact_that_closes_a_loop_say_so(tmp_path):
    path = tmp_path / "rocker.yaml"
    path.write_text(
        "{format: 1, kind: arm, name: rocker, gravity: 9.81,"
        " joints: [{name: crank, type: revolute, child: crank, axis: [0, 1, 0], state: free}],"
        " links: [{name: crank, bodies: [{mass: 1.0, center: [0, 0, -0.1], inertia: 0.003}]}],"
        " tip: {link: crank, position: [0, 0, -0.2]},"
        " contact: {law: bilateral, point: tip, stiffness: 1e4, damping: 1.0,"
        " shape: {type: ball, center: [0.4, 0, -0.2], radius: 0.4}}}"
    )
    opened, closed = (tmodes("modes", str(path), *more).stdout for more in ((), ("--contact",)))
    assert "loop open" in opened
    assert "free space" not in opened
    assert "in contact" in closed
