"""A whole arm in a run as schedules: signals, controllers, motors, chain, loads, contact, works.

Inputs ``time`` (1), ``state``, ``row``, and ``step`` h (1). The output ``rate`` is the derivative of the state; with
h > 0 its accelerations are those of a linearly implicit Euler step of h.
"""

from __future__ import annotations

from functools import cached_property

from tmodes.equations.loop.friction import contact_fold
from tmodes.equations.loop.instant import Instant
from tmodes.equations.loop.loop_parts import Driver, LoopParts
from tmodes.equations.loop.powers import Powers
from tmodes.equations.loop.serving import sampled_state
from tmodes.kinds.kernel.schedule import Schedule

__all__ = ["ClosedLoop", "Driver"]


class ClosedLoop(LoopParts):
    """The schedules of a plan; every schedule reads the same parameters."""

    @cached_property
    def rate(self) -> Schedule:
        """(time, state, row, step) -> derivative of the state."""
        return self._rate(Instant(self))

    @cached_property
    def implicit_rate(self) -> Schedule:
        """(time, state, row, step, start) -> derivative of the state, for the steps of implicit methods.

        Springs, dampers and servos start from ``start`` (2 nq), and h D + h^2 K are added to the masses; all else is
        taken where ``state`` is, at ``time``.
        """
        return self._rate(Instant(self, apart=True))

    @cached_property
    def euler_rate(self) -> Schedule:
        """The same for implicit Euler steps, whose ``state`` is h of its rates ahead of ``start``.

        A surface in contact with a tip is taken at the end of the step as well.
        """
        return self._rate(Instant(self, apart=True, euler=True))

    def _rate(self, instant: Instant) -> Schedule:
        currents = [instant.change[k] for k in sorted(instant.change)]
        controls = [instant.controls[k] for k in sorted(instant.controls)]
        works = Powers(instant).works
        instant.schedule.often = True
        instant.schedule.sampled = self.sampled
        instant.schedule.output("rate", instant.way.v, *instant.accelerations, *currents, *controls, *works)
        return instant.schedule

    @cached_property
    def sampled(self) -> Schedule | None:
        """(time, state, row, step) -> the state after the samples at the row's start; None without a sampled one."""
        return sampled_state(self) if self.plan.is_sampled else None

    @cached_property
    def observe(self) -> Schedule:
        """(time, state, row, step) -> what is shown.

        q, v, a, drives (4 each), own states of controllers, gear, contact (6), fold, the base's row, powers.
        """
        instant = Instant(self, after=self.plan.is_sampled)
        powers, drives = Powers(instant), range(len(self.drivers))
        shown = {
            "q": [instant.way.q],
            "v": [instant.way.v],
            "a": instant.accelerations,
            "drives": [powers.info[k] for k in drives],
            "controls": [instant.own[k] for k in sorted(instant.own) if instant.own[k].size],
            "gear": [powers.gear[k] for k in drives],
            "contact": [powers.contact],
            "contact_fold": [contact_fold(instant.solution, instant.begin)],
            "base": [instant.way.base],
            "powers": powers.works,
        }
        for name, blocks in shown.items():
            instant.schedule.output(name, *blocks)
        return instant.schedule
