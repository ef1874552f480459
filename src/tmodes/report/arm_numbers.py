"""The numbers of an arm's run that a reader asks first: cards, joints, links, elastic coordinates."""

from __future__ import annotations

from typing import Any

from tmodes.report.markup import Markup
from tmodes.report.numbers import (
    card_list,
    deviation_card,
    energy_card,
    first_frequency_card,
    settling_card,
    written,
)
from tmodes.report.tables import table

__all__ = ["arm_cards", "deformations_table", "joints_table", "links_table"]

_MOST_ROWS = 30
_ROUNDING = 1e-12
"""A position [rad, m] that is as good as zero."""

Card = tuple[str, str, str]


def arm_cards(told: dict[str, Any]) -> Markup:
    """The first numbers of a summary, each with its unit and a word on when or where."""
    return card_list(
        (
            deviation_card(told["deviation"]) if told["deviation"] else None,
            settling_card(told["settling"]) if told["settling"] else None,
            first_frequency_card(told["first_frequency_Hz"]),
            _gear(told["deformations"]),
            _deflection(told["links"]),
            _moment(told["links"]),
            _stress(told["links"]),
            _contact(told["contact_force"]),
            energy_card(told["energy"]),
        )
    )


def _gear(told: dict[str, dict[str, Any]]) -> Card | None:
    gears = {name: one for name, one in told.items() if name.endswith(".gear")}
    if not gears:
        return None
    name = max(gears, key=lambda name: gears[name]["max"])
    one = gears[name]
    where = f"{name.removesuffix('.gear')}, at {one['time_of_max_s']:.3g} s"
    return "Largest deflection of a gear", written(one["max"], one["unit"]), where


def _deflection(links: dict[str, dict[str, Any]]) -> Card | None:
    return _worst(links, "deflection", "max_m", "m", "Largest deflection of a link")


def _moment(links: dict[str, dict[str, Any]]) -> Card | None:
    return _worst(links, "bending_moment", "max_Nm", "N m", "Largest bending moment")


def _stress(links: dict[str, dict[str, Any]]) -> Card | None:
    known = {name: link for name, link in links.items() if link["stress"]}
    card = _worst(known, "stress", "max_Pa", "Pa", "Largest stress (von Mises)")
    if card is None:
        return None
    largest = max(link["stress"]["max_Pa"] for link in known.values())
    return card[0], _megapascal(largest), card[2]


def _worst(links: dict[str, dict[str, Any]], quantity: str, key: str, unit: str, title: str) -> Card | None:
    if not links:
        return None
    name = max(links, key=lambda name: links[name][quantity][key])
    one = links[name][quantity]
    place = "" if quantity == "deflection" else f" at s = {one['s']:.2g}"
    return title, written(one[key], unit), f"{name}{place}, at {one['time_s']:.3g} s"


def _contact(told: dict[str, float] | None) -> Card | None:
    if told is None:
        return None
    return "Contact force, mean", written(told["mean_N"], "N", 4), f"from {told['min_N']:.4g} to {told['max_N']:.4g} N"


def _megapascal(stress: float) -> str:
    return f"{stress / 1e6:.3g}\u00a0MPa"


def joints_table(told: dict[str, dict[str, Any]]) -> Markup | None:
    """Range, rate and effort of each driven joint."""
    if not told:
        return None
    head = ("Joint", "Least", "Largest", "Unit", "Fastest", "Largest effort", "Largest gear torque")
    rows = []
    for name, one in list(told.items())[:_MOST_ROWS]:
        force = "N" if one["unit"] == "m" else "N m"
        gear = one["largest_gear_torque"]
        rate = written(one["fastest"], f"{one['unit']}/s")
        rows.append([name, _place(one["least"]), _place(one["largest"]), one["unit"], rate,
                     written(one["largest_effort"], force), written(gear, force) if gear else "–"])  # fmt: skip
    return table(_caption("Driven joints over the run", told), head, rows, numeric=(1, 2, 4, 5, 6))


def _place(value: float) -> str:
    """A position; what is rounding is zero."""
    return f"{value if abs(value) > _ROUNDING else 0.0:.4g}"


def links_table(told: dict[str, dict[str, Any]]) -> Markup | None:
    """Largest deflection, bending moment and stress of each link that bends."""
    if not told:
        return None
    head = ("Link", "Deflection of its end", "Bending moment", "where", "Stress", "where")
    rows = []
    for name, link in list(told.items())[:_MOST_ROWS]:
        moment, stress = link["bending_moment"], link["stress"]
        where = ["–" if one is None else f"s = {one['s']:.2g}, {one['time_s']:.3g} s" for one in (moment, stress)]
        rows.append([name, written(link["deflection"]["max_m"], "m"), written(moment["max_Nm"], "N m"), where[0],
                     "not known" if stress is None else _megapascal(stress["max_Pa"]), where[1]])  # fmt: skip
    return table(_caption("Largest values over the run", told), head, rows, numeric=(1, 2, 4))


def deformations_table(told: dict[str, dict[str, Any]]) -> Markup | None:
    """Largest size of each elastic coordinate, of its parts and of the reference."""
    if not told:
        return None
    head = ("Coordinate", "Largest", "at", "Stationary", "Oscillatory", "Reference")
    keys = ("max_stationary", "max_oscillatory", "max_reference")
    rows = []
    for name, one in list(told.items())[:_MOST_ROWS]:
        unit = "-" if one["unit"] == "1" else one["unit"]
        parts = [written(one[key], unit) if key in one else "–" for key in keys]
        rows.append([name, written(one["max"], unit), f"{one['time_of_max_s']:.3g}\u00a0s", *parts])
    return table(_caption("Elastic coordinates over the run", told), head, rows, numeric=(1, 2, 3, 4, 5))


def _caption(words: str, told: dict[str, Any]) -> str:
    return words if len(told) <= _MOST_ROWS else f"{words}, the first {_MOST_ROWS} of {len(told)}"
