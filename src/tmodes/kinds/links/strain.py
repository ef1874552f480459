"""The link kind ``strain``: a beam whose curvature is a sum of functions, exact in large deflection."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.beam_breaks import TURNING
from tmodes.kinds.links.beam_functions import (
    MODULI,
    bare_beam,
    beam_mass,
    fine_rule,
    function_names,
    function_order,
    function_values,
    interval_integrals,
    last_functions,
    pieces_at,
)
from tmodes.kinds.links.beam_pieces import BeamNumbers, BeamPiece
from tmodes.kinds.links.beam_tables import beam_rule, beam_tables
from tmodes.kinds.links.contract import Body, Link, LinkNumbers, QuadraticStructure
from tmodes.kinds.links.facts import AngleLimit, ends
from tmodes.kinds.links.line import LineOfLink
from tmodes.kinds.links.strain_link import strain_link
from tmodes.kinds.links.strain_places import BeamLine
from tmodes.kinds.links.strain_shape import StrainShape
from tmodes.kinds.noted.functions import distinct, number

__all__ = ["Beam", "BeamPiece", "StrainStructure"]

Array = NDArray[np.float64]

_FAST, _BOTH, _BENT = 0.13, 4.5, 0.3
"""Least one over the fourth root of the ratio of energies; that over the ratio where both functions that move the tip
are softened, but one: what is missing moves fast, where the ratio is larger than in the whole motion. Least one over
the root of the ratio and the square of the angle of bending."""


@dataclass(frozen=True)
class StrainStructure(StrainShape, QuadraticStructure):  # pyright: ignore[reportIncompatibleVariableOverride]
    """A beam of a shape, whose fields are the structure's properties."""

    long: ClassVar[bool] = True

    @property
    def own_terms(self) -> bool:
        """Its mass is spread along its line."""
        return True

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """Inertia terms, and the sections at the tip and the stations."""
        return strain_link(self, tables, rate, q, qd)


@dataclass(frozen=True, eq=False)
class Beam(BeamNumbers, Link):
    """A ``strain`` link: see :class:`tmodes.kinds.links.beam_pieces.BeamNumbers` for its fields."""

    kind: ClassVar[str] = "strain"
    comparison: ClassVar[str] = "the last functions of each direction of its links softened"

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Directions with the number of each function: ``bend_y1``, ``bend_y2``, ...; of bodies inside from 101 on."""
        return tuple(name for direction in MODULI for name in function_names(self, direction))

    def stations(self, asked: Sequence[float] = ()) -> tuple[float, ...]:
        """Bodies and named points anywhere along it."""
        return self.along(asked)

    @property
    def body_places(self) -> tuple[float, ...]:
        """Places s < 1 that carry bodies."""
        return tuple(distinct(s for s, _ in self.bodies if s < 1.0))

    def bodies_at(self, s: float) -> tuple[Body, ...]:
        """Bodies on the section at s."""
        return tuple(body for at, body in self.bodies if (at >= 1.0 if s >= 1.0 else at == s))

    def unbent_bodies(self) -> tuple[Body, ...]:
        """The bodies on it, and the beam as a straight rod of its mean mass per length."""
        mass = self.length * number(np.mean([x for piece in self.pieces for x in piece.mass]))
        polar = self.length * number(np.mean([x for piece in self.pieces for x in piece.inertia[0]]))
        across = mass * self.length**2 / 12
        rod = Body(mass, np.array([self.length / 2, 0.0, 0.0]), np.diag([polar, across, across]))
        return (rod, *super().unbent_bodies())

    angle_limit: ClassVar[AngleLimit] = AngleLimit(
        1.0, 1.6, 1.0,
        "turns by more than 1 rad between two of its points",
        "give its beam more `points`",
        "give it more functions or points",
    )  # fmt: skip
    """The series of the rotation are exact to 1e-15 at 0.6 rad, 1e-12 at 1 rad and 1e-9 at 1.6 rad between points."""

    @property
    def functions(self) -> Mapping[str, int]:
        """Functions of each direction."""
        return {name: getattr(self, name) for name in MODULI}

    @property
    def projected(self) -> tuple[str, ...]:
        """Directions that have functions and turn sections."""
        return tuple(name for name in TURNING if getattr(self, name))

    def uncertainty(self, direction: str, ratio: float, angle: float) -> float:
        """In proportion to the energy, but for fast vibration, which has little of it, and for large bending.

        A missing moment does no work on a straight beam in what the functions describe; on one that is bent by an angle
        it does, in proportion to the angle's square: docs/decisions/0033.
        """
        bent = _BENT * angle**2 * ratio**0.5
        if (count := getattr(self, direction)) > last_functions(self, direction):
            return max(ratio, _FAST * ratio**0.25, bent)
        return max(ratio if count == 1 else _BOTH * ratio, bent)

    def other_moments(self, direction: str, s: ArrayLike) -> Array:
        """The functions of curvature times the stiffness: polynomials."""
        others = function_order(self, direction)[: -last_functions(self, direction)]
        return function_values(self, direction, s)[others] * self.stiffness_at(direction, s)

    def embedding(self, finer: Link) -> Array:
        """By functions, because those of bodies inside are less what the polynomials have."""
        if not isinstance(finer, Beam):
            return super().embedding(finer)
        s, w = fine_rule(self)
        found, row, column = np.zeros((len(finer.coordinates), len(self.coordinates))), 0, 0
        for direction in MODULI:
            own, theirs = (function_values(beam, direction, s) * np.sqrt(w) for beam in (self, finer))
            if len(own):
                block = np.linalg.lstsq(theirs.T, own.T, rcond=None)[0]
                found[row : row + len(theirs), column : column + len(own)] = block
            row, column = row + len(theirs), column + len(own)
        return found

    @property
    def outer_distance(self) -> float:
        """Largest distance of the outer fibre [m]."""
        return max(self.outer)

    def limiting_angles(self, q: Array, stations: tuple[float, ...] = ()) -> Array:
        """Largest angle between neighbouring points of its line (Gauss points, stations, ends)."""
        edges = np.unique([0.0, *beam_rule(self).points, *stations, 1.0])
        directions = np.repeat(np.arange(3), [len(function_names(self, name)) for name in TURNING])
        alpha = interval_integrals(self, edges[:-1], edges[1:])[0]
        turned = np.einsum("nj,ij,jc->nic", q[:, : len(directions)], alpha, np.eye(3)[directions])
        turned = turned + np.diff(edges)[:, None] * self.length * np.asarray(self.rest_curvature, dtype=float)
        return np.linalg.norm(turned, axis=2).max(axis=1)

    def stiffness_at(self, direction: str, s: ArrayLike) -> Array:
        """EI, GJ or EA at s."""
        return pieces_at(self, MODULI[direction], s)

    @property
    def beam_mass(self) -> float:
        """Its mass per length over its length."""
        return beam_mass(self)

    def described(self, row: Sequence[Any]) -> dict[str, Any]:  # noqa: ARG002
        """Its functions, stiffnesses and first frequencies by itself."""
        first, last = self.pieces[0], self.pieces[-1]
        bare = bare_beam(self)
        return {
            "model": "strain",
            "functions": dict(self.functions),
            "basis": self.basis,
            "length_m": self.length,
            "mass_kg": bare.mass + sum(body.mass for body in self.all_bodies),
            "beam_mass_kg": bare.mass,
            "bending_stiffness_y_Nm2": ends(first.bend_y[0], last.bend_y[1]),
            "bending_stiffness_z_Nm2": ends(first.bend_z[0], last.bend_z[1]),
            "torsional_stiffness_Nm2": ends(first.torsion[0], last.torsion[1]),
            "axial_stiffness_N": ends(first.axial[0], last.axial[1]),
            "shear_stiffness_y_N": ends(first.shear_y[0], last.shear_y[1]),
            "shear_stiffness_z_N": ends(first.shear_z[0], last.shear_z[1]),
            "tip_stiffness_y_N_per_m": _over(bare.compliance[0]),
            "tip_stiffness_z_N_per_m": _over(bare.compliance[1]),
            "bare_bend_y_Hz": bare.bend_y_Hz,
            "bare_bend_z_Hz": bare.bend_z_Hz,
            "bare_twist_Hz": bare.twist_Hz,
            "damping_time_s": self.damping_time,
        }

    def lines(self, stations: tuple[float, ...], s: NDArray[np.float64]) -> Sequence[LineOfLink]:
        """One line, section by section as the model has it."""
        return [BeamLine(self.length, stations, s, beam=self)]

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:
        """Quadrature, integrals of the functions, stiffness."""
        tables = beam_tables(self, stations)
        return LinkNumbers(StrainStructure(*astuple(tables.shape)), tables.packed, tables.stiffness, tables.damping)

    def compared(self) -> Self | None:
        """With its last functions of each direction softened; of one that only stretches no balance is known."""
        return replace(self, softened=True) if self.projected else None


def _over(compliance: float) -> float | None:
    return 1 / compliance if compliance > 0 else None
