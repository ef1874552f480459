"""``tmodes schema``: the JSON Schema of data sheets, for editors."""

from __future__ import annotations

import math
from typing import Annotated, Any

import typer

__all__ = ["schema"]


def schema(arm: Annotated[bool, typer.Option("--arm", help="Of sheets with `kind: arm`.")] = False) -> None:
    """Print the JSON Schema of data sheets, of the published robot or of arms: editors check with it."""
    from tmodes.cli.output import print_json
    from tmodes.io.arm_schema import arm_json_schema
    from tmodes.io.schema import json_schema

    print_json(_finite(arm_json_schema()) if arm else json_schema())


def _finite(node: Any) -> Any:
    """JSON has no infinite numbers; a sheet writes them as .inf."""
    if isinstance(node, dict):
        return {key: _finite(value) for key, value in node.items()}
    if isinstance(node, list):
        return [_finite(item) for item in node]
    return ".inf" if isinstance(node, float) and math.isinf(node) else node
