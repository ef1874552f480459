"""What stop conditions may name of a robot in a run, by name and with units; and its limits as conditions."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from tmodes.model.model import Model, PointMotion
from tmodes.sheet import Robot
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.motion_run import energies_of
from tmodes.simulation.plan import planned
from tmodes.simulation.start import RunSetup
from tmodes.simulation.stops import Instants, Quantity, Stop, Stops, resolved

__all__ = ["coordinate_units", "named_setup", "refuse_wrong_stops", "run_quantities", "run_stops"]

Array = NDArray[np.float64]

_AXES = ("x", "y", "z")
_DRIVEN = ("effort", "voltage", "current")
_ENERGIES = ("kinetic", "gravity", "elastic_gear", "elastic_link")
_CONTACT = (("force", "N", "contact", 3), ("fold", "-", "contact_fold", 0), ("penetration", "m", "contact", 4))


def run_stops(setup: RunSetup, more: tuple[str, ...] = ()) -> Stops:
    """The stop conditions of a robot's sheet, ``more`` of them, and its limits where they end a run.

    Raises :class:`tmodes.errors.InputError` as :func:`tmodes.simulation.stops.resolved`.
    """
    settings = setup.robot.integration
    if not (settings.stop or more or settings.stop_at_limits):
        return Stops()
    known = run_quantities(setup)
    limits = tuple(_limits(setup, known)) if settings.stop_at_limits else ()
    return Stops((*resolved(settings.stop, known), *resolved(more, known, "stop"), *limits))


def refuse_wrong_stops(robot: Robot) -> None:
    """Refuse what :func:`run_stops` refuses, without a state to start from; nothing is compiled for it.

    Raises :class:`tmodes.errors.InputError`.
    """
    if robot.integration.stop:
        run_stops(named_setup(robot))


def named_setup(robot: Robot) -> RunSetup:
    """A setup without a state to start from, of which only the names are asked; nothing is compiled for it."""
    plan = planned(robot)
    nowhere = np.zeros(0)
    return RunSetup(robot, plan, LoopModel(plan.plan), nowhere, Model(plan.chain), nowhere)


def run_quantities(setup: RunSetup) -> dict[str, Quantity]:
    """The quantities by name: coordinates, drives, states of controllers, named points, contact and energies."""
    seen = _Seen(setup)
    return {**_coordinates(setup), **_drives(setup, seen), **_points(seen), **_others(setup, seen)}


class _Seen:
    """What a robot shows at instants; the last of each kind is kept, because several conditions look at the same."""

    def __init__(self, setup: RunSetup) -> None:
        self.setup, self.layout = setup, setup.model.layout
        self.observed, self.points = lru_cache(1)(self._observed), lru_cache(1)(self._points)
        self.energies = lru_cache(1)(self._energies)

    def _observed(self, at: Instants) -> dict[str, Array]:
        """As :meth:`tmodes.simulation.loop.LoopModel.observe`."""
        return self.setup.model.observe(at.times, at.states, at.rows)

    def _points(self, at: Instants) -> PointMotion:
        """Motion of the named points; their accelerations are left out."""
        q, v = at.states[:, self.layout.q], at.states[:, self.layout.v]
        return self.setup.mechanics.points(q, v, 0.0, base=self.observed(at)["base"])

    def _energies(self, at: Instants) -> dict[str, Array]:
        """Energies by kind [J]."""
        q, v = at.states[:, self.layout.q], at.states[:, self.layout.v]
        return energies_of(self.setup, self.setup.mechanics, q, v, self.observed(at)["base"])


def _coordinates(setup: RunSetup) -> dict[str, Quantity]:
    layout, found = setup.model.layout, {}
    for k, (name, unit) in enumerate(zip(setup.model.coordinates, coordinate_units(setup), strict=True)):
        rate = "1/s" if unit == "-" else f"{unit}/s"
        for kind, of, block in (("position", unit, layout.q), ("velocity", rate, layout.v)):
            found[f"{name}.{kind}"] = Quantity(of, lambda at, column=block.start + k: at.states[:, column])
    return found


def coordinate_units(setup: RunSetup) -> list[str]:
    """Unit of each coordinate, as :meth:`tmodes.chain.chain.Chain.units`."""
    return [*setup.planned.chain.units(setup.model.coordinates).values()]


def _drives(setup: RunSetup, seen: _Seen) -> dict[str, Quantity]:
    found = {}
    sliding = setup.planned.chain.sliding
    for k, drive in enumerate(setup.planned.plan.drives):
        effort = "N" if drive.joint in sliding else "N*m"
        for column, (name, unit) in enumerate(zip(_DRIVEN, (effort, "V", "A"), strict=True)):
            found[f"{drive.joint}.{name}"] = Quantity(
                unit, lambda at, k=k, column=column: seen.observed(at)["drives"][:, k, column]
            )
        found[f"{drive.joint}.gear_torque"] = Quantity(effort, lambda at, k=k: seen.observed(at)["gear"][:, k])
    plan = setup.planned.plan
    for k, (name, unit) in enumerate(zip(plan.control_names, plan.control_units, strict=True)):
        found[name] = Quantity(unit, lambda at, k=k: seen.observed(at)["controls"][:, k])
    return found


def _points(seen: _Seen) -> dict[str, Quantity]:
    found = {}
    for k, point in enumerate(seen.setup.mechanics.parts.points):
        for axis, letter in enumerate(_AXES):
            for name, unit, part in ((letter, "m", "position"), (f"velocity.{letter}", "m/s", "velocity")):
                found[f"{point.name}.{name}"] = Quantity(
                    unit, lambda at, k=k, axis=axis, part=part: getattr(seen.points(at), part)[:, k, axis]
                )
        found[f"{point.name}.speed"] = Quantity(
            "m/s", lambda at, k=k: np.linalg.norm(seen.points(at).velocity[:, k], axis=1)
        )
    return found


def _others(setup: RunSetup, seen: _Seen) -> dict[str, Quantity]:
    found = {f"energy.{name}": Quantity("J", lambda at, name=name: seen.energies(at)[name]) for name in _ENERGIES}
    found["energy.total"] = Quantity("J", lambda at: np.sum([*seen.energies(at).values()], axis=0))
    for name, unit, part, column in _CONTACT if setup.planned.plan.touch else ():
        found[f"contact.{name}"] = Quantity(
            unit, lambda at, part=part, column=column: seen.observed(at)[part][:, column]
        )
    for column, (name, unit) in enumerate(zip(setup.planned.plan.surface_names, ("m", "m/s"), strict=False)):
        place = setup.model.layout.surface.start + column
        found[name] = Quantity(unit, lambda at, place=place: at.states[:, place])
    return found


def _limits(setup: RunSetup, known: dict[str, Quantity]) -> Iterator[Stop]:
    """The limits of joints. One is passed where it is by more than the tolerance: a joint may rest at its limit."""
    settings = setup.robot.integration
    for joint, own in ((each, name) for each in setup.robot.joints for name in each.coordinates):
        limits = joint.limits
        if limits is None:
            continue
        kinds = (
            ("position", limits.lower, False, False), ("position", limits.upper, True, False),
            ("velocity", limits.speed, True, True), ("effort", limits.effort, True, True),
        )  # fmt: skip
        for kind, limit, above, size in kinds:
            quantity = known.get(f"{own}.{kind}")
            if limit is None or quantity is None:
                continue
            margin = settings.absolute_tolerance + settings.relative_tolerance * max(1.0, abs(limit))
            name = f"abs({own}.{kind})" if size else f"{own}.{kind}"
            text = f"limit of {own}: {name} {'>' if above else '<'} {limit:.9g} {quantity.unit}"
            yield Stop(text, name, quantity, limit + margin if above else limit - margin, above, size)
