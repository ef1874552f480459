"""The charts of a run: what is drawn of it over time and frequency, in figures and on the page."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmodes.frame import along
from tmodes.plot.charts import Chart, Line, in_units, line_of, moving, shown_name
from tmodes.plot.facts import command_of, deformation_unit, drive_unit, effort_unit, motor_of, names_of
from tmodes.plot.spectra import run_spectra
from tmodes.plot.units import Unit, largest_value
from tmodes.result import Result
from tmodes.result.derived import Derives

__all__ = ["contact_parts", "energy_charts", "figure_charts", "run_charts", "tip_charts"]

_ROLES = {"real": "", "reference": "_nominal", "stationary": "_stationary", "oscillatory": "_oscillatory"}
"""Parts of a deformation, and how the names of their series end."""

_CAUSES = {
    "controller": "controller", "gears": "gear", "links": "link", "free joints": "free joint", "total": "total",
    "gears, free joints": "gear", "elastic gear": "gear", "elastic link": "link",
    "gear damping": "gear", "link damping": "link", "contact": "contact", "motor": "controller",
}  # fmt: skip
"""The cause of a part of the error, or of an energy."""

_SIGNED = "parts below zero lessen the error; others can exceed it"


def run_charts(result: Result, made: Derives | None = None) -> list[Chart]:
    """The charts of a run in SI units, the first of each group being the one to look at first.

    ``made`` notes which could not be drawn.
    """
    made, found = made or Derives(), list[Chart]()
    for name, charts in _CHARTS.items():
        found += made.attempt(f"charts of the {name}", lambda of=charts: [*of(result)], lambda _: [])
    return found


def figure_charts(result: Result, group: str) -> dict[str, Chart]:
    """Those of one group of :data:`_CHARTS` in readable units, by their names."""
    return {chart.id: chart for chart in in_units([[*_CHARTS[group](result)]])[0]}


def _causes(data: Any) -> Iterator[Chart]:
    """The error of the tip over time by its causes: components along the error, which add up to its size."""
    for which, series in (("commanded", "tip_error"), ("nominal", "tip_error_nominal")):
        if series in data:
            parts = data[series].transpose("time", "error_part", "axis").values
            names = [str(name).replace("_", " ") for name in data["error_part"].values]
            columns = [*along(parts).T, np.linalg.norm(parts.sum(axis=1), axis=1)]
            *lines, total = [
                Line(name, "real", values, (series, k), along=True, cause=_CAUSES.get(name, ""))
                for name, values, k in zip([*names, "total"], columns, [*range(len(names)), -1], strict=True)
            ]
            drawn = (*(line for line in lines if np.any(line.values)), total)
            title, time = f"Error from {which} path, by cause", data["time"].values
            yield Chart(series, title, "error", "m", time, drawn, "error", stacked=True, note=_SIGNED)


def tip_charts(data: Any) -> Iterator[Chart]:
    """How far the tip is from the nominal one (where there is a nominal run), and where both are."""
    time, planned = data["time"].values, "tip_nominal" in data
    if planned:
        parts = [line_of(data, ("tip", k), f"Δ{axis}", less=("tip_nominal", k)) for k, axis in enumerate("xyz")]
        kept = moving({line.label: line.values for line in parts})
        lines = (
            line_of(data, ("deviation", 0), "distance", cause="total"), *(one for one in parts if one.label in kept)
        )  # fmt: skip
        yield Chart("tip_deviation", "Error from nominal path", "tip", "m", time, lines, "error", "offered")
    known = {"real": "tip", "reference": "tip_nominal", "commanded": "tip_commanded"}
    paths = {role: name for role, name in known.items() if name in data}
    charts = {
        f"tip_{axis}": tuple(line_of(data, (name, k), axis, role) for role, name in paths.items())
        for k, axis in enumerate("xyz")
    }
    for name in moving({name: np.stack([line.values for line in lines]) for name, lines in charts.items()}):
        yield Chart(name, f"Tip {name[-1]}", "tip", "m", time, charts[name], "position")


def contact_parts(data: Any, title: str) -> Chart:
    """The components of the contact force [N]."""
    lines = {f"F{axis}": line_of(data, ("contact_force", k), f"F{axis}") for k, axis in enumerate("xyz")}
    kept = moving({name: line.values for name, line in lines.items()})
    return Chart("contact_parts", title, "contact", "N", data["time"].values, tuple(lines[name] for name in kept))


def _contact(data: Any) -> Iterator[Chart]:
    if "contact_force" not in data:
        return
    time, known = data["time"].values, {"real": "contact_force_normal", "reference": "contact_force_normal_nominal"}
    normal = tuple(line_of(data, (name, 0), "normal", role) for role, name in known.items() if name in data)
    yield Chart("contact_normal", "Normal contact force", "contact", "N", time, normal)
    yield contact_parts(data, "Contact force, by the point on the surface")
    deep = (line_of(data, ("penetration", 0), "penetration"),)
    yield Chart("penetration", "Penetration (below zero: distance)", "contact", "m", time, deep, "depth")


def _deformations(data: Any) -> Iterator[Chart]:
    """One chart for each gear and each link, or several of one that has coordinates of several units."""
    groups: dict[tuple[str, str, str], list[Line]] = {}
    for k, name in enumerate(names_of(data, "deformation_kind")):
        of_link = name in data["coordinate"].values
        owner, _, own = name.rpartition(".") if of_link else (name, "", name)
        unit, cause = deformation_unit(data, name), "link" if of_link else "gear"
        for role, end in _ROLES.items():
            if f"deformation{end}" in data:
                line = line_of(data, (f"deformation{end}", k), shown_name(own), role, cause=cause)
                groups.setdefault((cause, owner, unit), []).append(line)
    worst = {
        key[0]: max((one for one in groups if one[0] == key[0]), key=lambda one: _size(groups[one])) for key in groups
    }
    for (cause, owner, unit), lines in groups.items():
        alone = len({line.label for line in lines}) == 1  # one coordinate shows all its parts, of several how they move
        drawn = tuple(replace(line, shown=alone or line.role == "real") for line in lines)
        title = shown_name(owner if cause == "gear" else f"deformation of {owner}")
        yield Chart(
            f"deformation_{owner}_{unit}", f"{title[0].upper()}{title[1:]}", "deformations", unit, data["time"].values,
            drawn, overview=worst[cause] == (cause, owner, unit),
        )  # fmt: skip


def _size(lines: Sequence[Line]) -> float:
    return max(largest_value(line.values) for line in lines if line.role == "real")


_MOVED = ("position", "prescribed")
"""Commands that say where a joint shall be."""


def _joints(data: Any) -> Iterator[Chart]:
    """What drives do, one chart for each unit."""
    drives, places = names_of(data, "drive"), names_of(data, "coordinate")
    for name, (title, what, unit_of, lines) in _OF_DRIVES.items():
        found: dict[str, list[Line]] = {}
        for k, drive in enumerate(drives):
            found.setdefault(unit_of(data, drive), []).extend(lines(data, k, drive, places.index(drive)))
        for unit, own in found.items():
            if own:
                yield Chart(f"{name}_{unit}", title, "motors", unit, data["time"].values, tuple(own), what)


def _positions(data: Any, k: int, drive: str, place: int) -> Iterator[Line]:
    yield line_of(data, ("q", place), shown_name(drive))
    wanted = command_of(data, drive) in _MOVED
    if motor := motor_of(data, drive):
        place = names_of(data, "coordinate").index(motor)
        yield line_of(data, ("q", place), shown_name(drive), "motor", shown=False)
    if wanted:
        yield line_of(data, ("wanted", k), shown_name(drive), "commanded")


def _errors(data: Any, k: int, drive: str, place: int) -> Iterator[Line]:
    """The positions less their setpoint; none where there is no setpoint."""
    for line in _positions(data, k, drive, place) if command_of(data, drive) in _MOVED else ():
        if line.role != "commanded" and line.place:
            yield line_of(data, line.place, line.label, line.role, less=("wanted", k), shown=line.shown)


def _rates(data: Any, k: int, drive: str, place: int) -> Iterator[Line]:
    del k
    if command_of(data, drive) not in _MOVED:
        yield line_of(data, ("v", place), shown_name(drive))


def _series(name: str, *, nominal: str = "", zero: bool = False, cause: str = "") -> Callable[..., Iterator[Line]]:
    """The lines of a series of the drives, without those that stay zero unless ``zero``."""

    def lines(data: Any, k: int, drive: str, place: int) -> Iterator[Line]:
        del place
        if name in data and (zero or np.any(line_of(data, (name, k), "").values)):
            yield line_of(data, (name, k), shown_name(drive), cause=cause)
            if nominal in data:
                yield line_of(data, (nominal, k), shown_name(drive), "reference", shown=False, cause=cause)

    return lines


_OF_DRIVES: dict[str, tuple[str, str, Callable[[Any, str], str], Callable[..., Iterator[Line]]]] = {
    "effort": ("Motor effort", "", effort_unit, _series("effort", zero=True)),
    "joint_error": ("Error of joints from their setpoints", "error", drive_unit, _errors),
    "joint": ("Joint positions", "position", drive_unit, _positions),
    "rate": ("Joint rates", "rate", lambda data, drive: f"{drive_unit(data, drive)}/s", _rates),
    "gear_torque": (
        "Gear torque",
        "",
        effort_unit,
        _series("gear_torque", nominal="gear_torque_nominal", cause="gear"),
    ),
    "voltage": ("Motor voltage", "", lambda *_: "V", _series("voltage")),
    "current": ("Motor current", "", lambda *_: "A", _series("current")),
}


def _controllers(data: Any) -> Iterator[Chart]:
    """The own states of the controllers, by unit."""
    if "controller_states" not in data:
        return
    units = [str(unit).replace("*", " ") for unit in data["controller_state_unit"].values]
    names = [shown_name(str(name).replace(".controller.", ": ")) for name in data["controller_state"].values]
    for unit in dict.fromkeys(units):
        own = (k for k, one in enumerate(units) if one == unit)
        lines = tuple(line_of(data, ("controller_states", k), names[k]) for k in own)
        yield Chart(
            f"controller_states_{unit}",
            "States of the controllers",
            "motors",
            unit,
            data["time"].values,
            lines,
            "state",
        )


def energy_charts(data: Any) -> Iterator[Chart]:
    """The energies, those of the elasticity on an axis of their own too, the works, the residual of the balance [J]."""
    time, kinds = data["time"].values, _kinds(data, "energy")
    elastic = tuple(line for line in kinds if line.label.startswith("elastic"))
    yield Chart("energy", "Energy", "energy", "J", time, kinds, "energy")
    if elastic:
        yield Chart(
            "energy_elastic", "Elastic energy, on its own axis", "energy", "J", time, elastic, "elastic energy",
            overview=True,
        )  # fmt: skip
    yield Chart("work", "Work since the start", "energy", "J", time, _kinds(data, "work"), "work")
    residual = (line_of(data, ("energy_balance", 0), "residual", cause="total"),)
    yield Chart(
        "energy_balance",
        "Residual of the energy balance",
        "energy",
        "J",
        time,
        residual,
        "residual",
        "first",
        unit=Unit("J", 1.0),
    )


def _kinds(data: Any, name: str) -> tuple[Line, ...]:
    """Those that are not zero throughout; the first one where all are."""
    labels = [str(label).replace("_", " ") for label in data[f"{name}_kind"].values]
    lines = [line_of(data, (name, k), label, cause=_CAUSES.get(label, "")) for k, label in enumerate(labels)]
    return tuple(line for line in lines if np.any(line.values)) or tuple(lines[:1])


_CHARTS: dict[str, Callable[[Result], Iterator[Chart]]] = {
    "error": lambda result: _causes(result.record),
    "tip": lambda result: tip_charts(result.record),
    "contact": lambda result: _contact(result.record),
    "deformations": lambda result: _deformations(result.record),
    "joints": lambda result: _joints(result.record),
    "controllers": lambda result: _controllers(result.record),
    "energies": lambda result: energy_charts(result.record),
    "spectra": run_spectra,
}
"""Groups of charts in their order."""
