"""Numbers in tables: frequencies, the elastic angles beside their reference, the error of the integration."""

from __future__ import annotations

from typing import Any

from tmodes.report.markup import Markup, tag
from tmodes.report.quantity import power_of_ten, written
from tmodes.report.tables import table

__all__ = ["PLACES", "deformation_table", "error_table", "frequency_tables"]

PLACES = {
    "th11q": ("mode 1, horizontal", "ϑ", "1,1q"),
    "th11m": ("mode 1, vertical", "ϑ", "1,1m"),
    "th12d": ("mode 2, horizontal", "ϑ", "1,2δ"),
    "th12e": ("mode 2, vertical", "ϑ", "1,2e"),
    "xi": ("gear", "ξ", ""),
}
"""Where each elastic angle is, its letter and its index."""

CASES = {"controlled": "Controlled", "locked": "Motor locked", "free": "Motor free"}


def frequency_tables(frequencies: dict[str, list[dict[str, Any]]], *, beside: bool = True) -> Markup:
    """Natural and damped frequencies, damping ratio and the element in which most of each lives, per case.

    ``beside``: the tables stand in columns, which is for short names.
    """
    tables = []
    for case, words in CASES.items():
        rows = [
            [
                f"{mode['frequency_Hz']:.4g}",
                "-" if mode["damped_frequency_Hz"] is None else f"{mode['damped_frequency_Hz']:.4g}",
                f"{100 * mode['damping_ratio']:.3g}",
                str(mode["element"]),
            ]
            for mode in sorted(frequencies.get(case, []), key=lambda mode: mode["frequency_Hz"])
        ]
        if rows:
            tables.append(
                table(words, ("natural [Hz]", "damped [Hz]", "damping [%]", "lives in"), rows, numeric=(0, 1, 2))
            )
    return tag("div", *tables, class_="columns wide" if beside else None)


def deformation_table(info: dict[str, dict[str, float | None]]) -> Markup:
    """Largest size of each elastic angle, of its reference, and how far one is from the other."""
    rows = [_deformation(name, values) for name, values in sorted(info.items(), key=lambda item: _order(item[0]))]
    head = ("Angle", "Symbol", "Largest, real", "Largest, reference", "rms deviation / rms reference")
    return table("Elastic angles over the run", head, rows, numeric=(2, 3, 4))


def _deformation(name: str, info: dict[str, float | None]) -> list[str]:
    place, letter, index = PLACES.get(name, (name, "", ""))
    ratio = info["rms_deviation_over_rms_reference"]
    sizes = [written(info[key] or 0.0, "rad") for key in ("max_rad", "max_reference_rad")]
    symbol = tag("span", letter, tag("sub", index) if index else None)
    return [place, symbol, *sizes, "–" if ratio is None else f"{100 * ratio:.3g} %"]


def _order(name: str) -> int:
    return list(PLACES).index(name) if name in PLACES else len(PLACES)


def error_table(info: dict[str, Any] | None) -> Markup:
    """The estimated error of the integration in each headline figure; None where it is not known."""
    if info is None:
        return tag("p", "The error of the integration was not estimated.", class_="note")
    bound = "At most about" if "sum" in info["how"] else "Error"
    rows = [[name.replace(".", ", ").replace("_", " "), power_of_ten(value)] for name, value in info["figures"].items()]
    return table(f"Error of the integration, by a {info['how']}", ("Figure", f"{bound} [SI]"), rows, numeric=(1,))
