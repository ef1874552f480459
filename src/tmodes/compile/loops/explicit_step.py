"""What a step of every adaptive explicit method begins with, and what follows once its error is known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.step_control import StepControl, add_local_errors, first_stage
from tmodes.compile.loops.stiffness import StiffnessTest
from tmodes.compile.loops.time_loop import Status, TimeLoop

__all__ = ["AdaptiveStep", "ExplicitMethod"]


class AdaptiveStep(NamedTuple):
    """A step of length h from ``time`` to ``time_after``; ``wanted``: its length if no knot had cut it (``last``)."""

    time: Any
    wanted: Any
    h: Any
    last: Any
    time_after: Any


@dataclass(frozen=True)
class ExplicitMethod:
    """How steps are controlled and tested; ``end``: the slope at a step's end, the first stage of the next."""

    control: StepControl
    stiffness: StiffnessTest | None
    end: str

    def begin(self, loop: TimeLoop, offset: int | None) -> tuple[Gate, AdaptiveStep]:
        """The first stage of a step, which ends on a knot where one comes; ``offset``: where the gate's numbers are."""
        gate = Gate(loop, offset)
        gate.begin("y", "probe")
        first_stage(loop)
        time, wanted = loop.get("t"), loop.get("h")
        h, last, time_after = loop.step_until(loop.knot(1))
        return gate, AdaptiveStep(time, wanted, h, last, time_after)

    def end_with(
        self, loop: TimeLoop, gate: Gate, step: AdaptiveStep, errors: tuple[Any, Any], write: Callable[[], None]
    ) -> None:
        """Judge, write and take the step to ``new``, or try it again shorter.

        ``errors``: that of the step over its tolerance, and what the array ``local`` is multiplied with to be its local
        error; ``write`` writes the samples.
        """
        error, share = errors
        self.control.judge(loop, step.h, error)
        loop.stop_if(loop.builder.not_(loop.within_bounds("new")), Status.DIVERGED)
        gate.meet(step.h)
        add_local_errors(loop, "local", share)
        write()
        self.control.accept(loop, (step.wanted, step.h, step.last, step.time_after), error, self.end)
        if self.stiffness:
            self.stiffness.write(loop, step.h)
        loop.builder.branch(loop.again)
