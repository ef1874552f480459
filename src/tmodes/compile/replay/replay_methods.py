"""The methods whose steps can be taken once more and differentiated, as tables, with their native loops."""

from __future__ import annotations

from functools import cache

from tmodes.compile.loops.extrapolated import Extrapolated
from tmodes.compile.loops.runge_kutta import RungeKutta, dop853_table, replayed
from tmodes.compile.native import Library
from tmodes.compile.replay.replay_extrapolated import extrapolated_loops
from tmodes.compile.replay.replay_loop import replay_loops
from tmodes.integrate.method import Integrator
from tmodes.integrate.registry import integrator, integrators

__all__ = ["Table", "loops_of", "replay_methods", "table_of"]

Table = RungeKutta | Extrapolated


def replay_methods() -> list[str]:
    """The names of the methods that have a table."""
    return [name for name, one in integrators().items() if one.replayed]


@cache
def table_of(one: Integrator) -> Table:
    """The table of a method; KeyError for one without."""
    if one.tableau is not None:
        return replayed(one.tableau)
    return {"dop853": dop853_table, "extrapolation": Extrapolated}[one.name]()


def loops_of(method: str) -> Library:
    """The native loops ``again``, ``along`` and ``back`` over recorded steps of a method."""
    return replay_loops() if integrator(method).is_explicit else extrapolated_loops()
