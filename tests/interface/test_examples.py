"""Every public name has a docstring with an example, and the examples run as they stand."""

from __future__ import annotations

import doctest
import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydantic import BaseModel

import tmodes
from tmodes.kinds.schema.quantity import DataSheet

STUDY = """\
format: 1
kind: study
name: s
parameters: {k: {distribution: {type: uniform, low: 1, high: 2}}}
plan: {type: monte_carlo, runs: 4, seed: 0}
quantities: {y: {expression: "k**2"}}
optimize: {objectives: [{minimize: y}]}
"""
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.IGNORE_EXCEPTION_DETAIL
LIBRARY = {*vars(BaseModel), *vars(DataSheet), *vars(Exception), *vars(BaseException)}


def public() -> Iterator[tuple[str, Any]]:
    """The names of ``tmodes``, and of its classes the methods that are not another library's."""
    for name in tmodes.__all__:
        one = getattr(tmodes, name)
        yield name, one
        for inner in dir(one) if isinstance(one, type) else ():
            member = inspect.getattr_static(one, inner)
            plain = inspect.isfunction(getattr(member, "__func__", member))
            if plain and not inner.startswith("_") and inner not in LIBRARY:
                yield f"{name}.{inner}", getattr(one, inner)
    yield "Robot.outputs", tmodes.Robot.outputs


NAMES = dict(public())


@pytest.fixture(scope="module")
def known() -> dict[str, Any]:
    """What examples start from."""
    robot = tmodes.load("spong1987").with_({"integration.duration": 0.1})
    return {"tmodes": tmodes, "np": np, "robot": robot, "model": tmodes.Model(robot), "result": robot.run()}


def test_there_are_many() -> None:
    assert len(NAMES) > 80
    assert {"Robot.modes", "Model.mass_matrix", "Result.load", "run", "Study.evaluate"} <= NAMES.keys()


@pytest.mark.parametrize("name", NAMES)
def test_its_example_runs(name: str, known: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("study.yaml").write_text(STUDY, encoding="utf-8")
    Path("own.py").write_text("", encoding="utf-8")
    examples = doctest.DocTestParser().get_examples(inspect.getdoc(NAMES[name]) or "")
    assert examples, f"{name} has no example"
    said: list[str] = []
    test = doctest.DocTest(examples, dict(known), name, None, None, None)
    found = doctest.DocTestRunner(optionflags=FLAGS).run(test, out=said.append)
    assert found.failed == 0, "".join(said)
