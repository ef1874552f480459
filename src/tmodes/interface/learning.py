"""Iterative learning over repeated runs: what ``tmodes learn`` computes and prints."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.interface.files import write_files
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes.sheet import Robot

    Array = NDArray[np.float64]

__all__ = ["Learning", "learn"]

_FINE = 4
"""Steps of the response between two corrections."""

_BACK = 3.0
"""By how much the caution grows where a correction made the error larger."""

_START = 0.1
"""Share of the run that counts as its start."""

_MOST = {"iterations": (1, 100), "samples": (10, 1000)}


@checked_arguments
def learn(
    robot: Robot,
    *,
    iterations: int = 5,
    samples: int = 200,
    caution: float = 0.03,
    out: str | os.PathLike[str] | None = None,
    figure: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Learning:
    """The same move again and again, its setpoints corrected after each run until the joints follow the signals.

    Each of the ``iterations`` runs the robot as it really is, and corrects the setpoints of all drives under position
    control at ``samples`` instants, all but the first, where the run starts, by the inverse of the closed loop of the
    robot as known, linear about its start: r + (G'G + s)^-1 G' e, e: signal less position of the joint, behind its
    gear. s is the square of ``caution`` times the largest gain of G: the larger, the slower, and the more the robot may
    differ from the one known. A correction with which the error grows is undone, and ``caution`` tripled; the setpoints
    of the best run are kept. ``out``: a file for the sheet with them; ``figure``: one for the errors, .svg, .png or
    .pdf.

    Raises :class:`tmodes.errors.InputError` for numbers out of bounds and robots without such drives,
    :class:`tmodes.errors.SimulationError` where a run does not end, and :class:`tmodes.errors.ResultFileError` where a
    file cannot be written. Source: N. Amann, D. H. Owens, E. Rogers, Iterative learning control using optimal feedback
    and feedforward actions, Int. J. Control 65 (1996).

    >>> learnt = tmodes.load("spong1987").learn(iterations=3)
    >>> bool(learnt.rms[3] < 0.05 * learnt.rms[0])
    True
    """
    import numpy as np

    robot = robot.commanded(progress)
    for name, value in (("iterations", iterations), ("samples", samples)):
        low, high = _MOST[name]
        if not low <= value <= high:
            raise InputError(f"--{name}", f"{value}", f"a number from {low} to {high}", "choose one of these")
    if not 1e-6 <= caution <= 10:
        raise InputError("--caution", f"{caution:g}", "a number from 1e-6 to 10", "0.03 is usual")
    places = [k for k, drive in enumerate(robot.drives) if drive.command.is_controlled]
    if not places:
        expected = "a drive with `command: position`, whose setpoint is learnt"
        raise InputError("drives", "none under position control", expected, "give one a controller")
    times = np.linspace(0.0, robot.integration.duration, samples + 1)
    progress("linear model", 0.0)
    gain = _lifted(robot, [robot.drives[k].joint for k in places], times)
    left, sizes, right = np.linalg.svd(gain, full_matrices=False)
    added, tried, found = np.zeros((len(places), samples + 1)), robot, [_errors(robot, robot, places, times)]
    kept, cautions = [(added, robot, found[0])], [caution]
    for k in range(iterations):
        progress("runs", (k + 1) / (iterations + 1))
        change = right.T @ (sizes / (sizes**2 + (cautions[-1] * sizes[0]) ** 2) * (left.T @ kept[-1][2].ravel()))
        added = kept[-1][0].copy()
        added[:, 1:] += change.reshape(len(places), samples)
        tried = _corrected(robot, places, times, added)
        found.append(_errors(tried, robot, places, times))
        better = bool(np.linalg.norm(found[-1]) < np.linalg.norm(kept[-1][2]))
        kept += [(added, tried, found[-1])] if better else []
        cautions.append(cautions[-1] * (1 if better else _BACK))
    learnt = Learning(robot, kept[-1][1], tuple(robot.drives[k].joint for k in places), times, kept[-1][0],
                      np.stack(found), np.array([caution, *cautions[:-1]]))  # fmt: skip
    write_files(out, learnt, figure, overwrite=overwrite)
    return learnt


def _lifted(robot: Robot, joints: list[str], times: Array) -> Array:
    """Positions of the joints at ``times`` by corrections at all but the first of them, joint by joint.

    Corrections are clamped cubic splines, to the response as lines between the samples.
    """
    import numpy as np
    from scipy.interpolate import CubicSpline
    from scipy.signal import cont2discrete

    from tmodes import linearize

    fine = np.linspace(0.0, times[-1], _FINE * (len(times) - 1) + 1)
    inputs = [f"{joint}.{kind}" for joint in joints for kind in ("setpoint", "setpoint_rate")]
    plant = linearize(robot, closed=True, inputs=inputs, outputs=[f"{joint}.position" for joint in joints])
    found: Any = cont2discrete((plant.A, plant.B, plant.C, plant.D), fine[1], "foh")
    A, B, C, D, _ = found
    free, answers = B, [D]
    for _ in fine[1:]:
        answers.append(C @ free)
        free = A @ free
    pulses = np.stack(answers)  # (times, joints, inputs)
    late = _FINE * np.arange(len(times))[:, None] - np.arange(len(fine))[None]
    placed = np.where((late >= 0)[:, :, None, None], pulses[np.maximum(late, 0)], 0.0)
    basis = CubicSpline(times, np.eye(len(times)), bc_type="clamped")
    values, slopes = basis(fine), basis(fine, 1)
    blocks = [[placed[:, :, i, 2 * j] @ values + placed[:, :, i, 2 * j + 1] @ slopes for j in range(len(joints))]
              for i in range(len(joints))]  # fmt: skip
    return np.block([[block[:, 1:] for block in row] for row in blocks])


def _errors(tried: Robot, robot: Robot, places: list[int], times: Array) -> Array:
    """Signals of the sheet less positions of the joints (joints, times), of a run of the robot with other setpoints."""
    import numpy as np
    from scipy.interpolate import CubicSpline

    from tmodes.errors import SimulationError
    from tmodes.simulation.simulate import simulate_motion

    done, names = simulate_motion(tried.pair()), tried.undriven.chain().coordinates
    ran = done.times
    if ran[-1] < times[-1] * (1 - 1e-9):
        raise SimulationError(f"a run with learnt setpoints ended at {ran[-1]:.4g} s; take a larger `caution`")
    drives = [robot.drives[k] for k in places]
    wanted = [drive.signal.schedule(times[-1]) for drive in drives]
    found = [CubicSpline(ran, done.q[:, names.index(drive.joint)])(times) for drive in drives]
    return np.array([[one.at(t) for t in times] for one in wanted]) - np.array(found)


def _corrected(robot: Robot, places: list[int], times: Array, added: Array) -> Robot:
    """The robot with corrections (joints, times) added to its setpoints."""
    from tmodes.io.sheet_check import sheet_data

    plain, changes = sheet_data(robot)["drives"], {}
    for k, values in zip(places, added, strict=True):
        table = {"type": "table", "interpolation": "cubic", "times": times.tolist(), "values": values.tolist()}
        changes[f"drives.{k}.signal"] = {"type": "sum", "signals": [plain[k]["signal"], table]}
    return robot.with_(changes)


@dataclass(frozen=True, eq=False, repr=False)
class Learning(CommandResult):
    """The ``robot`` with the setpoints of the best run: ``added`` (joints, times) [rad, m].

    ``errors`` (runs, joints, times) of all runs; ``cautions`` (runs,) with which their setpoints were found.
    """

    given: Robot = field(repr=False)
    robot: Any = field(repr=False)
    joints: tuple[str, ...]
    times: Array
    added: Array
    errors: Array
    cautions: Array

    @property
    def best(self) -> int:
        """The run whose setpoints are kept."""
        return int(self.rms.argmin())

    @property
    def rms(self) -> Array:
        """Root mean square of the errors of all joints [rad, m], one of each run; the first is without correction."""
        import numpy as np

        return np.sqrt(np.mean(self.errors**2, axis=(1, 2)))

    @property
    def sheet(self) -> str:
        """The data sheet of the robot with learnt setpoints, as YAML."""
        from tmodes.io.sheet_write import robot_to_yaml

        return robot_to_yaml(self.robot)

    @property
    def data(self) -> Dataset:
        """``error`` (run, joint, time), ``correction`` (joint, time) [rad, m], ``rms`` (run)."""
        from xarray import Dataset

        unit = {"units": "rad or m"}
        return Dataset(
            {"error": (("run", "joint", "time"), self.errors, unit), "rms": ("run", self.rms, unit),
             "correction": (("joint", "time"), self.added, unit)},
            {"run": range(len(self.errors)), "joint": list(self.joints), "time": ("time", self.times, {"units": "s"})},
        )  # fmt: skip

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes learn --json`` prints it."""
        largest = abs(self.errors).max(axis=2)
        return {
            "robot": self.given.name, "joints": list(self.joints), "rms": self.rms.tolist(),
            "best": self.best,
            "caution": self.cautions.tolist(), "largest": largest.tolist(), "time_s": self.times.tolist(),
            "correction": self.added.tolist(),
            "units": {"rms": "rad or m, of all joints, by run", "largest": "rad or m, by run and joint",
                      "correction": "rad or m, added to the setpoint of each joint"},
        }  # fmt: skip

    def plot(self, ax: Any = None) -> list[Any]:
        """The root mean square of the error of each joint by run; the largest may be that of the start, which stays."""
        import numpy as np

        from tmodes.plot.commands import points

        rms, runs = np.sqrt(np.mean(self.errors**2, axis=2)), np.arange(len(self.errors))
        shown = {joint: (runs, rms[:, k]) for k, joint in enumerate(self.joints)}
        title = f"{self.given.name}: learning over {len(runs) - 1} runs"
        return points(shown, "run", "rms error of the joint [rad or m]", title=title, ax=ax, line="-", log=True)

    def tables(self) -> Iterator[str | Table]:
        """The errors of each run."""
        share, count = self.rms[self.best] / self.rms[0], len(self.errors)
        yield f"{self.given.name}: rms error {share:.3g} of the first by setpoints of run {self.best} of {count - 1}"
        if self.cautions[-1] > self.cautions[0]:
            yield "Corrections that made the error larger were undone: this robot differs much from the one known."
        largest = abs(self.errors).max(axis=2)
        when = float(self.times[abs(self.errors[self.best]).max(axis=0).argmax()])
        if when < _START * self.times[-1]:
            yield f"The largest error is that of the start, where the robot sags at rest (at {when:.3g} s)."
        columns = zip(self.cautions, self.rms, largest, strict=True)
        rows = [[str(k), f"{caution:.2g}", f"{rms:.4g}", *(f"{one:.4g}" for one in most)]
                for k, (caution, rms, most) in enumerate(columns)]  # fmt: skip
        heads = ["run", "caution", "rms of all", *(f"largest, {joint}" for joint in self.joints)]
        yield Table("Signal less position of the joints [rad or m]", heads, rows)
