"""``tmodes check``: whether a data sheet is right, and plausible."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmodes.cli.options import AsJson, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.output import print_json
from tmodes.errors import InputError, InputErrors

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["check"]


def check(
    robot: SheetArgument,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """Check a data sheet: report all wrong values together, then what looks implausible (a wrong unit, say)."""
    from tmodes.io.sheet_plausible import notices_about

    try:
        sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths)
        info, numbers = _info(sheet)
    except (InputError, InputErrors) as error:
        if as_json:
            errors = error.errors if isinstance(error, InputErrors) else (error,)
            keys = ("which", "got", "expected", "hint", "where")
            print_json({"ok": False, "errors": [{key: getattr(one, key) for key in keys} for one in errors]})
        raise
    notices = notices_about(sheet)
    if as_json:
        print_json({"ok": True, "name": sheet.name, **numbers, "warnings": notices})
        return
    print(f"{sheet.name}: valid ({info})")
    for notice in notices:
        print(f"warning: {notice}")


def _info(sheet: Robot) -> tuple[str, dict[str, object]]:
    """What the sheet describes, in words and for machines."""
    from tmodes.model.model import Model
    from tmodes.simulation.quantities import refuse_wrong_stops

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
