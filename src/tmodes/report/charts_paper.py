"""The charts of a run of the 2010 paper's robot, drafted from its result."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from tmodes.report.common_charts import contact_parts, energy_charts, tip_charts
from tmodes.report.drafts import Draft, Line, line_of, values_at
from tmodes.report.numbers import PLACES
from tmodes.report.spectra import robot_spectra

__all__ = ["robot_charts"]


def robot_charts(data: Any) -> Iterator[Draft]:
    """Every chart, the first of each group being the one to look at first."""
    yield from tip_charts(data)
    yield from _contact(data)
    yield from (_angle(data, k) for k in _order(data))
    yield from _motor(data)
    yield from energy_charts(data)
    yield from robot_spectra(data)


def _contact(data: Any) -> Iterator[Draft]:
    if "contact_force" in data:
        lines = [line_of(data, ("contact_force_radial", 0), "radial", "real")]
        if "contact_force_radial_reference" in data:
            lines.append(line_of(data, ("contact_force_radial_reference", 0), "radial", "reference"))
        yield Draft("contact_radial", "Radial contact force", "contact", "N", data["time"].values, tuple(lines))
        yield contact_parts(data, "Contact force, by the tip on the environment")


def _order(data: Any) -> list[int]:
    """Deformations as the figures have them, known ones first."""
    names = [str(name) for name in data["deformation_kind"].values]
    return sorted(range(len(names)), key=lambda k: list(PLACES).index(names[k]) if names[k] in PLACES else len(PLACES))


def _angle(data: Any, k: int) -> Draft:
    name = str(data["deformation_kind"].values[k])
    place, letter, index = PLACES.get(name, (name, "", ""))
    roles = {"real": "", "reference": "_reference", "stationary": "_stationary", "oscillatory": "_oscillatory"}
    lines = [
        line_of(data, (f"deformation{end}", k), f"{letter}{index}" or name, role)
        for role, end in roles.items()
        if f"deformation{end}" in data
    ]
    title = f"{place.capitalize()}, {letter}{' ' if index else ''}{index}" if letter else name
    return Draft(f"deformation_{name}", title, "deformations", "rad", data["time"].values, tuple(lines))


def _motor(data: Any) -> Iterator[Draft]:
    time = data["time"].values
    yield Draft("voltage", "Motor voltage", "motors", "V", time, _beside_reference(data, "voltage", "u"))
    yield Draft("current", "Motor current", "motors", "A", time, _beside_reference(data, "current", "i"))
    yield from _torque(data)
    yield Draft("gear_torque", "Gear torque", "motors", "N m", time, _beside_reference(data, "gear_torque", "ς"))
    yield from _motor_angle(data)


def _beside_reference(data: Any, name: str, label: str) -> tuple[Line, ...]:
    lines = [line_of(data, (name, 0), label, "real")]
    if f"{name}_reference" in data:
        lines.append(line_of(data, (f"{name}_reference", 0), label, "reference"))
    return tuple(lines)


def _torque(data: Any) -> Iterator[Draft]:
    """What the current makes, C_M i, where the constant is known."""
    constant = json.loads(data.attrs["parameters"]).get("motor.torque_constant")
    if isinstance(constant, float):
        current = values_at(data, ("current", 0))
        line = Line("CM i", "real", constant * current, ("current", 0), None, constant)
        yield Draft("motor_torque", "Motor torque", "motors", "N m", data["time"].values, (line,))


def _motor_angle(data: Any) -> Iterator[Draft]:
    if "theta_wanted" in data:
        place = ("q", [str(name) for name in data["coordinate"].values].index("theta"))
        time, wanted = data["time"].values, ("theta_wanted", 0)
        lines = (line_of(data, place, "θ", "real"), line_of(data, wanted, "θ", "reference"))
        yield Draft("motor_angle", "Motor angle", "motors", "rad", time, lines)
        error = (line_of(data, place, "θ less wanted", "real", less=wanted),)
        yield Draft("motor_error", "Motor angle less wanted", "motors", "rad", time, error, "offered")
