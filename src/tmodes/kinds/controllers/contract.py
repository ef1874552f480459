"""What a controller is: from what is measured and wanted to the command of one drive, with states of its own.

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

The command is the voltage of a motor that has a resistance, else the effort. Controllers are written in an arithmetic
that is passed in: sums, products, quotients, and the functions of :mod:`tmodes.kinds.kernel.functions`. They run in
native code, in batches, in derivatives and in WebAssembly.

A controller with a ``period`` is sampled: at the multiples of its period its command and its own states (``updates``)
are computed from what is measured there; in between both are held. Steps of all methods end on these instants.

Steps of implicit methods take the feedback of a drive's own position and rate at the end of the step (their slopes are
derived), all other feedback and the own states explicitly.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar

from tmodes.errors import InputError
from tmodes.kinds.schema.kind import Kind

__all__ = ["CONTROLLERS", "Controller", "Measured", "OwnState"]


@dataclass(frozen=True)
class Measured:
    """What a controller sees of one instant, as numbers or symbols.

    Of its own drive: ``wanted`` position with two derivatives, ``position`` and ``velocity`` of the motor (of the joint
    where it has no elastic gear) and its ``current``. Of a controller that sees all: ``q`` and ``v`` of all coordinates
    in the order of ``names`` (motors, joints, links), ``currents`` that are states, and ``setpoints``: (value, rate,
    acceleration) of each drive's signal in the order of ``drives``.
    """

    wanted: Any
    wanted_rate: Any
    wanted_acceleration: Any
    position: Any
    velocity: Any
    current: Any = 0.0
    q: list[Any] = field(default_factory=list)
    v: list[Any] = field(default_factory=list)
    names: tuple[str, ...] = ()
    currents: list[Any] = field(default_factory=list)
    setpoints: list[list[Any]] = field(default_factory=list)
    drives: tuple[str, ...] = ()

    def coordinate(self, name: str) -> tuple[Any, Any]:
        """Position and rate of a coordinate by name; raises :class:`tmodes.errors.InputError` for an unknown one."""
        if name not in self.names:
            hint = "name it in `unknown`, which is asked when the sheet is read"
            raise InputError("controller", f"the unknown coordinate `{name}`", f"one of {', '.join(self.names)}", hint)
        place = self.names.index(name)
        return self.q[place], self.v[place]


@dataclass(frozen=True)
class OwnState:
    """A controller's own state in a result: name and unit, as ``rad*s|m*s`` where that of a sliding joint differs."""

    name: str
    unit: str = "1"

    def unit_of(self, *, slides: bool) -> str:
        """The unit on a joint that turns or slides."""
        return self.unit.split("|")[-1 if slides else 0]


class Controller(Kind, family="controller", key="type"):
    """What keeps a wanted position."""

    sees_all: ClassVar[bool] = False
    """Whether it sees the whole measured state, not only its own drive."""

    def numbers(self) -> tuple[float, ...]:
        """Numbers of the law, which its methods read as ``p``."""
        raise NotImplementedError

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """The command [V, or N*m or N], of its numbers, what it sees, and its own states."""
        raise NotImplementedError

    @property
    def period(self) -> float | None:
        """Time between its samples [s]; None where it works in continuous time."""
        return None

    def initial(self) -> tuple[float, ...]:
        """Its own states at time 0; as many as there are rates, or updates."""
        return ()

    @property
    def states(self) -> tuple[OwnState, ...]:
        """Names and units of its own states."""
        return tuple(OwnState(f"state{k + 1}") for k in range(len(self.initial())))

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Derivatives by time of its own states, in continuous time."""
        del p, m, x
        return []

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Its own states after a sample; the command of that sample is of those before."""
        del p, m
        return x

    @property
    def is_local(self) -> bool:
        """Whether it is no more to small motions than a spring and a damper of its own drive."""
        return not (self.sees_all or self.initial() or self.period)

    @property
    def structure(self) -> str:
        """The law's compiled form: two controllers of the same structure share their code."""
        sampled = " sampled" * (self.period is not None)
        return f"{self.fingerprint()} {len(self.numbers())} {len(self.initial())}{sampled}"

    def local_gains(self) -> tuple[float, float]:
        """Fall of the command per own position and rate about zero; 0 for a controller that sees the whole state."""
        p, x, step = self.numbers(), list(self.initial()), 1e-4

        def command(position: float, velocity: float) -> float:
            return float(self.command(p, Measured(0.0, 0.0, 0.0, position, velocity), x))

        if self.sees_all:
            return 0.0, 0.0
        stiff = (command(-step, 0.0) - command(step, 0.0)) / (2 * step)
        return stiff, (command(0.0, -step) - command(0.0, step)) / (2 * step)

    def unknown(self, coordinates: tuple[str, ...]) -> list[str]:
        """Coordinates that it asks for by name and that the robot does not have."""
        del coordinates
        return []


CONTROLLERS = Controller.registry
"""Those of tmodes, and what a user registers: ``@CONTROLLERS.register``."""
