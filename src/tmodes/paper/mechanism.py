"""Structure without a number, and numbers without structure.

One compiled Model serves every parameter set (known and real stiffness, a sweep, a batch), because parameters are
inputs of the compiled code; a :class:`Mechanism` is all that the code depends on.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from tmodes.paper.environment import FrictionLaw

__all__ = ["Drive", "Mechanism", "Parameters", "Reading"]


class Reading(StrEnum):
    """Which reading of the paper's equations. ``docs/readings.md`` compares them with numbers."""

    PRINTED = "printed"
    CONSISTENT = "consistent"


class Drive(StrEnum):
    """What moves the motor: a given voltage, the local controller, or a motor that follows its reference exactly."""

    VOLTAGE = "voltage"
    CONTROLLED = "controlled"
    PRESCRIBED = "prescribed"


@dataclass(frozen=True)
class Mechanism:
    """The structure of a robot: what its equations look like, without a number. Hashable: a key of the cache.

    ``contact`` is the friction law of the environment, or None in free space; ``rigid`` names the elements that are
    rigid by wish (``gear``, ``mode1``, ``mode2``); ``reference_degree`` the degree of the reference's polynomials.
    """

    reading: Reading
    contact: FrictionLaw | None
    drive: Drive
    rigid: frozenset[str] = frozenset()
    reference_degree: int = 2

    @property
    def key(self) -> str:
        """The structure in words, stable between runs and processes."""
        return f"{self.arm_key} drive={self.drive} degree={self.reference_degree}"

    @property
    def arm_key(self) -> str:
        """The structure without its drive."""
        rigid = "+".join(sorted(self.rigid)) or "none"
        return f"{self.reading} contact={self.contact or 'none'} rigid={rigid}"


@dataclass(frozen=True)
class Parameters(Mapping[str, float]):
    """Numbers without structure: one flat, named vector [SI units]."""

    names: tuple[str, ...]
    vector: NDArray[np.float64]

    def __getitem__(self, name: str) -> float:
        return float(self.vector[self.names.index(name)])

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)
