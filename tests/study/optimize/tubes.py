"""Clamped tubes in a row under point masses: an independent finite element solution."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

__all__ = ["EXAMPLES", "Tube", "catalogue", "row_of_tubes"]

EXAMPLES = Path(__file__).parents[3] / "examples" / "studies"
ELEMENTS = 20
GRAVITY = 9.81


@dataclass(frozen=True)
class Tube:
    """A round tube."""

    name: str
    outer: float
    wall: float
    young: float
    density: float

    @property
    def stiffness(self) -> float:
        """E I [N*m^2]."""
        return self.young * np.pi / 64 * (self.outer**4 - (self.outer - 2 * self.wall) ** 4)

    @property
    def mass_per_length(self) -> float:
        """[kg/m]."""
        return self.density * np.pi / 4 * (self.outer**2 - (self.outer - 2 * self.wall) ** 2)


def catalogue(path: Path) -> list[Tube]:
    """The tubes of a file."""
    rows = [*csv.reader(path.read_text().splitlines())][1:]
    return [Tube(name, float(d) / 1e3, float(t) / 1e3, float(e) * 1e9, float(rho)) for name, d, t, e, _, rho in rows]


def row_of_tubes(tubes: list[Tube], lengths: list[float], masses: list[float]) -> tuple[float, float, float]:
    """Mass of the tubes [kg], sag of the end [m], first frequency [Hz]: Hermite elements, 20 for each tube."""
    size = 2 * (ELEMENTS * len(tubes) + 1)
    stiffness, inertia, weight = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size)
    place = 0
    for tube, length, mass in zip(tubes, lengths, masses, strict=True):
        k, m, f = _element(tube, length / ELEMENTS)
        for _ in range(ELEMENTS):
            here = slice(place, place + 4)
            stiffness[here, here] += k
            inertia[here, here] += m
            weight[here] += f
            place += 2
        inertia[place, place] += mass
        weight[place] += mass * GRAVITY
    k, m, f = stiffness[2:, 2:], inertia[2:, 2:], weight[2:]
    frequency = np.sqrt(eigh(k, m, eigvals_only=True, subset_by_index=[0, 0])[0]) / (2 * np.pi)
    total = sum(tube.mass_per_length * length for tube, length in zip(tubes, lengths, strict=True))
    return float(total), float(np.linalg.solve(k, f)[-2]), float(frequency)


def _element(tube: Tube, h: float) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Stiffness, inertia and weight of a beam element with cubic shapes."""
    stiffness = [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2],
                 [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h**2, -6 * h, 4 * h**2]]  # fmt: skip
    inertia = [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
               [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]]  # fmt: skip
    mass = tube.mass_per_length * h
    weight = np.array([6, h, 6, -h]) * mass * GRAVITY / 12
    return tube.stiffness / h**3 * np.array(stiffness), mass / 420 * np.array(inertia), weight
