"""StudySheet: what a person writes of a study; its parameters, plan, quantities, limits and what is kept."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import DataSheet, Issue
from tmodes.study.distributions import Distribution
from tmodes.study.plans import Plan
from tmodes.study.quantities import Quantity

__all__ = ["STUDY_FORMAT", "Choice", "Correlation", "Keep", "Objective", "Optimize", "Parameter", "StudySheet"]

STUDY_FORMAT = 1
MOST_PARAMETERS, MOST_QUANTITIES, MOST_CHOICES = 200, 200, 10_000

Plain = float | int | str | bool
"""What may stand at one path of a robot's sheet."""


class Choice(DataSheet):
    """One entry of a catalogue: its name, and what it sets in the robot's sheet."""

    name: str = Field(min_length=1, max_length=100, description="name in tables and figures")
    set: dict[str, Plain] = Field(description="values by path of the robot's sheet")


class Parameter(DataSheet):
    """What varies: the number at ``path``, or an entry of a list of ``choices`` or of a ``catalogue``.

    A parameter without a path is seen by expressions and functions alone. ``relative``: its values are factors on the
    sheet's own number.
    """

    path: str | None = Field(default=None, min_length=1, max_length=500, description="path in the robot's sheet")
    relative: bool = Field(default=False, description="true: factors on the sheet's own number")
    distribution: Distribution | None = Field(default=None, description="how it varies")
    choices: tuple[Choice, ...] = Field(default=(), strict=False, max_length=MOST_CHOICES, description="what to choose")
    catalogue: str | None = Field(
        default=None, max_length=200,
        description="CSV file in the folder of the study: a column `name`, and a path of the sheet over each other",
    )  # fmt: skip
    title: str = Field(default="", max_length=200, description="what it is, for tables and figures")

    def _issues(self) -> Iterator[Issue]:
        given = [key for key in ("distribution", "choices", "catalogue") if getattr(self, key)]
        if len(given) != 1:
            got = " and ".join(given) or "nothing that varies it"
            hint = "write `distribution: {type: uniform, low: ..., high: ...}`, or `choices`, or `catalogue`"
            yield Issue("", got, "one of distribution, choices and catalogue", hint)
        if self.path and not self.distribution:
            yield Issue("path", repr(self.path), "left out: choices name their own paths", "remove `path`")


class Correlation(DataSheet):
    """Correlation of two parameters, that of their underlying normals (Gaussian copula)."""

    between: tuple[str, str] = Field(strict=False, description="names of two parameters")
    value: float = Field(gt=-1, lt=1, description="correlation of the underlying normals")


class Keep(DataSheet):
    """Which cases keep their whole motion, beside the table."""

    cases: tuple[int, ...] = Field(default=(), strict=False, max_length=10_000, description="by number, from 0")
    every: int | None = Field(default=None, ge=1, description="each so manyth case; 1: all")


class Objective(DataSheet):
    """What is to be small or large: a quantity or an expression of quantities and parameters."""

    minimize: str | None = Field(default=None, max_length=500, description="a quantity, or an expression")
    maximize: str | None = Field(default=None, max_length=500, description="a quantity, or an expression")


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
    worst_case: int = Field(default=0, ge=0, le=100_000, description="cases of what is uncertain, for each design")
    percentile: float = Field(default=100.0, gt=0, le=100, description="of these cases that counts; 100: the worst")


class StudySheet(DataSheet):
    """Many cases of one robot: what varies, by which plan, what is asked of each case, and what is kept."""

    format: Literal[1] = Field(description="version of the file format")
    kind: Literal["study"] = Field(description="a study")
    name: str = Field(min_length=1, max_length=100, description="name of the study")
    title: str = Field(default="", max_length=300, description="what it is about")
    robot: str | None = Field(default=None, max_length=500, description="published robot, or a file in this folder")
    set: dict[str, Any] = Field(default_factory=dict, description="changes of the robot for all cases, by path")
    parameters: dict[str, Parameter] = Field(min_length=1, max_length=MOST_PARAMETERS, description="what varies")
    correlations: tuple[Correlation, ...] = Field(default=(), strict=False, description="pairs that vary together")
    plan: Plan = Field(description="which cases are run")
    quantities: dict[str, Quantity] = Field(min_length=1, max_length=MOST_QUANTITIES, description="what is asked")
    keep: Keep = Field(default_factory=Keep, description="cases that keep their whole motion")
    optimize: Optimize | None = Field(default=None, description="for `tmodes optimize`")
    block: int | None = Field(default=None, ge=1, le=1_000_000, description="cases that are stored together")
