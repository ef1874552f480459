"""What every quantity of interest keeps, those of a user's script among them: a ratio is defined here."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
import pytest
from pydantic import Field

from study.core.studies import short
from tmodes.study.quantities import QUANTITIES, Asked, Needs, Quantity
from tmodes.study.quantities.contract import Found
from tmodes.study.study import Study


class Ratio(Quantity):
    """One quantity over another."""

    type: Literal["ratio"] = Field(description="kind of quantity")
    over: str = Field(description="name of a quantity")
    under: str = Field(description="name of a quantity")

    def needs(self) -> Needs:
        """Both."""
        return Needs(names=(self.over, self.under))

    def values(self, asked: Asked) -> Found:
        """Their ratio."""
        return asked.values[self.over] / asked.values[self.under], {}


@pytest.fixture(autouse=True, scope="module")
def ratio() -> Iterator[None]:
    """It is registered where it is defined."""
    QUANTITIES.register(Ratio)
    yield
    QUANTITIES.unregister("ratio")


def height(result: Any) -> float:
    """Height of the tip at the end [m]."""
    return float(result.motion["tip"].values[-1, 2])


EXAMPLES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "series": ({"series": "deviation", "reduce": "max"}, {"unit": "mm"}),
    "static": ({"name": "sag"}, {"unit": "mm"}),
    "summary": ({"path": "deviation.max_m"}, {"unit": "mm"}),
    "expression": ({"formula": "gear**2"}, {}),
    "function": ({"name": "height"}, {}),
    "ratio": ({"over": "base", "under": "gear"}, {}),
}
"""One of each kind, and what converts it; one without an entry fails."""

NAMES = sorted({*QUANTITIES, "ratio"})


@pytest.mark.parametrize("name", NAMES)
def test_it_gives_a_finite_number_of_each_case_in_its_unit(name):
    data, unit = EXAMPLES[name]
    given = {"base": {"expression": "3*gear"}, "a": {"type": name, **data}, "b": {"type": name, **data, **unit}}
    one = short(given, functions={"height": height})
    rows = one.evaluate(5, np.array([[0.9], [1.1]]), threads=1)
    assert rows.case.tolist() == [5, 6]
    assert [*rows.status] == ["finished", "finished"]
    assert np.isfinite(rows.quantities["a"]).all()
    assert (rows.quantities["a"] != 0).any()
    if unit:
        assert rows.units["b"] == "mm"
        np.testing.assert_allclose(rows.quantities["b"], 1e3 * rows.quantities["a"], rtol=1e-12)
    again = Study.from_data(one.data, functions=one.functions)
    assert again.quantity_identities == one.quantity_identities


@pytest.mark.parametrize("name", NAMES)
def test_its_digest_is_of_what_it_says_and_not_of_its_title(name):
    data, _ = EXAMPLES[name]
    plain, titled = (Quantity.of({"type": name, **data, "title": title}) for title in ("", "a title"))
    assert plain.digest({}) == titled.digest({})
    assert plain.digest({}) != Quantity.of({"type": name, **data, "unit": "km"}).digest({})
    assert not math.isnan(len(plain.digest({})))
