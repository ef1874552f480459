"""Study: a checked study sheet with its robot; its cases, and what is asked of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.sheet.robot import Robot
from tmodes.study.plans import Design
from tmodes.study.rows import Rows
from tmodes.study.sheet import StudySheet

__all__ = ["Study"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]


@dataclass(frozen=True, eq=False)
class Study:
    """What :func:`tmodes.study.read.read_study` gives. ``robot`` None: quantities are expressions of parameters alone.

    ``data``: the sheet as plain data, all files that it names read into it (catalogues, samples), so that another
    machine needs no file: ``Study.from_data(data)`` gives the same study. ``functions``: quantities of one's own by
    name, Python functions of a :class:`tmodes.Result`.
    """

    sheet: StudySheet
    robot: Robot | None
    data: Mapping[str, Any]
    folder: Path | None = None
    functions: Mapping[str, Callable[[Any], float]] = field(default_factory=dict)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters."""
        return tuple(self.sheet.parameters)

    def design(self) -> Design:
        """All cases, by the plan of the sheet."""
        raise NotImplementedError

    def evaluate(self, first: int, values: Array, progress: Progress = lambda stage, share: None) -> Rows:
        """Compute the cases ``values`` (m, d), of which the first has the number ``first``.

        A case that fails is a row with its reason; nothing is raised but for what is wrong with the study itself.
        """
        raise NotImplementedError

    @property
    def identity(self) -> str:
        """Digest of all that the rows of a case depend on besides its values: robot, paths, quantities, engine."""
        raise NotImplementedError
