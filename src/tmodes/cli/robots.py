"""``tmodes robots``: the published robots, or the data sheet of one, to edit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, Roots
from tmodes.cli.output import print_json, print_table
from tmodes.errors import InputError
from tmodes.io.words import meant, shown
from tmodes.robots.load import load, sheet_names, sheet_text

if TYPE_CHECKING:
    from pathlib import Path


__all__ = ["robots"]


def robots(
    name: Annotated[str | None, typer.Argument(help="Print this one's data sheet (YAML).")] = None,
    root: Roots = None,
    as_json: AsJson = False,
) -> None:
    """List the published robots, or print one's data sheet, to edit.

    For example:  tmodes robots filipovic2010 > my.yaml
    """
    if name is not None:
        _print_sheet(name, root, as_json=as_json)
        return
    known = _known()
    if as_json:
        print_json(known)
        return
    rows = [[one["name"], one["kind"], one["title"]] for one in known]
    print_table("Published robots", ["name", "kind", "what it is"], rows)


def _known() -> list[dict[str, str]]:
    """Name, kind, title and citation of each, as its file reports them: not built, for an arm may need other files."""
    from tmodes.io.yaml_file import parse_yaml

    found = []
    for name in sheet_names():
        data, _ = parse_yaml(sheet_text(name), f"{name}.yaml")
        info = {key: str(data.get(key, "")) for key in ("title", "citation")}
        found.append({"name": name, "kind": _kind(data), **info})
    return found


def _kind(data: dict[str, Any]) -> str:
    if "urdf" in data:
        return "arm, with a URDF"
    return str(data.get("kind", "2010 robot"))


def _print_sheet(name: str, root: list[Path] | None, *, as_json: bool) -> None:
    from tmodes.io.sheet_check import sheet_data

    if name not in sheet_names():
        raise _unknown(name, sheet_names())
    if not as_json:
        print(sheet_text(name), end="")
        return
    sheet = load(name, roots=root or ())
    print_json(sheet_data(sheet))


def _unknown(name: str, known: list[str]) -> InputError:
    hint = meant(name, known, "see the list: tmodes robots")
    return InputError("robot", shown(name), f"one of {', '.join(known)}", hint)
