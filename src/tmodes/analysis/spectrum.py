"""Eigenvalues of linearised equations: how fast a system rings, decays or grows, where, and which step they ask for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import SimulationError
from tmodes.integrate.settings import Integration

__all__ = [
    "GROWING", "RINGS", "MotorState", "Spectrum", "StepVerdict", "growth_warnings",
    "spectrum_of", "step_size_verdict", "step_times_eigenvalue",
]  # fmt: skip

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

GROWING = 1e-7
"""Real over absolute value of an eigenvalue above which its motion grows, and is not just undamped."""

RINGS = 1e-9
"""Imaginary over absolute value of an eigenvalue above which its motion rings."""

_DOUBLE_ZERO = float(np.sqrt(np.finfo(float).eps))
"""Size over the largest eigenvalue up to which rounding parts a double eigenvalue zero, of what moves freely."""

_UNDAMPED = 1e-9
"""Real over absolute value of an eigenvalue below which it is taken as undamped."""

_MOST_WHOLE = 500
"""Size of a state up to which all its eigenvalues are found; of a larger one only the largest."""


class MotorState(StrEnum):
    """What the motors do while the robot vibrates: they stand still, turn without current, or are controlled."""

    LOCKED = "locked"
    FREE = "free"
    CONTROLLED = "controlled"


@dataclass(frozen=True)
class Spectrum:
    """Eigenvalues [1/s] of the linearised equations, and the ``dominant`` coordinate of each."""

    eigenvalues: Complex
    dominant: tuple[str, ...]

    @property
    def highest(self) -> float:
        """The largest absolute value of all [1/s]; 0 where nothing moves."""
        return float(np.abs(self.eigenvalues).max(initial=0.0))

    @property
    def ringing(self) -> Complex:
        """The eigenvalues whose motion rings, both of each pair."""
        return self.eigenvalues[np.abs(self.eigenvalues.imag) > RINGS * np.abs(self.eigenvalues)]

    @property
    def slowest_decay(self) -> float | None:
        """The smallest decay rate [1/s] of the motions that ring; None where nothing rings."""
        return min((-float(value.real) for value in self.ringing), default=None)


def spectrum_of(matrix: Array, coordinates: Sequence[str], currents: Sequence[str] = ()) -> Spectrum:
    """The spectrum of a state matrix (m, m) in coordinates, their rates, then motor currents.

    Of more than 500 states only the six largest eigenvalues are found. The dominant coordinate is the one whose rate
    (or current) is largest: a fast motion is large in the rates.
    """
    if not len(matrix) or not np.isfinite(matrix).all():
        return Spectrum(np.zeros(0, dtype=complex), ())
    if len(matrix) <= _MOST_WHOLE:
        values, shapes = np.linalg.eig(matrix)
    else:
        from scipy.sparse.linalg import eigs

        found: Any = eigs(matrix, k=6, which="LM", v0=np.ones(len(matrix)))
        values, shapes = found
    # Rounding must not make what rings without damping look as if it grew.
    rising, turning = np.real(values), np.imag(values)
    values = np.where(np.abs(rising) <= _UNDAMPED * np.abs(values), 0.0, rising) + 1j * turning
    n = len(coordinates)
    names = [*coordinates, *coordinates, *currents]
    largest = np.abs(shapes[n:]).argmax(axis=0) + n if n else np.zeros(0, dtype=int)
    return Spectrum(values.astype(complex), tuple(names[int(k)] for k in largest))


@dataclass(frozen=True)
class StepVerdict:
    """``highest`` |eigenvalue| [1/s] at the start; ``dt_omega`` = step times it; ``stable``; ``sentence``: warning."""

    highest: float
    dt_omega: float | None
    stable: bool
    sentence: str = ""


def step_size_verdict(settings: Integration, spectrum: Spectrum) -> StepVerdict:
    """Judge the step by the eigenvalues at the start.

    A fixed step by the amplification of its explicit method, |R(dt lambda)| <= 1. An adaptive method
    keeps its own step stable, but an explicit one may take too many: raises :class:`SimulationError` with the number.
    """
    eigenvalues = spectrum.eigenvalues
    highest = spectrum.highest
    coordinate = spectrum.dominant[int(np.argmax(np.abs(eigenvalues)))] if highest else "none"
    one = settings.integrator
    if one is None or one.adaptive:
        if one and one.reach:
            _refuse_too_stiff(settings, highest, coordinate, one.reach)
        return StepVerdict(highest, None, True)
    if one.tableau is None:
        return StepVerdict(highest, settings.step * highest, True)
    z = settings.step * eigenvalues[eigenvalues.real <= 0]
    growth = float(np.abs(one.tableau.amplification(z[z != 0])).max(initial=0.0))
    dt_omega = settings.step * highest
    info = f"dt*omega = {dt_omega:.3g} (step {settings.step:.3g} s, {highest:.4g} rad/s in coordinate {coordinate})"
    if growth > 1 + 1e-9:
        hint = f"set integration.step below {2.5 / highest:.2g}, or integration.method: dormand_prince"
        return StepVerdict(highest, dt_omega, False, f"{one.name} is unstable at this step: {info}; {hint}")
    if dt_omega > 1.0:
        hint = f"set integration.step near {0.3 / highest:.2g}, or integration.method: dormand_prince"
        return StepVerdict(highest, dt_omega, True, f"{one.name} is stable but inaccurate at this step: {info}; {hint}")
    return StepVerdict(highest, dt_omega, True)


def step_times_eigenvalue(verdict: StepVerdict, statistics: dict[str, Any]) -> float | None:
    """dt*omega of a run: of its fixed step, or of its mean one where the method chose; None before any step."""
    if verdict.dt_omega is not None or not statistics.get("mean_step_s"):
        return verdict.dt_omega
    return float(statistics["mean_step_s"] * verdict.highest)


def growth_warnings(spectrum: Spectrum, whose: str, causes: str) -> list[str]:
    """A robot that is unstable at its start: the fastest growth, in which coordinate, and what may cause it."""
    least = np.maximum(GROWING * np.abs(spectrum.eigenvalues), _DOUBLE_ZERO * spectrum.highest)
    growing = spectrum.eigenvalues.real > least
    if not growing.any():
        return []
    fastest = int(np.argmax(np.where(growing, spectrum.eigenvalues.real, -np.inf)))
    rate = spectrum.eigenvalues[fastest].real
    return [
        f"the {whose} is unstable at its start: a motion in coordinate {spectrum.dominant[fastest]} grows at "
        f"{rate:.3g} 1/s ({causes})"
    ]


def _refuse_too_stiff(settings: Integration, highest: float, coordinate: str, reach: float) -> None:
    """An explicit method may step no longer than its reach over the largest eigenvalue, however little happens."""
    steps = settings.duration * highest / reach
    if steps <= settings.max_steps:
        return
    raise SimulationError(
        f"the equations are too stiff for {settings.method}: an eigenvalue of {highest:.3g} 1/s in coordinate "
        f"{coordinate} takes about {steps:.1e} steps, more than integration.max_steps = "
        f"{settings.max_steps}; lower the stiffness or damping that acts there (.inf makes an element rigid), "
        "raise the friction velocity, shorten the run, or raise integration.max_steps"
    )
