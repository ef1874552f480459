"""``tmodes check``: whether a data sheet is right, and plausible."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmodes.cli.options import AsJson, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet

if TYPE_CHECKING:
    from tmodes.paper.sheet import Robot
    from tmodes.sheet import Arm

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
    from tmodes.io.doubts import doubts_about

    try:
        sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths)
        told, numbers = _told(sheet)
    except (InputError, InputErrors) as error:
        if as_json:
            errors = error.errors if isinstance(error, InputErrors) else (error,)
            keys = ("which", "got", "expected", "mend", "where")
            print_json({"ok": False, "errors": [{key: getattr(one, key) for key in keys} for one in errors]})
        raise
    doubts = doubts_about(sheet)
    if as_json:
        print_json({"ok": True, "name": sheet.name, **numbers, "warnings": doubts})
        return
    print(f"{sheet.name}: right. {told}")
    for doubt in doubts:
        print(f"warning: {doubt}")


def _told(sheet: Robot | Arm) -> tuple[str, dict[str, object]]:
    """What the sheet is, in words and for machines."""
    from tmodes.paper.mechanism import Drive
    from tmodes.paper.quantities import robot_stops
    from tmodes.sheet import Arm

    if isinstance(sheet, Arm):
        return _told_of_arm(sheet)
    robot_stops(sheet)
    mechanism, parameters = sheet.pair().real.split(Drive.CONTROLLED)
    return f"{len(parameters)} numbers; {mechanism.key}", {"mechanism": mechanism.key}


def _told_of_arm(arm: Arm) -> tuple[str, dict[str, object]]:
    from tmodes.model.model import ArmModel
    from tmodes.simulation.quantities import refuse_wrong_stops

    refuse_wrong_stops(arm.pair().real)
    coordinates = list(ArmModel(arm.pair().real.chain()).coordinates)
    bending = sum(link.beam is not None for link in arm.links)
    counts = f"joints: {len(arm.joints)}, beams: {bending}, coordinates: {len(coordinates)}"
    driven = [drive.joint for drive in arm.drives]
    return f"{counts}, drives: {len(driven)}", {"kind": "arm", "coordinates": coordinates, "drives": driven}
