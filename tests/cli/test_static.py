"""``tmodes static``: loads from the line, tables, JSON, refusals."""

from __future__ import annotations

import json

import numpy as np
import pytest

from command import tmodes

ARM = "spong1987"


def test_json_holds_everything():
    """5 N*m about y on a gear of 100 N*m/rad, weight 9.8 N at 1 m below."""
    info = json.loads(tmodes("static", ARM, "--moment", "0,5,0", "--json").stdout)
    angle = info["coordinates"]["joint"]
    assert 100 * angle + 9.8 * np.sin(angle) == pytest.approx(5.0, rel=1e-9)
    assert info["stable"] is True
    assert info["held"] == ["joint.motor"]
    assert info["stiffness"]["directions"][4]["unit"] == "N*m/rad"
    assert info["units"]["residual"]


def test_tables():
    out = tmodes("static", ARM, "--load", "point=tip,force=1,0,0,frame=section", "--hold", "joint.motor=0.2").stdout
    assert "stable" in out
    assert "joint.gear" in out


def test_each_value_of_the_pose_has_its_unit_and_rounding_is_zero():
    """The gear of 2010 turns by 1e-29 rad under weight across its axis; the links sag by 1.29 mrad."""
    rows = [line.split() for line in tmodes("static", "filipovic2010").stdout.splitlines() if line.strip()]
    assert ["joint", "0", "rad"] in rows
    assert ["link.elevation1", "-0.00129016", "rad"] in rows
    assert not [cell for row in rows for cell in row if "e-" in cell]


def test_a_slide_is_in_metres(tmp_path):
    joint = {"name": "slide", "type": "prismatic", "parent": "base", "child": "cart", "axis": [0, 0, 1],
             "motor": {"inertia": 1.0, "side": "joint"}, "gear": {"stiffness": 1e4, "damping": 1.0}}  # fmt: skip
    cart = {"name": "cart", "bodies": [{"name": "body", "mass": 2.0, "center": [0, 0, 0]}]}
    drive = {"joint": "slide", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}}
    file = tmp_path / "slide.yaml"
    data = {"format": 1, "kind": "arm", "name": "slide", "gravity": 9.81, "joints": [joint], "links": [cart],
            "drives": [drive]}  # fmt: skip
    file.write_text(json.dumps(data), encoding="utf-8")
    rows = [line.split() for line in tmodes("static", file).stdout.splitlines()]
    assert ["slide", "-0.001962", "m"] in rows


@pytest.mark.parametrize(
    ("arguments", "info"),
    [
        (["--load", "point=tyre,force=0,0,1"], "tyre"),
        (["--load", "force=0,0"], "three numbers"),
        (["--load", "farce=0,0,1"], "--load"),
        (["--load", "force=0,nan,0"], "finite"),
        (["--load", "force=0,one,0"], "numbers"),
        (["--force", "1,2,inf"], "finite"),
        (["--hold", "joint"], "COORDINATE=VALUE"),
        (["--hold", "jiont=0"], "joint"),
        (["--point", "elbow"], "tip"),
    ],
)
def test_wrong_lines_are_refused(arguments, info):
    assert info in tmodes("static", ARM, *arguments, code=2).stderr


def test_the_robot_of_2010():
    """A force along y at 0.9 m gives way l^2/k at the gear of 4700 N*m/rad, the rest in the link."""
    info = json.loads(tmodes("static", "filipovic2010", "--json").stdout)
    assert info["stable"] is True
    assert info["held"] == ["joint.motor"]
    along = info["stiffness"]["directions"][1]
    assert along["shares"]["joint.gear"] == pytest.approx(along["stiffness"] * 0.9**2 / 4700, rel=2e-3)


def test_buckling_is_reported():
    """Upwards 300 N on a hanging meter, 100 N*m/rad: beyond the load that it carries upright."""
    done = tmodes("static", ARM, "--force", "0,0,300")
    assert "NOT STABLE" in done.stdout
    assert "buckles" in done.stderr
