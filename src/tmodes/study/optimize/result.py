"""Optimum: the best design, those next to it, and how it was found; its tables and figure."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, nan
from typing import TYPE_CHECKING, Any

from tmodes.io.printed import CommandResult, Table, changed_by, written
from tmodes.io.words import count_of
from tmodes.study.answers import amount
from tmodes.study.optimize.goals import ROUNDING
from tmodes.study.plain import plain

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.study.optimize.trials import Trials

__all__ = ["Candidate", "Held", "Optimum", "chosen_values", "design_name"]


@dataclass(frozen=True)
class Held:
    """A limit at a design: the ``value`` of its ``term``, the ``bound`` [``unit``], and the share that is left.

    ``sign`` 1: the value must be below the bound, -1: above. ``margin`` < 0: exceeded by so much. ``active``: the
    design is on the limit.
    """

    text: str
    term: str
    sign: int
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


@dataclass(frozen=True, eq=False, repr=False)
class Optimum(CommandResult):
    """What :func:`tmodes.study.optimize.optimize` has found.

    ``best``: the feasible design with the best (first) objective, or None; ``nearest``: where none is feasible, the
    one that exceeds its limits least of those that finished. ``ranked``: feasible designs, the best one first;
    ``front``: of several objectives the designs of which none is better in all. ``exact``: every design was tried.
    ``designs``, ``feasible`` and ``failed``: how many; ``cases`` that were computed for them, ``gradients``: runs with
    their adjoint sweep.
    ``lost_to``: how many designs exceed each limit; ``history``: number of a trial and its objective, where it was the
    best so far; ``prices``: change of the objective by each active limit's bound, where a gradient method knows it.
    ``start``: the design of the sheet itself, the middle of a range of which the sheet has no number; ``trials``: every
    design that was tried.
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
    start: Candidate | None = None
    trials: Trials | None = None

    @property
    def sentence(self) -> str:
        """The best design in words, with its objective against the start, and its limits."""
        return _best_design(self)

    def title(self, name: str) -> str:
        """What a parameter or a quantity is called: its title, else its name."""
        sheet = self.trials.study.sheet if self.trials else None
        one = ({**sheet.parameters, **sheet.quantities} if sheet else {}).get(name)
        return (one and one.title) or name

    def info(self) -> dict[str, Any]:
        """All as plain data."""
        one = {key: getattr(self, key) for key in ("name", "method", "exact", "designs", "feasible", "failed", "cases")}
        more = {
            "gradients": self.gradients, "objectives": list(self.objectives), "units": dict(self.units),
            "lost_to": dict(self.lost_to), "prices": dict(self.prices), "history": [list(row) for row in self.history],
            "best": self.best and self.best.info(), "nearest": self.nearest and self.nearest.info(),
            "ranked": [one.info() for one in self.ranked], "front": [one.info() for one in self.front],
            "start": self.start and self.start.info(), "sentence": self.sentence,
        }  # fmt: skip
        return plain(one | more)

    @property
    def designs_shown(self) -> tuple[Candidate, ...]:
        """The Pareto front, else the feasible designs, the best one first, else the nearest one."""
        return self.front or self.ranked or ((self.nearest,) if self.nearest else ())

    @property
    def data(self) -> Dataset:
        """Along ``design``, the front or the ranked ones: what is chosen, objectives, and terms of the limits."""
        from xarray import Dataset

        shown = self.designs_shown
        names = shown[0].values if shown else ()
        series = {name: ("design", [one.values[name] for one in shown]) for name in names}
        series |= {text: ("design", [one.objectives[k] for one in shown]) for k, text in enumerate(self.objectives)}
        for k, limit in enumerate(shown[0].limits if shown else ()):
            series[limit.text] = ("design", [one.limits[k].value for one in shown])
        return Dataset(series, {"design": [one.number for one in shown]})

    def plot(self, ax: Any = None) -> list[Any]:
        """The Pareto front of the first two objectives; of one objective its best value over the trials."""
        from tmodes.plot.commands import points

        if self.front:
            across, up = ([one.objectives[k] for one in self.front] for k in (0, 1))
            return points({"": (across, up)}, self.objectives[0], self.objectives[1], title=self.name, ax=ax)
        trials, best = zip(*self.history, strict=True) if self.history else ((), ())
        return points({"": (trials, best)}, "trial", self.objectives[0], title=self.name, ax=ax, line="-")

    def tables(self) -> Iterator[str | Table]:
        """The answer in a sentence, how many were tried, the best ones, and how far the best is from its limits."""
        yield self.sentence
        how = "every design tried, so the optimum is exact" if self.exact else _METHODS[self.method]
        counts = f"{self.designs:,} designs, {self.feasible:,} feasible"
        failed = f", {self.failed:,} failed" if self.failed else ""
        cases = f", {self.cases:,} cases" if self.cases != self.designs else ""
        runs = f", {self.gradients:,} runs with gradients" if self.gradients else ""
        yield f"{self.name}: {counts}{failed}{cases}{runs} ({how})\n"
        if self.front:
            yield self._table(f"Pareto front ({len(self.front)} designs)", self.front)
        elif self.best:
            yield self._table("Best designs", self.ranked[:_MOST_SHOWN])
            yield from self._limits(self.best)

    def _table(self, title: str, designs: Sequence[Candidate]) -> Table:
        """One row for each design: what is chosen, the objectives, the quantities of the limits."""
        first = designs[0]
        objectives = [text.partition(" ")[2] for text in self.objectives]
        columns = [*first.values, *map(self._with_unit, objectives), *(one.text for one in first.limits)]
        rows = [
            [
                *(one.choices.get(name, f"{value:.6g}") for name, value in one.values.items()),
                *(f"{value:.6g}" for value in one.objectives),
                *(f"{limit.value:.5g}" for limit in one.limits),
            ]
            for one in designs
        ]
        return Table(title, columns, rows)

    def _with_unit(self, text: str) -> str:
        unit = self.units.get(text, "-")
        return text if unit == "-" else f"{text} [{unit}]"

    def _limits(self, best: Candidate) -> Iterator[str]:
        """How far the best design is from its limits, and what each limit costs."""
        for limit in best.limits:
            lost = self.lost_to[limit.text]
            state = "is active" if limit.active else f"has {_percent(limit.margin)} left"
            price, unit = self.prices.get(limit.text), "unit" if limit.unit == "-" else limit.unit
            cost = "" if price is None else f"; the objective changes by {price:.4g} for each {unit} of it"
            yield f"{limit.text} {state}{cost}; {lost:,} designs exceed it"

    @property
    def notices(self) -> list[str]:
        """Where no design is feasible, the one that is nearest to it, and why."""
        one = self.nearest
        if self.front or self.best or not one:
            return []
        shown = ", ".join(f"{name} = {one.choices.get(name, f'{value:.6g}')}" for name, value in one.values.items())
        exceeded = [
            f"  {limit.text}: {limit.value:.5g}{'' if limit.unit == '-' else f' {limit.unit}'}, exceeded by "
            f"{_percent(-limit.margin)}"
            for limit in one.limits
            if limit.margin < 0
        ]
        return [
            f"no design keeps all limits; the one that exceeds them least: {shown}",
            *exceeded,
            *([f"  a case of it failed: {one.reason}"] if one.reason else []),
            *(f"  {text} is exceeded by {lost:,} of {self.designs:,} designs" for text, lost in self.lost_to.items()),
        ]


_MOST_SHOWN = 10

_METHODS = {
    "gradient": "along gradients: a local optimum",
    "compromise": "along gradients: local optima",
    "cobyqa": "by models of what designs give: a local optimum",
    "tpe": "tree-structured Parzen estimators: a better design may exist",
    "nsga2": "NSGA-II: better designs may exist",
}


def _percent(share: float) -> str:
    return written(100 * share, "%", 3)


def design_name(one: Candidate) -> str:
    """What was chosen from lists, else the number of the design."""
    return " + ".join(one.choices.values()) or f"Design {one.number}"


def _best_design(found: Optimum) -> str:
    """The best design with its objective against the start, and its limits; or why there is none."""
    one = found.best or found.nearest
    if one is None:
        reason = next(filter(None, found.trials.reasons if found.trials else ()), "")
        return f"None of the {count_of(found.designs, 'design')} finished{reason and ': '}{reason.rstrip('.')}."
    values = chosen_values(found, one).items()
    chosen = ", ".join(value if value.startswith(name) else f"{found.title(name)} {value}" for name, value in values)
    counts = f"{found.feasible:,} of {found.designs:,} designs keep all limits" if one.limits else ""
    limits = ", ".join(_held(limit, found.title(limit.term)) for limit in one.limits)
    if found.best is None:
        return f"No design keeps all limits; nearest is {chosen}: {limits}."
    if found.front:
        aims = [text.partition(" ")[2] for text in found.objectives]
        ends = (", ".join([design_name(each), *(f"{found.title(name)} {amount(value, found.units.get(name, '-'))}"
                for name, value in zip(aims, each.objectives, strict=True))])
                for each in (found.front[0], found.front[-1]))  # fmt: skip
        lead = f"{len(found.front):,} designs are the best compromises of {' and '.join(map(found.title, aims))}"
        return f"{lead}: from {' to '.join(ends)}{counts and '; '}{counts}."
    name, value = found.objectives[0].partition(" ")[2], one.objectives[0]
    start = found.start.objectives[0] if found.start else nan
    unit = found.units.get(name, "-")
    against = f" ({changed_by(value, start)} against the start's {amount(start, unit)})" if isfinite(start) else ""
    parts = [f"Best design: {chosen}: {found.title(name)} {amount(value, unit)}{against}", limits, counts]
    return f"{'; '.join(filter(None, parts))}."


def chosen_values(found: Optimum, one: Candidate) -> Mapping[str, str]:
    """What a design chooses, in words, by parameter."""
    units = found.units
    return {name: one.choices.get(name) or amount(value, units.get(name, "-")) for name, value in one.values.items()}


def _held(limit: Held, name: str) -> str:
    bound = f"at {'most' if limit.sign > 0 else 'least'} {amount(limit.bound, limit.unit)}"
    return f"{name} {amount(limit.value, limit.unit)} ({bound}{'' if limit.margin >= -ROUNDING else ', broken'})"
