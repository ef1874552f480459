"""Shapers for the motion of a robot: what ``tmodes shaper`` computes and prints."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from tmodes.errors import InputError
from tmodes.interface.files import write_files
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table, known_columns
from tmodes.io.units import finite_number

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes.analysis.modes.along_motion import ModeAlong
    from tmodes.kinds.shapers.registry import Shaper
    from tmodes.sheet import Robot

__all__ = ["Shaping", "middle_modes", "shaper"]

UNITS = {
    "delay_s": "s, by which the motion becomes longer",
    "times_s": "s",
    "amplitudes": "1, of the motion",
    "frequency_Hz": "Hz, natural; lowest and highest along the motion",
    "damping_ratio": "1",
    "residual": "1, vibration of a mode after the motion over that after the unshaped one, by its detuning",
    "detuning": "1, frequency of the mode over that of the shaper, less 1",
    "width": "1, detuning down to and up to which the residual is at most `allowed`",
    "allowed": "1, of the vibration without shaper",
}

DETUNING = 0.3
"""The residual is computed for frequencies that are off by up to this share."""

_STEPS = 61
_WIDE, _FINE = 0.95, 20_000
"""Detuning in which the width is looked for, and at how many places."""

ALLOWED, _NEAR = 0.05, 1.01
"""Residual that the width is measured at, or the one at the frequency itself where that is larger; up to this factor:
with damping EI exceeds what it tolerates by as much close to its frequency."""

_MOST_MODES, _MOST_NUMBER, _MOST_DAMPING = 4, 100, 0.9

Where = Literal["start", "end", "path"]


@checked_arguments
def shaper(
    robot: Robot,
    *,
    kind: str = "zv",
    modes: Sequence[int] = (1,),
    where: Where = "start",
    frequency: Sequence[float | str] = (),
    damping: Sequence[float | str] = (),
    tolerated: float | None = None,
    out: str | os.PathLike[str] | None = None,
    figure: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Shaping:
    """A shaper for the motion of a robot, so that ``modes`` do not ring after it, and the robot with its moves shaped.

    ``kind``: zv, zvd, zvdd, ei, or one of your own; ``modes``: numbers, from 1 on by rising frequency, of those of the
    robot as it is known, under its controllers, or with motors locked where none has any; ``where``: in the pose in
    which its motion starts, in which it ends, or all along its path: then for the middle between the lowest and the
    highest frequency. ``frequency`` [Hz, natural] and ``damping`` (ratios) in their place, one for each mode;
    ``tolerated``: vibration that `ei` leaves at its frequency (0.05). ``out``: a file for the shaped robot's sheet;
    ``figure``: one for the residual over detuning, .svg, .png or .pdf.

    Raises :class:`tmodes.errors.InputError` for wrong numbers, unknown kinds, and modes that the robot does not have,
    :class:`tmodes.errors.SimulationError` where it finds no rest, and :class:`tmodes.errors.ResultFileError` where a
    file cannot be written. Source: N. C. Singer, W. P. Seering, Preshaping command inputs to reduce system vibration,
    ASME J. Dynamic Systems, Measurement, and Control 112 (1990).

    >>> shaped = tmodes.load("spong1987").shaper(kind="zv")
    >>> round(shaped.delay, 4), shaped.residual(1.1).round(3)
    (0.4013, array([0.095]))
    >>> shaped.robot.drives[0].signal.type
    'shaped'
    """
    given = _given(kind, frequency, damping, tolerated)
    along: list[ModeAlong] = []
    robot = robot.commanded(progress)
    if not frequency:
        numbers, along = middle_modes(robot, modes, where, progress)
        given |= numbers
    found = Shaping(robot, _shaped(robot, given), _member(given), tuple(along), where)
    write_files(out, found, figure, overwrite=overwrite)
    return found


def _given(kind: str, frequency: Sequence[Any], damping: Sequence[Any], tolerated: float | None) -> dict[str, Any]:
    """Plain data of a shaper, as far as it is given, checked."""
    from tmodes.kinds.shapers.registry import SHAPERS

    found: dict[str, Any] = {"type": kind}
    fields = SHAPERS[kind].model_fields
    if tolerated is not None:
        if "tolerated" not in fields or not 0 < tolerated <= 0.5:
            expected = "above 0 and at most 0.5, with a kind that tolerates vibration"
            raise InputError("--tolerated", repr(tolerated), expected, "leave it out, or take --kind ei")
        found["tolerated"] = tolerated
    if len(frequency) > _MOST_MODES or len(damping) not in (0, len(frequency)):
        got = f"{len(frequency)} frequencies and {len(damping)} damping ratios"
        expected = f"at most {_MOST_MODES} frequencies, and none or as many ratios"
        raise InputError("--frequency", got, expected, "give one ratio for each frequency")
    found["frequencies"] = [finite_number("--frequency", one, "Hz", "a frequency > 0", most=1e12) for one in frequency]
    found["damping"] = [finite_number("--damping", one, "-", "a ratio from 0 to 0.9", most=0.9) for one in damping]
    if any(one < 1e-3 for one in found["frequencies"]) or any(one < 0 for one in found["damping"]):
        got = ", ".join(f"{one:g}" for one in (*found["frequencies"], *found["damping"]))
        raise InputError("--frequency", got, "at least 0.001 Hz, ratios from 0 to 0.9", "check their units and signs")
    return found


def _along(robot: Robot, modes: Sequence[int], where: str, progress: Callable[[str, float], None]) -> list[ModeAlong]:
    from tmodes.analysis.modes.along_motion import commanded_poses, modes_along

    numbers = tuple(modes)
    if not 1 <= len(set(numbers)) == len(numbers) <= _MOST_MODES or not all(1 <= k <= _MOST_NUMBER for k in numbers):
        expected = f"up to {_MOST_MODES} different numbers from 1 to {_MOST_NUMBER}"
        raise InputError("--modes", ", ".join(map(str, numbers[:9])) or "none", expected, "`tmodes modes` lists them")
    poses = [held for _, held in commanded_poses(robot, *([1] if where == "start" else []))]
    return modes_along(robot, numbers, poses[-1:] if where == "end" else poses, progress)


def middle_modes(
    robot: Robot, modes: Sequence[int], where: str, progress: Callable[[str, float], None] = lambda stage, share: None
) -> tuple[dict[str, Any], list[ModeAlong]]:
    """Frequencies [Hz] and damping of a shaper, in the middle between lowest and highest of each mode; and these."""
    along = _along(robot, modes, where, progress)
    pairs = [[float(values.min() + values.max()) / 2 for values in (one.frequency, one.damping)] for one in along]
    return {"frequencies": [one for one, _ in pairs], "damping": [min(one, _MOST_DAMPING) for _, one in pairs]}, along


def _member(given: dict[str, Any]) -> Shaper:
    from tmodes.kinds.shapers.registry import Shaper

    found = Shaper.of(given)
    found.impulses()  # raises where there are none
    return found


def _shaped(robot: Robot, given: dict[str, Any]) -> Robot:
    """The robot with the signals of all drives that move shaped; one that was shaped gets this shaper."""
    from tmodes.io.sheet_check import sheet_data

    changes = {}
    for k, (drive, data) in enumerate(zip(robot.drives, sheet_data(robot).get("drives", ()), strict=True)):
        if drive.signal.is_steady:
            continue
        plain = data["signal"]
        inner = plain["signal"] if plain["type"] == "shaped" else plain
        changes[f"drives.{k}.signal"] = {"type": "shaped", "signal": inner, "shaper": given}
    return robot.with_(changes) if changes else robot


@dataclass(frozen=True, eq=False, repr=False)
class Shaping(CommandResult):
    """A ``shaper``, and the ``robot`` whose moves go through it; ``along``: the modes that it was made for, by pose."""

    given: Robot = field(repr=False)
    robot: Any = field(repr=False)
    shaper: Shaper
    along: tuple[ModeAlong, ...]
    where: str

    @property
    def delay(self) -> float:
        """By how much the motion becomes longer [s]: the time of the last impulse."""
        return float(self.shaper.delay)

    @property
    def sheet(self) -> str:
        """The data sheet of the shaped robot, as YAML."""
        from tmodes.io.sheet_write import robot_to_yaml

        return robot_to_yaml(self.robot)

    @property
    def impulses(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Times (n,) [s], rising, and amplitudes (n,) [-] of the copies of the motion."""
        import numpy as np

        times, amplitudes = self.shaper.impulses()
        order = np.argsort(times, kind="stable")
        return times[order], amplitudes[order]

    @property
    def _ratios(self) -> tuple[float, ...]:
        return self.shaper.damping or (0.0,) * len(self.shaper.frequencies)

    def residual(self, ratio: float | NDArray[np.float64] = 1.0) -> NDArray[np.float64]:
        """Vibration that is left of each mode (modes, *shape of the ratio), over that without shaper [-].

        ``ratio``: frequency of the mode over that which the shaper is made for.
        """
        import numpy as np

        from tmodes.kinds.shapers.registry import residual

        pairs = zip(self.shaper.frequencies, self._ratios, strict=True)
        return np.stack([residual(self.impulses, frequency * np.asarray(ratio), ratio_) for frequency, ratio_ in pairs])

    @property
    def allowed(self) -> float:
        """The residual at which widths are measured: 5 %, or more where `ei` tolerates more."""
        return max(ALLOWED, round(float(self.residual().max()), 12))

    @property
    def widths(self) -> list[tuple[float, float]]:
        """Of each mode, by which share its frequency may be lower and higher with a residual of at most ``allowed``."""
        import numpy as np

        detuning = np.linspace(-_WIDE, _WIDE, 2 * _FINE + 1)
        found = []
        for left in self.residual(1 + detuning):
            fits = left <= _NEAR * self.allowed
            low, high = fits[: _FINE + 1][::-1], fits[_FINE:]
            ends = [int(np.argmin(side)) if not side.all() else len(side) for side in (low, high)]
            found.append((-detuning[_FINE + max(ends[0] - 1, 0)], detuning[_FINE + max(ends[1] - 1, 0)]))
        return [(float(low), float(high)) for low, high in found]

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes shaper --json`` prints it."""
        data, (times, amplitudes) = self.data, self.impulses
        return {
            "robot": self.given.name, "units": UNITS, "shaper": self.shaper.model_dump(mode="json"),
            "where": self.where if self.along else "given", "delay_s": self.delay,
            "times_s": times.tolist(), "amplitudes": amplitudes.tolist(),
            "modes": [
                {"mode": one.number, "element": one.element,
                 "frequency_Hz": [float(one.frequency.min()), float(one.frequency.max())],
                 "damping_ratio": [float(one.damping.min()), float(one.damping.max())]}
                for one in self.along
            ],
            "detuning": data.detuning.values.tolist(), "residual": data.residual.values.tolist(),
            "width": [list(one) for one in self.widths], "allowed": self.allowed,
        }  # fmt: skip

    @property
    def data(self) -> Dataset:
        """``amplitude`` (impulse) at ``time`` [s]; ``residual`` (mode, detuning) [-], ``frequency`` (mode) [Hz]."""
        import numpy as np
        from xarray import Dataset

        detuning = np.linspace(-DETUNING, DETUNING, _STEPS)
        times, amplitudes = self.impulses
        return Dataset(
            {"amplitude": ("impulse", amplitudes, {"units": "1"}),
             "residual": (("mode", "detuning"), self.residual(1 + detuning), {"units": "1"}),
             "frequency": ("mode", list(self.shaper.frequencies), {"units": "Hz"})},
            {"time": ("impulse", times, {"units": "s"}), "mode": self._numbers, "detuning": detuning},
        )  # fmt: skip

    @property
    def _numbers(self) -> list[int]:
        return [one.number for one in self.along] or [*range(1, 1 + len(self.shaper.frequencies))]

    def plot(self, ax: Any = None) -> list[Any]:
        """The residual of each mode over its detuning [%], and that at which the width is measured."""
        from tmodes.plot.commands import points

        data = self.data
        across = 100 * data.detuning.values
        shown = {
            f"mode {number}, {frequency:.3g} Hz": (across, 100 * left)
            for number, frequency, left in zip(
                self._numbers, self.shaper.frequencies, data.residual.values, strict=True
            )
        }
        shown |= {f"allowed, {self.allowed:.0%}": (across[[0, -1]], [100 * self.allowed] * 2)}
        title = f"{self.given.name}: {self.shaper.name_of_kind()}, {self.delay:.3g} s longer"
        return points(shown, "frequency of the mode off that of the shaper [%]", "vibration left [%]", title=title,
                      ax=ax, line="-", marks=False)  # fmt: skip

    def tables(self) -> Iterator[str | Table]:
        """The shaper and its delay, the modes it is made for, impulses, and what is left off their frequencies."""
        import numpy as np

        name, (times, amplitudes) = self.shaper.name_of_kind(), self.impulses
        yield f"{self.given.name}: shaper {name}, the motion becomes {self.delay:.4g} s longer"
        rows = []
        for k, (frequency, ratio) in enumerate(zip(self.shaper.frequencies, self._ratios, strict=True)):
            (low, high), left = self.widths[k], self.residual(np.array(_DETUNED) + 1)[k]
            own = self.along[k] if self.along else None
            span = f"{own.frequency.min():.4g} to {own.frequency.max():.4g}" if own and len(own.frequency) > 1 else "-"
            rows.append([str(self._numbers[k]), own.element if own else "given", f"{frequency:.4g}", f"{ratio:.4f}",
                         span, *(f"{100 * one:.1f}" for one in left), f"{low:+.1%} to {high:+.1%}"])  # fmt: skip
        columns = ["mode", "element", "f [Hz]", "damping", "on the way",
                   *(f"{one:+.0%}" if one else "at it" for one in _DETUNED),
                   f"{self.allowed:.0%} from, to"]  # fmt: skip
        where = {"path": "on the way of the motion", "end": "at its end"}.get(self.where, "at its start")
        off = f"Vibration left [%] where a mode is off in frequency{', modes ' + where if self.along else ''}"
        yield known_columns(off, columns, rows)
        impulses = [[f"{time:.6g}", f"{size:.6g}"] for time, size in zip(times, amplitudes, strict=True)]
        yield Table("Copies of the motion", ["after [s]", "share"], impulses)


_DETUNED = (-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3)
