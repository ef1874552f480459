"""What is known of a tuning besides its best gains: the curve of designs against a second aim, effects of gains."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, nan
from typing import TYPE_CHECKING, Any

from tmodes.errors import SimulationError
from tmodes.io.printed import Table, written
from tmodes.io.words import count_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tmodes.study.optimize import Optimum
    from tmodes.study.optimize.result import Candidate

__all__ = ["Against", "curve_table", "effects_of", "in_all_cases", "plot_curve", "said", "weighed"]

_MOST_SHOWN = 10
"""Designs of a curve that are printed."""


@dataclass(frozen=True, eq=False)
class Against:
    """What is weighed against the error: ``what`` [``unit``], ``before`` and ``after`` in each case (cases,)."""

    what: str
    unit: str
    before: NDArray[np.float64]
    after: NDArray[np.float64]


def weighed(found: Optimum) -> Candidate:
    """Of a curve the design of the least error that is no worse in what it is weighed against than the sheet's own."""
    one, start = found.best or found.nearest, found.start
    if one is None:
        raise SimulationError(found.sentence)
    own = start.objectives[-1] if start else nan
    kept = [design for design in found.front if design.objectives[-1] <= own]
    return min(kept, key=lambda design: design.objectives[0]) if kept else one


def plot_curve(found: Any, other: Against, ax: Any) -> list[Any]:
    """The curve, with where it was before, and the gains that are taken."""
    from tmodes.plot.commands import points
    from tmodes.plot.units import readable

    curve = found.curve
    marks = {"none better in both": (curve["against"].values, curve["error"].values),
             "before": (other.before.max(keepdims=True), found.before.max(keepdims=True)),
             "these gains": (other.after.max(keepdims=True), found.after.max(keepdims=True))}  # fmt: skip
    units = [readable(unit, [one[k].max() for one in marks.values()])
             for k, unit in enumerate((other.unit, found.unit))]  # fmt: skip
    across, up = (f"{what} [{unit.name}]" for what, unit in zip((other.what, found.what), units, strict=True))
    shown = {name: tuple(unit.of(one) for unit, one in zip(units, both, strict=True))
             for name, both in marks.items()}  # fmt: skip
    return points(shown, across, up, title=found.name, ax=ax)  # pyright: ignore[reportArgumentType]


def curve_table(found: Any, other: Against) -> Table:
    """Some designs of the curve, evenly taken."""
    curve = found.curve
    count = curve.sizes["design"]
    most = min(count, _MOST_SHOWN)
    shown = [*dict.fromkeys(k * (count - 1) // max(1, most - 1) for k in range(most))]
    rows = [[str(k), said(float(curve["error"][k]), found.unit), said(float(curve["against"][k]), other.unit),
             *(f"{gain:.4g}" for gain in curve["gains"].values[k])] for k in shown]  # fmt: skip
    short = [".".join(one.path.split(".")[-3::2]) for one in found.gains]
    part = f", {len(shown)} of them" if len(shown) < count else ""
    return Table(f"Trade-off: {count_of(count, 'design')} of which none is better in both{part}",
                 ["design", found.what, other.what, *short], rows)  # fmt: skip


def said(value: float, unit: str) -> str:
    """A value with its unit, for a terminal."""
    return written(value, unit, 4).replace("\u00a0", " ")


def in_all_cases(found: Optimum, best: Candidate) -> dict[str, NDArray[np.float64]]:
    """Quantities (designs, cases) by name: gains of the sheet, the best ones, these with each alone at its ends."""
    import numpy as np

    trials = found.trials
    assert trials  # noqa: S101
    space, own = trials.space, np.array([*best.values.values()])
    designs = [trials.study.space.nominal[list(space.columns)], own]
    for k in range(len(own)):
        designs += [np.where(np.arange(len(own)) == k, end, own) for end in (space.low, space.high)]
    quantities = trials.study.evaluate(0, trials.cases_of(np.array(designs))).quantities
    return {name: one.reshape(len(designs), -1) for name, one in quantities.items()}


def effects_of(quantities: Sequence[NDArray[np.float64]]) -> list[float | None]:
    """The largest change of quantities of :func:`in_all_cases`, as a share of the worst case, by each gain alone."""
    import numpy as np

    worst = np.array([one.max(axis=1) for one in quantities])
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.abs(worst[:, 2:] / worst[:, 1:2] - 1.0).max(axis=0).reshape(-1, 2).max(axis=1)
    return [share if isfinite(share) else None for share in shares.tolist()]
