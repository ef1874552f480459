"""Outputs: the numbers of an instant of a run that can be asked for by name: unit, meaning, and place in a schedule.

One table is read by stop conditions, studies, gradients, results, figures and pages; an output is one entry of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import joint_of_element
from tmodes.equations.loop.instant import Instant
from tmodes.equations.loop.layout import WORKS
from tmodes.equations.loop.output_slots import Seen, lines_of
from tmodes.equations.loop.plan import LoopParts
from tmodes.equations.recursion.hinge import POSE
from tmodes.equations.recursion.passes import BASE
from tmodes.errors import InputError
from tmodes.io.words import nearest
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.kinds.links.line import layout

__all__ = [
    "COMMANDED", "DEVIATION", "DISTANCES", "ENERGIES", "OWN", "Output", "Outputs", "Series", "output_schedule",
    "station_numbers",
]  # fmt: skip

DEVIATION, OWN, COMMANDED = "deviation", "tip_difference", "tip_error"

DISTANCES = {
    DEVIATION: "nominal tip of the same robot", OWN: "tip of the sheet's own run", COMMANDED: "commanded path",
}  # fmt: skip
"""Outputs that compare the tip with a place that is given at each instant, and what that is."""

ENERGIES = ("kinetic", "gravity", "elastic_gear", "elastic_link")
"""Energies [J] by kind."""

_AXES = ("x", "y", "z")
_SHOWN, _LISTED = 12, 8
"""Names that a message lists, and a representation."""


class Output(NamedTuple):
    """One number of an instant: ``name``, ``unit``, what it is, and where a schedule has it, ``of(seen, *places)``.

    ``stored``: the variable of a result that holds it, then the labels along its further dimensions; empty where it is
    computed from the motion.
    """

    name: str
    unit: str
    meaning: str
    of: Callable[..., Slot]
    places: tuple[Any, ...] = ()
    stored: tuple[str, ...] = ()

    @property
    def is_work(self) -> bool:
        """Whether it is integrated next to the motion."""
        return self.stored[:1] == ("work",)

    @property
    def further(self) -> bool:
        """Whether it takes numbers of its own next to those of the loop."""
        return self.of is Seen.along

    @property
    def along(self) -> bool:
        """Whether it is a number of the line of a link."""
        return self.of is Seen.along

    @property
    def late(self) -> bool:
        """Whether it follows from the accelerations and efforts of its instant, not from positions and rates alone."""
        return self.of not in {Seen.moved, Seen.pose, Seen.speed, Seen.angle, Seen.body_rate, Seen.bent, Seen.state}

    def slot(self, instant: Instant) -> Slot:
        """Where the schedule of an instant has it; numbers that it takes of its own stand among those of the loop."""
        return self.of(Seen(instant, instant.loop.numbers_of(self.name)), *self.places)

    def resting(self, instant: Instant) -> Slot | None:
        """The same where nothing moves, before the efforts are known; None for what follows from these."""
        if still := _RESTING.get(self.of):
            return still(Seen(instant, instant.loop.numbers_of(self.name)), *self.places)
        return instant.none[1] if self.unit.endswith("/s^2") else None


_RESTING = {Seen.proper: Seen.upheld, Seen.along: Seen.along, Seen.contact: Seen.contact, Seen.gear: Seen.wound}
"""How outputs that follow from accelerations are found where there are none."""


class Series(NamedTuple):
    """``schedule``: (time, state and what is given, row, step) -> the outputs that were asked for.

    ``further``: numbers of stations along links that stand behind the loop's own parameters.
    """

    schedule: Schedule
    further: NDArray[np.float64]


def output_schedule(
    loop: LoopParts, wanted: Mapping[str, Sequence[Output]], given: int = 0, *, after: bool, often: bool
) -> Series:
    """The schedule of some outputs, by groups; ``given``: how many numbers stand behind the state.

    ``after``: controllers are shown after the samples with which the row begins; without, the state is after them.
    ``often``: it is called so often that much work for its code pays.
    """
    seen = Seen(Instant(loop, after=after, posed=True, given=given))
    for group, outputs in wanted.items():
        seen.schedule.output(group, *(output.of(seen, *output.places) for output in outputs))
    chosen = seen.schedule.only(tuple(wanted))
    chosen.often, chosen.gate, chosen.narrow, chosen.switches, chosen.switched = often, None, None, None, None
    chosen.sampled, chosen.parameters = None, seen.numbers.size
    return Series(chosen, seen.numbers.vector)


def station_numbers(loop: LoopParts, names: Sequence[str]) -> NDArray[np.float64]:
    """The numbers of outputs at stations along links, behind those of the loop; of other names there are none."""
    outputs = Outputs(loop) if any("@" in name for name in names) else {}
    shown = [outputs[name] for name in names if name in outputs and outputs[name].further]
    return output_schedule(loop, {"shown": shown}, after=False, often=False).further if shown else np.zeros(0)


def refuse_unknown(name: str, known: Sequence[str], which: str) -> NoReturn:
    """Raise :class:`tmodes.errors.InputError` for a name that is not known, with the nearest one that is."""
    last = name.rpartition(".")[2]
    close = nearest(name, known) or next((other for other in known if other.rpartition(".")[2] == last), None)
    names = sorted(known, key=lambda other: (not other.startswith(name.partition(".")[0]), other))
    more = ", ..." if len(names) > _SHOWN else ""
    hint = f"did you mean `{close}`?" if close else "write one of these names"
    raise InputError(which, f"the unknown name {name!r}", f"one of {', '.join(names[:_SHOWN])}{more}", hint)


class Outputs(Mapping[str, Output]):
    """The outputs of a closed loop by their names, with those at any station of a link: ``arm.moment.y@0.5``.

    ``given``: those of :data:`DISTANCES` that are given, in their order behind the state. ``groups``: several outputs
    under one name, ``tip``, ``q``.
    """

    def __init__(self, loop: LoopParts, given: Sequence[str] = ()) -> None:
        self.loop, self._given = loop, tuple(given)
        chain, names = loop.plan.chain, loop.parts.names
        self._units, self._sliding = chain.units(names), chain.sliding
        found = (
            *self._coordinates(), *self._drives(), *self._points(), *self._contact(), *self._bent(), *self._energies(),
            *self._base(), *self._distances(), *self._signals(),
        )  # fmt: skip
        self._own = {output.name: output for output in found}

    def __getitem__(self, name: str) -> Output:
        return self._own[name] if name in self._own else self._along(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._own)

    def __len__(self) -> int:
        return len(self._own)

    @property
    def rows(self) -> list[tuple[str, str, str]]:
        """Name, unit and meaning of each; of stations along links with ``@S`` in the place of the station."""
        named = [*self._own.items(), *self.stations.items()]
        return [(name, output.unit, output.meaning) for name, output in named]

    def __repr__(self) -> str:
        rows = self.rows
        shown = [f"  {name} [{unit}]: {text}" for name, unit, text in rows[:_LISTED]]
        return "\n".join([f"{len(rows)} outputs", *shown, *["  ..."] * (len(rows) > _LISTED)])

    def find(self, name: str, which: str, others: Iterable[str] = ()) -> Output:
        """The output of a name; raises :class:`tmodes.errors.InputError` of ``which`` with the nearest name.

        ``others``: names of something else that may be meant.
        """
        if name not in self:
            self._refuse(name, which, *others)
        return self[name]

    def _refuse(self, name: str, which: str, *groups: str) -> NoReturn:
        head, _, station = name.rpartition("@")
        if f"{head}@S" in self.stations:
            expected = "a place from 0, the root of the link, to 1, its tip"
            raise InputError(which, f"`{station}` in `{name}`", expected, f"write for instance {head}@0.5")
        refuse_unknown(name, [*groups, *self._own, *self.stations], which)

    def group(self, name: str, which: str) -> tuple[Output, ...]:
        """The outputs of a group, or the one of a name; raises as :meth:`find`."""
        if not (name in self.groups or name in self):
            self._refuse(name, which, *self.groups)
        return self.groups.get(name) or (self[name],)

    @cached_property
    def groups(self) -> dict[str, tuple[Output, ...]]:
        """Several outputs under one name; each output is a group of its own, too."""
        names, drives, points = self.loop.parts.names, self.loop.plan.drives, self.loop.parts.points
        state = range(self.loop.layout.size)
        found: dict[str, Sequence[Output]] = {
            "state": [Output(f"state.{k}", "-", "", Seen.state, (k,)) for k in state],
            **{kind: [self[f"{name}.{of}"] for name in names] for kind, of in _MOTION.items()},
            "drives": [self[f"{one.joint}.{kind}"] for one in drives for kind in (*_DRIVEN, "setpoint")],
            "gear": [self[f"{one.joint}.gear_torque"] for one in drives],
            "contact": [Output(f"contact.{k}", "-", "", Seen.contact, (k,)) for k in range(len(_CONTACT))],
            "base": [Output(f"base.{k}", "-", "", Seen.base, (k,)) for k in range(BASE)],
            "powers": [self[f"power.{kind}"] for kind in WORKS],
        }
        for key, name in [("tip", points[0].name), *((f"points.{point.name}", point.name) for point in points)]:
            for suffix, kind in (("", ""), ("_velocity", "velocity."), ("_acceleration", "acceleration.")):
                found[f"{key}{suffix}"] = [self[f"{name}.{kind}{axis}"] for axis in _AXES]
        return {name: tuple(group) for name, group in found.items()}

    @cached_property
    def stations(self) -> dict[str, Output]:
        """What there is along links that bend, at any station: names that end on ``@S``, of station 0."""
        found = {}
        for node in range(len(self.loop.parts.nodes)):
            for number, line in enumerate(lines_of(self.loop.parts, node, 0.0)):
                name = self.loop.parts.nodes[node].node.name + line.suffix
                for quantity, part in layout(stressed=line.stressed).items():
                    for k, (suffix, unit, text) in enumerate(_ALONG.get(quantity, ())):
                        place = node, number, 0.0, part.start + k
                        found[f"{name}.{suffix}@S"] = Output("", unit, f"{text} of {name}", Seen.along, place)
        return found

    def _along(self, name: str) -> Output:
        head, _, station = name.rpartition("@")
        try:
            s = float(station)
        except ValueError:
            raise KeyError(name) from None
        pattern = self.stations.get(f"{head}@S") if 0 <= s <= 1 else None
        if pattern is None:
            raise KeyError(name)
        node, number, _, column = pattern.places
        meaning = f"{pattern.meaning} at {s:g} of its length"
        return pattern._replace(name=name, meaning=meaning, places=(node, number, s, column))

    def _coordinates(self) -> Iterator[Output]:
        kinds = zip(_MOTION.items(), ("", "/s", "/s^2"), strict=True)
        for (variable, kind), over in kinds:
            for k, (name, unit) in enumerate(self._units.items()):
                of, places = (Seen.acceleration, (k,)) if variable == "a" else (Seen.moved, (variable, k))
                own = unit if not over else f"1{over}" if unit == "-" else f"{unit}{over}"
                yield Output(f"{name}.{kind}", own, f"{kind} of {name}", of, places, (variable, name))

    def _drives(self) -> Iterator[Output]:
        plan = self.loop.plan
        for k, drive in enumerate(plan.drives):
            joint, effort = drive.joint, "N" if drive.joint in self._sliding else "N*m"
            for column, (kind, unit) in enumerate(_DRIVEN.items()):
                text = f"{_DRIVEN_WORDS[kind]} of {joint}"
                yield Output(f"{joint}.{kind}", unit or effort, text, Seen.drive, (k, column), (kind, joint))
            moves, volts = not drive.servo or drive.servo.is_controlled, drive.servo and drive.servo.driven
            unit = ("m" if joint in self._sliding else "rad") if moves else "V" if volts else effort
            text = f"setpoint of the drive of {joint}, what its command is"
            yield Output(f"{joint}.setpoint", unit, text, Seen.drive, (k, len(_DRIVEN)), ("wanted", joint))
            text = f"torque of the gear on {joint}"
            yield Output(f"{joint}.gear_torque", effort, text, Seen.gear, (k,), ("gear_torque", joint))
        for k, (name, unit) in enumerate(zip(plan.control_names, plan.control_units, strict=True)):
            text = "state of a controller"
            yield Output(name, unit, text, Seen.control, (k,), ("controller_states", name))

    def _signals(self) -> Iterator[Output]:
        for block in self.loop.plan.blocks:
            for name, port in zip(block.signals, block.ports, strict=True):
                unit = port.unit.split("|")[-1 if block.joint in self._sliding else 0]
                yield Output(name, unit, f"signal of the block {block.name}", Seen.wire, (name,))

    def _points(self) -> Iterator[Output]:
        for k, point in enumerate(self.loop.parts.points):
            name = point.name
            for axis, letter in enumerate(_AXES):
                for kind, unit, column in (("position", "m", 9), ("velocity", "m/s", 12)):
                    key = f"{name}.{letter}" if column == 9 else f"{name}.{kind}.{letter}"
                    text, stored = f"{kind} of {name} along {letter}", (kind, name, letter)
                    yield Output(key, unit, text, Seen.pose, (k, column + axis), stored)
                key, text = f"{name}.acceleration.{letter}", f"acceleration of {name} along {letter}"
                yield Output(key, "m/s^2", text, Seen.gain, (k, axis), ("acceleration", name, letter))
                key, text = f"{name}.angular_velocity.{letter}", f"angular velocity of {name} about {letter}"
                yield Output(key, "rad/s", text, Seen.pose, (k, POSE + axis))
                text = f"acceleration of {name} less gravity along its own axis {letter}"
                yield Output(f"{name}.proper_acceleration.{letter}", "m/s^2", text, Seen.proper, (k, axis))
                text = f"angular velocity of {name} about its own axis {letter}"
                yield Output(f"{name}.body_rate.{letter}", "rad/s", text, Seen.body_rate, (k, axis))
            yield Output(f"{name}.speed", "m/s", f"speed of {name}", Seen.speed, (k,))
            for axis, angle in enumerate(("roll", "pitch", "yaw")):
                text = f"{angle} of {name}: R = Rz(yaw) Ry(pitch) Rx(roll)"
                yield Output(f"{name}.{angle}", "rad", text, Seen.angle, (k, axis))

    def _contact(self) -> Iterator[Output]:
        if not self.loop.plan.touch:
            return
        for column, (name, unit, text, stored) in enumerate(_CONTACT):
            yield Output(f"contact.{name}", unit, text, Seen.contact, (column,), stored)
        yield Output("contact.fold", "-", "1 plus the mass of the surface times the mobility there", Seen.fold)
        for k, name in enumerate(self.loop.plan.surface_names):
            kind, unit = (("displacement", "m"), ("velocity", "m/s"))[k]
            column, text = self.loop.layout.surface.start + k, f"{kind} of the surface along the push on it"
            yield Output(name, unit, text, Seen.state, (column,), (f"surface_{kind}",))

    def _bent(self) -> Iterator[Output]:
        parts, joints = self.loop.parts, self.loop.parts.joints
        for axis in parts.axes:
            element, joint = axis.axis.element, axis.axis.name
            if not element:
                continue
            unit = self._units.get(joint_of_element(element), "rad")
            one = Output("", unit, f"deformation of {element}", Seen.bent, (axis.angle,), ("deformation", element))
            for name in (f"deformation.{element}", *((f"{joint}.gear_twist",) if element.endswith(".gear") else ())):
                yield one._replace(name=name)
        for k in range(joints.stop, parts.size):
            name = parts.names[k]
            stored = ("deformation", name)
            text = f"deformation of {name}"
            yield Output(f"deformation.{name}", self._units[name], text, Seen.moved, ("q", k), stored)

    def _energies(self) -> Iterator[Output]:
        for kind in ENERGIES:
            yield Output(f"energy.{kind}", "J", f"{_ENERGY[kind]} energy", Seen.energy, (kind,), ("energy", kind))
        yield Output("energy.total", "J", "sum of all energies", Seen.energy, ENERGIES)
        works = self.loop.layout.works
        for k, kind in enumerate(WORKS):
            text = f"of {kind.replace('_', ' ')}"
            yield Output(f"power.{kind}", "W", f"power {text}", Seen.power, (k,))
            if works.stop > works.start:
                yield Output(f"work.{kind}", "J", f"work {text}", Seen.state, (works.start + k,), ("work", kind))

    def _base(self) -> Iterator[Output]:
        if self.loop.mechanics.base_moves:
            for first, kind, unit in ((0, "force", "N"), (3, "moment", "N*m")):
                for axis, letter in enumerate(_AXES):
                    text = f"{kind} by the robot on its base, {letter} in the world"
                    yield Output(f"base.{kind}.{letter}", unit, text, Seen.on_base, (first + axis,))

    def _distances(self) -> Iterator[Output]:
        for place, name in enumerate(self._given):
            text = f"of the tip from the {DISTANCES[name]}"
            stored = (name,) if name == DEVIATION else ()
            yield Output(name, "m", f"distance {text}", Seen.apart, (3 * place,), stored)
            for axis, letter in enumerate(_AXES):
                yield Output(f"{name}.{letter}", "m", f"step {text}, {letter}", Seen.step, (3 * place, axis, 1))


_MOTION = {"q": "position", "v": "velocity", "a": "acceleration"}
_DRIVEN = {"effort": "", "voltage": "V", "current": "A"}
_DRIVEN_WORDS = {"effort": "effort of the drive", "voltage": "motor voltage", "current": "motor current"}
_ENERGY = {
    "kinetic": "kinetic", "gravity": "potential", "elastic_gear": "elastic (gears and springs of joints)",
    "elastic_link": "elastic (links)",
}  # fmt: skip
_CONTACT = (
    *((f"force.{axis}", "N", f"force by the point on the surface along {axis}", ("contact_force", axis))
      for axis in _AXES),
    ("force", "N", "normal force on the surface", ("contact_force_normal",)),
    ("penetration", "m", "how far the point is inside of the surface", ("penetration",)),
    ("penetration_rate", "m/s", "rate of the penetration", ()),
)  # fmt: skip
_ACROSS = ("y", "z")
_ALONG = {
    "position": [(axis, "m", f"position along {axis}") for axis in _AXES],
    "deflection": [(f"deflection.{axis}", "m", f"deflection along {axis} of the root") for axis in _ACROSS],
    "slope": [(f"slope.{axis}", "rad", f"slope towards {axis} of the root") for axis in _ACROSS],
    "moment": [("torsion", "N*m", "torsional moment"),
               *((f"moment.{axis}", "N*m", f"bending moment about {axis} of the section") for axis in _ACROSS)],
    "shear": [(f"shear.{axis}", "N", f"shear force along {axis} of the section") for axis in _ACROSS],
    "axial": [("axial", "N", "axial force")],
    "curvature": [(f"curvature.{axis}", "1/m", f"curvature about {axis} of the section") for axis in _ACROSS],
    "twist": [("twist", "rad/m", "twist")], "stretch": [("stretch", "-", "stretch")],
    "strain": [("strain", "-", "largest strain")], "mises_stress": [("stress", "Pa", "largest von Mises stress")],
}  # fmt: skip
