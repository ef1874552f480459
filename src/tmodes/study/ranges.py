"""A study of ranges of numbers of one robot, as ``tmodes batch`` states it."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.io.sheet_check import sheet_data
from tmodes.sheet import Robot
from tmodes.simulation.batch.result import BatchRun
from tmodes.simulation.reductions import Reduction, of_samples
from tmodes.simulation.vary.programs import refused_cases
from tmodes.simulation.vary.simulate import prepared, run_prepared
from tmodes.simulation.vary.values import changed_sheet, changes_of, checked
from tmodes.study.mapping import Group, groups_of, target_of
from tmodes.study.read import study_of_robot
from tmodes.study.rows import Rows, joined
from tmodes.study.study import Study

__all__ = ["AT_END", "LARGEST", "computed", "drawn_study", "grid_study", "sampled"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

LARGEST, AT_END = "tip_difference_m", "tip_difference_at_end_m"
"""Distance of the tip from that of the sheet's own run [m]: its largest value, and that at the end."""

_REDUCED = {LARGEST: "max", AT_END: "end"}

_TOGETHER = 1 << 16
"""Cases that are computed at once."""

_TIPS = 4_000_000
"""Numbers of stored tips that are in memory at once."""


def drawn_study(robot: Robot, ranges: Mapping[str, tuple[float, float]], runs: int, seed: int) -> Study:
    """``runs`` cases with numbers at some paths drawn, uniform between two; the same for the same seed.

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong ranges and unknown paths.
    """
    spread = {path: {"type": "uniform", "low": low, "high": high} for path, (low, high) in ranges.items()}
    return _study(robot, spread, {"type": "monte_carlo", "runs": runs, "seed": seed})


def grid_study(robot: Robot, values: Mapping[str, Array]) -> Study:
    """All combinations of the numbers (m,) at some paths, the last path fastest; raises as :func:`drawn_study`."""
    points = dict(zip(_names(values), (numbers.tolist() for numbers in values.values()), strict=True))
    return _study(
        robot, {path: _between(numbers) for path, numbers in values.items()}, {"type": "grid", "points": points}
    )


def _between(numbers: Array) -> dict[str, Any]:
    low, high = float(numbers.min()), float(numbers.max())
    return {"type": "uniform", "low": low, "high": high} if low < high else {"type": "discrete", "values": [low]}


def _study(robot: Robot, spread: Mapping[str, dict[str, Any]], plan: dict[str, Any]) -> Study:
    checked({path: [0.0] for path in spread})
    data = sheet_data(robot)
    for path in spread:
        target_of(path, data, relative=False)
    quantities = {name: {"series": "tip_difference", "reduce": how} for name, how in _REDUCED.items()}
    parameters = {
        name: {"path": path, "distribution": distribution}
        for name, (path, distribution) in zip(_names(spread), spread.items(), strict=True)
    }
    head = {"format": 1, "kind": "study", "name": "batch", "parameters": parameters, "plan": plan}
    return study_of_robot(robot, {**head, "quantities": quantities})


def _names(paths: Iterable[str]) -> list[str]:
    """Names of parameters, as a study may have them, for their paths."""
    names: list[str] = []
    for k, path in enumerate(paths):
        name = re.sub(r"[^A-Za-z0-9]+", "_", path).strip("_")[:50]
        fits = name[:1].isalpha() and name not in names
        names.append(name if fits else f"p{k}_{name}")
    return names


def computed(study: Study, threads: int | None, progress: Progress) -> Rows:
    """The rows of all cases; what the sheet refuses raises before any runs.

    Raises :class:`tmodes.errors.InputErrors` for the first of the cases that the sheet refuses.
    """
    values = study.design().values
    _refuse_wrong(_group(study, values))
    parts: list[Rows] = []
    for first in range(0, len(values), _TOGETHER):
        some = values[first : first + _TOGETHER]

        def tell(stage: str, share: float, first: int = first, size: int = len(some)) -> None:
            progress(stage, (first + share * size) / len(values))

        parts.append(study.evaluate(first, some, tell, threads=threads))
        if "interrupted" in parts[-1].status:
            break
    return joined(parts)


def sampled(study: Study, out: str | os.PathLike[str], threads: int | None, progress: Progress) -> Rows:
    """The same rows, by runs whose samples are all kept in the folder ``out``, a batch.

    Raises KeyboardInterrupt where the sheet's own run was interrupted; else as :func:`computed`, and for a folder that
    cannot be taken :class:`tmodes.errors.ResultFileError`.
    """
    values = study.design().values
    group = _group(study, values)
    _refuse_wrong(group)
    assert group.robot is not None  # noqa: S101
    given = {one.path or name: values[:, k].copy() for k, (name, one) in enumerate(study.sheet.parameters.items())}
    cases = prepared(group.robot, given, out=out, progress=progress, threads=threads)
    own = run_prepared(prepared(group.robot, None), tips=True, threads=1, progress=progress)
    if "interrupted" in own.status:
        raise KeyboardInterrupt
    batch = run_prepared(cases, tips=True, threads=threads, progress=progress)
    parameters = {name: values[:, k].copy() for k, name in enumerate(study.names)}
    why = ["" if status == "finished" else text for status, text in zip(batch.status, batch.message, strict=True)]
    size = len(values)
    return Rows(
        np.arange(size), parameters, _distances(batch, own), dict.fromkeys(_REDUCED, "m"), batch.status, why,
        [""] * size, np.zeros(size),
    )  # fmt: skip


def _distances(batch: BatchRun, own: BatchRun) -> dict[str, Array]:
    """The quantities (k,) [m] of a batch with tips, not-a-number where a case did not finish."""
    assert batch.tips is not None  # noqa: S101
    assert own.tips is not None  # noqa: S101
    found = {name: np.full(batch.size, np.nan) for name in _REDUCED}
    each = max(1, _TIPS // own.tips.size)
    for first in range(0, batch.size, each):
        part = slice(first, first + each)
        far = np.linalg.norm(batch.tips[part] - own.tips[0], axis=2)
        for name, how in _REDUCED.items():
            numbers = of_samples(Reduction("tip_difference", how), far, batch.times)
            found[name][part] = np.where(batch.finished[part], numbers, np.nan)
    return found


def _group(study: Study, values: Array) -> Group:
    """All cases as those of one robot, which they are: no setting of the integration differs."""
    assert study.robot is not None  # noqa: S101
    return next(groups_of(study.robot, study.names, study.targets, study.choices, values))


def _refuse_wrong(group: Group) -> None:
    """Raise for the first case that the sheet refuses."""
    assert group.robot is not None  # noqa: S101
    if wrong := refused_cases(group.robot, group.vary):
        first = min(wrong)
        changed_sheet(group.robot, changes_of(group.vary, first), first)
