"""All terms of the equations at many states, as plain records."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmodes.equations.lagrange.layout import EVALUATED
from tmodes.errors import SimulationError
from tmodes.paper.mechanism import Drive, Reading
from tmodes.paper.model import PaperModel
from tmodes.paper.sheet import PaperRobot

__all__ = ["NEAREST", "evaluate_states"]

NEAREST = 1e-9
"""Distance of the tip from the base point [m] below which its direction is rounding."""


def evaluate_states(robot: PaperRobot, records: Sequence[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Each record (phi (6,), phid (6,), u [V]) with the terms of :data:`tmodes.equations.lagrange.layout.EVALUATED`.

    The terms are computed at once, the records made as they are asked for: many are never whole in memory.

    The tip force is left out in free space. Raises :class:`SimulationError` naming the state where a term is not
    finite (the tip over the base, say).
    """
    mechanism, parameters = robot.split(Drive.VOLTAGE)
    phi, phid, voltage = ([record[key] for record in records] for key in ("phi", "phid", "u"))
    terms = PaperModel(mechanism).evaluate(phi, phid, voltage, parameters)
    if mechanism.contact:
        _check_distance(terms["tip"], mechanism.reading)
    names = [name for name in EVALUATED if mechanism.contact or name != "F_tip_on_environment"]
    for name in names:
        _check_finite(name, terms[name])
    return (
        {
            **{key: record[key] for key in ("phi", "phid", "u")},
            "reading": mechanism.reading.value,
            **{name: terms[name][index].tolist() for name in names},
        }
        for index, record in enumerate(records)
    )


def _check_distance(tip: Any, reading: Reading) -> None:
    """The contact's normal needs a distance from the base point (`printed`: from the vertical through it)."""
    distance = np.linalg.norm(tip[:, :2] if reading is Reading.PRINTED else tip, axis=1)
    index = int(np.argmin(distance))
    if distance[index] > NEAREST:
        return
    raise SimulationError(
        f"states[{index}]: the tip is {distance[index]:.1g} m from the base; expected more than {NEAREST:g} m, for the "
        "contact force has no direction there. Change phi, or leave --contact out"
    )


def _check_finite(name: str, values: Any) -> None:
    finite = np.isfinite(values).reshape(len(values), -1).all(axis=1)
    if finite.all():
        return
    index = int(np.argmin(finite))
    raise SimulationError(
        f"states[{index}]: {name} is not finite there; expected a state at which the equations hold. Keep phi "
        "and phid within what a robot can do"
    )
