"""The JSON Schema of an arm's data sheet, for editors that complete and check while one types."""

from __future__ import annotations

from typing import Any

from tmodes.io.schema import editor_schema
from tmodes.sheet import Robot

__all__ = ["arm_json_schema"]


def arm_json_schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of an arm's data sheet, with units, symbols and meanings."""
    return editor_schema(Robot.model_json_schema(by_alias=True))
