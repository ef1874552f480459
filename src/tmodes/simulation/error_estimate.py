"""How far a run is from the exact motion: given by its own local errors, or by a second run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from tmodes.integrate.settings import Integration
from tmodes.simulation.trajectory import STOPPED, ErrorEstimate, Trajectory

__all__ = ["with_error"]


def with_error(run: Trajectory, settings: Integration, again: Callable[[Integration], Trajectory]) -> Trajectory:
    """The run with an estimate of its error at each sample; ``again`` runs the same with other settings.

    - ``check_error``: from a run with a tenth of the tolerances, whose error is a tenth as large (tolerance
      proportionality); at fixed step with half of it, whose error is 1/2^order of it (Richardson);
    - else at fixed step: from a run with twice the step, at half the cost; none where that one is unstable;
    - else the sizes of the local errors, summed over the steps as the method reports them of each component. It bounds
      what motions that do not grow make of them; it is mostly far too large, because what continues is the solution of
      higher order. Where a motion is unstable, or its frequency changes with its energy, errors grow faster than this
      sum; where a slow coordinate is fed by the error of its own rate, they may pass it.

    A second run that does not reach the end reports nothing. Interrupted within it, the run counts as interrupted.
    """
    one = settings.integrator
    order = one.order if one and not one.adaptive else None
    if run.status not in {"finished", STOPPED} or not (order or settings.check_error):
        return run
    if run.status == STOPPED:
        settings = settings.model_copy(update={"duration": float(run.times[-1])})
    other = again(settings.finer() if settings.check_error else settings.coarser())
    seconds = run.seconds + other.seconds
    if other.status == "interrupted":
        message = "interrupted after its end, before its error was estimated"
        return replace(run, status="interrupted", message=message, seconds=seconds)
    if other.status != "finished":
        return replace(run, seconds=seconds)
    share, how = _share(order, finer=settings.check_error)
    return replace(run, error=ErrorEstimate(share * (other.states - run.states), how, signed=True), seconds=seconds)


def _share(order: int | None, *, finer: bool) -> tuple[float, str]:
    """What the difference to the other run is multiplied with, and what that run is."""
    if order is None:
        return 10 / 9, "run with a tenth of the tolerances"
    if finer:
        return 2**order / (2**order - 1), "run with half the step"
    return -1 / (2**order - 1), "run with twice the step"
