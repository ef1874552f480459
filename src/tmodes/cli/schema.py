"""``tmodes schema``: the JSON Schema of data sheets, for editors."""

from __future__ import annotations

__all__ = ["schema"]


def schema() -> None:
    """Print the JSON Schema of robot data sheets: editors complete and check with it."""
    from tmodes.cli.output import print_json
    from tmodes.io.schema import json_schema

    print_json(json_schema())
