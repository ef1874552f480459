"""``tmodes schema``: the JSON Schema of data sheets, for editors."""

from __future__ import annotations

from typing import Annotated

import typer

__all__ = ["schema"]


def schema(arm: Annotated[bool, typer.Option("--arm", help="Of sheets with `kind: arm`.")] = False) -> None:
    """Print the JSON Schema of data sheets, of the published robot or of arms: editors check with it.

    For example:  tmodes schema --arm > arm.schema.json   and in the first line of the sheet
    # yaml-language-server: $schema=arm.schema.json
    """
    from tmodes.cli.output import print_json
    from tmodes.io.schema import json_schema
    from tmodes.io.sheet_schema import arm_json_schema

    print_json(arm_json_schema() if arm else json_schema())
