"""``tmodes robots``: the published robots, or the data sheet of one, to edit."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.cli.options import AsJson

__all__ = ["robots"]


def robots(
    name: Annotated[str | None, typer.Argument(help="Print this robot's data sheet (YAML).")] = None,
    as_json: AsJson = False,
) -> None:
    """List the published robots, or print one's data sheet, to edit.

    For example:  tmodes robots filipovic2010 > my.yaml
    """
    from tmodes import robots as published
    from tmodes.cli.output import print_json, print_table

    if name is not None:
        sheet = published.load_robot(name) if as_json else None
        print_json(sheet.model_dump(mode="json")) if sheet else print(published.text(name), end="")
        return
    known = {robot: published.load_robot(robot) for robot in published.names()}
    if as_json:
        print_json([{"name": key, "title": sheet.title, "citation": sheet.citation} for key, sheet in known.items()])
        return
    print_table("Published robots", ["name", "what it is"], [[key, sheet.title] for key, sheet in known.items()])
