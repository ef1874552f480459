"""One number with its unit as a person reads it; ``web/src/format.ts`` writes the same."""

from __future__ import annotations

import math

from tmodes.plot.units import NEVER_LARGE, pretty

__all__ = ["power_of_ten", "written"]

_PREFIXES = (
    (1e10, 1e-9, "G"), (1e7, 1e-6, "M"), (1e4, 1e-3, "k"), (0.1, 1.0, ""), (1e-4, 1e3, "m"), (1e-7, 1e6, "µ"),
    (1e-11, 1e9, "n"),
)  # fmt: skip
_PLAIN = ("Hz", "%", "rad/s")
"""Units that take no prefix."""

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def written(value: float, unit: str, digits: int = 4) -> str:
    """A value [``unit``, SI] with a readable unit, not to be parted at the end of a line: ``4.041 mm``."""
    name = "" if unit in ("", "-", "1") else pretty(unit)
    size = abs(value)
    if not math.isfinite(value):
        return f"{value:g}\u00a0{name}".rstrip()
    if not name or unit in _PLAIN or size == 0.0:
        text = power_of_ten(value) if 0.0 < size < 1e-3 else _rounded(value, digits)
        return f"{text}\u00a0{name}".rstrip("\u00a0")
    for least, factor, prefix in _PREFIXES:
        if size >= least and (factor >= 1.0 or unit.split("/", maxsplit=1)[0] not in NEVER_LARGE):
            return f"{_rounded(value * factor, digits)}\u00a0{prefix}{name}"
    return f"{power_of_ten(value)}\u00a0{name}"


def _rounded(value: float, digits: int) -> str:
    """To so many digits that tell, never with an exponent: ``12340``."""
    return f"{float(f'{value:.{digits}g}'):.12g}"


def power_of_ten(value: float) -> str:
    """A number of any size with two digits: ``1.7 × 10⁻¹¹``."""
    if value == 0.0:
        return "0"
    digits, _, power = f"{value:.1e}".partition("e")
    return f"{digits}\u00a0×\u00a010{str(int(power)).translate(_SUPERSCRIPT)}"
