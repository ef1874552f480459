"""The lightest tubes of an arm that moves, with a limit on how long it takes to settle."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from study.optimize.tubes import EXAMPLES
from tmodes.study.optimize import optimize
from tmodes.study.read import read_study
from tmodes.study.ways import results

SAG, FREQUENCY, SETTLING = 2.5, 9.0, 0.12


@pytest.fixture
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    """All runs in this process: new ones would take longer than these few runs."""
    monkeypatch.setattr(results.os, "cpu_count", lambda: 1)


@pytest.mark.nightly
@pytest.mark.usefixtures("here")
def test_a_search_finds_the_optimum_of_all_pairs_and_settling_decides() -> None:
    pytest.importorskip("optuna")
    study = read_study(EXAMPLES / "lightest_moving_arm.yaml")
    rows = study.evaluate(0, study.design().values)
    mass, sag, f1, settling = (rows.quantities[name] for name in ("mass", "sag", "f1", "settling"))
    names = study.choice_names("upper")
    pairs = [*itertools.product(names, names)]

    def lightest(kept: np.ndarray) -> tuple[str, str]:
        return pairs[int(np.argmin(np.where(kept, mass, np.inf)))]

    still = (sag <= SAG) & (f1 >= FREQUENCY)
    best = lightest(still & (settling <= SETTLING))
    assert len(rows) == 36
    assert np.isfinite(settling).all()
    assert best != lightest(still)

    found = optimize(study, "tpe", trials=24)
    assert found.designs <= 24
    assert found.best is not None
    assert (found.best.choices["upper"], found.best.choices["lower"]) == best
