"""Vibrations of a robot: what ``tmodes modes`` computes and prints."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.interface.poses import Pose, pose_of, pose_words
from tmodes.interface.statics import circumstances, link_table, which_robot
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.analysis.modes.of_sheet import Vibrations
    from tmodes.sheet import Robot

__all__ = ["Modes", "modes"]

_MOST_ANGLE = 1000.0

_UNITS = {
    "frequency_Hz": "Hz, natural: |pole|/2 pi; 0: it does not ring",
    "damped_frequency_Hz": "Hz, imaginary part of the pole over 2 pi; null: it does not ring",
    "undamped_frequency_Hz": "Hz, of mass and stiffness alone; null: second motion of an over-damped mode",
    "time_constant_s": "s, -1/pole of what decays without ringing, two of an over-damped mode; null: it rings",
    "damping_ratio": "1, -real part of the pole over its size",
    "pole": "1/s, real and imaginary part: the eigenvalue of mass, damping, stiffness and controllers",
    "share": "1",
    "growth_time_s": "s, in which an unstable mode grows by the factor e",
    "frequency_error": "1, undamped frequency over that with four more functions a direction, less 1; null: not known",
    "angle_rad": "rad",
    "poles": "1/s, real and imaginary part, of all eigenvalues under control",
    "missing_share": "1, of the energy of bending, in shapes that the link's functions do not have",
}

_MOTOR = {"locked": "motor locked", "free": "motor free (no current)", "controlled": "motor under control"}


@checked_arguments
def modes(
    robot: Robot,
    *,
    contact: bool = False,
    angle: float | None = None,
    at: Pose | None = None,
    max_frequency: float = math.inf,
    reading: str | None = None,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Modes:
    """Frequencies and damping about the static equilibrium, of the actual robot and of the nominal one.

    Under its loads, its motors at their first command, at a pose ``at`` [rad, m], or the first drive's motor at
    ``angle`` [rad]; ``contact``: with the tip on the environment; ``max_frequency`` [Hz]: the highest one that is kept;
    ``reading``: of a sheet of the 2010 robot. Of drives and a base at constant speed about that motion. All numbers are
    of the pole p, an eigenvalue of mass, damping, stiffness and controllers: natural frequency abs(p)/2 pi, damped
    Im p/2 pi, damping ratio -Re p/abs(p).

    Raises :class:`tmodes.errors.InputError` for a pose, an angle or a contact that the robot does not have, and
    :class:`tmodes.errors.SimulationError` where it finds no rest. Source: L. Meirovitch, Fundamentals of Vibrations
    (2001), ch. 7.

    >>> vibrations = tmodes.load("spong1987").modes()
    >>> [round(mode["frequency_Hz"], 3) for mode in vibrations.states["locked"]]
    [1.668]
    """
    from tmodes.analysis.modes.of_sheet import vibrations

    asked = _asked(robot if reading is None else robot.with_({"reading": reading}), contact, angle)
    if not max_frequency > 0:
        raise InputError("--max-frequency", repr(max_frequency), "a frequency > 0 Hz", "give it in Hz, or leave it out")
    pair, held = asked.pair(), pose_of(at, asked)
    robots = {"real": pair.real} | ({"nominal": pair.nominal} if asked.real else {})
    found = {
        kind: _up_to(vibrations(one, contact=contact, held=held, progress=progress), max_frequency)
        for kind, one in robots.items()
    }
    return Modes(robots, found, contact, pose_words(at))


@dataclass(frozen=True, eq=False, repr=False)
class Modes(CommandResult):
    """Modes of vibration of the ``real`` robot, and of the ``nominal`` one where its numbers are others.

    ``found``: by robot, modes by what its motors do (``locked``, ``free``, ``controlled``), links and warnings.
    """

    robots: Mapping[str, Robot] = field(repr=False)
    found: Mapping[str, Vibrations]
    contact: bool = False
    at: str | None = None

    @property
    def states(self) -> dict[str, list[dict[str, Any]]]:
        """Modes of the real robot, by what its motors do, each as plain data with units in the names."""
        return self.found["real"].states

    @property
    def warnings(self) -> list[str]:
        """What is to be known about these numbers."""
        found = [warning for one in self.found.values() for warning in one.warnings]
        return list(dict.fromkeys(found))

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes modes --json`` prints it."""
        known = self.robots.get("nominal", self.robots["real"])
        states = {kind: one.states for kind, one in self.found.items()}
        links, warnings = ({kind: one[k] for kind, one in self.found.items()} for k in (1, 2))
        head = {"robot": known.name, "equations": known.equations, "contact": self.contact, "units": _UNITS}
        poles = {kind: one.poles for kind, one in self.found.items()}
        return {**head, **states, "poles": poles, "links": links, "warnings": warnings}

    @property
    def data(self) -> Dataset:
        """Along ``mode``: frequency and ``damped_frequency`` [Hz], ``damping_ratio``, ``pole`` [1/s], ``shape``.

        As coordinates which robot, what its motors do, and the dominant element.
        """
        from xarray import Dataset

        rows = [(kind, state, one) for kind, state, modes in self._each() for one in modes]
        names = list(next((one["shape"] for *_, one in rows), {}))

        def column(key: str) -> list[float]:
            return [math.nan if one[key] is None else one[key] for *_, one in rows]

        words = {name: ("mode", [str(row[k]) for row in rows]) for k, name in enumerate(("robot", "motors"))}
        words |= {"element": ("mode", [one["element"] for *_, one in rows])}
        shapes = [[one["shape"].get(name, math.nan) for name in names] for *_, one in rows]
        return Dataset(
            {
                "frequency": ("mode", column("frequency_Hz"), {"units": "Hz"}),
                "damped_frequency": ("mode", column("damped_frequency_Hz"), {"units": "Hz"}),
                "damping_ratio": ("mode", column("damping_ratio"), {"units": "1"}),
                "pole": ("mode", [complex(*one["pole"]) for *_, one in rows], {"units": "1/s"}),
                "shape": (("mode", "coordinate"), shapes),
            },
            {**words, "coordinate": names},
        )  # fmt: skip

    def _each(self) -> Iterator[tuple[str, str, list[dict[str, Any]]]]:
        for kind, one in self.found.items():
            for state, modes in one.states.items():
                yield kind, state, modes

    def plot(self, ax: Any = None) -> list[Any]:
        """Damping ratio over natural frequency, for each thing that the motors may do."""
        from tmodes.plot.commands import points

        shown = {
            f"{kind}, motors {state}": ([one["frequency_Hz"] for one in modes], [one["damping_ratio"] for one in modes])
            for kind, state, modes in self._each()
        }
        return points(shown, "natural frequency [Hz]", "damping ratio", title=self.robots["real"].name, ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """A table for each robot and each thing that its motors may do, and whether the links' models hold."""
        for kind, one in self.found.items():
            robot = self.robots[kind]
            whose = ", actual robot" if kind == "real" and len(self.found) > 1 else which_robot(robot)
            where = circumstances(robot, contact=self.contact, at=self.at)
            for state, modes in one.states.items():
                if modes:
                    motor = _MOTOR[state] if one.motors else "no motor"
                    yield Table(f"{robot.name}{whose}, {motor}, {where}", _COLUMNS, [_row(mode) for mode in modes])
            yield from link_table(one.links)


_COLUMNS = "dominant element", "share of energy", "natural [Hz]", "damped [Hz]", "damping ratio", "converged"


def _up_to(found: Vibrations, highest: float) -> Vibrations:
    """Without modes of a higher frequency [Hz]."""
    states = {state: [row for row in rows if row["frequency_Hz"] <= highest] for state, rows in found.states.items()}
    return found._replace(states=states)


def _asked(sheet: Robot, contact: bool, angle: float | None) -> Robot:
    """The robot in contact or not, its first motor at an angle [rad]."""
    if angle is not None:
        if not abs(angle) <= _MOST_ANGLE:
            expected = f"an angle between -{_MOST_ANGLE:g} and {_MOST_ANGLE:g} rad"
            raise InputError("--angle", repr(angle), expected, "give the motor's angle in radians, or leave it out")
        if len(sheet.drives) != 1:
            hint = "set the start of its drives: --set drives.0.signal.start=0.5"
            raise InputError("--angle", repr(angle), "left out where the robot has not exactly one drive", hint)
        held = {"joint": sheet.drives[0].joint, "command": "prescribed"}
        held |= {"signal": {"type": "constant", "value": angle}}
        sheet = sheet.with_({"drives": [held], "control": []})
    if contact and sheet.contact_off:
        sheet = sheet.with_({"contact": True})
    if contact and sheet.contact is None:
        raise InputError(
            "--contact", "a robot that touches nothing", "given for a robot with a contact", "leave --contact out"
        )
    return sheet


def _row(line: dict[str, Any]) -> list[str]:
    growth, damped, error = line["growth_time_s"], line["damped_frequency_Hz"], line["frequency_error"]
    decay = line["time_constant_s"]
    checked = "-" if error is None else "yes" if line["converged"] else f"! {error:+.1%}"
    ringing = "-" if damped is None else f"{damped:.4g}"
    ratio = f"{round(line['damping_ratio'], 4) + 0.0:.4f}" if growth is None else f"grows by e in {growth:.3g} s"
    ratio = ratio if decay is None else f"no vibration, decays in {decay:.3g} s"
    natural = f"{line['frequency_Hz']:.4g}" if damped or (growth is None and decay is None) else "-"
    return [line["element"] + ("" if line["stable"] else " (UNSTABLE)"), f"{line['share']:.0%}", natural, ringing,
            ratio, checked]  # fmt: skip
