"""The linked charts of one or several runs, drafted from their results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmodes.chain.chain import joint_of_element
from tmodes.frame import along
from tmodes.plot.facts import command_of, deformation_unit, drive_unit, effort_unit, names_of
from tmodes.report.drafts import Draft, Line, in_readable_units, line_of, run_spectra
from tmodes.result import Result
from tmodes.result.derived import Derives

__all__ = ["charts_of", "contact_parts", "drafts_of", "energy_charts", "tip_charts"]

_TOGETHER = 6
"""Coordinates or joints in one chart, at most."""

_SAME = 2e-3
"""Share of a chart's range within which curves lie on each other."""

_PARTS = {"real": "", "reference": "_nominal", "stationary": "_stationary", "oscillatory": "_oscillatory"}


def charts_of(results: Sequence[Result], made: Sequence[Derives] = ()) -> list[list[dict[str, Any]]]:
    """The charts of each run as ``Chart`` of ``web/src/contract.ts``; charts of one name have one unit in all runs.

    ``made``: what notes of each run which charts could not be drawn.
    """
    runs = [drafts_of(*one) for one in zip(results, made or [Derives() for _ in results], strict=True)]
    shown = {draft.id for run in runs for draft in run if _shows(draft)}
    return in_readable_units([[draft for draft in run if draft.id in shown] for run in runs])


def _shows(draft: Draft) -> bool:
    """Whether there is more than zeros, or that is what it is to show."""
    return draft.group == "energy" or any(np.any(line.values) for line in draft.lines)


def drafts_of(result: Result, made: Derives | None = None) -> list[Draft]:
    """The charts of a run in SI units, the first of each group being the one to look at first.

    ``made`` notes which could not be drawn.
    """
    made, found = made or Derives(), list[Draft]()
    for name, drafts in _DRAFTS.items():
        found += made.attempt(f"charts of the {name}", lambda of=drafts: [*of(result)], lambda _: [])
    return found


def _causes(data: Any) -> Iterator[Draft]:
    """The error of the tip over time by its causes: components along the error, which add up to its size."""
    for which, series in (("commanded", "tip_error"), ("nominal", "tip_error_nominal")):
        if series in data:
            parts = data[series].transpose("time", "error_part", "axis").values
            columns = [np.linalg.norm(parts.sum(axis=1), axis=1), *along(parts).T]
            each = enumerate(zip(["total", *map(str, data["error_part"].values)], columns, strict=True), -1)
            total, *lines = [Line(name, "real", one, (series, k), along=True) for k, (name, one) in each]
            drawn = (*(line for line in lines if np.any(line.values)), total)
            title, time = f"Tip error to {which}, by cause", data["time"].values
            yield Draft(series, title, "error", "m", time, drawn, stacked=True)


def _contact(data: Any) -> Iterator[Draft]:
    if "contact_force" not in data:
        return
    time = data["time"].values
    lines = [line_of(data, ("contact_force_normal", 0), "normal", "real")]
    if "contact_force_normal_nominal" in data:
        lines.append(line_of(data, ("contact_force_normal_nominal", 0), "normal", "reference"))
    yield Draft("contact_normal", "Normal contact force", "contact", "N", time, tuple(lines))
    yield contact_parts(data, "Contact force, by the point on the surface")
    deep = (line_of(data, ("penetration", 0), "penetration", "real"),)
    yield Draft("penetration", "Penetration (below zero: distance)", "contact", "m", time, deep)


def _deformations(data: Any) -> Iterator[Draft]:
    """One chart for each gear and each link; a link with many coordinates, or coordinates of two units, has several."""
    if "deformation_kind" not in data.dims:
        return
    names = names_of(data, "deformation_kind")
    groups: dict[tuple[str, str], list[int]] = {}
    for k, name in enumerate(names):
        groups.setdefault((_owner(data, name), deformation_unit(data, name)), []).append(k)
    for (owner, unit), places in groups.items():
        yield from _element(data, owner, unit, names, places)


def _owner(data: Any, name: str) -> str:
    """The gear itself, or the link of a coordinate."""
    return name.rpartition(".")[0] if name in data["coordinate"].values else name


def _element(data: Any, owner: str, unit: str, names: Sequence[str], places: Sequence[int]) -> Iterator[Draft]:
    for first in range(0, len(places), _TOGETHER):
        part = places[first : first + _TOGETHER]
        title = (
            f"Link {owner}"
            if owner not in names
            else f"{owner.rpartition('.')[2].title()} of {joint_of_element(owner)}"
        )
        if len(places) > _TOGETHER:
            title += f", coordinates {first + 1} to {first + len(part)} of {len(places)}"
        lines = tuple(
            line_of(data, (f"deformation{end}", k), names[k].removeprefix(f"{owner}."), role, shown=_shown(role, part))
            for k in part
            for role, end in _PARTS.items()
            if f"deformation{end}" in data
        )
        own = f"deformation_{owner}_{unit}_{first}"
        yield Draft(own, title, "deformations", unit, data["time"].values, lines)


def _shown(role: str, together: Sequence[int]) -> bool:
    """One coordinate shows all its parts, of several only how they move."""
    return role == "real" or len(together) == 1


def _joints(data: Any) -> Iterator[Draft]:
    if "drive" not in data.dims:
        return
    drives = names_of(data, "drive")
    yield from _by_unit(data, "effort", "Effort", drives, _effort, effort_unit)
    yield from _by_unit(data, "joint_error", "Tracking error of the joints", drives, _error, drive_unit)
    yield from _by_unit(data, "joint", "Joint positions", drives, _position, drive_unit)
    yield from _by_unit(data, "gear_torque", "Gear torque", drives, _gear_torque, effort_unit)
    for name, title, unit in (("voltage", "Motor voltage", "V"), ("current", "Motor current", "A")):
        if name in data:
            lines = [(line_of(data, (name, k), drive, "real"),) for k, drive in enumerate(drives)]
            yield from _chunks(name, title, unit, data, [part for part in lines if np.any(part[0].values)])


def _by_unit(data: Any, name: str, title: str, drives: Sequence[str], lines: Any, unit_of: Any) -> Iterator[Draft]:
    groups: dict[str, list[tuple[Line, ...]]] = {}
    for k, drive in enumerate(drives):
        if found := lines(data, k, drive):
            groups.setdefault(unit_of(data, drive), []).append(found)
    for unit, found in groups.items():
        yield from _chunks(f"{name}_{unit}", title, unit, data, found)


def _chunks(name: str, title: str, unit: str, data: Any, groups: Sequence[tuple[Line, ...]]) -> Iterator[Draft]:
    groups = _apart(groups)
    for first in range(0, len(groups), _TOGETHER):
        part = groups[first : first + _TOGETHER]
        more = f", {first + 1} to {first + len(part)} of {len(groups)}" if len(groups) > _TOGETHER else ""
        lines = tuple(line for group in part for line in group)
        yield Draft(f"{name}_{first}", f"{title}{more}", "motors", unit, data["time"].values, lines)


def _apart(groups: Sequence[tuple[Line, ...]]) -> list[tuple[Line, ...]]:
    """Curves that lie on each other are drawn once, under all their names."""
    largest = max((float(np.ptp(line.values)) for group in groups for line in group), default=0.0)
    found: list[tuple[Line, ...]] = []
    for group in groups:
        for k, other in enumerate(found):
            if len(other) == len(group) and all(
                np.abs(one.values - two.values).max() <= _SAME * largest for one, two in zip(other, group, strict=True)
            ):
                found[k] = tuple(replace(line, label=f"{line.label} ≈ {group[0].label}") for line in other)
                break
        else:
            found.append(group)
    return found


def _controllers(data: Any) -> Iterator[Draft]:
    """The own states of the controllers, by unit."""
    if "controller_states" not in data:
        return
    units = [str(unit).replace("*", " ") for unit in data["controller_state_unit"].values]
    names = [str(name).replace(".controller.", ": ") for name in data["controller_state"].values]
    for unit in dict.fromkeys(units):
        own = [k for k, one in enumerate(units) if one == unit]
        lines = [(line_of(data, ("controller_states", k), names[k], "real"),) for k in own]
        yield from _chunks(f"controller_states_{unit}", "States of the controllers", unit, data, lines)


def _place(data: Any, drive: str) -> tuple[str, int]:
    return "q", names_of(data, "coordinate").index(drive)


def _wanted(data: Any, drive: str) -> bool:
    return command_of(data, drive) in ("position", "prescribed")


def _position(data: Any, k: int, drive: str) -> tuple[Line, ...]:
    real = line_of(data, _place(data, drive), drive, "real")
    return (real, line_of(data, ("wanted", k), drive, "reference")) if _wanted(data, drive) else (real,)


def _error(data: Any, k: int, drive: str) -> tuple[Line, ...]:
    if not _wanted(data, drive):
        return ()
    return (line_of(data, _place(data, drive), drive, "real", less=("wanted", k)),)


def _effort(data: Any, k: int, drive: str) -> tuple[Line, ...]:
    return (line_of(data, ("effort", k), drive, "real"),)


def _gear_torque(data: Any, k: int, drive: str) -> tuple[Line, ...]:
    line = line_of(data, ("gear_torque", k), drive, "real")
    if not np.any(line.values):
        return ()
    if "gear_torque_nominal" not in data:
        return (line,)
    return line, line_of(data, ("gear_torque_nominal", k), drive, "reference", shown=False)


def tip_charts(data: Any) -> Iterator[Draft]:
    """How far the tip is from the nominal one (where there is a nominal run), and where both are."""
    time, planned = data["time"].values, "tip_nominal" in data
    if planned:
        parts = [line_of(data, ("tip", k), f"Δ{axis}", "real", less=("tip_nominal", k)) for k, axis in enumerate("xyz")]
        lines = (line_of(data, ("deviation", 0), "distance", "real"), *parts)
        yield Draft("tip_deviation", "Tip, actual − nominal", "tip", "m", time, lines, "offered")
    for k, axis in enumerate("xyz"):
        lines = (line_of(data, ("tip", k), axis, "real"),)
        if planned:
            lines += (line_of(data, ("tip_nominal", k), axis, "reference"),)
        yield Draft(f"tip_{axis}", f"Tip {axis}", "tip", "m", time, lines)


def contact_parts(data: Any, title: str) -> Draft:
    """The components of the contact force [N]."""
    lines = tuple(line_of(data, ("contact_force", k), f"F{axis}", "real") for k, axis in enumerate("xyz"))
    return Draft("contact_parts", title, "contact", "N", data["time"].values, lines)


def energy_charts(data: Any) -> Iterator[Draft]:
    """The energies, those of the elasticity apart since they are small, the works, the residual of the balance [J]."""
    time, kinds = data["time"].values, _kinds(data, "energy")
    elastic = tuple(line for line in kinds if line.label.startswith("elastic"))
    if motion := tuple(line for line in kinds if line not in elastic):
        yield Draft("energy", "Kinetic and potential energy", "energy", "J", time, motion)
    if elastic:
        yield Draft("energy_elastic", "Elastic energy", "energy", "J", time, elastic)
    yield Draft("work", "Work since the start", "energy", "J", time, _kinds(data, "work"))
    residual = (line_of(data, ("energy_balance", 0), "residual", "real"),)
    yield Draft("energy_balance", "Residual of the energy balance", "energy", "J", time, residual, "first")


def _kinds(data: Any, name: str) -> tuple[Line, ...]:
    """Those that are not zero throughout; the first one where all are."""
    labels = [str(label).replace("_", " ") for label in data[f"{name}_kind"].values]
    lines = [line_of(data, (name, k), label, "real") for k, label in enumerate(labels)]
    return tuple(line for line in lines if np.any(line.values)) or tuple(lines[:1])


_DRAFTS: dict[str, Callable[[Result], Iterator[Draft]]] = {
    "error of the tip": lambda result: _causes(result.record),
    "tip": lambda result: tip_charts(result.record),
    "contact": lambda result: _contact(result.record),
    "deformations": lambda result: _deformations(result.record),
    "joints": lambda result: _joints(result.record),
    "controllers": lambda result: _controllers(result.record),
    "energies": lambda result: energy_charts(result.record),
    "spectra": run_spectra,
}
"""Groups of charts in their order."""
