"""How far the numbers of a study go: the least and the largest value of each path, of all cases that can run."""

from __future__ import annotations

import numpy as np

from tmodes.errors import InputError, InputErrors
from tmodes.simulation.vary.refused import refused_cases
from tmodes.study.mapping import Group

__all__ = ["spans_of"]


def spans_of(group: Group) -> dict[str, tuple[float, float]]:
    """The ends of each path of a group's cases that the sheet takes; nothing where none varies, or some are special.

    What is not finite, or zero, is prepared case by case: it may change the structure.
    """
    if group.robot is None or not group.vary:
        return {}
    whole = np.array([*group.vary.values()])
    usual = np.isfinite(whole).all(axis=0) & (whole != 0).all(axis=0)
    try:
        lost = refused_cases(group.robot, {path: values[usual] for path, values in group.vary.items()})
    except (InputError, InputErrors):
        return {}
    good = np.delete(whole[:, usual], list(lost), axis=1)
    if not good.shape[1]:
        return {}
    ends = zip(good.min(axis=1).tolist(), good.max(axis=1).tolist(), strict=True)
    return dict(zip(group.vary, ends, strict=True))
