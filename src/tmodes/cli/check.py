"""``tmodes check``: whether a data sheet is right, and plausible."""

from __future__ import annotations

from tmodes.cli.options import AsJson, RobotArgument, Settings, chosen_robot

__all__ = ["check"]


def check(robot: RobotArgument, settings: Settings = None, as_json: AsJson = False) -> None:
    """Check a data sheet: all wrong values in one go, then what looks implausible (a wrong unit, say)."""
    from tmodes.cli.output import print_json
    from tmodes.errors import InputError, InputErrors
    from tmodes.io.plausible import implausible
    from tmodes.mechanism import Drive

    try:
        sheet = chosen_robot(robot, settings)
    except (InputError, InputErrors) as error:
        if as_json:
            errors = error.errors if isinstance(error, InputErrors) else (error,)
            keys = ("which", "got", "expected", "mend", "where")
            print_json({"ok": False, "errors": [{key: getattr(one, key) for key in keys} for one in errors]})
        raise
    mechanism, parameters = sheet.pair().real.split(Drive.CONTROLLED)
    doubts = implausible(sheet)
    if as_json:
        print_json({"ok": True, "name": sheet.name, "mechanism": mechanism.key, "warnings": doubts})
        return
    print(f"{sheet.name}: right. {len(parameters)} numbers; {mechanism.key}")
    for doubt in doubts:
        print(f"warning: {doubt}")
