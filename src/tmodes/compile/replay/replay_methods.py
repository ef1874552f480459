"""The methods whose steps can be taken once more and differentiated, as tables, with their native loops."""

from __future__ import annotations

from tmodes.compile.loops.extrapolated import Extrapolated
from tmodes.compile.loops.runge_kutta import EXPLICIT, RungeKutta
from tmodes.compile.native import Library
from tmodes.compile.replay.replay_extrapolated import extrapolated_loops
from tmodes.compile.replay.replay_loop import replay_loops

__all__ = ["METHODS", "Tableau", "loops_of"]

Tableau = RungeKutta | Extrapolated

METHODS: dict[str, Tableau] = {**EXPLICIT, "extrapolation": Extrapolated()}
"""By the names of :class:`tmodes.integrate.settings.Method`."""


def loops_of(method: str) -> Library:
    """The native loops ``again``, ``along`` and ``back`` over recorded steps of a method."""
    return replay_loops() if method in EXPLICIT else extrapolated_loops()
