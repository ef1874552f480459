"""Force control along one direction, with integral action; impedance control along the others."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Measured, OwnState
from tmodes.kinds.controllers.impedance import Cartesian
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors
from tmodes.kinds.noted import functions as noted
from tmodes.kinds.schema.frames import Vector, list_of_numbers
from tmodes.kinds.schema.quantity import Issue, any_sign, not_negative

__all__ = ["Force"]


@CONTROLLERS.register
class Force(Cartesian):
    """u = g(th) + J' ((1 - n n') (K (x_d - x) + D x_d') + n (F_d + z) - D x') - Kn th', z' = Ki (F_d - F).

    n: ``direction`` in the world; F: the signal ``input``, force of the tip on what it touches along n, which has to be
    sampled. The integral waits until there is contact, F > 0; until then F_d moves the tip against its damper (M. H.
    Raibert, J. J. Craig, Hybrid position/force control of manipulators, ASME J. Dyn. Sys. Meas. Control 102, 1981).
    """

    type: Literal["force"] = Field(description="kind of controller")
    direction: Vector = list_of_numbers("-", "n", "where it pushes, in the world, of any length")
    force: float = any_sign("N", "F_d", "wanted force of the tip on what it touches, along the direction")
    integral_gain: float = not_negative("1/s", "Ki", "integral gain on the error of the force")
    input: str = Field(min_length=1, max_length=200, description="measured force: a sensor, or an output by its name")

    def _issues(self) -> Iterator[Issue]:
        yield from super()._issues()
        if not any(self.direction):
            yield Issue("direction", "a direction of zeros", "a direction", "write [0, 0, -1] to push downwards")

    @property
    def reads(self) -> tuple[str, ...]:
        """The force."""
        return (self.input,)

    def numbers(self) -> tuple[Any, ...]:
        """K, D, Kn, n, F_d, Ki; sampled: Ki T."""
        size = noted.hypot(*self.direction)
        gain = self.integral_gain if self.sample_time is None else self.integral_gain * self.sample_time
        return (*super().numbers(), *(one / size for one in self.direction), self.force, gain)

    def initial(self) -> tuple[float, ...]:
        """Nothing is integrated."""
        return (0.0,)

    @property
    def states(self) -> tuple[OwnState, ...]:
        """Z."""
        return (OwnState("force", "N"),)

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        towards, lost = self.pull(p, m)
        n = [p[7 + i] for i in range(3)]
        along = p[10] + x[0] - vectors.total([a * b for a, b in zip(n, towards, strict=True)])
        return self.efforts(p, m, [a + along * b - c for a, b, c in zip(towards, n, lost, strict=True)])

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """That of z."""
        del x
        felt = m.signals[self.input]
        return [f.if_else(felt > 0, p[11] * (p[10] - felt), 0.0)]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """That of the next sample."""
        return [x[0] + self.rates(p, m, x)[0]]

    @property
    def structure(self) -> str:
        """What it reads is part of the code."""
        return f"{super().structure} {self.input}"
