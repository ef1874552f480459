"""The studies of the folder examples: each is read and run, on a small scale."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tmodes.study.read import read_study
from tmodes.study.study import Study

FOLDER = Path(__file__).parents[3] / "examples" / "studies"

STUDIES = sorted(path.name for path in FOLDER.glob("*.yaml") if "kind: study" in path.read_text(encoding="utf-8"))

OPTIMUM = ("A50x2", 0.7328707342294283, 0.8903455683971954, 17.09247779447507)
"""The lightest tube: mass [kg], sag [mm], first frequency [Hz]: reference values computed in closed form."""


@pytest.mark.parametrize("name", STUDIES)
def test_it_is_read_and_keeps_its_identity(name):
    one = read_study(FOLDER / name)
    assert one.cases == len(one.design().values)
    assert Study.from_data(one.data).identity == one.identity


def test_scatter_of_gear_payload_and_link():
    one = read_study(FOLDER / "gear_stiffness.yaml")
    assert one.robot is not None
    short = replace(one, robot=one.robot.with_({"integration.duration": 0.1, "integration.output_step": 0.005}))
    rows = short.evaluate(0, short.design().values[:6])
    assert set(rows.status) == {"finished"}
    assert (rows.quantities["peak"] > 0).all()
    np.testing.assert_allclose(rows.quantities["swing"], rows.quantities["peak"] - rows.quantities["end"], atol=1e-15)
    assert sorted(rows.kept) == [0]
    assert rows.units["force"] == "N"


def test_ishigamis_function():
    one = read_study(FOLDER / "ishigami.yaml")
    rows = one.evaluate(0, one.design().values)
    assert rows.quantities["y"].mean() == pytest.approx(3.5, abs=0.01)
    assert rows.quantities["y"].var() == pytest.approx(13.844587940719254, rel=0.01)  # closed form


def test_the_lightest_tube():
    one = read_study(FOLDER / "tube.yaml")
    rows = one.evaluate(0, one.design().values)
    mass, sag, f1 = (rows.quantities[name] for name in ("mass", "sag", "f1"))
    best = int(np.argmin(np.where((sag <= 1.5) & (f1 >= 14.0), mass, np.inf)))
    name, *numbers = OPTIMUM
    assert one.choice_names("tube")[best] == name
    assert [mass[best], sag[best], f1[best]] == pytest.approx(numbers, rel=1e-4)
    assert int(((sag <= 1.5) & (f1 >= 14.0)).sum()) == 3
