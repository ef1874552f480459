"""``tmodes check``: whether a data sheet is right, and plausible."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmodes.cli.options import AsJson, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet

if TYPE_CHECKING:
    from tmodes.paper.sheet import PaperRobot
    from tmodes.sheet import Robot

__all__ = ["check"]


def check(
    robot: SheetArgument,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """Check a data sheet: all wrong values in one go, then what looks implausible (a wrong unit, say)."""
    from tmodes.cli.output import print_json
    from tmodes.errors import InputError, InputErrors
    from tmodes.io.notices import notices_about

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
    print(f"{sheet.name}: right. {info}")
    for notice in notices:
        print(f"warning: {notice}")


def _info(sheet: PaperRobot | Robot) -> tuple[str, dict[str, object]]:
    """What the sheet is, in words and for machines."""
    from tmodes.paper.mechanism import Drive
    from tmodes.paper.quantities import robot_stops
    from tmodes.sheet import Robot

    if isinstance(sheet, Robot):
        return _info_of_arm(sheet)
    robot_stops(sheet)
    mechanism, parameters = sheet.pair().real.split(Drive.CONTROLLED)
    return f"{len(parameters)} numbers; {mechanism.key}", {"mechanism": mechanism.key}


def _info_of_arm(arm: Robot) -> tuple[str, dict[str, object]]:
    from tmodes.model.model import Model
    from tmodes.simulation.quantities import refuse_wrong_stops

    refuse_wrong_stops(arm.pair().real)
    coordinates = list(Model(arm.pair().real.chain()).coordinates)
    bending = sum(link.beam is not None for link in arm.links)
    counts = f"joints: {len(arm.joints)}, beams: {bending}, coordinates: {len(coordinates)}"
    driven = [drive.joint for drive in arm.drives]
    return f"{counts}, drives: {len(driven)}", {"kind": "arm", "coordinates": coordinates, "drives": driven}
