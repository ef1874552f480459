"""``tmodes robots``, ``tmodes check`` and ``tmodes schema``: data sheets listed, checked and described."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_json, print_parts, print_table, working
from tmodes.errors import InputError, InputErrors
from tmodes.io.words import meant, shown
from tmodes.robots.load import load, sheet_names, sheet_text

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["check", "robots", "schema"]


def robots(
    name: Annotated[str | None, typer.Argument(help="Print this one's data sheet (YAML).")] = None,
    root: Roots = None,
    as_json: AsJson = False,
) -> None:
    """List the published robots, or print one's data sheet, to edit.

    For example:  tmodes robots two_link_arm > my.yaml
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
    """Name, kind, title and citation of each, as its file reports them: not built, for a robot may need other files."""
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


def check(
    robot: SheetArgument,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Check a data sheet: report all wrong values together, then what looks implausible (a wrong unit, say)."""
    from tmodes.interface.checks import check as found_of

    try:
        sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
        with working("checking", at_once=True):
            found = found_of(sheet)
    except (InputError, InputErrors) as error:
        if as_json:
            errors = error.errors if isinstance(error, InputErrors) else (error,)
            keys = ("which", "got", "expected", "hint", "where")
            print_json({"ok": False, "errors": [{key: getattr(one, key) for key in keys} for one in errors]})
        raise
    print_json(found.info()) if as_json else print_parts(found.tables())


def schema(general: Annotated[bool, typer.Option("--arm", help="Of sheets with `kind: arm`.")] = False) -> None:
    """Print the JSON Schema of data sheets, of the 2010 robot or with --arm of any other: editors check with it.

    For example:  tmodes schema --arm > arm.schema.json   and in the first line of the sheet
    # yaml-language-server: $schema=arm.schema.json
    """
    from tmodes.io.forms import F2010, ROBOT, json_schema

    print_json(json_schema(ROBOT if general else F2010))
