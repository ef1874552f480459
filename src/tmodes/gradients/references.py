"""Where the tip should be at the samples of a run, with its derivatives: nominal tip, or commanded path."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import straight
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, OWN
from tmodes.errors import InputError
from tmodes.gradients.changes import Change, changes_of
from tmodes.gradients.lowering import Lowered, lowered, pieces_at, rows_of
from tmodes.gradients.quantities import Quantities
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_paths import steps_of
from tmodes.sheet import Robot
from tmodes.simulation.recording import Recording
from tmodes.simulation.replay import Replay
from tmodes.simulation.vary.tables import commanded_states, nominal_variant, setpoints

__all__ = ["TipReference", "pulled", "swept"]

Array = NDArray[np.float64]


class TipReference:
    """Of a distance of the tip (:data:`tmodes.equations.loop.outputs.DISTANCES`): ``values`` (n, 3) [m].

    ``done``: the run that is compared. Raises :class:`tmodes.errors.InputError` where there is no such reference.
    """

    def __init__(self, sheet: Robot, done: Recording, name: str, paths: Sequence[str], most_bytes: float) -> None:
        if name == OWN:
            got, hint = f"`{OWN}`", f"take `{DEVIATION}`, `{COMMANDED}`, or a Functional of `tip`"
            raise InputError("quantities", got, "a distance from another run than the sheet's own", hint)
        self.here = lowered(sheet, nominal_variant(sheet, paths, [name]))
        self.known = {} if name == DEVIATION else _known(sheet, self.here, paths)
        self.replay = self.here.recorded(most_bytes) if name == DEVIATION else None
        self.done = self.replay.recording if self.replay else self._commanded(done)
        self.tip = Quantities(self.here, self.done, ("tip",))
        self.changes = changes_of(sheet, self.here, self.replay, paths)
        self.values = self.tip.info()["tip"]

    def _commanded(self, done: Recording) -> Recording:
        """The undeformed robot with its drives at their setpoints, in the place of a run."""
        rows = rows_of(self.here.setup.planned.schedule, self.here.settings.duration)
        states = commanded_states(self.here.setup, self.known, rows[pieces_at(rows, done.times)], done.times)
        return replace(done, rows=rows, samples=states)

    def along(self) -> dict[str, Array]:
        """Slopes (n, 3) by path."""
        if self.replay:
            states: Iterable[Array] = swept(self.replay, [*self.changes.values()])
        else:
            states = [self._slopes(change) for change in self.changes.values()]
        pairs = zip(self.changes.items(), states, strict=True)
        return {path: self.tip.along(own, change.parameters, change.rows)["tip"] for (path, change), own in pairs}

    def _slopes(self, change: Change) -> Array:
        """Of the states on the commanded path; undeformed shapes are an affine function of the setpoints."""
        times, rows, piece = self.done.times, self.done.rows, pieces_at(self.done.rows, self.done.times)
        rows = np.column_stack([rows[piece, 0], change.rows[piece, 1:]])
        still = straight(self.here.setup.mechanics, np.zeros((1, self.here.setup.mechanics.nq)))
        states = commanded_states(self.here.setup, self.known, rows, times)
        states[:, self.here.model.layout.q] -= still
        return states

    def back(self, weights: Array) -> dict[str, float]:
        """Derivatives of the sum of ``weights`` (n, 3) times the values, by path."""
        if self.replay:
            return pulled(self.replay, self.tip, {"tip": weights}, self.changes)[0]
        return {path: float((weights * slope).sum()) for path, slope in self.along().items()}


def _known(sheet: Robot, here: Lowered, paths: Sequence[str]) -> dict[int, int]:
    """The signal of each coordinate that has a setpoint."""
    known, data = setpoints(here.setup), sheet_data(sheet)
    if known is None:
        got, hint = "a path that depends on how joints without a drive move", f"take `{DEVIATION}`, or another output"
        raise InputError("quantities", got, f"setpoints of all joints for derivatives of `{COMMANDED}`", hint)
    for path in paths:
        steps = steps_of(path, data)
        if steps[0] == "couplings" or steps[-1] in ("locked_at", "rest"):
            expected, hint = (
                f"a number that leaves the undeformed shape as it is, for `{COMMANDED}`",
                "take `deviation`",
            )
            raise InputError(path, "a coupling, or where a spring is relaxed", expected, hint)
    return known


def swept(replay: Replay, changes: Sequence[Change]) -> Iterable[Array]:
    """Slopes (n, size) of the samples along each change."""
    if not changes:
        return ()
    jumps: dict[int, Array] = {}
    for k, change in enumerate(changes):
        for step, jump in change.jumps.items():
            jumps.setdefault(step, np.zeros((len(changes), len(jump))))[k] = jump
    size = len(replay.parameters)
    start, parameters, rows = (
        np.stack(parts) for parts in zip(*((c.start, c.parameters[:size], c.rows) for c in changes), strict=True)
    )
    return replay.along(start, parameters, rows, jumps)


def pulled(
    replay: Replay, seen: Quantities, weights: Mapping[str, Array], changes: Mapping[str, Change]
) -> tuple[dict[str, float], dict[str, Array], Array, Array, Array]:
    """Derivatives of the sum of ``weights`` times quantities.

    By path; by what distances are from, which does not count in that; by the start, all parameters, and the rows.
    """
    measured, size = seen.back(weights), len(replay.parameters)
    carried = replay.back(measured.states, {step for change in changes.values() for step in change.jumps})
    parameters, rows = measured.parameters.copy(), carried.rows + measured.rows
    parameters[:size] += carried.parameters
    by = {}
    for path, change in changes.items():
        info = parameters @ change.parameters + carried.start @ change.start + (rows * change.rows).sum()
        by[path] = float(info + sum(carried.inner[step] @ jump for step, jump in change.jumps.items()))
    return by, measured.given, carried.start, parameters[:size], rows
