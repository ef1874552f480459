"""``tmodes eval`` of arms against Spong's equations: I q'' + m g l sin q + k (q - th) = 0, J th'' = k (q - th) + u."""

from __future__ import annotations

import json

import numpy as np
import pytest

from command import tmodes

ARM = "spong1987"


def test_against_the_paper(tmp_path):
    file = tmp_path / "states.json"
    file.write_text(json.dumps({"states": [{"q": {"joint": 0.3}, "v": [0.5, -0.7], "effort": {"joint": 2.0}}]}))
    info = json.loads(tmodes("eval", ARM, "--states", file, "--json").stdout)
    (state,) = info["states"]
    assert info["coordinates"] == ["joint.motor", "joint"]
    assert state["a"] == pytest.approx([(2 + 100 * 0.3) / 0.3, -9.8 * np.sin(0.3) - 100 * 0.3], rel=1e-12)
    assert np.array(state["M"]) == pytest.approx(np.diag([0.3, 1.0]), abs=1e-15)
    assert state["g"] == pytest.approx([0, 9.8 * np.sin(0.3)], rel=1e-12)
    assert state["f_el"] == pytest.approx([-30.0, 30.0])
    assert state["energies"]["elastic_gear"] == pytest.approx(50 * 0.09)
    assert state["energies"]["kinetic"] == pytest.approx(0.15 * 0.25 + 0.5 * 0.49)
    tip = state["points"]["tip"]
    assert tip["position"] == pytest.approx([-np.sin(0.3), 0, -np.cos(0.3)])
    assert np.array(tip["J"])[:, 1] == pytest.approx([-np.cos(0.3), 0, np.sin(0.3), 0, 1, 0], abs=1e-14)
    assert info["units"]["M"]
    balance = np.array(state["M"]) @ state["a"] + state["h"] + state["f_el"]
    assert balance == pytest.approx([2.0, 0.0], abs=1e-12)


def test_a_table_is_the_same_as_records(tmp_path):
    (tmp_path / "s.csv").write_text("joint, joint.rate, effort.joint\n0.3,1,0\n\n0.1,0,2\n")
    records = [{"q": [0, 0.3], "v": [0, 1]}, {"q": [0, 0.1], "effort": [2]}]
    (tmp_path / "s.json").write_text(json.dumps(records))
    info = [tmodes("eval", ARM, "--states", tmp_path / name, "--json").stdout for name in ("s.csv", "s.json")]
    assert info[0] == info[1]
    assert "Accelerations" in tmodes("eval", ARM, "--states", tmp_path / "s.csv").stdout


@pytest.mark.parametrize(
    ("name", "content", "info"),
    [
        ("a.json", '[{"q": [1]}]', "2 numbers"),
        ("a.json", '[{"q": {"jiont": 1}}]', "Did you mean `joint`"),
        ("a.json", '[{"q": [0, NaN]}]', "finite"),
        ("a.json", '[{"v": [0, 0]}]', "add `q`"),
        ("a.json", '{"q": [0, 0]}', "a list of records"),
        ("a.json", "[]", "an empty list"),
        ("a.json", "[", "broken JSON"),
        ("a.csv", "joint\none\n", "a number"),
        ("a.csv", "joint,joint\n1,2\n", "stands twice"),
        ("a.csv", "joint\n1,2\n", "2 cells"),
        ("a.csv", "elbow\n1\n", "'elbow'"),
        ("a.csv", "joint\ninf\n", "finite"),
    ],
)
def test_refusals(tmp_path, name, content, info):
    (tmp_path / name).write_text(content)
    done = tmodes("eval", ARM, "--states", tmp_path / name, code=2)
    assert info in done.stderr
