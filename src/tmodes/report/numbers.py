"""The numbers that a reader asks first: cards, frequencies, and the elastic angles beside their reference."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tmodes.plot.units import readable
from tmodes.report.markup import Markup, tag
from tmodes.report.tables import table

__all__ = [
    "card_list", "cards", "deformation_table", "deviation_card", "energy_card", "error_table", "first_frequency_card",
    "frequency_tables", "power_of_ten", "settling_card", "written",
]  # fmt: skip

PLACES = {
    "th11q": ("mode 1, horizontal", "ϑ", "1,1q"),
    "th11m": ("mode 1, vertical", "ϑ", "1,1m"),
    "th12d": ("mode 2, horizontal", "ϑ", "1,2δ"),
    "th12e": ("mode 2, vertical", "ϑ", "1,2e"),
    "xi": ("gear", "ξ", ""),
}
"""Where each elastic angle is, its letter and its index."""

CASES = {"controlled": "Controlled", "locked": "Motor locked", "free": "Motor free"}

SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def written(value: float, unit: str, digits: int = 3) -> str:
    """A number with a readable unit, not to be parted at the end of a line: ``4.04 mm``."""
    chosen = readable(unit, value)
    return f"{value * chosen.factor:.{digits}g}\u00a0{chosen.name}"


def cards(told: dict[str, Any]) -> Markup:
    """The first numbers of a summary, each with its unit and a word on when or where."""
    facts = (
        deviation_card(told["deviation"]),
        settling_card(told["settling"]),
        first_frequency_card(told["first_frequency_Hz"]),
        _angle(told["deformations"]),
        _moment(told["largest_bending_moment"]),
        _torque(told["gear_torque"]),
        _contact(told["contact_force_radial"]),
        energy_card(told["energy"]),
    )
    return card_list(facts)


def card_list(facts: Iterable[tuple[str, str, str] | None]) -> Markup:
    """Cards of name, value and note; None is left out."""
    entries = (
        tag("div", tag("dt", name), tag("dd", tag("strong", value), tag("span", note)), class_="card")
        for name, value, note in filter(None, facts)
    )
    return tag("dl", *entries, class_="cards")


def deviation_card(told: dict[str, float]) -> tuple[str, str, str]:
    """How far the tip is from its reference."""
    note = f"at {told['time_of_max_s']:.3g} s; {written(told['end_m'], 'm')} at the end of the run"
    return "Largest deviation of the tip", written(told["max_m"], "m"), note


def settling_card(told: dict[str, Any]) -> tuple[str, str, str]:
    """How long the tip takes to settle, or why that is not known."""
    name = "Settling after the move"
    if told["time_s"] is None:
        return name, "not seen", told["reason"]
    within = f"until the tip stays within {written(told['limit_m'], 'm')}"
    return name, written(told["time_s"], "s"), f"{within}, {100 * told['band']:g} % of its largest deviation"


def first_frequency_card(told: dict[str, float | None]) -> tuple[str, str, str] | None:
    """The lowest frequency under control; None where there is none."""
    if told["controlled"] is None:
        return None
    locked = "" if told["locked"] is None else f"{told['locked']:.4g} Hz with the motor locked"
    return "First frequency, controlled", f"{told['controlled']:.4g} Hz", locked


def _angle(told: dict[str, dict[str, float | None]]) -> tuple[str, str, str]:
    sizes = {name: values["max_rad"] or 0.0 for name, values in told.items()}
    name = max(sizes, key=lambda name: sizes[name])
    return "Largest elastic angle", written(sizes[name], "rad"), PLACES.get(name, (name,))[0]


def _moment(told: dict[str, Any]) -> tuple[str, str, str]:
    place = "at the root" if told["s"] == 0 else f"at {100 * told['s']:.3g}\u00a0% of its length"
    where = f"mode {str(told['mode'])[-1]}, {place}, {told['plane']} plane, at {told['time_s']:.3g}\u00a0s"
    return "Largest bending moment", written(abs(told["value_Nm"]), "N m"), where


def _torque(told: dict[str, float]) -> tuple[str, str, str]:
    return "Largest gear torque", written(told["max_Nm"], "N m"), f"at {told['time_s']:.3g} s"


def _contact(told: dict[str, float] | None) -> tuple[str, str, str]:
    name = "Radial contact force, mean"
    if told is None:
        return name, "none", "the tip moved in free space"
    return name, written(told["mean_N"], "N", 4), f"from {told['min_N']:.4g} to {told['max_N']:.4g} N"


def energy_card(told: dict[str, Any]) -> tuple[str, str, str]:
    """How well the energies add up."""
    share = told["worst_residual_over_moved"]
    note = (
        f"worst residual, {power_of_ten(told['worst_residual_J'])}\u00a0J, over {written(told['moved_J'], 'J')} moved"
    )
    return "Energy balance", "nothing moved" if share is None else power_of_ten(share), note


def power_of_ten(value: float) -> str:
    """A number of any size with two digits: ``1.7 × 10⁻¹¹``."""
    if value == 0.0:
        return "0"
    digits, _, power = f"{value:.1e}".partition("e")
    return f"{digits}\u00a0×\u00a010{str(int(power)).translate(SUPERSCRIPT)}"


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


def deformation_table(told: dict[str, dict[str, float | None]]) -> Markup:
    """Largest size of each elastic angle, of its reference, and how far one is from the other."""
    rows = [_deformation(name, values) for name, values in sorted(told.items(), key=lambda item: _order(item[0]))]
    head = ("Angle", "Symbol", "Largest, real", "Largest, reference", "rms deviation / rms reference")
    return table("Elastic angles over the run", head, rows, numeric=(2, 3, 4))


def _deformation(name: str, told: dict[str, float | None]) -> list[str]:
    place, letter, index = PLACES.get(name, (name, "", ""))
    ratio = told["rms_deviation_over_rms_reference"]
    sizes = [written(told[key] or 0.0, "rad") for key in ("max_rad", "max_reference_rad")]
    symbol = tag("span", letter, tag("sub", index) if index else None)
    return [place, symbol, *sizes, "–" if ratio is None else f"{100 * ratio:.3g} %"]


def _order(name: str) -> int:
    return list(PLACES).index(name) if name in PLACES else len(PLACES)


def error_table(told: dict[str, Any] | None) -> Markup:
    """The estimated error of the integration in each headline figure; None where it is not known."""
    if told is None:
        return tag("p", "The error of the integration was not estimated.", class_="note")
    bound = "At most about" if "sum" in told["how"] else "Error"
    rows = [[name.replace(".", ", ").replace("_", " "), power_of_ten(value)] for name, value in told["figures"].items()]
    return table(f"Error of the integration, by a {told['how']}", ("Figure", f"{bound} [SI]"), rows, numeric=(1,))
