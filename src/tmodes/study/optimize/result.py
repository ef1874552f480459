"""Optimum: the best design, those next to it, and how it was found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from tmodes.study.plain import plain

__all__ = ["Candidate", "Held", "Optimum"]


@dataclass(frozen=True)
class Held:
    """A limit at a design: the ``value`` of its term, the ``bound`` [``unit``], and the share that is left.

    ``margin`` < 0: exceeded by so much. ``active``: the design is on the limit.
    """

    text: str
    value: float
    bound: float
    unit: str
    margin: float

    @property
    def active(self) -> bool:
        """Whether less than a thousandth is left."""
        return abs(self.margin) <= ACTIVE


ACTIVE = 1e-3


@dataclass(frozen=True, eq=False)
class Candidate:
    """One design: ``number`` among the trials, its ``values`` by parameter, ``choices`` by name where it is chosen.

    ``quantities``: least and largest value over what is uncertain; ``objectives`` and ``limits`` at the worst.
    ``reason``: why a case of it failed.
    """

    number: int
    values: Mapping[str, float]
    choices: Mapping[str, str]
    quantities: Mapping[str, tuple[float, float]]
    objectives: tuple[float, ...]
    limits: tuple[Held, ...]
    feasible: bool
    violation: float
    reason: str = ""

    def info(self) -> dict[str, Any]:
        """As plain data."""
        shown = {name: self.choices.get(name, value) for name, value in self.values.items()}
        quantities = {name: low if low == high else [low, high] for name, (low, high) in self.quantities.items()}
        limits = [
            {"limit": one.text, "value": one.value, "bound": one.bound, "unit": one.unit, "margin": one.margin,
             "active": one.active}
            for one in self.limits
        ]  # fmt: skip
        return {
            "number": self.number, "design": shown, "values": dict(self.values), "quantities": quantities,
            "objectives": list(self.objectives), "limits": limits, "feasible": self.feasible,
            "violation": self.violation, "reason": self.reason,
        }  # fmt: skip


@dataclass(frozen=True, eq=False)
class Optimum:
    """What :func:`tmodes.study.optimize.optimize` has found.

    ``best``: the feasible design with the best (first) objective, or None; ``nearest``: where none is feasible, the
    one that exceeds its limits least. ``ranked``: feasible designs, the best one first; ``front``: of several
    objectives the designs of which none is better in all. ``exact``: every design was tried. ``designs``, ``feasible``
    and ``failed``: how many; ``cases`` that were computed for them, ``gradients``: runs with their adjoint sweep.
    ``lost_to``: how many designs exceed each limit; ``history``: number of a trial and its objective, where it was the
    best so far; ``prices``: change of the objective by each active limit's bound, where a gradient method knows it.
    """

    name: str
    method: str
    exact: bool
    objectives: tuple[str, ...]
    units: Mapping[str, str]
    best: Candidate | None
    nearest: Candidate | None
    ranked: tuple[Candidate, ...]
    front: tuple[Candidate, ...]
    designs: int
    feasible: int
    failed: int
    cases: int
    gradients: int
    lost_to: Mapping[str, int]
    history: tuple[tuple[int, float], ...]
    prices: Mapping[str, float]

    def info(self) -> dict[str, Any]:
        """All as plain data."""
        one = {key: getattr(self, key) for key in ("name", "method", "exact", "designs", "feasible", "failed", "cases")}
        more = {
            "gradients": self.gradients, "objectives": list(self.objectives), "units": dict(self.units),
            "lost_to": dict(self.lost_to), "prices": dict(self.prices), "history": [list(row) for row in self.history],
            "best": self.best and self.best.info(), "nearest": self.nearest and self.nearest.info(),
            "ranked": [one.info() for one in self.ranked], "front": [one.info() for one in self.front],
        }  # fmt: skip
        return plain(one | more)
