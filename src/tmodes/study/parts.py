"""Rows of a part of a study from the blocks that hold its quantities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmodes.study.rows import GOOD, Rows

if TYPE_CHECKING:
    from tmodes.study.cover import Part
    from tmodes.study.store import Folder

__all__ = ["merged", "rows_of"]


def rows_of(folder: Folder, part: Part) -> Rows:
    """The rows of a part, with the quantities of the study in its order. A block that has vanished is an error."""
    return merged([folder.block(label).rows for label in part.labels], list(folder.keys))


def merged(parts: list[Rows], quantities: list[str]) -> Rows:
    """One set of rows of the same cases, whose quantities were computed apart.

    A case is as bad as in the worst of them: of the first that is not finished its status and reason are taken;
    seconds are added.
    """
    first = parts[0]
    columns = {name: values for rows in reversed(parts) for name, values in rows.quantities.items()}
    units = {name: unit for rows in reversed(parts) for name, unit in rows.units.items()}
    worst = [
        next((k for k, s in enumerate(each) if s not in GOOD), 0)
        for each in zip(*(p.status for p in parts), strict=True)
    ]
    status, reason = ([getattr(parts[k], of)[row] for row, k in enumerate(worst)] for of in ("status", "reason"))
    method = [next((word for word in words if word), "") for words in zip(*(p.method for p in parts), strict=True)]
    return Rows(
        first.case, first.parameters, {name: columns[name] for name in quantities if name in columns}, units,
        status, reason, method, seconds=np.sum([rows.seconds for rows in parts], axis=0),
        kept={case: motion for rows in parts for case, motion in rows.kept.items()},
        errors=np.fmax.reduce([rows.errors for rows in parts]),
    )  # fmt: skip
