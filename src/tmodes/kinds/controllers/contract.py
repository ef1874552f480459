"""Controllers: from what is measured and wanted to commands of drives, with states of their own.

A controller of a user's own is a class with the field ``type`` and two methods::

    @CONTROLLERS.register
    class LQR(Controller):
        sees_all: ClassVar[bool] = True
        type: Literal["lqr"] = Field(description="kind of controller")
        gains: tuple[float, ...] = Field(strict=False, description="row of K, of (q, v)")

        def numbers(self) -> tuple[float, ...]:
            return self.gains

        def command(self, p, m, x):
            return m.wanted - vectors.total([k * s for k, s in zip(p, [*m.q, *m.v])])

The command is the voltage of a motor that has a resistance, else the effort. A controller is a block
(:mod:`tmodes.kinds.controllers.block`): in the section `control` of a sheet it may command several drives, read sensors
and other blocks by name (``reads``), or give signals that other blocks read (``ports``).

Steps of implicit methods take the feedback of a drive's own position and rate at the end of the step (their slopes are
derived), all other feedback and the own states explicitly.
"""

from __future__ import annotations

from typing import ClassVar

from tmodes.kinds.controllers.block import Block, LinearPlant, Measured, OwnState, Port
from tmodes.kinds.noted.functions import number

__all__ = ["CONTROLLERS", "Block", "Controller", "LinearPlant", "Measured", "OwnState", "Port"]


class Controller(Block, family="controller", key="type"):
    """What keeps a wanted position, filters a signal, or estimates a state."""

    tuned: ClassVar[tuple[str, ...]] = ("position_gain", "integral_gain", "velocity_gain")
    """Its numbers, or groups of numbers by name, that ``tmodes tune`` changes, as far as it has them."""
    limits_at: ClassVar[tuple[int, ...]] = ()
    """Which of its numbers are limits of its command."""

    @property
    def is_local(self) -> bool:
        """Whether it is no more to small motions than a spring and a damper of its own drive."""
        return not (self.sees_all or self.initial() or self.period or self.reads)

    def local_gains(self) -> tuple[float, float]:
        """Fall of the command per own position and rate about zero; 0 for a controller that sees more than those."""
        if self.sees_all or self.reads or self.needs_model:
            return 0.0, 0.0
        p, x, step = self.numbers(), list(self.initial()), 1e-4

        def command(position: float, velocity: float) -> float:
            return number(self.command(p, Measured(position=position, velocity=velocity), x))

        stiff = (command(-step, 0.0) - command(step, 0.0)) / (2 * step)
        return stiff, (command(0.0, -step) - command(0.0, step)) / (2 * step)

    def unknown(self, coordinates: tuple[str, ...]) -> list[str]:
        """Coordinates that it asks for by name and that the robot does not have."""
        del coordinates
        return []


CONTROLLERS = Controller.registry
"""Those of tmodes, and what a user registers: ``@CONTROLLERS.register``."""
