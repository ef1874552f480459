"""Study: a checked study sheet with its robot; its cases, and what is asked of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, reduce
from operator import or_
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.io.arguments import checked_arguments, numbers_of, whole_number
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_problems import Problem
from tmodes.io.words import shown
from tmodes.sheet import Robot
from tmodes.simulation.batch.executor import PROCESSOR, Executor
from tmodes.simulation.vary.values import Whole
from tmodes.study.identity import base_digest, quantity_digests, whole_digest
from tmodes.study.mapping import Target, target_of
from tmodes.study.plans import Design
from tmodes.study.plans.contract import MOST_CASES
from tmodes.study.quantities import Needs
from tmodes.study.quantities.function import Identity, function_identities
from tmodes.study.rows import Rows
from tmodes.study.sheet import StudySheet
from tmodes.study.space import Dimension, ParameterSpace, correlation_matrix

__all__ = ["Study", "study_problems", "unknown_names"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

MOST_NUMBERS = 200_000_000
"""Cases times parameters and quantities of one study: 1.6 GB."""


@dataclass(frozen=True, eq=False)
class Study:
    """What :func:`tmodes.study.read.read_study` gives. ``robot`` None: quantities are expressions of parameters alone.

    ``data``: the sheet as plain data, all files that it names read into it (robot, catalogues, samples), so that
    another machine needs no file: ``Study.from_data(data)`` gives the same study. ``functions``: quantities of one's
    own by name, Python functions of a :class:`tmodes.Result`.

    >>> study = tmodes.read_study("study.yaml")
    >>> study.names, study.cases
    (('k',), 4)
    """

    sheet: StudySheet
    robot: Robot | None
    data: Mapping[str, Any]
    folder: Path | None = None
    functions: Mapping[str, Callable[[Any], float]] = field(default_factory=dict)
    places: Mapping[str, str] = field(default_factory=dict)
    """File and line of each quantity, by its name, for messages; empty without a file."""
    identified: Mapping[str, Identity] | None = None
    """What the functions are known by while the study runs; None: by what they are when it is asked."""

    @classmethod
    def from_data(cls, data: Mapping[str, Any], functions: Mapping[str, Callable[[Any], float]] | None = None) -> Study:
        """The study of :attr:`data`; raises :class:`tmodes.errors.InputErrors` for what is none.

        >>> study = tmodes.read_study("study.yaml")
        >>> tmodes.Study.from_data(study.data).names
        ('k',)
        """
        from tmodes import study_from_data

        return study_from_data(data, functions=functions)

    def __reduce__(self) -> tuple[Any, ...]:
        """What was pickled is read again as data, and checked."""
        return type(self).from_data, (dict(self.data), dict(self.functions))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters."""
        return tuple(self.sheet.parameters)

    @cached_property
    def targets(self) -> dict[str, Target]:
        """What each parameter with a path acts on."""
        data = None if self.robot is None else sheet_data(self.robot)
        return {
            name: target_of(one.path, data, relative=one.relative)
            for name, one in self.sheet.parameters.items()
            if one.path and data is not None
        }

    @cached_property
    def choices(self) -> dict[str, list[dict[str, Any]]]:
        """What each entry of a choice sets, by the name of the parameter."""
        parameters = self.sheet.parameters.items()
        return {name: [entry.set for entry in one.choices] for name, one in parameters if one.choices}

    @checked_arguments
    def choice_names(self, name: str) -> tuple[str, ...]:
        """Names of the entries of a choice, by their numbers; none of another parameter.

        >>> tmodes.read_study("study.yaml").choice_names("k")  # a number that is no choice
        ()
        """
        if name not in self.names:
            raise InputError("parameter", shown(name), f"one of {', '.join(self.names)}", "check the spelling")
        return tuple(entry.name for entry in self.sheet.parameters[name].choices)

    @property
    def parameter_units(self) -> dict[str, str]:
        """Unit of the values of each parameter, ``-`` for none."""
        return {name: one.unit or "-" for name, one in self.sheet.parameters.items()}

    @cached_property
    def space(self) -> ParameterSpace:
        """The parameters as plans see them."""
        pairs = [(*one.between, one.value) for one in self.sheet.correlations]
        return ParameterSpace(
            [self._dimension(name) for name in self.names], correlation_matrix(self.names, pairs) if pairs else None
        )

    def _dimension(self, name: str) -> Dimension:
        one, target = self.sheet.parameters[name], self.targets.get(name)
        known = target.nominal if target else None
        if one.distribution is None:
            return Dimension(name, 0.0, None, len(one.choices))
        return Dimension(name, one.distribution.middle if known is None else known, one.distribution)

    @property
    def cases(self) -> int:
        """How many cases the plan has."""
        return self.sheet.plan.cases(self.space)

    def design(self) -> Design:
        """All cases, by the plan of the sheet; the same each time.

        >>> tmodes.read_study("study.yaml").design().values.shape
        (4, 1)
        """
        return self.sheet.plan.design(self.space)

    @cached_property
    def wholes(self) -> dict[tuple[float, ...], Whole]:
        """All cases that share a robot, by the kind of their group.

        What is found once for all cases depends on the plan, and not on how its cases are cut into blocks.
        """
        from tmodes.study.mapping import groups_of

        if self.robot is None:
            return {}
        found: dict[tuple[float, ...], Whole] = {}
        for group in groups_of(self.robot, self.names, self.targets, self.choices, self.design().values):
            finite = {path: values[np.isfinite(values)] for path, values in group.vary.items()}
            if all(map(len, finite.values())):
                ends = {path: (float(own.min()), float(own.max())) for path, own in finite.items()}
                found[group.kind] = Whole(len(group.places), ends)
        return found

    @cached_property
    def needs(self) -> Needs:
        """What all quantities need of each case."""
        return reduce(or_, (one.needs() for one in self.sheet.quantities.values()), Needs())

    @checked_arguments
    def evaluate(
        self, first: int, values: Array, progress: Progress = lambda stage, share: None, *,
        threads: int | None = None, executor: Executor = PROCESSOR,
    ) -> Rows:  # fmt: skip
        """Compute the cases ``values`` (m, d), of which the first has the number ``first``.

        ``threads``: at once, None for one on each core. ``executor``: what runs cases whose series are reduced. A case
        that fails is a row with its reason. Raises :class:`tmodes.errors.InputError` for what is wrong with the study
        itself: a series, a number or a key of the summary that its robot does not have, a unit to which a quantity
        cannot be converted.

        >>> tmodes.read_study("study.yaml").evaluate(0, [[1.0], [2.0]]).quantities["y"]
        array([1., 4.])
        """
        first = whole_number("first", first, 0, 2**53)
        given = numbers_of(values, "values", ((None, len(self.names)),), "rows of Study.design().values")
        from tmodes import evaluated_study

        return evaluated_study(self, first, given, progress, threads, executor)

    @cached_property
    def base_identity(self) -> str:
        """Digest of all that the rows of a case depend on besides its values and quantities: robot, paths, engine."""
        return base_digest(self.sheet, self.robot, self.choices)

    def fixed(self) -> Self:
        """The study with its functions known as what they are now, whatever becomes of what they depend on.

        >>> tmodes.read_study("study.yaml").fixed().names
        ('k',)
        """
        if self.identified is not None:
            return self
        return replace(self, identified=function_identities(self.sheet.quantities.values(), self.functions))

    @property
    def quantity_identities(self) -> dict[str, str]:
        """Digest of each quantity, by its name: of its own definition, of its function, and of those that it needs."""
        return quantity_digests(self.sheet, self.fixed().identified or {})

    @property
    def identity(self) -> str:
        """Digest of all that the rows of a case depend on besides its values: robot, paths, quantities, engine."""
        return whole_digest(self.base_identity, self.quantity_identities)


def study_problems(study: Study, *, functions_known: bool) -> Iterator[Problem]:
    """What is wrong with a study whose parts are right: its plan, its size, quantities that need a robot."""
    from tmodes.study.quantities.function import function_issues

    sheet, plan = study.sheet, study.sheet.plan
    wrong = list(plan.issues(study.space))
    for path, got, expected, hint in wrong:
        inner = [int(step) if step.isdecimal() else step for step in path.split(".") if step]
        yield ("plan", *inner), InputError("", got, expected, hint)
    if not wrong:
        yield from _size(study)
    if study.robot is None:
        for name, one in sheet.quantities.items():
            if (needs := one.needs()) and (needs.reductions or needs.static or needs.result):
                got, hint = "a number of a robot, without one", "name the robot: `robot: NAME`"
                yield ("quantities", name), InputError("", got, "an expression of parameters", hint)
    for name, one in sheet.quantities.items() if functions_known else ():
        yield from (
            (("quantities", name, *each[:1]), InputError("", *each[1:]))
            for each in function_issues(one, study.functions)
        )


def unknown_names(study: Study) -> Iterator[Problem]:
    """Names and paths in quantities that neither the robot has nor one with an entry of a choice."""
    for name, one in study.sheet.quantities.items() if study.robot else ():
        for key, *words in one.robot_issues(_robots(study)):
            yield ("quantities", name, key), InputError("", *words)


_MOST_CHOICES = 40
"""Entries of choices whose robots are asked for names that the study's own robot has not."""


def _robots(study: Study) -> Iterator[Robot]:
    """The robot, and it with each entry of a choice, but for those that it does not take."""
    assert study.robot is not None  # noqa: S101
    yield study.robot
    entries = [entry for entries in study.choices.values() for entry in entries]
    for entry in entries[:_MOST_CHOICES]:
        with suppress(InputError, InputErrors):
            yield study.robot.with_(entry)


def _size(study: Study) -> Iterator[Problem]:
    """A plan with more cases than can be computed, before anything of it is made."""
    cases, each = study.cases, len(study.names) + len(study.sheet.quantities)
    most = min(MOST_CASES, MOST_NUMBERS // each)
    if cases > most:
        shown = f"{cases:,}" if cases < 10**12 else f"{float(cases) if cases < 10**300 else float('inf'):.3g}"
        got = f"{shown} cases of {len(study.names)} parameters"
        yield ("plan",), InputError("", got, f"at most {most:,} cases", "take fewer levels or runs, or another plan")
    beyond = [case for case in study.sheet.keep.cases if case >= cases]
    if beyond:
        got, hint = f"case {beyond[0]} of {cases}", "the first case is 0"
        yield ("keep", "cases"), InputError("", got, f"numbers from 0 to {cases - 1}", hint)
