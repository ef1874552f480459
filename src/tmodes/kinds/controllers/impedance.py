"""Impedance control: the tip behaves as if springs and dampers held it to its setpoint."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Measured
from tmodes.kinds.controllers.model_based import AllDrives
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.frames import Vector, list_of_numbers
from tmodes.kinds.schema.quantity import Issue, not_negative

__all__ = ["Cartesian", "Impedance"]


class Cartesian(AllDrives):
    """u = g(th) + J' F - Kn th' of the motors' angles: forces F on the tip of the rigid robot, in the world."""

    stiffness: Vector = list_of_numbers("N/m", "K", "stiffness along x, y, z of the world")
    damping: Vector = list_of_numbers("N*s/m", "D", "damping along x, y, z of the world")
    joint_damping: float = not_negative("gain*s", "Kn", "damping of each motor, of motions that keep the tip",
                                        default=0.0)  # fmt: skip

    def _issues(self) -> Iterator[Issue]:
        for name in ("stiffness", "damping"):
            if min(getattr(self, name)) < 0:
                yield Issue(name, f"{getattr(self, name)}", "numbers not less than 0", "correct the sign")

    def numbers(self) -> tuple[Any, ...]:
        """K, D, Kn."""
        return (*self.stiffness, *self.damping, self.joint_damping)

    def pull(self, p: Any, m: Measured) -> tuple[list[Any], list[Any]]:
        """Force towards the setpoint, K (x_d - x) + D x_d', and that of the dampers, D x' [N]."""
        (th, thd), (r, rate, _) = m.motors(), self.references(m)
        here, wanted = m.model.tip(th), m.model.tip(r)
        moves, leads = _times(m.model.tip_jacobian(th), thd), _times(m.model.tip_jacobian(r), rate)
        towards = [p[i] * (wanted[i] - here[i]) + p[3 + i] * leads[i] for i in range(3)]
        return towards, [p[3 + i] * moves[i] for i in range(3)]

    def efforts(self, p: Any, m: Measured, force: list[Any]) -> list[Any]:
        """Those that put a force [N] on the tip."""
        th, thd = m.motors()
        rows = m.model.tip_jacobian(th)
        pushes = [vectors.total([rows[i][k] * force[i] for i in range(3)]) for k in range(len(th))]
        weights = m.model.gravity(th)
        return self.chosen(m, [g + push - p[6] * turns for g, push, turns in zip(weights, pushes, thd, strict=True)])


def _times(rows: list[list[Any]], rates: list[Any]) -> list[Any]:
    return [vectors.total([a * b for a, b in zip(row, rates, strict=True)]) for row in rows]


@CONTROLLERS.register
class Impedance(Cartesian):
    """u = g(th) + J' (K (x_d - x) + D (x_d' - x')) - Kn th': x is where the tip of the rigid robot would be.

    x_d is where it is at the setpoints of the joints. The stiffness that the tip has to a static force is that of K,
    the gears and the links in series (N. Hogan, Impedance control, ASME J. Dyn. Sys. Meas. Control 107, 1985; of
    elastic joints: A. Albu-Schaeffer, C. Ott, G. Hirzinger, A unified passivity-based control framework for position,
    torque and impedance control of flexible joint robots, Int. J. Robotics Research 26, 2007).
    """

    type: Literal["impedance"] = Field(description="kind of controller")

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        del x
        towards, lost = self.pull(p, m)
        return self.efforts(p, m, [a - b for a, b in zip(towards, lost, strict=True)])
