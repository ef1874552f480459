"""``tmodes schema``: the JSON Schema of data sheets, for editors."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.cli.output import print_json

__all__ = ["schema"]


def schema(arm: Annotated[bool, typer.Option("--arm", help="Of sheets with `kind: arm`.")] = False) -> None:
    """Print the JSON Schema of data sheets, of the 2010 robot or with --arm of any other: editors check with it.

    For example:  tmodes schema --arm > arm.schema.json   and in the first line of the sheet
    # yaml-language-server: $schema=arm.schema.json
    """
    from tmodes.io.forms import F2010, ROBOT, json_schema

    print_json(json_schema(ROBOT if arm else F2010))
