"""What the rows of a study depend on, as digests: robot, paths, quantities, and the engine that computes them."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from typing import Any

import tmodes
from tmodes.compile.cache import source_digest
from tmodes.io.sheet_check import sheet_data
from tmodes.kinds.registry import outside_digest
from tmodes.sheet import Robot
from tmodes.study.quantities.function import Identity
from tmodes.study.sheet import StudySheet
from tmodes.study.space import ordered

__all__ = ["base_digest", "engine_version", "quantity_digests", "whole_digest"]

_SOURCES = (
    *("analysis", "chain", "compile", "equations", "frame.py", "integrate", "io", "kinds", "model", "result", "robots"),
    *("sheet", "simulation", "study/evaluate.py", "study/mapping.py", "study/quantities", "study/ways"),
)
"""Source from which the rows follow."""


def engine_version() -> str:
    """Version of tmodes with a digest of its engine's source: rows of one are never mixed with those of another."""
    return f"{tmodes.__version__}+{source_digest(_SOURCES)[:16]}"


def base_digest(sheet: StudySheet, robot: Robot | None, choices: Mapping[str, Any]) -> str:
    """Digest of the robot, of what the parameters stand for, of the engine and of all kinds from outside."""
    meant = {name: [one.path, one.relative, choices.get(name)] for name, one in sheet.parameters.items()}
    return _digest([engine_version(), outside_digest(), robot and sheet_data(robot), meant])


def quantity_digests(sheet: StudySheet, functions: Mapping[str, Identity]) -> dict[str, str]:
    """Digest of each quantity by its name; ``functions``: identities by their names."""
    needs = {name: one.needs().names for name, one in sheet.quantities.items()}
    found: dict[str, str] = {}
    for name in ordered(needs):
        own = sheet.quantities[name]
        function = functions.get(own.function())
        found[name] = _digest([own.digest(found), function.digest if function else ""])
    return {name: found[name] for name in sheet.quantities}


def whole_digest(base: str, quantities: Mapping[str, str]) -> str:
    """Digest of all of it."""
    return _digest([base, dict(quantities)])


def _digest(value: Any) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()
