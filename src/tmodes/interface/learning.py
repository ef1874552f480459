"""Iterative learning over repeated runs: what ``tmodes learn`` computes and prints."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from math import ceil
from typing import TYPE_CHECKING, Any, NamedTuple

from tmodes.errors import InputError
from tmodes.interface.files import write_files
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes.sheet import Robot
    from tmodes.simulation.motion_run import RunData

    Array = NDArray[np.float64]

__all__ = ["Learning", "learn"]

_FINE = 4
"""Steps of the response between two corrections."""

_BACK = 3.0
"""By how much the caution grows where a correction made the error larger."""

_START = 0.1
"""Share of the run that counts as its start, over which an error that it begins with is taken back."""

_LEVER = 1e-3
"""Share of the largest lever of the joints on the tip below which a direction of the tip is not theirs to correct."""

_MOST = {"iterations": (1, 100), "samples": (10, 1000)}


@checked_arguments
def learn(
    robot: Robot,
    *,
    iterations: int = 5,
    samples: int = 200,
    caution: float = 0.03,
    by: str = "joints",
    out: str | os.PathLike[str] | None = None,
    figure: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Learning:
    """The same move again and again, its setpoints corrected after each run until joints or tip are where they should.

    Each of the ``iterations`` runs the robot as it really is, and corrects the setpoints of all drives under position
    control at ``samples`` instants, all but the first, where the run starts, by the inverse of the closed loop of the
    robot as known, linear about its start: r + (G'G + s)^-1 G' e, e: signal less position of the joint, behind its
    gear; ``by`` the tip, with what links bend: its commanded path less where it is, through the pseudo-inverse of the
    Jacobian of the undeformed robot as known, there and in G. s is the square of ``caution`` times the largest gain of
    G: the larger, the slower, and the more the robot may differ from the one known. A correction with which the error
    grows is undone, and ``caution`` tripled; the setpoints of the best run are kept. What is off at the start, as by
    the sag at rest, is taken back over the first tenth of the run: the setpoints do not jump. ``out``: a file for the
    sheet with them; ``figure``: one for the errors, .svg, .png or .pdf.

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
    if by not in ("joints", "tip"):
        raise InputError("--by", f"`{by}`", "joints or tip", "choose one of these")
    if not 1e-6 <= caution <= 10:
        raise InputError("--caution", f"{caution:g}", "a number from 1e-6 to 10", "0.03 is usual")
    places = [k for k, drive in enumerate(robot.drives) if drive.command.is_controlled]
    if not places:
        expected = "a drive with `command: position`, whose setpoint is learnt"
        raise InputError("drives", "none under position control", expected, "give one a controller")
    times = np.linspace(0.0, robot.integration.duration, samples + 1)
    joints = [robot.drives[k].joint for k in places]
    progress("linear model", 0.0)
    aim, first = _aimed(robot, places, times, by)
    left, sizes, right = np.linalg.svd(_lifted(robot, places, times, aim), full_matrices=False)
    added, tried, found = np.zeros((len(places), samples + 1)), robot, [aim.errors(first)]
    kept, cautions = [(added, robot, found[0])], [caution]
    start = np.cos(np.pi / 2 * np.minimum(times / (_START * times[-1]), 1)) ** 2
    for k in range(iterations):
        progress("runs", (k + 1) / (iterations + 1))
        off = np.einsum("tjk,kt->jt", aim.turn, kept[-1][2] - kept[-1][2][:, :1] * start)
        change = right.T @ (sizes / (sizes**2 + (cautions[-1] * sizes[0]) ** 2) * (left.T @ off.ravel()))
        added = kept[-1][0].copy()
        added[:, 1:] += change.reshape(len(places), samples)
        tried = _corrected(robot, places, times, added)
        found.append(aim.errors(_ran(tried, times[-1])))
        better = bool(np.linalg.norm(found[-1]) < np.linalg.norm(kept[-1][2]))
        kept += [(added, tried, found[-1])] if better else []
        cautions.append(cautions[-1] * (1 if better else _BACK))
    learnt = Learning(robot, kept[-1][1], tuple(joints), times, kept[-1][0], np.stack(found),
                      np.array([caution, *cautions[:-1]]), aim.names)  # fmt: skip
    write_files(out, learnt, figure, overwrite=overwrite)
    return learnt


class _Aim(NamedTuple):
    """What shall be where: outputs by ``names``, where they are ``wanted`` (outputs, times), and ``at`` of a run.

    ``turn`` (times, joints, outputs): from their errors to those of the joints.
    """

    names: tuple[str, ...]
    times: Array
    wanted: Array
    turn: Array
    at: Callable[[RunData], Array]

    def errors(self, done: RunData) -> Array:
        """What is wanted less what is (outputs, times)."""
        from scipy.interpolate import CubicSpline

        return self.wanted - CubicSpline(done.times, self.at(done), axis=1)(self.times)


def _aimed(robot: Robot, places: list[int], times: Array, by: str) -> tuple[_Aim, RunData]:
    """Of the joints the signals of the sheet, of the tip its commanded path; and the run without correction."""
    import numpy as np
    from scipy.interpolate import CubicSpline

    from tmodes.result.paths import error_parts, shapes_of

    first, drives = _ran(robot, times[-1]), [robot.drives[k] for k in places]
    if by == "joints":
        signals = [(one.motion or one.signal).schedule(times[-1]) for one in drives]
        own = [first.coordinates.index(one.joint) for one in drives]
        wanted = np.array([[one.at(t) for t in times] for one in signals])
        turn = np.broadcast_to(np.eye(len(own)), (len(times), len(own), len(own)))
        names = tuple(f"{one.joint}.position" for one in drives)
        return _Aim(names, times, wanted, turn, lambda done: done.q[:, own].T), first
    parts, known = error_parts(first, len(first.times)), first.reference or first
    own = [known.coordinates.index(one.joint) for one in drives]
    straight = CubicSpline(first.times, shapes_of(known, first, slice(len(first.times)))[0])(times)
    levers = known.model.jacobian(straight)[:, 0, :3][..., own]
    path = CubicSpline(first.times, parts.commanded if parts else first.points.position[:, 0])(times).T
    turn: Array = np.linalg.pinv(levers, rcond=_LEVER).astype(float)
    if not turn[0].any():
        raise InputError("--by", "the tip, which no joint moves at the start", "joints", "learn by the joints")
    return _Aim(("tip.x", "tip.y", "tip.z"), times, path, turn, lambda done: done.points.position[:, 0].T), first


def _ran(robot: Robot, until: float) -> RunData:
    from tmodes.errors import SimulationError
    from tmodes.simulation.simulate import simulate_motion

    done = simulate_motion(robot.pair())
    if done.times[-1] < until * (1 - 1e-9):
        raise SimulationError(f"a run with learnt setpoints ended at {done.times[-1]:.4g} s; take a larger `caution`")
    return done


def _lifted(robot: Robot, places: list[int], times: Array, aim: _Aim) -> Array:
    """What is to be corrected at all ``times`` but the first, by corrections at these, joint by joint.

    Corrections are clamped cubic splines: to the response as lines between fine steps; to sampled controllers held, as
    they read them, for the common period of their samples.
    """
    import numpy as np
    from scipy.interpolate import CubicSpline
    from scipy.signal import cont2discrete

    from tmodes import linearize

    inputs = [f"{robot.drives[k].joint}.{kind}" for kind in ("setpoint", "setpoint_rate") for k in places]
    smooth = _corrected(robot, places, times, np.zeros((len(places), len(times))))  # with a rate, whatever the signals
    plant = linearize(smooth, closed=True, inputs=inputs, outputs=aim.names)
    step, count = plant.period or times[1] / _FINE, len(places)
    A, B, C, D = plant.A, plant.B, aim.turn[0] @ plant.C, aim.turn[0] @ plant.D
    if not plant.period:
        found: Any = cont2discrete((A, B, C, D), step, "foh")
        A, B, C, D, _ = found
    fine = step * np.arange(ceil(times[-1] / step - 1e-9) + 1)
    basis = CubicSpline(times, np.eye(len(times))[:, 1:], bc_type="clamped")
    pushes = np.stack([basis(np.minimum(fine, times[-1])), basis(np.minimum(fine, times[-1]), 1)], axis=1)
    x = np.zeros((len(A), count * (len(times) - 1)))
    lifted = np.zeros((len(times), count, x.shape[1]))
    for moment, push in zip(fine, pushes, strict=True):
        u = np.concatenate([np.kron(np.eye(count), one) for one in push])
        near = np.maximum(0.0, 1 - np.abs(times - moment) / step)
        lifted[near > 0] += near[near > 0, None, None] * (C @ x + D @ u)
        x = A @ x + B @ u
    return lifted.transpose(1, 0, 2).reshape(-1, x.shape[1])


def _corrected(robot: Robot, places: list[int], times: Array, added: Array) -> Robot:
    """The robot with corrections (joints, times) added to its setpoints, its motion that of before."""
    from tmodes.io.sheet_check import sheet_data

    plain, changes = sheet_data(robot)["drives"], {}
    for k, values in zip(places, added, strict=True):
        table = {"type": "table", "interpolation": "cubic", "times": times.tolist(), "values": values.tolist()}
        changes[f"drives.{k}.signal"] = {"type": "sum", "signals": [plain[k]["signal"], table]}
        changes[f"drives.{k}.motion"] = plain[k].get("motion") or plain[k]["signal"]
    return robot.with_(changes)


@dataclass(frozen=True, eq=False, repr=False)
class Learning(CommandResult):
    """The ``robot`` with the setpoints of the best run: ``added`` (joints, times) [rad, m].

    ``errors`` (runs, outputs, times) of all runs, of the outputs ``names``, positions of joints [rad, m] or of the tip
    [m]; ``cautions`` (runs,) with which their setpoints were found.
    """

    given: Robot = field(repr=False)
    robot: Any = field(repr=False)
    joints: tuple[str, ...]
    times: Array
    added: Array
    errors: Array
    cautions: Array
    names: tuple[str, ...]

    @property
    def by_tip(self) -> bool:
        """Whether errors are those of the tip."""
        return self.names[0] == "tip.x"

    @property
    def best(self) -> int:
        """The run whose setpoints are kept."""
        return int(self.rms.argmin())

    @property
    def rms(self) -> Array:
        """RMS by run of the errors of all joints [rad, m], or of the distance of the tip from its path [m].

        The first is without correction.
        """
        import numpy as np

        return np.sqrt(np.mean(self.errors**2, axis=(1, 2)) * (3 if self.by_tip else 1))

    @property
    def sheet(self) -> str:
        """The data sheet of the robot with learnt setpoints, as YAML."""
        from tmodes.io.sheet_write import robot_to_yaml

        return robot_to_yaml(self.robot)

    @property
    def data(self) -> Dataset:
        """``error`` (run, output, time), ``rms`` (run), ``correction`` (joint, time) [rad, m]."""
        from xarray import Dataset

        unit, own = {"units": self._unit}, {"units": "rad or m"}
        return Dataset(
            {"error": (("run", "output", "time"), self.errors, unit), "rms": ("run", self.rms, unit),
             "correction": (("joint", "time"), self.added, own)},
            {"run": range(len(self.errors)), "output": list(self.names), "joint": list(self.joints),
             "time": ("time", self.times, {"units": "s"})},
        )  # fmt: skip

    @property
    def _unit(self) -> str:
        return "m" if self.by_tip else "rad or m"

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes learn --json`` prints it."""
        largest = abs(self.errors).max(axis=2)
        return {
            "robot": self.given.name, "joints": list(self.joints), "outputs": list(self.names),
            "rms": self.rms.tolist(), "best": self.best,
            "caution": self.cautions.tolist(), "largest": largest.tolist(), "time_s": self.times.tolist(),
            "correction": self.added.tolist(),
            "units": {"rms": f"{self._unit}, of all outputs, by run", "largest": f"{self._unit}, by run and output",
                      "correction": "rad or m, added to the setpoint of each joint"},
        }  # fmt: skip

    def plot(self, ax: Any = None) -> list[Any]:
        """The root mean square of the error of each output by run, that of the start, which stays, with it."""
        import numpy as np

        from tmodes.plot.commands import points

        rms, runs = np.sqrt(np.mean(self.errors**2, axis=2)), np.arange(len(self.errors))
        shown = {name: (runs, rms[:, k]) for k, name in enumerate(self.names) if rms[:, k].any()}
        title = f"{self.given.name}: learning over {len(runs) - 1} runs"
        return points(shown, "run", f"rms error [{self._unit}]", title=title, ax=ax, line="-", log=True)

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
        heads = ["run", "caution", "rms of all", *(f"largest, {name}" for name in self.names)]
        what = "Commanded path less position of the tip" if self.by_tip else "Signal less position of the joints"
        yield Table(f"{what} [{self._unit}]", heads, rows)
