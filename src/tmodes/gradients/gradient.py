"""Sensitivities of a run to its data sheet, and gradients of what is measured on it.

The steps of the run are recorded and differentiated as they are, whatever their lengths would be for other numbers: the
results are exact for these steps, and as exact as the tolerances for the motion itself. Where a contact starts or ends,
a step ends on the change; that its time moves with the numbers is not seen, which leaves nothing out where the force is
continuous there. On a unilateral surface with a damper it jumps with the speed of impact: such runs are refused.
"""

from __future__ import annotations

import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.outputs import DISTANCES
from tmodes.gradients.changes import Change, changes_of
from tmodes.gradients.lowering import Lowered, lowered
from tmodes.gradients.quantities import Functional, Quantities, measured_by
from tmodes.gradients.references import TipReference, pulled, swept
from tmodes.io.arguments import checked_arguments, numbers_of
from tmodes.io.printed import shortened
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.recording import MOST_BYTES, Recording
from tmodes.simulation.replay import Replay

__all__ = ["Cost", "Gradient", "Sensitivities", "adjoint_gradient", "forward_sensitivities"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Cost:
    """What derivatives took: seconds by what they went into, and memory.

    ``plan``: what any run needs before it; ``forward``: the run, recorded; ``sweep``: the derivatives of its steps;
    ``measure``: quantities and their derivatives; ``sheet``: derivatives of the numbers by the paths. ``steps`` of the
    run; ``checkpoints``: states that were kept of them, in ``bytes`` of memory.
    """

    method: str
    plan: float
    forward: float
    sweep: float
    measure: float
    sheet: float
    steps: int
    checkpoints: int
    bytes: int


@dataclass(frozen=True, eq=False, repr=False)
class Sensitivities:
    """``times`` (n,) [s], ``states`` (n, size), and by path their derivatives (n, size) per unit of the quantity.

    ``info``: the quantities that were asked for, (n, numbers), and ``of`` their derivatives by name and path.
    """

    times: Array
    states: Array
    by: dict[str, Array]
    info: dict[str, Array]
    of: dict[str, dict[str, Array]]
    cost: Cost

    def __repr__(self) -> str:
        size = f"{len(self.times)} samples of {self.states.shape[1]} states"
        return shortened([f"derivatives of {', '.join([size, *self.info])} by {', '.join(self.by)}"], "see .by")


@dataclass(frozen=True, eq=False, repr=False)
class Gradient:
    """Value of a functional, and its derivatives, each per unit of what it is by.

    ``by``: by path, with what a quantity does through the state at the start and the signals; ``start`` (size,): by
    the state at the start; ``parameters``: by all numbers that the compiled code reads; ``signals`` (pieces, 1 +
    coefficients): by the coefficients of the pieces of all signals, the first column (their start) as if each stood by
    itself. Where a distance of the tip is measured, what it is from counts in ``by`` alone.
    """

    value: float
    by: dict[str, float]
    start: Array
    parameters: Array
    signals: Array
    cost: Cost

    def __repr__(self) -> str:
        slopes = ", ".join(f"{path}: {slope:.6g}" for path, slope in self.by.items())
        return shortened([f"{self.value:.6g}, and its derivatives per SI unit: {slopes}"], "see .by")


@checked_arguments
def forward_sensitivities(
    sheet: Robot,
    paths: Sequence[str] = (),
    *,
    quantities: Sequence[str] = (),
    start: Mapping[str, ArrayLike] | None = None,
    most_bytes: float = MOST_BYTES,
) -> Sensitivities:
    """Derivatives of the states at all samples by numbers of the sheet: ``links.arm.length``, ``gear.stiffness``.

    ``quantities``: what else is given and differentiated, as ``tip`` (:class:`tmodes.gradients.quantities.Quantities`
    has their names). ``start``: directions (size,) of the state at the start, by names of one's own. Eight directions
    are carried along at once; of many numbers and one functional :func:`adjoint_gradient` is the quicker.
    ``most_bytes``: memory for the states of the steps; where they are more, some are kept and those between computed
    again.

    Raises :class:`tmodes.errors.InputError` for a path, a quantity or a method that cannot be differentiated
    (dormand_prince, dop853, rk4 and extrapolation can), and :class:`tmodes.errors.SimulationError` for a run that does
    not reach its end, or in which the force of a contact jumps. Sensitivity equations of the discrete steps: E. Hairer,
    S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, section II.6.

    >>> found = tmodes.forward_sensitivities(robot, ["joints.joint.gear.stiffness"], quantities=["tip"])
    >>> found.of["tip"]["joints.joint.gear.stiffness"].shape == found.info["tip"].shape
    True
    """
    refuse_other(sheet)
    sheet = sheet.commanded(vary=paths)
    watch, here, replay = _begun(sheet, most_bytes)
    done = replay.recording
    references = _references(sheet, here, done, quantities, paths, most_bytes)
    seen = Quantities(here, done, quantities, {name: one.values for name, one in references.items()})
    changes = changes_of(sheet, here, replay, paths, seen.outputs)
    none = Change(np.zeros_like(seen.parameters), np.zeros_like(here.start), np.zeros_like(done.rows), {})
    changes |= {
        name: none._replace(start=_direction(name, way, here.start.size)) for name, way in (start or {}).items()
    }
    watch.lap("sheet")
    found = dict(zip(changes, swept(replay, [*changes.values()]), strict=True))
    watch.lap("sweep")
    given, still = [one.along() for one in references.values()], np.zeros((len(done.times), 3))
    slopes = {
        path: seen.along(found[path], change.parameters, change.rows, [one.get(path, still) for one in given])
        for path, change in changes.items()
    }
    of = {name: {path: slope[name] for path, slope in slopes.items()} for name in quantities}
    info = seen.info()
    watch.lap("measure")
    return Sensitivities(done.times, done.samples, found, info, of, watch.cost(done))


@checked_arguments
def adjoint_gradient(
    sheet: Robot, functional: Functional, paths: Sequence[str] = (), *, most_bytes: float = MOST_BYTES
) -> Gradient:
    """Derivatives of one number measured on the samples of a run, by any number of quantities of the sheet.

    ``functional``: as :func:`tmodes.gradients.quantities.tracking_error` gives it, or of one's own. One sweep in
    reverse over the recorded steps gives them all, whose cost does not grow with the number of ``paths``. Memory and
    errors as of :func:`forward_sensitivities`. Adjoints of the discrete steps with checkpoints: A. Griewank, A.
    Walther, Evaluating Derivatives (2008), chapters 3 and 12.

    >>> error = tmodes.tracking_error("tip", [0, 0, -1])
    >>> tmodes.adjoint_gradient(robot, error, ["joints.joint.gear.stiffness"]).by
    {'joints.joint.gear.stiffness': ...}
    """
    refuse_other(sheet)
    sheet = sheet.commanded(vary=paths)
    watch, here, replay = _begun(sheet, most_bytes)
    done, names = replay.recording, [*dict.fromkeys(paths)]
    references = _references(sheet, here, done, functional.quantities, names, most_bytes)
    seen = Quantities(here, done, functional.quantities, {name: one.values for name, one in references.items()})
    changes = changes_of(sheet, here, replay, names, seen.outputs)
    watch.lap("sheet")
    value, weights = measured_by(functional, done.times, seen.info())
    watch.lap("measure")
    by, given, first, parameters, rows = pulled(replay, seen, weights, changes)
    for name, one in references.items() if given else ():
        by = {
            path: slope + more for (path, slope), more in zip(by.items(), one.back(given[name]).values(), strict=True)
        }
    watch.lap("sweep")
    return Gradient(value, by, first, parameters, rows, watch.cost(done))


def _references(
    sheet: Robot, here: Lowered, done: Recording, names: Sequence[str], paths: Sequence[str], most_bytes: float
) -> dict[str, TipReference]:
    """What distances of the tip are from, by their names."""
    heads = [name.partition(".")[0] for name in names if name not in here.model.outputs]
    return {name: TipReference(sheet, done, name, paths, most_bytes) for name in DISTANCES if name in heads}


def _direction(name: str, way: ArrayLike, size: int) -> Array:
    """A direction (size,) of the state at the start."""
    return numbers_of(way, f"start.{name}", ((size,),), "a number for each of the state")


def _begun(sheet: Robot, most_bytes: float) -> tuple[_Watch, Lowered, Replay]:
    """The run, with its steps."""
    watch = _Watch()
    here = lowered(sheet)
    watch.lap("plan")
    replay = here.recorded(most_bytes)
    watch.lap("forward")
    return watch, here, replay


class _Watch:
    """Seconds between laps."""

    def __init__(self) -> None:
        self.last, self.laps = clock.perf_counter(), dict[str, float]()

    def lap(self, name: str) -> None:
        """Take the time since the last lap."""
        now = clock.perf_counter()
        self.laps[name], self.last = now - self.last, now

    def cost(self, done: Recording) -> Cost:
        """All laps, and what was recorded."""
        return Cost(done.method, **self.laps, steps=len(done.t), checkpoints=len(done.kept), bytes=done.kept.nbytes)
