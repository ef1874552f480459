"""Numbers of a run in tables: joints, links, elastic coordinates, frequencies, the error of the integration."""

from __future__ import annotations

from typing import Any

from tmodes.plot.units import pretty
from tmodes.report.markup import Markup, table, tag
from tmodes.report.quantity import power_of_ten, written

__all__ = ["deformations_table", "error_table", "frequency_tables", "joints_table", "links_table"]

CASES = {"controlled": "Controlled", "locked": "Motors locked", "free": "Motors free"}

_FREQUENCY_HEAD = ("natural [Hz]", "damped [Hz]", "damping [%]", "dominant element")
_MOST_ROWS = 30
_SI = {"m": "m", "N": "N", "Nm": "N m", "Pa": "Pa"}
_ROUNDING = 1e-12
"""A position [rad, m] that is as good as zero."""


def frequency_tables(frequencies: dict[str, list[dict[str, Any]]]) -> Markup:
    """Natural and damped frequencies, damping ratio and the dominant element of each mode, per case."""
    tables = []
    for case, words in CASES.items():
        rows = [
            [
                f"{mode['frequency_Hz']:.4g}",
                "–" if mode["damped_frequency_Hz"] is None else f"{mode['damped_frequency_Hz']:.4g}",
                f"{100 * mode['damping_ratio']:.3g}",
                str(mode["element"]),
            ]
            for mode in sorted(frequencies.get(case, []), key=lambda mode: mode["frequency_Hz"])
        ]
        if rows:
            tables.append(table(words, _FREQUENCY_HEAD, rows, numeric=(0, 1, 2)))
    return tag("div", *tables)


def error_table(info: dict[str, Any] | None) -> Markup:
    """The estimated error of the integration in each headline figure; None where it is not known."""
    if info is None:
        return tag("p", "The error of the integration was not estimated.", class_="note")
    bound = "At most about" if "sum" in info["how"] else "Error"
    rows = [_error_row(name, value) for name, value in info["figures"].items()]
    return table(f"Error of the integration, by a {info['how']}", ("Number", f"{bound} [SI]"), rows, numeric=(1,))


def _error_row(name: str, value: float) -> list[str]:
    """``links.rod.deflection.max_m`` with words and unit apart."""
    place, _, last = name.rpartition(".")
    words, _, unit = last.rpartition("_")
    words, unit = (words, pretty(_SI[unit])) if unit in _SI else (last, "")
    text = ", ".join(filter(None, [place, words])).replace("_", " ")
    return [text, f"{power_of_ten(value)}\u00a0{unit}".rstrip("\u00a0")]


def joints_table(info: dict[str, dict[str, Any]]) -> Markup | None:
    """Range, rate and effort of each driven joint."""
    if not info:
        return None
    head = ("Joint", "Least", "Largest", "Unit", "Fastest", "Largest effort", "Largest gear torque")
    rows = []
    for name, one in list(info.items())[:_MOST_ROWS]:
        force = "N" if one["unit"] == "m" else "N m"
        gear = one["largest_gear_torque"]
        rate = written(one["fastest"], f"{one['unit']}/s")
        rows.append([name, _place(one["least"]), _place(one["largest"]), one["unit"], rate,
                     written(one["largest_effort"], force), written(gear, force) if gear else "–"])  # fmt: skip
    return table(_caption("Driven joints over the run", info), head, rows, numeric=(1, 2, 4, 5, 6))


def _place(value: float) -> str:
    """A position; what is rounding is zero."""
    return f"{value if abs(value) > _ROUNDING else 0.0:.4g}"


def links_table(info: dict[str, dict[str, Any]]) -> Markup | None:
    """Largest deflection, bending moment and stress of each elastic link."""
    if not info:
        return None
    head = ("Link", "Deflection of its end", "Bending moment", "where", "Stress", "where")
    rows = []
    for name, link in list(info.items())[:_MOST_ROWS]:
        moment, stress = link["bending_moment"], link["stress"]
        where = ["–" if one is None else f"s = {one['s']:.2g}, {one['time_s']:.3g} s" for one in (moment, stress)]
        rows.append([name, written(link["deflection"]["max_m"], "m"), written(moment["max_Nm"], "N m"), where[0],
                     "not known" if stress is None else written(stress["max_Pa"], "Pa"), where[1]])  # fmt: skip
    return table(_caption("Largest values over the run", info), head, rows, numeric=(1, 2, 4))


def deformations_table(info: dict[str, dict[str, Any]]) -> Markup | None:
    """Largest size of each elastic coordinate, of its parts and of the reference."""
    if not info:
        return None
    head = ("Coordinate", "Largest", "at", "Quasi-static", "Oscillatory", "Reference")
    keys = ("max_stationary", "max_oscillatory", "max_reference")
    rows = []
    for name, one in list(info.items())[:_MOST_ROWS]:
        unit = "-" if one["unit"] == "1" else one["unit"]
        parts = [written(one[key], unit) if key in one else "–" for key in keys]
        rows.append([name, written(one["max"], unit), f"{one['time_of_max_s']:.3g}\u00a0s", *parts])
    return table(_caption("Elastic coordinates over the run", info), head, rows, numeric=(1, 2, 3, 4, 5))


def _caption(words: str, info: dict[str, Any]) -> str:
    return words if len(info) <= _MOST_ROWS else f"{words}, the first {_MOST_ROWS} of {len(info)}"
