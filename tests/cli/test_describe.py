"""``tmodes describe``: tables and JSON."""

from __future__ import annotations

import json

from command import tmodes


def test_tables_and_json_agree():
    out = tmodes("describe", "deluca_siciliano1991").stdout
    info = json.loads(tmodes("describe", "deluca_siciliano1991", "--json").stdout)
    assert info["links"][0]["model"] == "strain"
    assert f"{info['links'][0]['bare_bend_z_Hz']:.4g}" in out
    assert "upper_arm.bend_z 87.5%" in out


def test_columns_without_a_number_are_left_out():
    """Links of bodies alone have no bending stiffness; those of beams do."""
    heads = [tmodes("describe", name).stdout for name in ("spong1987", "deluca_siciliano1991")]
    assert ["EI y, z" in head for head in heads] == [False, True]
    assert all("mass [kg]" in head for head in heads)


def test_a_change_is_described():
    changed = tmodes("describe", "spong1987", "--set", "joints.joint.gear.stiffness=250", "--json")
    assert json.loads(changed.stdout)["gears"][0]["stiffness"] == [250.0]


def test_unknown_arm():
    assert "sponge" in tmodes("describe", "sponge1987", code=2).stderr
