"""The native time loops of the 2010 robot by the name of their method, each compiled when it is first asked for."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from tmodes.compile.lanes import lane_kernels
from tmodes.compile.loops import loops
from tmodes.equations.lagrange.layout import COORDINATES
from tmodes.integrate.method import EULER, IMPLICIT, JACOBIAN
from tmodes.paper.mechanism import Mechanism
from tmodes.paper.model_schedules import implicit_schedule, rate_schedule

__all__ = ["PaperLoops", "rate_of"]

_PAIRS = len(COORDINATES)


def rate_of(mechanism: Mechanism) -> Any:
    """The rate of the state as a CasADi function of (time, state, row, parameters)."""
    from tmodes.equations.lagrange.closed_loop import closed_loop, rate_function

    return rate_function(closed_loop(mechanism))


@dataclass(frozen=True)
class PaperLoops:
    """The loops of one structure: explicit ones around its rate as it stands, others around its schedules."""

    mechanism: Mechanism

    def __getitem__(self, method: str) -> Any:
        """The function of a method of :class:`tmodes.integrate.settings.Method`; KeyError for a name that is none."""
        guarded = 2 * _PAIRS
        if method in loops.loop_methods(IMPLICIT, EULER):
            schedule = implicit_schedule(self.mechanism)
            return loops.implicit_loops("implicit loops", schedule, guarded, _PAIRS)[method]
        if method in loops.loop_methods(JACOBIAN):
            schedule = rate_schedule(self.mechanism)
            return loops.rosenbrock_loop("rosenbrock", schedule, guarded, _PAIRS, guarded)[method]
        return self._explicit[method]

    @cached_property
    def _explicit(self) -> Any:
        return loops.time_loops("loops", self.mechanism.key, lambda: rate_of(self.mechanism), guarded=2 * _PAIRS)

    @cached_property
    def lanes(self) -> Any:
        """The explicit loops over robots side by side."""
        key, guarded = self.mechanism.key, 2 * _PAIRS
        return lane_kernels.time_lane_loops("lane loops", key, lambda: rate_of(self.mechanism), guarded=guarded)
