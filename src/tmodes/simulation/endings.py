"""How a run that did not reach its end is reported: status, time, coordinate, likely cause, and a fix."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.loops.time_loop import Status

__all__ = ["Lost", "chattered", "used_up"]


class Lost(NamedTuple):
    """Where a run could not go on: time and next step [s], accelerations (nq,), and their ``names``."""

    time: float
    step: float
    accelerations: NDArray[np.float64]
    names: Sequence[str]
    bound: float

    def info(self, status: Status) -> tuple[str, str]:
        """Status and sentence of a loop that ended by DIVERGED, STEP_TOO_SMALL or NOT_CONVERGED."""
        size = np.where(np.isfinite(self.accelerations), np.abs(self.accelerations), np.inf)
        k = int(np.argmax(size))
        value = f"its acceleration is {self.accelerations[k]:.3g} rad/s^2"
        kind, why, hint = self._kind(status)
        if kind != "diverged" and not size[k] < self.bound:  # what is lost makes steps small and iterations fail
            kind, hint = "diverged", "look for what drives it away, no number among the signals, or a vanishing mass"
        words = kind.replace("_", " ")
        return kind, f"{words} at t = {self.time:.6g} s in coordinate {self.names[k]}: {value}{why}; {hint}".rstrip(
            "; "
        )

    def _kind(self, status: Status) -> tuple[str, str, str]:
        """Status, cause and fix by the loop's own word."""
        if status is Status.NOT_CONVERGED:
            hint = "shorten integration.step, or loosen integration.relative_tolerance"
            return "not_converged", f" and the iterations of a step of {self.step:.3g} s do not converge", hint
        if status is Status.STEP_TOO_SMALL:
            hint = "raise integration.relative_tolerance where rounding alone is larger"
            return "step_too_small", f" and no step is small enough (last {self.step:.3g} s)", hint
        return "diverged", f"; its next step leaves {self.bound:g} rad or rad/s", ""


def chattered(time: float, most: int, within: float) -> tuple[str, str]:
    """Of a contact that changes ``most`` times ``within`` a time [s]: a bounce whose period shrinks to nothing."""
    return "chattering", (
        f"stopped at t = {time:.6g} s: the contact set in or ended more than {most} times within {within:g} s, as a "
        "bounce does whose period shrinks to nothing; give the surface damping, or a lower stiffness"
    )


def used_up(time: float, duration: float, name: str, value: str) -> str:
    """Why a run stopped whose steps or seconds of computing are used up."""
    hint = "raise it, shorten integration.duration, loosen the tolerance, or look for what makes the motion stiff"
    return f"stopped at t = {time:.6g} s of {duration:g} s: integration.{name} = {value} is used up; {hint}"
