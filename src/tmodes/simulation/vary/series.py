"""Series of a run by their names: those that stop conditions may name, deformations, and distances of the tip."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmodes.analysis.quasistatic import elastic_names, sprung
from tmodes.chain.chain import joint_of_element
from tmodes.equations.loop.lean import Shown
from tmodes.errors import InputError
from tmodes.io.words import nearest
from tmodes.simulation.quantities import coordinate_units, run_quantities
from tmodes.simulation.start import RunSetup

__all__ = ["COMMANDED", "DEVIATION", "DISTANCES", "OWN", "compiled_series", "refuse_unknown_series", "units_of"]

DEVIATION, OWN, COMMANDED = "deviation", "tip_difference", "tip_error"

DISTANCES = (DEVIATION, OWN, COMMANDED)
"""Distances of the tip [m]: from the nominal tip of the same case, the sheet's own run, and the commanded path."""

_DRIVEN = ("effort", "voltage", "current")
_TOUCH = {"force": Shown("contact", (3,)), "penetration": Shown("contact", (4,)), "fold": Shown("fold")}
_SHOWN = 12


def units_of(setup: RunSetup) -> dict[str, str]:
    """Units of all series of a robot, by their names."""
    found = {name: quantity.unit for name, quantity in run_quantities(setup).items()}
    units = dict(zip(setup.model.coordinates, coordinate_units(setup), strict=True))
    for name in elastic_names(setup.mechanics):
        found[f"deformation.{name}"] = units.get(name, units.get(joint_of_element(name), "rad"))
    return found | dict.fromkeys(DISTANCES, "m")


def compiled_series(setup: RunSetup, given: Sequence[str]) -> dict[str, Shown]:
    """Those of the series that compiled code gives, by their names; ``given``: distances, in the order of the table."""
    found = dict([*_states(setup), *_drives(setup), *_points(setup), *_deformations(setup)])
    if setup.planned.plan.touch:
        found |= {f"contact.{name}": shown for name, shown in _TOUCH.items()}
    return found | {name: Shown("apart", (3 * k,)) for k, name in enumerate(given)}


def _states(setup: RunSetup) -> Iterator[tuple[str, Shown]]:
    layout = setup.model.layout
    for k, name in enumerate(setup.model.coordinates):
        yield f"{name}.position", Shown("state", (layout.q.start + k,))
        yield f"{name}.velocity", Shown("state", (layout.v.start + k,))
    for k, name in enumerate(setup.planned.plan.surface_names):
        yield name, Shown("state", (layout.surface.start + k,))


def _drives(setup: RunSetup) -> Iterator[tuple[str, Shown]]:
    for k, drive in enumerate(setup.planned.plan.drives):
        for column, name in enumerate(_DRIVEN):
            yield f"{drive.joint}.{name}", Shown("drive", (k, column))
        yield f"{drive.joint}.gear_torque", Shown("gear", (k,))
    for k, name in enumerate(setup.planned.plan.control_names):
        yield name, Shown("control", (k,))


def _points(setup: RunSetup) -> Iterator[tuple[str, Shown]]:
    for k, point in enumerate(setup.mechanics.parts.points):
        for axis, letter in enumerate("xyz"):
            yield f"{point.name}.{letter}", Shown("point", (k, axis))
            yield f"{point.name}.velocity.{letter}", Shown("point", (k, 3 + axis))
        yield f"{point.name}.speed", Shown("speed", (k,))


def _deformations(setup: RunSetup) -> Iterator[tuple[str, Shown]]:
    """Deflections of links, and of gears that each belong to one motor."""
    model, motors = setup.mechanics, {axis.angle: axis.motor for axis in setup.mechanics.parts.axes}
    for name, joint in zip(elastic_names(model), sprung(model), strict=False):
        if motors[joint] >= 0 and model.chain.couplings is None:
            yield f"deformation.{name}", Shown("bent", (joint, motors[joint]))
    for k in model.deformations.tolist():
        yield f"deformation.{model.coordinates[k]}", Shown("state", (k,))


def refuse_unknown_series(names: Sequence[str], known: Sequence[str]) -> None:
    """Raise :class:`tmodes.errors.InputError` for a name that is none, with the nearest that is."""
    for name in names:
        if name in known:
            continue
        last = name.rpartition(".")[2]
        close = nearest(name, known) or next((other for other in known if other.rpartition(".")[2] == last), None)
        listed = sorted(known, key=lambda other: (not other.startswith(name.partition(".")[0]), other))
        more = ", ..." if len(listed) > _SHOWN else ""
        hint = f"did you mean `{close}`?" if close else "write one of these names"
        got, expected = f"the unknown series {name!r}", f"one of {', '.join(listed[:_SHOWN])}{more}"
        raise InputError("reductions", got, expected, hint)
