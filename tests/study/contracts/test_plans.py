"""What every plan keeps, those of a user's script among them: one of corners is defined here."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
import pytest
from pydantic import Field

from study.core.studies import study
from tmodes.study.plans import PLANS, Design, Plan
from tmodes.study.plans.contract import Space


class Corners(Plan):
    """All corners."""

    type: Literal["corners"] = Field(description="kind of plan")

    def cases(self, space: Space) -> int:
        """Two to the number of parameters."""
        return 2 ** len(space.names)

    def design(self, space: Space) -> Design:
        """All combinations of ends."""
        return Design(space.between(np.array([*itertools.product((0.0, 1.0), repeat=len(space.names))])))


@pytest.fixture(autouse=True, scope="module")
def corners() -> Iterator[None]:
    """It is registered where it is defined."""
    PLANS.register(Corners)
    yield
    PLANS.unregister("corners")


EXAMPLES: dict[str, dict[str, Any]] = {
    "grid": {"levels": 3, "levels_of": {"b": 4}},
    "random": {"runs": 37},
    "latin_hypercube": {"runs": 37},
    "sobol": {"runs": 37},
    "monte_carlo": {"runs": 37},
    "one_at_a_time": {"points": 4},
    "tolerance": {},
    "list": {"rows": [{"a": 0.5, "b": 3.0}, {"c": 2.0}]},
    "corners": {},
    "saltelli": {"samples": 64},
    "morris": {"trajectories": 8},
}
"""One of each plan; one without an entry fails."""

NESTED = {"random", "sobol", "monte_carlo"}
"""Plans whose longer ones begin as the shorter ones."""

PARAMETERS = {
    "a": {"distribution": {"type": "uniform", "low": 0.0, "high": 1.0}},
    "b": {"distribution": {"type": "triangular", "low": 2.0, "mode": 3.0, "high": 4.0}},
    "c": {"distribution": {"type": "discrete", "values": [1.0, 2.0, 5.0]}},
}

NAMES = sorted({*PLANS, "corners"})


def planned(name: str, seed: int | None = None, **more: Any) -> Design:
    """The design of an example."""
    plan = {"type": name, **EXAMPLES[name], **more} | ({} if seed is None else {"seed": seed})
    made = study(PARAMETERS, plan=plan)
    design = made.design()
    assert made.cases == len(design.values)
    return design


@pytest.mark.parametrize("name", NAMES)
def test_its_cases_are_within_the_ranges_and_the_same_each_time(name):
    design = planned(name)
    assert design.values.shape[1] == 3
    assert np.isfinite(design.values).all()
    low, high = np.array([0.0, 2.0, 1.0]), np.array([1.0, 4.0, 5.0])
    assert (design.values >= low).all()
    assert (design.values <= high).all()
    assert set(design.values[:, 2].tolist()) <= {1.0, 2.0, 5.0}
    assert planned(name).values.tobytes() == design.values.tobytes()
    assert all(0 <= case < len(design.values) for case in design.labels)


@pytest.mark.parametrize("name", sorted(name for name in NAMES if "seed" in PLANS.get(name, Corners).model_fields))
def test_another_seed_has_other_cases(name):
    assert planned(name, seed=5).values.tobytes() != planned(name, seed=6).values.tobytes()


@pytest.mark.parametrize("name", sorted(NESTED))
def test_a_longer_one_begins_as_the_shorter(name):
    short, long = planned(name, runs=37), planned(name, runs=100)
    assert long.values[:37].tobytes() == short.values.tobytes()


def test_a_longer_latin_hypercube_is_another_one():
    """As its documentation says."""
    assert "Not nested" in (PLANS["latin_hypercube"].__doc__ or "")
    short, long = planned("latin_hypercube", runs=37), planned("latin_hypercube", runs=100)
    assert not np.array_equal(long.values[:37], short.values)


@pytest.mark.parametrize("name", ["random", "monte_carlo"])
def test_a_parameter_that_is_added_changes_no_other(name):
    plan = {"type": name, "runs": 20}
    few = study({"a": PARAMETERS["a"]}, plan=plan).design().values
    more = study({"z": PARAMETERS["b"], "a": PARAMETERS["a"]}, plan=plan).design().values
    assert np.array_equal(more[:, 1], few[:, 0])


def test_a_latin_hypercube_has_one_case_in_each_share():
    values = planned("latin_hypercube").values[:, 0]
    assert sorted(np.floor(values * 37).astype(int).tolist()) == [*range(37)]


def test_sobol_says_when_it_is_not_balanced():
    assert "32 or 64" in planned("sobol").notices[0]
    assert planned("sobol", runs=64).notices == ()
    values = planned("sobol", runs=64).values[:, 0]
    assert sorted(np.floor(values * 64).astype(int).tolist()) == [*range(64)]


def test_a_grid_has_all_combinations_the_last_parameter_fastest():
    values = planned("grid", points={"a": [0.1, 0.7]}).values
    assert len(values) == 2 * 4 * 3
    assert values[:4].tolist() == [[0.1, 2.0, 1.0], [0.1, 2.0, 2.0], [0.1, 2.0, 5.0], [0.1, pytest.approx(8 / 3), 1.0]]


def test_one_at_a_time_leaves_all_others_nominal():
    design = planned("one_at_a_time")
    nominal = design.values[design.info["nominal"]]
    assert nominal.tolist() == [0.5, 3.0, 2.0]
    for k, name in enumerate("abc"):
        part = design.values[slice(*design.info["ranges"][name])]
        assert (np.delete(part, k, axis=1) == np.delete(nominal, k)).all()
        assert len(np.unique(part[:, k])) == len(part)


def test_tolerance_has_ends_and_corners():
    design = planned("tolerance")
    assert design.values[design.info["low"]["b"]].tolist() == [0.5, 2.0, 2.0]
    assert design.values[design.info["high"]["c"]].tolist() == [0.5, 3.0, 5.0]
    corners = design.values[slice(*design.info["corners"])]
    assert len({*map(tuple, corners.tolist())}) == 8
    assert design.labels[design.info["high"]["a"]] == "a high"


def test_many_tolerances_have_no_corners_and_say_so():
    many = {f"p{k}": PARAMETERS["a"] for k in range(13)}
    design = study(many, plan={"type": "tolerance"}).design()
    assert len(design.values) == 1 + 2 * 13
    assert "too many corners" in design.notices[0]


def test_written_cases_take_what_they_leave_out_from_the_middle():
    assert planned("list").values.tolist() == [[0.5, 3.0, 2.0], [0.5, 3.0, 2.0]]
