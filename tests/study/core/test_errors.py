"""The column `errors`: what the step control has estimated, summed; null where nothing is estimated."""

from __future__ import annotations

import numpy as np
import pytest

from study.core.studies import short, study
from tmodes.study.runner import run_study

SERIES = {"peak": {"series": "tip.speed", "reduce": "max"}, "end": {"series": "tip.x", "reduce": "end"}}
METHODS = {"dormand_prince": 1e-5, "dop853": 1e-5, "extrapolation": 1e-6}


def rows_of(**settings):
    study = short(SERIES, plan={"type": "monte_carlo", "runs": 20}, set={
        "integration.duration": 0.3, "integration.output_step": 0.01,
        **{f"integration.{name}": value for name, value in settings.items()},
    })  # fmt: skip
    return study.evaluate(0, study.design().values)


@pytest.mark.parametrize("method", list(METHODS))
def test_it_is_more_than_the_error_and_falls_with_the_tolerance(method):
    loose, tight = (rows_of(method=method, relative_tolerance=METHODS[method] * share) for share in (1.0, 1e-2))
    exact = rows_of(method="dop853", relative_tolerance=1e-12)
    for rows in (loose, tight):
        assert (rows.errors > 0).all()
        for name, values in rows.quantities.items():
            true = np.abs(values - exact.quantities[name]) / np.abs(exact.quantities[name])
            assert (true < rows.errors).all()
    assert (tight.errors < 0.1 * loose.errors).all()


def test_fixed_steps_and_formulas_have_none():
    assert np.isnan(rows_of(method="rk4", step=1e-4).errors).all()
    formula = study()
    assert np.isnan(formula.evaluate(0, formula.design().values).errors).all()


def test_the_table_has_it_through_blocks_on_the_disk(tmp_path):
    asked = short(SERIES, plan={"type": "monte_carlo", "runs": 20}, block=8)
    table = run_study(asked, tmp_path).table()
    rows = asked.evaluate(0, asked.design().values)
    assert table["errors"].to_pylist() == pytest.approx(rows.errors.tolist(), rel=1e-6)
    assert table.schema.field("errors").metadata[b"unit"] == b"-"
    empty = run_study(study(), tmp_path / "formulas").table()
    assert empty["errors"].null_count == len(empty)
