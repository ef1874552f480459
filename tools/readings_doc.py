"""Measures the table of docs/readings.md again and writes it there: ``python tools/readings_doc.py``.

The numbers may differ in their last digit between machines, so a test compares them within a tolerance.
"""

from __future__ import annotations

import re
import sys

import generated
import tmodes

__all__ = ["CASES", "ROW", "Case", "measured"]

Case = tuple[str, float, bool]
"""Reading, payload [kg], contact."""

CASES: tuple[Case, ...] = tuple(
    (reading, payload, contact)
    for payload in (0.5, 4.0)
    for contact in (False, True)
    for reading in ("printed", "consistent")
)

_CELL = r" \| ([\d.]+)"
ROW = re.compile(rf"^\| `(printed|consistent)`{_CELL} \| (yes|no){_CELL}{_CELL}{_CELL}{_CELL} \|$", re.MULTILINE)


def measured(case: Case) -> tuple[float, float, float, float]:
    """First and third locked frequency [Hz], largest deviation [mm], largest th12d [mrad] of a case."""
    reading, payload, contact = case
    changes = {"reading": reading, "payload.mass": payload, "contact": contact}
    result = tmodes.run(tmodes.load("filipovic2010", changes))
    locked = [mode["frequency_Hz"] for mode in result.frequencies["locked"]]
    bending = abs(result.data.deformation.sel(deformation_kind="link.azimuth2"))
    return locked[0], locked[2], float(result.data.deviation.max()) * 1e3, float(bending.max()) * 1e3


def _main() -> int:
    target = generated.ROOT / "docs" / "readings.md"
    rows = iter(
        f"| `{case[0]}` | {case[1]} | {'yes' if case[2] else 'no'} | " + " | ".join(f"{x:#.5g}" for x in numbers) + " |"
        for case, numbers in ((case, measured(case)) for case in CASES)
    )
    target.write_text(ROW.sub(lambda _: next(rows), target.read_text(encoding="utf-8")), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(_main())
