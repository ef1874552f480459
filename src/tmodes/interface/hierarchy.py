"""The model hierarchy of a robot's links: what ``tmodes hierarchy`` computes and prints."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.sheet import Robot
    from tmodes.simulation.hierarchy.hierarchy import Ladder, Rung

__all__ = ["Hierarchy", "hierarchy"]

UNITS = {
    "frequencies_Hz": "Hz, motors locked, about rest",
    "sag_m": "m, tip at rest off the undeformed robot's",
    "cost_us": "us, one forward dynamics, native, median",
    "highest_eigenvalue": "1/s, an explicit step must be below about 2.8 over it",
    "tip_difference_m": "m, largest in the motion, to the finest rung",
    "tip_error": "1, of the largest deflection of the tip in the motion",
    "frequency_error": "1, of the first frequency",
    "deflection_m": "m, largest deflection of the tip in the motion, by the finest rung",
}


@checked_arguments
def hierarchy(
    robot: Robot,
    *,
    tolerance: float = 1e-3,
    finest: int = 6,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Hierarchy:
    """Every link model (rigid, segments, modes, strain with more and more functions) in the motion of the sheet.

    Each is compared with the finest one, which has ``finest`` functions of each direction of bending (1 to 12): how far
    its tip is off, its first frequency, what it costs. The cheapest within ``tolerance``, a share of the largest
    deflection of the tip, is recommended. A robot that nothing in its sheet moves makes a short move of all joints.

    Raises :class:`tmodes.errors.InputError` for a robot without beams or a tolerance that is none, and
    :class:`tmodes.errors.SimulationError` where the finest model has no rest or does not reach the end of its motion.

    >>> tmodes.load("spong1987").hierarchy()
    Traceback (most recent call last):
    tmodes.errors.InputError: ...
    """
    from tmodes.simulation.hierarchy.hierarchy import ladder

    return Hierarchy(ladder(robot.commanded(progress), tolerance, finest=finest, progress=progress))


@dataclass(frozen=True, eq=False, repr=False)
class Hierarchy(CommandResult):
    """All models from rigid to finest; ``found``: their numbers, and which is recommended."""

    found: Ladder

    @property
    def recommended(self) -> str:
        """The cheapest model within the tolerance."""
        return self.found.recommended

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes hierarchy --json`` prints it."""
        return {"units": UNITS, **self.found.as_data()}

    @property
    def data(self) -> Dataset:
        """Along ``model``: coordinates, ``tip_difference`` and ``sag`` [m], errors of tip and frequency, cost."""
        from xarray import Dataset

        units = {"coordinates": "1", "tip_difference_m": "m", "tip_error": "1", "frequency_error": "1", "sag_m": "m",
                 "cost_us": "us", "highest_eigenvalue": "1/s"}  # fmt: skip
        return Dataset(
            {name.removesuffix("_m").removesuffix("_us"): ("model", self._numbers(name), {"units": unit})
             for name, unit in units.items()},
            {"model": [rung.model for rung in self.found.rungs]},
        )  # fmt: skip

    def _numbers(self, name: str) -> list[float]:
        return [math.nan if (value := getattr(rung, name)) is None else value for rung in self.found.rungs]

    def plot(self, ax: Any = None) -> list[Any]:
        """Errors of the tip and of the first frequency over the number of coordinates."""
        from tmodes.plot.commands import points

        across = self._numbers("coordinates")
        shown = {name.replace("_", " "): (across, self._numbers(name)) for name in ("tip_error", "frequency_error")}
        return points(shown, "coordinates", "error", title=self.found.robot, ax=ax, log=True)

    @property
    def notices(self) -> list[str]:
        """What else is to be said of the models."""
        found, info = self.found, []
        if not found.converged:
            off = f"{found.rungs[-2].model} is not within the tolerance of {found.rungs[-1].model}"
            info.append(f"{off}: that itself may be off by more; add --finest {len(found.rungs) - 1}")
        if all(rung.tip_error is None for rung in found.rungs):
            info.append("the tip does not deflect in this motion, so only frequencies are compared: is `tip` on the "
                        "right link?")  # fmt: skip
        return [*info, *(f"{rung.model}: {rung.why}" for rung in found.rungs if rung.why)]

    def tables(self) -> Iterator[str | Table]:
        """One row for each model, and which is recommended."""
        found = self.found
        columns = ["model", "coordinates", "first mode [Hz]", "sag [mm]", "tip error [mm]", "of deflection",
                   "frequency error", "evaluation [us]", "fastest [1/s]", ""]  # fmt: skip
        title = f"{found.robot}: {found.move}; the tip deflects by up to {found.deflection_m * 1e3:.4g} mm"
        yield Table(title, columns, [_rung_row(rung, found) for rung in found.rungs])
        within = f"within {_share(found.tolerance)} of {found.rungs[-1].model}"
        yield f"Recommended: {found.recommended}, the cheapest {within}."


def _rung_row(rung: Rung, found: Ladder) -> list[str]:
    last = rung is found.rungs[-1]
    off = "-" if rung.tip_difference_m is None or last else f"{rung.tip_difference_m * 1e3:.4g}"
    return [
        rung.model,
        str(rung.coordinates),
        f"{rung.frequencies_Hz[0]:.4f}" if rung.frequencies_Hz else "-",
        f"{rung.sag_m * 1e3:.4f}",
        off,
        "-" if last else _share(rung.tip_error),
        "-" if last else _share(rung.frequency_error),
        f"{rung.cost_us:.2f}",
        "-" if rung.highest_eigenvalue is None else f"{rung.highest_eigenvalue:.3g}",
        "<- recommended" if rung.model == found.recommended else "",
    ]


def _share(error: float | None) -> str:
    return "-" if error is None else f"{100 * error:.2g} %" if error < 1 else f"{100 * error:.0f} %"
