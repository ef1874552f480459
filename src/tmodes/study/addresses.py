"""What a stored number depends on: digests of the robot, of each quantity, of the cases, and of the engine."""

from __future__ import annotations

import hashlib
import inspect
import json
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.cache import source_digest
from tmodes.kinds.registry import outside_digest

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["base_of", "canonical", "cases_address", "engine_version", "quantity_keys", "restricted"]

_ENGINE = (
    "analysis", "chain", "compile", "equations", "integrate", "kinds", "model", "result", "sensitivity", "sheet",
    "simulation", "study/quantities",
)  # fmt: skip
"""Source from which the numbers of a case follow."""

_NOT_OF_A_CASE = ("name", "title", "plan", "quantities", "keep", "optimize", "block", "correlations")
"""Keys of a study that say which cases are run and what is asked of them, not what a case is."""


def canonical(data: Any) -> bytes:
    """Plain data as bytes, the same for the same data."""
    return json.dumps(data, sort_keys=True, separators=(",", ":")).encode()


def _digest(*parts: bytes) -> str:
    """SHA-256 of parts, each with its length, as hexadecimal text."""
    whole = hashlib.sha256()
    for part in parts:
        whole.update(len(part).to_bytes(8, "little") + part)
    return whole.hexdigest()


@cache
def _source() -> str:
    return source_digest(_ENGINE)


def engine_version() -> str:
    """The version of what computes: that of tmodes, a digest of its source, and of kinds that a user has registered."""
    from tmodes import __version__

    outside = outside_digest().encode()
    return f"{__version__}-{_source()[:16]}" + (f"-{_digest(outside)[:16]}" if outside else "")


def base_of(study: Study) -> str:
    """Digest of what a case is: the robot, its settings, and where each parameter acts; not which cases, nor what for.

    Distributions are left out: a value that is the same from another distribution is the same case.
    """
    data = {key: value for key, value in study.data.items() if key not in _NOT_OF_A_CASE}
    drawn = ("distribution", "title")
    parameters = {
        name: {key: value for key, value in entry.items() if key not in drawn}
        for name, entry in study.data.get("parameters", {}).items()
    }
    return _digest(canonical(data | {"parameters": parameters}), canonical(list(study.names)))


def cases_address(base: str, names: Sequence[str], values: NDArray[np.float64]) -> str:
    """Address of the cases ``values`` (m, d) of the parameters ``names``: the same wherever in a study they stand."""
    numbers = np.ascontiguousarray(values, dtype="<f8")
    return _digest(base.encode(), canonical(list(names)), canonical(list(numbers.shape)), numbers.tobytes())


def quantity_keys(study: Study) -> dict[str, str]:
    """A digest of each quantity by its name: of its definition, and of all quantities that it is made of."""
    return {name: _digest(*_parts(study, name)) for name in study.sheet.quantities}


def _parts(study: Study, name: str) -> list[bytes]:
    entries = study.data["quantities"]
    parts = []
    for each in sorted(_closure(study, (name,))):
        entry = {key: value for key, value in entries[each].items() if key != "title"}
        parts.append(canonical([each == name, "" if each == name else each, entry]))
        if study.sheet.quantities[each].needs().result:
            parts += [canonical([word, _code(of)]) for word, of in sorted(study.functions.items())]
    return parts


def _code(function: Callable[[Any], float]) -> str:
    """The source of a function; without one its compiled code."""
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):
        code = getattr(function, "__code__", None)
        return code.co_code.hex() if code else repr(function)


def _closure(study: Study, names: Sequence[str]) -> set[str]:
    """These quantities, and those that they are made of."""
    found: set[str] = set()
    left = list(names)
    while left:
        name = left.pop()
        if name in study.sheet.quantities and name not in found:
            found.add(name)
            left += study.sheet.quantities[name].needs().names
    return found


def restricted(study: Study, names: Sequence[str]) -> Study:
    """The study with these quantities alone, and those that they are made of."""
    wanted = _closure(study, names)
    quantities: Mapping[str, Any] = study.data["quantities"]
    if wanted == set(quantities):
        return study
    data = {**study.data, "quantities": {name: entry for name, entry in quantities.items() if name in wanted}}
    return study.from_data(data, functions=study.functions)
