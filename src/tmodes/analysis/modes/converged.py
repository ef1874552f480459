"""Which modes of an arm its functions do not yet tell: against the same arm with two more functions a direction."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.modes import ArmMode
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.sheet import Robot
from tmodes.sheet.parts import LinkSheet

__all__ = ["CONVERGED", "MOST_CHECKED", "finer", "frequency_errors"]

Array = NDArray[np.float64]

CONVERGED = 0.01
"""Share by which a frequency may change with more functions."""

MOST_CHECKED = 60
"""Coordinates up to which an arm is compared with a finer one."""

ALIKE = 0.3
"""Likeness (modal assurance) from which two modes are the same motion."""


def finer(arm: Robot) -> Robot | None:
    """The arm with more functions; None where no link has any to which more could be added."""

    def refined(link: LinkSheet) -> LinkSheet:
        return link.model_copy(update={"beam": link.beam.finer()}) if link.beam else link

    links = tuple(refined(link) for link in arm.links)
    return None if links == arm.links else arm.model_copy(update={"links": links})


def frequency_errors(
    rest: Equilibrium, modes: Sequence[ArmMode], fine: Equilibrium, fine_modes: Sequence[ArmMode]
) -> list[float | None]:
    """By which share each frequency is higher than that of the finer arm's mode most like it; None where none is."""
    from scipy.optimize import linear_sum_assignment

    if not modes:
        return []
    names = fine.model.coordinates
    places = [names.index(name) for name in rest.model.coordinates]
    ours, theirs = np.zeros((len(names), len(modes))), np.array([mode.shape for mode in fine_modes]).T
    ours[places] = np.array([mode.shape for mode in modes]).T
    alike = _likeness(ours, theirs, fine.matrices[0])
    first, second = linear_sum_assignment(-alike)
    found: list[float | None] = [None] * len(modes)
    for k, other in zip(first, second, strict=True):
        exact = fine_modes[other].frequency_Hz
        if alike[k, other] > ALIKE and exact > 0 and modes[k].frequency_Hz > 0:
            found[int(k)] = float(modes[k].frequency_Hz / exact - 1)
    return found


def _likeness(ours: Array, theirs: Array, mass: Array) -> Array:
    """Modal assurance by the mass matrix: 1 for the same motion."""
    sizes = [np.einsum("ik,ij,jk->k", x, mass, x) for x in (ours, theirs)]
    return (ours.T @ mass @ theirs) ** 2 / np.outer(*sizes)
