"""The contract of an integrator: what a run asks of its method. One file, and one object, for each method."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError

__all__ = ["EULER", "EXPLICIT", "IMPLICIT", "JACOBIAN", "Integrator", "Tableau", "explicit"]

EXPLICIT, JACOBIAN, IMPLICIT, EULER = "explicit", "jacobian", "implicit", "euler"
"""What a step asks of the equations: rates; rates and their Jacobian; implicit steps; linearly implicit Euler steps."""

_EXACT = 1e-12
"""Error of the sum of a tableau's weights above which they are taken as wrong."""


@dataclass(frozen=True)
class Tableau:
    """An explicit Runge-Kutta method. The last row of ``a`` gives the step's end, whose slope begins the next step.

    ``a``: row i holds the weights of the slopes before in stage i; ``c``: the stages' times as shares of the step.
    ``error``: weights of the slopes in the local error, None of a method with a fixed step. ``dense``: weight of slope
    i at the share s is the sum over j of dense[i][j] s^(j+1); None: the cubic Hermite polynomial of both ends.
    ``safety``, ``smallest``, ``largest``, ``beta``: of the step control (PI, Hairer and Wanner). ``stiff``: largest
    step times eigenvalue where the last two stages are at the step's end, and the same on the imaginary axis; None: the
    method does not notice stiffness.
    """

    a: tuple[tuple[float, ...], ...]
    c: tuple[float, ...]
    error: tuple[float, ...] | None = None
    dense: tuple[tuple[float, ...], ...] | None = None
    safety: float = 0.9
    smallest: float = 0.2
    largest: float = 10.0
    beta: float = 0.0
    stiff: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        for k, (row, share) in enumerate(zip(self.a, self.c, strict=True)):
            if len(row) > k or abs(sum(row) - share) > _EXACT:
                expected = f"at most {k} weights whose sum is c[{k}] = {share:g}"
                raise InputError(f"tableau.a.{k}", str(row), expected, "compare with the published tableau")
        if self.error is not None and (len(self.error) != len(self.a) or abs(sum(self.error)) > _EXACT):
            expected = f"{len(self.a)} weights whose sum is 0"
            raise InputError("tableau.error", str(self.error), expected, "higher less lower order, of each stage")

    @property
    def stages(self) -> int:
        """How many slopes there are, that at the step's end included."""
        return len(self.a)

    @property
    def own(self) -> int:
        """How many slopes make the step."""
        return len(self.a) - 1

    def amplification(self, z: NDArray[np.complex128]) -> NDArray[np.complex128]:
        """By which factor a step multiplies the solution of y' = lambda y, z = step lambda."""
        slopes: list[NDArray[np.complex128]] = []
        for row in self.a:
            slopes.append(z * (1 + sum((w * slope for w, slope in zip(row, slopes, strict=False)), np.zeros_like(z))))
        return slopes[-1] / z


@dataclass(frozen=True, eq=False, kw_only=True)
class Integrator:
    """One method.

    ``description``: in a line, for help. ``order``: of its steps. ``adaptive``: it chooses its steps by the tolerances,
    else it takes the step of the settings. ``asks``: what of the equations. ``tableau``: of an explicit Runge-Kutta
    method, for which the native loops are general; a method without one has a loop of its own in
    :mod:`tmodes.compile.loops`. ``reach``: the largest step times eigenvalue at which an explicit method is stable,
    about; None without such a limit. ``looks``: points of a step at which stop conditions are checked. ``replayed``:
    its steps can be repeated and differentiated. ``tolerances``: defaults of its own, by the names of the settings.
    ``least_tolerance``: a relative tolerance below this is lost in rounding.
    """

    name: str
    description: str
    order: int
    adaptive: bool = True
    asks: str = EXPLICIT
    tableau: Tableau | None = None
    reach: float | None = None
    looks: int = 4
    replayed: bool = False
    tolerances: Mapping[str, float] = field(default_factory=dict)
    least_tolerance: float = 1e-14

    @property
    def is_explicit(self) -> bool:
        """Whether its steps need nothing but rates."""
        return self.asks == EXPLICIT

    @property
    def key(self) -> str:
        """Its name in the cache of compiled code, which differs from one tableau to another."""
        return self.name if self.tableau is None else f"{self.name} {self.tableau}"


def explicit(
    name: str,
    description: str,
    order: int,
    a: tuple[tuple[float, ...], ...],
    b: tuple[float, ...],
    lower: tuple[float, ...] | None = None,
    **more: float,
) -> Integrator:
    """An integrator from a tableau as it is published: ``a`` (lower triangle), ``b``, and ``lower``.

    ``lower``: the weights of the embedded method of lower order, of the stages and, where it needs it, of the slope at
    the step's end; None: a fixed step. ``more``: safety, smallest, largest, beta of the step control.

    Raises :class:`tmodes.errors.InputError` for weights whose sums are wrong.
    """
    if abs(sum(b) - 1) > _EXACT:
        raise InputError("tableau.b", str(b), "weights whose sum is 1", "compare with the published tableau")
    rows, error = (*(tuple(row) for row in a), tuple(b)), None
    if lower is not None:
        whole = np.zeros((2, len(rows)))
        whole[0, : len(b)], whole[1, : len(lower)] = b, lower
        error = tuple(map(float, whole[0] - whole[1]))
    tableau = Tableau(rows, tuple(float(sum(row)) for row in rows), error)
    made = replace(tableau, **more) if more else tableau
    reach = _reach(made)
    return Integrator(
        name=name, description=description, order=order, adaptive=error is not None, tableau=made, reach=reach,
        replayed=True,
    )  # fmt: skip


def _reach(tableau: Tableau) -> float:
    """The largest step times eigenvalue on the negative real axis at which the method is stable."""
    z = np.array(-np.linspace(0.01, 40.0, 4000), dtype=np.complex128)
    growing = np.abs(tableau.amplification(z)) > 1 + 1e-9
    return float(-z[growing.argmax()].real) if growing.any() else 40.0
