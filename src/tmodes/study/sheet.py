"""StudySheet: what a person writes of a study; its parameters, plan, quantities, limits and what is kept."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field

from tmodes.io.forms import SheetForm, register_form
from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import DataSheet, Issue, quantity
from tmodes.study.distributions import Distribution
from tmodes.study.plans import Plan
from tmodes.study.plans.contract import count
from tmodes.study.quantities import Quantity
from tmodes.study.space import study_issues

__all__ = [
    "STUDY", "STUDY_FORMAT", "Choice", "Correlation", "Keep", "Objective", "Optimize", "Parameter", "StudySheet",
]  # fmt: skip

STUDY_FORMAT = 1
MOST_PARAMETERS, MOST_QUANTITIES, MOST_CHOICES = 200, 200, 10_000

Plain = float | int | str | bool
"""What may stand at one path of a robot's sheet."""


class Choice(DataSheet):
    """One entry of a catalogue: its name, and what it changes in the robot's sheet."""

    name: str = Field(min_length=1, max_length=100, description="name in tables and figures")
    set: dict[str, Plain] = Field(description="values by path of the robot's sheet")


class Parameter(DataSheet):
    """What varies: the number at ``path``, or an entry of a list of ``choices`` or of a ``catalogue``.

    A parameter without a path is seen by expressions and functions alone. ``relative``: its values are factors on the
    number that the sheet has there, or that a choice has set.
    """

    path: str | None = Field(default=None, min_length=1, max_length=500, description="path in the robot's sheet")
    relative: bool = Field(default=False, description="true: factors on the sheet's own number")
    distribution: Distribution | None = Field(default=None, description="how it varies")
    choices: tuple[Choice, ...] = Field(default=(), strict=False, max_length=MOST_CHOICES, description="what to choose")
    catalogue: str | None = Field(
        default=None, min_length=1, max_length=200,
        description="CSV file in the folder of the study: a column `name`, and a path of the sheet over each other",
    )  # fmt: skip
    unit: str | None = Field(
        default=None, min_length=1, max_length=40,
        description="unit of its values; left out of one with a path, whose unit is that of the path",
    )  # fmt: skip
    title: str = Field(default="", max_length=200, description="what it is, for tables and figures")

    def _issues(self) -> Iterator[Issue]:
        given = [key for key in ("distribution", "choices", "catalogue") if getattr(self, key)]
        if len(given) != 1:
            got = " and ".join(given) or "nothing that varies it"
            hint = "write `distribution: {type: uniform, low: ..., high: ...}`, or `choices`, or `catalogue`"
            yield Issue("", got, "varied by one of distribution, choices and catalogue", hint)
        if self.path and given and not self.distribution:
            yield Issue("path", repr(self.path), "left out: choices name their own paths", "remove `path`")
        if self.relative and not self.path:
            yield Issue("relative", "true", "false without a `path`", "name the path of the sheet's number")
        names = [choice.name for choice in self.choices]
        if twice := next((name for name in names if names.count(name) > 1), None):
            yield Issue(
                f"choices.{names.index(twice)}.name", f"{twice!r}, given twice", "a name of its own", "change it"
            )


class Correlation(DataSheet):
    """Correlation of two parameters, that of their underlying normals (Gaussian copula)."""

    between: tuple[str, str] = Field(strict=False, description="names of two parameters")
    value: float = quantity("-", "rho", "correlation of the underlying normals", above=-1.0, at_most=1.0)

    def _issues(self) -> Iterator[Issue]:
        if self.value >= 1.0:
            yield Issue(
                "value", repr(self.value), "a number between -1 and 1", "for 1 use one parameter in both places"
            )


class Keep(DataSheet):
    """Which cases keep their whole motion, in addition to the table."""

    cases: tuple[int, ...] = list_of_numbers("-", "k", "numbers of cases, from 0", default=())
    every: int | None = count("n", "each so manyth case; 1: all", default=None)

    def _issues(self) -> Iterator[Issue]:
        if wrong := [case for case in self.cases if case < 0]:
            yield Issue("cases", f"the number {wrong[0]}", "numbers from 0 on", "the first case is 0")


class Objective(DataSheet):
    """What is to be small or large: a quantity or an expression of quantities and parameters."""

    minimize: str | None = Field(default=None, min_length=1, max_length=500, description="a quantity, or an expression")
    maximize: str | None = Field(default=None, min_length=1, max_length=500, description="a quantity, or an expression")

    def _issues(self) -> Iterator[Issue]:
        if bool(self.minimize) == bool(self.maximize):
            got = "both" if self.minimize else "neither"
            yield Issue("", got, "one of minimize and maximize", "write `{minimize: mass}`")


class Optimize(DataSheet):
    """Which parameters are chosen, for what, within which limits, and what is not known when they are.

    Parameters that are not chosen by the ``design`` stay uncertain: with ``worst_case`` each design is judged by the
    worst of its cases, or by a ``percentile`` of them.
    """

    objectives: tuple[Objective, ...] = Field(strict=False, min_length=1, max_length=5, description="one, or several")
    limits: tuple[str, ...] = Field(
        default=(), strict=False, max_length=50, description="conditions such as `sag <= 1.5 mm`"
    )
    design: tuple[str, ...] = Field(default=(), strict=False, description="names of what is chosen; else all")
    worst_case: int = count("n", "cases of what is uncertain, for each design", 100_000, least=0, default=0)
    percentile: float = quantity(
        "-", "p", "of these cases that counts; 100: the worst", above=0.0, at_most=100.0, default=100.0
    )


class StudySheet(DataSheet):
    """Many cases of one robot: what varies, by which plan, what is asked of each case, and what is kept."""

    format: Literal[1] = Field(description="version of the file format")
    kind: Literal["study"] = Field(description="a study")
    name: str = Field(min_length=1, max_length=100, description="name of the study")
    title: str = Field(default="", max_length=300, description="what it is about")
    robot: str | None = Field(
        default=None, min_length=1, max_length=500, description="published robot, or a file in this folder"
    )
    set: dict[str, Any] = Field(default_factory=dict, description="changes of the robot for all cases, by path")
    parameters: dict[str, Parameter] = Field(max_length=MOST_PARAMETERS, description="what varies")
    correlations: tuple[Correlation, ...] = Field(
        default=(), strict=False, max_length=MOST_PARAMETERS**2, description="pairs that vary together"
    )
    plan: Plan = Field(description="which cases are run; in a file it may be left out")
    quantities: dict[str, Quantity] = Field(max_length=MOST_QUANTITIES, description="what is asked")
    keep: Keep = Field(default_factory=Keep, description="cases that keep their whole motion")
    optimize: Optimize | None = Field(default=None, description="for `tmodes optimize`")
    block: int | None = count("n", "cases that are stored together", 1_000_000, default=None)

    def _issues(self) -> Iterator[Issue]:
        yield from study_issues(self)


STUDY = register_form(SheetForm("study", StudySheet, STUDY_FORMAT, ()))
"""The form of a study's file, for the readers of sheets."""
