"""What a run shows at once: its series and warnings, without what takes longer than the run itself."""

from __future__ import annotations

import json
from typing import Any

from tmodes.result.assemble import provenance
from tmodes.result.result import Result
from tmodes.result.settling import not_settled

__all__ = ["LATER", "early_result"]

LATER = ("settling", "vibration", "frequency")
"""Beginnings of the names of numbers that an early result does not know."""

_NOT_YET: dict[str, Any] = {
    "frequencies": {},
    "vibration": {},
    "settling": not_settled(""),
}


def early_result(result: Result, *, lines: bool = True) -> Result:
    """The result of a run that was just made, for a picture that changes while somebody drags; not to be stored.

    It has no modes, settling, residual vibration and estimated errors; the parts of the tip's largest error are those
    by cause, without those of single gears and links. ``lines`` False: nor has it the lines of the links, nor the
    parts of deformations, and no warning about these. A result that is whole already stays as it is.
    """
    assembly = result.assembly
    if assembly is None:
        return result
    series, warnings = (assembly.all_series, assembly.warnings) if lines else assembly.moving
    status, message = assembly.ending
    attributes = provenance(assembly.run, assembly.known) | {"status": status, "message": message}
    computed = {"warnings": warnings, "move_end": assembly.move_end, **_NOT_YET}
    attributes |= {name: json.dumps(value) for name, value in computed.items()}
    found = Result(series.assign_attrs(attributes), result.timing)
    vars(found).update(robot=assembly.known, actual=assembly.run.robot)  # which are there already
    return found
