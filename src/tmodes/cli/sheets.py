"""``tmodes robots``, ``tmodes check`` and ``tmodes schema``: data sheets listed, checked and described."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_json, print_table, working
from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.io.words import meant, shown
from tmodes.robots.load import load, sheet_names, sheet_text

if TYPE_CHECKING:
    from pathlib import Path

    from tmodes.sheet import Robot

__all__ = ["check", "robots", "schema"]


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
    from tmodes.analysis.consequences import consequences
    from tmodes.io.sheet_plausible import notices_about

    try:
        sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
        with working("checking", at_once=True):
            info, numbers = _described(sheet)
            notices = [*notices_about(sheet), *consequences(sheet), *_starting(sheet)]
    except (InputError, InputErrors) as error:
        if as_json:
            errors = error.errors if isinstance(error, InputErrors) else (error,)
            keys = ("which", "got", "expected", "hint", "where")
            print_json({"ok": False, "errors": [{key: getattr(one, key) for key in keys} for one in errors]})
        raise
    if as_json:
        print_json({"ok": True, "name": sheet.name, **numbers, "notes": sheet.held_notices, "warnings": notices})
        return
    print(f"{sheet.name}: valid ({info})")
    for note in sheet.held_notices:
        print(f"note: {note}")
    for notice in notices:
        print(f"warning: {notice}")


def _starting(sheet: Robot) -> list[str]:
    """Why the robot cannot run as it stands, or that its start is no equilibrium."""
    from tmodes.result.run import ready_to_run
    from tmodes.simulation.start import run_setup
    from tmodes.simulation.warnings import departures

    try:
        setup = run_setup(ready_to_run(sheet).pair().real)
    except (InputError, SimulationError) as error:
        return [f"`tmodes run` needs more: {error}"]
    return [*departures(setup, setup.first_row)]


def _described(sheet: Robot) -> tuple[str, dict[str, object]]:
    """What the sheet describes, in words and for machines."""
    from tmodes.model.model import Model
    from tmodes.simulation.outputs import refuse_wrong_stops

    real = sheet.pair().real
    refuse_wrong_stops(real)
    coordinates = list(Model(real.chain()).coordinates)
    bending = sum(link.beam is not None for link in sheet.links)
    counts = [_count(len(sheet.joints), "joint"), _count(bending, "flexible link")]
    counts.append(_count(len(coordinates), "coordinate"))
    driven = [drive.joint for drive in sheet.drives]
    contact = "contact on" if sheet.contact else "contact off" if sheet.contact_off else "no contact"
    words = [*counts, _count(len(driven), "drive"), contact, f"equations: {sheet.equations}"]
    data = {"kind": sheet.kind, "equations": sheet.equations, "contact": sheet.contact is not None}
    return ", ".join(words), {**data, "coordinates": coordinates, "drives": driven}


def _count(count: int, what: str) -> str:
    return f"{count} {what}" + ("" if count == 1 else "s")


def schema(general: Annotated[bool, typer.Option("--arm", help="Of sheets with `kind: arm`.")] = False) -> None:
    """Print the JSON Schema of data sheets, of the 2010 robot or with --arm of any other: editors check with it.

    For example:  tmodes schema --arm > arm.schema.json   and in the first line of the sheet
    # yaml-language-server: $schema=arm.schema.json
    """
    from tmodes.io.forms import F2010, ROBOT, json_schema

    print_json(json_schema(ROBOT if general else F2010))
