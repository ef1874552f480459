"""The identity of a study: it follows from all that a row depends on, and from nothing else."""

from __future__ import annotations

import pickle
from typing import Any

import pytest

from study.core.studies import short, study
from tmodes.study.study import Study

PEAK = {"peak": {"series": "deviation", "reduce": "max"}}
GEAR = {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 0.8, "high": 1.2}}


def changed(**more: Any) -> Study:
    """The short study with something else."""
    return short(more.pop("quantities", PEAK), more.pop("parameters", {"gear": GEAR}), **more)


def test_it_is_the_same_again_and_after_a_round_trip():
    first = changed()
    assert changed().identity == first.identity
    assert Study.from_data(first.data).identity == first.identity
    assert pickle.loads(pickle.dumps(first)).identity == first.identity  # noqa: S301


@pytest.mark.parametrize(
    "more",
    [
        {"plan": {"type": "grid"}},
        {"keep": {"cases": [1]}},
        {"title": "another"},
        {"parameters": {"gear": {**GEAR, "distribution": {"type": "uniform", "low": 0.1, "high": 2.0}}}},
        {"quantities": {"peak": {"type": "series", "series": "deviation", "reduce": "max", "title": "a title"}}},
    ],
)
def test_which_cases_are_run_does_not_matter(more):
    assert changed(**more).identity == changed().identity


@pytest.mark.parametrize(
    "more",
    [
        {"set": {"integration.duration": 0.1, "integration.output_step": 0.005}},
        {"parameters": {"gear": {**GEAR, "relative": False}}},
        {"parameters": {"gear": {**GEAR, "path": "gear.damping"}}},
        {"robot": "spong1987", "set": {}, "parameters": {"gear": {**GEAR, "path": "joints.0.gear.stiffness"}}},
    ],
)
def test_robot_and_paths_matter(more):
    assert changed(**more).base_identity != changed().base_identity


def test_a_quantity_that_is_added_changes_no_other():
    more = changed(quantities={**PEAK, "end": {"series": "tip.z", "reduce": "end"}})
    assert more.base_identity == changed().base_identity
    assert more.quantity_identities["peak"] == changed().quantity_identities["peak"]
    assert more.identity != changed().identity


def test_an_expression_depends_on_what_it_needs():
    one, other = (
        changed(quantities={"a": {"series": "tip.z", "reduce": how}, "b": {"expression": "2*a"}})
        for how in ("max", "min")
    )
    assert one.quantity_identities["b"] != other.quantity_identities["b"]


def test_a_function_is_known_by_its_code():
    functions = [lambda result: 1.0, lambda result: 2.0]
    digests = {
        short({"a": {"function": "f"}}, functions={"f": one}).quantity_identities["a"]
        for one in (*functions, functions[0])
    }
    assert len(digests) == 2


def test_entries_of_a_choice_matter():
    one, other = (
        short(PEAK, {"size": {"choices": [{"name": "A", "set": {"gear.stiffness": value}}]}}) for value in (4e3, 5e3)
    )
    assert one.base_identity != other.base_identity


def test_the_data_say_all_without_files():
    data = study().data
    assert set(data) == {"study", "robot"}
    assert data["robot"] is None
    assert changed().data["robot"]["name"] == "filipovic2010"
