"""What a stored number depends on: digests of the robot, of the cases, and of the engine."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.registry import outside_digest

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["base_of", "canonical", "cases_address", "engine_of_blocks", "in_order", "restricted"]

_NOT_OF_A_CASE = ("distribution", "title")
"""Keys of a parameter that say which values it has, or what it is called: not what a value means."""


def canonical(data: Any) -> bytes:
    """Plain data as bytes, the same for the same data: for digests."""
    return json.dumps(data, sort_keys=True, separators=(",", ":")).encode()


def in_order(data: Any) -> bytes:
    """Plain data as bytes with their order, which is that of a study's parameters, and so of the columns of values."""
    return json.dumps(data, separators=(",", ":")).encode()


def _digest(*parts: bytes) -> str:
    """SHA-256 of parts, each with its length, as hexadecimal text."""
    whole = hashlib.sha256()
    for part in parts:
        whole.update(len(part).to_bytes(8, "little") + part)
    return whole.hexdigest()


def engine_of_blocks() -> str:
    """The version of what computes: that of the engine, and a digest of kinds that a user has registered."""
    from tmodes.study.identity import engine_version

    outside = outside_digest().encode()
    return engine_version() + (f"+{_digest(outside)[:16]}" if outside else "")


def base_of(study: Study) -> str:
    """Digest of what a case is, whatever computes it: the robot with its settings, and what each parameter means.

    Distributions are left out: a value that is the same from another distribution is the same case.
    """
    parameters = [
        [name, {key: value for key, value in entry.items() if key not in _NOT_OF_A_CASE}]
        for name, entry in study.data["study"]["parameters"].items()
    ]
    return _digest(canonical(study.data["robot"]), canonical(parameters))


def cases_address(base: str, names: Sequence[str], values: NDArray[np.float64]) -> str:
    """Address of the cases ``values`` (m, d) of the parameters ``names``: the same wherever in a study they stand."""
    numbers = np.ascontiguousarray(values, dtype="<f8")
    return _digest(base.encode(), canonical(list(names)), canonical(list(numbers.shape)), numbers.tobytes())


def restricted(study: Study, names: Sequence[str]) -> Study:
    """The study with these quantities alone, and those that they are made of."""
    wanted: set[str] = set()
    left = list(names)
    while left:
        name = left.pop()
        if name in study.sheet.quantities and name not in wanted:
            wanted.add(name)
            left += study.sheet.quantities[name].needs().names
    sheet = study.data["study"]
    if wanted == set(sheet["quantities"]):
        return study
    quantities = {name: entry for name, entry in sheet["quantities"].items() if name in wanted}
    own = {
        key: value for key, value in sheet.items() if key != "optimize"
    }  # it may name the quantities that are left out
    found = study.from_data({**study.data, "study": {**own, "quantities": quantities}}, functions=study.functions)
    return found if study.identified is None else replace(found, identified=study.identified)
