"""Blocks with ports: what controllers, filters, observers and sensors have in common.

A block reads named signals (``reads``), gives signals (``ports``), and may have states of its own. It is written in an
arithmetic that is passed in: sums, products, quotients, and the functions of :mod:`tmodes.kinds.kernel.functions`. It
runs in native code, in batches, in derivatives and in WebAssembly.

A block with a ``period`` is sampled: at the multiples of its period its outputs and its own states (``updates``) are
computed from what it reads there; in between both are held. Steps of all methods end on these instants. A drive with a
`period` of its own samples a block of continuous time, whose states then advance by rates times period (Euler).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Self

from tmodes.errors import InputError
from tmodes.kinds.schema.kind import Kind

__all__ = ["Block", "LinearPlant", "Measured", "OwnState", "Port"]


@dataclass(frozen=True)
class Measured:
    """What a block sees of one instant, as numbers or symbols.

    Of its own drive: ``wanted`` position with two derivatives, ``position`` and ``velocity`` of the motor (of the joint
    where it has no elastic gear) and its ``current``; ``limit``: largest command of that drive, None without one. Of a
    block that sees all: ``q`` and ``v`` of all coordinates in the order of ``names`` (motors, joints, links),
    ``currents`` that are states, and ``setpoints``: (value, rate, acceleration, or :attr:`Block.setpoint_orders`) of
    each drive's signal in the order of ``drives``; ``joint``: its own among these; ``commands``: those that it
    commands, in the order of its outputs. ``signals``: what it reads by name.
    ``period``: time between its samples [s], None in continuous time. ``model``: see :attr:`Block.needs_model`.
    ``fed``: an effort is fed forward to its own drive, by the drive or by a block that adds to its command.
    ``at_rest``: an equilibrium is looked for, in which there is no noise and nothing is rounded.
    """

    wanted: Any = 0.0
    wanted_rate: Any = 0.0
    wanted_acceleration: Any = 0.0
    position: Any = 0.0
    velocity: Any = 0.0
    current: Any = 0.0
    q: list[Any] = field(default_factory=list)
    v: list[Any] = field(default_factory=list)
    names: tuple[str, ...] = ()
    currents: list[Any] = field(default_factory=list)
    setpoints: list[list[Any]] = field(default_factory=list)
    drives: tuple[str, ...] = ()
    joint: str = ""
    commands: tuple[str, ...] = ()
    signals: Mapping[str, Any] = field(default_factory=dict)
    limit: Any = None
    period: Any = None
    model: Any = None
    fed: bool = False
    at_rest: bool = False

    def coordinate(self, name: str) -> tuple[Any, Any]:
        """Position and rate of a coordinate by name; raises :class:`tmodes.errors.InputError` for an unknown one."""
        if name not in self.names:
            hint = "name it in `unknown`, which is asked when the sheet is read"
            raise InputError("controller", f"the unknown coordinate `{name}`", f"one of {', '.join(self.names)}", hint)
        place = self.names.index(name)
        return self.q[place], self.v[place]

    def motors(self) -> tuple[list[Any], list[Any]]:
        """Positions and rates of the motors of all drives, of the joint itself behind a rigid gear."""
        places = [self.names.index(name if (name := f"{one}.motor") in self.names else one) for one in self.drives]
        return [self.q[k] for k in places], [self.v[k] for k in places]

    def joints(self) -> tuple[list[Any], list[Any]]:
        """Positions and rates of the joints of all drives."""
        places = [self.names.index(one) for one in self.drives]
        return [self.q[k] for k in places], [self.v[k] for k in places]

    def setpoint(self, joint: str) -> list[Any]:
        """Value, rate, acceleration (...) of the signal of a joint's drive."""
        return self.setpoints[self.drives.index(joint)]


@dataclass(frozen=True)
class OwnState:
    """A block's own state in a result: name and unit, as ``rad*s|m*s`` where that of a sliding joint differs."""

    name: str
    unit: str = "1"

    def unit_of(self, *, slides: bool) -> str:
        """The unit on a joint that turns or slides."""
        return self.unit.split("|")[-1 if slides else 0]


@dataclass(frozen=True)
class Port:
    """A signal that a block gives: its name behind that of the block (empty: the block's own) and its unit."""

    name: str = ""
    unit: str = "1"


@dataclass(frozen=True)
class LinearPlant:
    """The robot about a rest, for the design of a block: x' = A x + B u, y = C x + D u of deviations from ``rest``.

    ``states``: names of x, coordinates then ``NAME'`` for their rates, then currents; ``drives``: those of u, in the
    order of its columns; ``rest``: x at rest; ``effort``: u that holds it; ``reads``: names of the rows of C and D,
    whose values at rest are ``measured``; commands act ``delay`` [s] after their samples. ``added``: what is fed
    forward on top of each command, as (signal, factor) pairs for each drive; ``effort`` holds the rest beside it.
    ``first``: where the setpoints of the drives begin.
    """

    states: tuple[str, ...]
    drives: tuple[str, ...]
    reads: tuple[str, ...]
    A: Any
    B: Any
    C: Any
    D: Any
    rest: Any
    effort: Any
    measured: Any
    delay: float = 0.0
    added: tuple[tuple[tuple[str, Any], ...], ...] = ()
    added_at_rest: tuple[Any, ...] = ()
    first: tuple[float, ...] = ()


class Block(Kind):
    """A part of a control system: signals in, signals out, with states of its own."""

    sees_all: ClassVar[bool] = False
    """Whether it sees the whole state and all setpoints, not only its own drive."""

    is_designed: ClassVar[bool] = False
    """Whether something follows from the linear robot (:meth:`designed`); such a block stands in `control`."""

    commands_effort: ClassVar[bool] = False
    """Whether its command is an effort [N*m or N] of a motor with a resistance, too: its current is then controlled."""

    setpoint_orders: ClassVar[int] = 3
    """How many numbers of each setpoint a block sees that sees all: value, rate, ..., at most 5 (fourth derivative)."""

    needs_model: ClassVar[bool] = False
    """Whether it computes with the robot as known, its gears and links rigid: ``m.model.torque(q, v, a)`` and more, see
    :class:`tmodes.equations.loop.rigid_terms.RigidTerms`; angles in the order of ``m.drives``."""

    needs_joint: ClassVar[bool] = False
    """Whether it works on one joint as its own, in `control` too: on its only drive, or the one that `of` names."""

    needs_drives: ClassVar[bool] = False
    """Whether it has no other outputs than commands of the drives that it names."""

    needs_gears: ClassVar[bool] = False
    """Whether all driven joints must have elastic gears."""

    ports: ClassVar[tuple[Port, ...]] = ()
    """The signals that it gives; none: one for each drive that it commands, named by the joints."""

    @property
    def reads(self) -> tuple[str, ...]:
        """Names of the signals that it reads: outputs, sensors, ports of other blocks."""
        return ()

    @property
    def noises(self) -> tuple[str, ...]:
        """Those of the signals that it reads that are noise of its own, at its samples."""
        return ()

    def noise_of(self, name: str) -> tuple[int, float]:
        """Seed and standard deviation of one of these."""
        raise NotImplementedError

    @property
    def given(self) -> Mapping[str, Any]:
        """Signals over time that it brings, by the names under which it reads them."""
        return {}

    def numbers(self) -> tuple[float, ...]:
        """Numbers of the law, which its methods read as ``p``."""
        raise NotImplementedError

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """Its output of its numbers, what it sees, and its own states; a list where it has several.

        That of a drive is [V] of a motor that has a resistance, else [N*m or N]; see :attr:`commands_effort`.
        """
        raise NotImplementedError

    @property
    def period(self) -> float | None:
        """Time between its samples [s]; None where it works in continuous time."""
        return None

    @property
    def lag(self) -> float:
        """How much later than its sample an output is given [s]."""
        return 0.0

    def initial(self) -> tuple[float, ...]:
        """Its own states at time 0; as many as there are rates, or updates.

        Where it has an attribute ``remembered``, so many last ones are past commands, the newest of all outputs first.
        """
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
        """Its own states after a sample; the outputs of that sample are of those before."""
        del p, m
        return x

    def designed(self, plant: Callable[..., LinearPlant], drives: tuple[str, ...]) -> Self:
        """The block with what follows from the robot as known; itself where nothing does.

        ``plant(reads, drives, start=False)`` gives the linear robot with the outputs of some names; ``drives``: joints
        that it commands.
        """
        del plant, drives
        return self

    def with_numbers(self, numbers: Sequence[Any]) -> Self:
        """The same block with other :meth:`numbers`, whatever its fields say."""
        made = self.model_copy()
        vars(made)["numbers"] = lambda: tuple(numbers)
        return made

    @property
    def robustness(self) -> float | None:
        """e_max of a designed law: the largest change of the coprime factors of its weighted loop that it bears."""
        return None

    def following(self, sheet: Block) -> Block:
        """Of one that is designed: the same with the signals of its ``sheet``, which may be noted; gains stay."""
        del sheet
        return self

    def remarks(self) -> list[str]:
        """What a user should know of the block as it is designed, before a run."""
        return []

    @property
    def structure(self) -> str:
        """The law's compiled form: two blocks of the same structure share their code."""
        sampled = " sampled" * (self.period is not None)
        return f"{self.fingerprint()} {len(self.numbers())} {len(self.initial())}{sampled}"
