"""Torques that bring a robot from rest to rest, by exact derivatives of the native run.

The unknowns are factors of functions of time (:mod:`tmodes.gradients.torque_functions`), the residual is the state at
the end off the equilibrium at the goal, in the modes of the robot there. A Gauss-Newton step runs the robot once,
carries the slopes by all functions along its recorded steps, and solves a linear least-squares problem. Limits that are
passed count in it, and the bending of the torques by a weight that falls from step to step (J. Nocedal, S. J. Wright,
Numerical Optimization, 2006, section 10.3; the falling weight: M. Hanke, Inverse Problems 13, 1997).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.compile.ir.derivative_kernels import LANES
from tmodes.gradients.lowering import lowered
from tmodes.gradients.torque_functions import POLYNOMIALS, TorqueFunctions, torque_functions
from tmodes.integrate.choice import explicit_steps
from tmodes.kinds.signals.registry import SIGNALS
from tmodes.kinds.signals.schedule import SignalPieces, on_knots
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command, DriveSheet, InitialState
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.replay import Replay

__all__ = ["Found", "RestToRest", "table", "under_torques"]

Array = NDArray[np.float64]

_FIRST, _LAST, _PER_RESIDUAL, _FALL, _RISE = 1e-2, 1e-8, 1e-2, 10.0, 3.0
"""Weight of the bending of the torques: at first, at least, at least over the residual; its fall and its rise."""

_SHORT, _SHORTEST, _BETTER, _IDLE = 0.3, 0.05, 0.9, 6
"""Shares of a step: short, too short to halve. What counts as better, and how many steps may be no better."""

_LIMIT, _WITHIN, _TURNS, _PER_LIMIT = 1e-2, 0.998, 60, 10
"""Weight of what passes a limit; share of a limit that may be used; how often it is asked which limits are passed, and
steps to find what keeps to each."""

_NEAR = 0.5
"""Share of the cost without bending up to which a step must be able to lower it; else the weight falls first."""

_ACCEPTED = 5e-7
"""Swing that is accepted, over the distance of the tip from the base."""

_POLYNOMIALS, _STIFF, _LAST_NEAR = 30, 1e-4, 1e-4
"""Along a course: how many polynomials, the weight of the bending of the torques over that of the course, and that of
both at least."""

_EXPLICIT = 1000
"""Explicit steps beyond which slopes by all functions are cheaper along implicit ones."""

_STEPS, _SAMPLES, _TOLERANCE, _WAVES = 25, 200, 1e-10, 100
"""Gauss-Newton steps at most; samples of a run; largest relative tolerance of the runs; half waves of a harmonic."""


class Course(NamedTuple):
    """What a motion keeps near to where ends and limits leave it open.

    ``off``: of instants (n,) [s] the function that says of coordinates (n, nq) how far off they are (n, k), over the
    size of the course, with the slopes (n, k, nq). ``efforts``: of instants, those to begin with (drives, n) [N*m, N];
    ``poses`` (n, nq): about where it leads, for its size.
    """

    off: Callable[[Array], Callable[[Array], tuple[Array, Array]]]
    efforts: Callable[[Array], Array]
    poses: Array


class Found(NamedTuple):
    """What was found: ``torques`` (drives, rows) at ``knots`` (rows,) [s], and how well.

    ``swing`` [m]: bound of how far the tip swings afterwards, by the linear modes at the goal; ``excess``: largest
    share by which a limit is passed; ``factors``: of the functions, (drives x functions,); ``runs`` and ``slopes``: how
    many runs it took, and how many of them with slopes.
    """

    knots: Array
    torques: Array
    factors: Array
    swing: float
    excess: float
    runs: int
    slopes: int
    interpolation: str = "cubic"

    def signals(self, joints: Sequence[str]) -> dict[str, Any]:
        """The torques as signals by joint."""
        return {k: table(self.knots, row, self.interpolation) for k, row in zip(joints, self.torques, strict=True)}


def under_torques(
    robot: Robot, pose: Mapping[str, float], torques: Mapping[str, Any], duration: float
) -> tuple[Robot, Equilibrium]:
    """The nominal robot at rest with its motors in a ``pose`` by joint [rad, m], driven by ``torques`` from there on.

    Torques are signals by joint. Raises :class:`tmodes.errors.SimulationError` where there is no rest.
    """
    motors = {joint.name for joint in robot.joints if joint.motor}
    drives = [drive for drive in robot.drives if drive.joint not in torques]
    for joint, signal in torques.items():
        command = Command.TORQUE if joint in motors else Command.EFFORT
        drives.append(DriveSheet(joint=joint, command=command, signal=signal))
    settings = robot.integration.model_copy(update={"duration": duration, "stop": ()})
    made = robot.model_copy(update={"drives": tuple(drives), "integration": settings, "real": {}})
    names = made.chain().coordinates
    held = {f"{joint}.motor" if f"{joint}.motor" in names else joint: value for joint, value in pose.items()}
    rest = robot_rest(made, held=held)
    start = {"state": InitialState.HELD, "coordinates": held, "rates": {}}
    return made.model_copy(update={"initial": made.initial.model_copy(update=start)}), rest


def table(knots: Array, values: Array, interpolation: str = "cubic") -> Any:
    """A signal that is the clamped cubic spline through ``values`` at ``knots`` [s], or ``linear`` between them."""
    given = {"times": tuple(knots.tolist()), "values": tuple(values.tolist())}
    return SIGNALS["table"](type="table", interpolation=interpolation, **given)


@dataclass(frozen=True, eq=False)
class _Goal:
    """Modes of the robot, its motors free, about its rest at the goal ``q``, with their ``frequencies`` [rad/s].

    ``residual`` (2 n, 2 n) makes of coordinates off the goal and rates the numbers that shall vanish, displacements
    times the root of mass [sqrt(kg) m]; ``tip`` (n,): how far each mode moves the tip [1/sqrt(kg)].
    """

    q: Array
    frequencies: Array
    residual: Array
    tip: Array

    @classmethod
    def of(cls, rest: Equilibrium, duration: float) -> _Goal:
        """By mass and stiffness there; what is slower than a half wave of the move counts by what it drifts in one."""
        from scipy.linalg import block_diag, eigh

        mass, _, stiffness = rest.matrices
        values, shapes = eigh((stiffness + stiffness.T) / 2, mass)
        frequencies, project = np.sqrt(np.maximum(values, 0.0)), shapes.T @ mass
        slow = np.maximum(frequencies, np.pi / duration)
        tip = np.linalg.norm(rest.model.jacobian(rest.q)[0, :3] @ shapes, axis=0)
        both = np.asarray(block_diag(project, project / slow[:, None]), dtype=float)
        return cls(rest.q, frequencies, both, tip)

    def swing(self, residual: Array) -> float:
        """Bound of how far the tip is from the goal afterwards [m]."""
        return float(self.tip @ np.hypot(*residual.reshape(2, -1)))


class _Point(NamedTuple):
    """Factors, their run, what shall vanish over what it is at the start, and torques and speeds over their limits.

    ``bent``: bending of the torques, and how far the robot is from the course that it is to keep near to.
    """

    factors: Array
    replay: Replay
    residual: Array
    used: Array
    bent: Array


class _Runs:
    """Runs of a robot with factors (drives x functions,) of torques added to those of its sheet, and their slopes."""

    def __init__(self, robot: Robot, joints: Sequence[str], functions: TorqueFunctions, sizes: Array) -> None:
        own = robot.integration
        update = {
            "output_step": own.duration / _SAMPLES, "relative_tolerance": min(own.relative_tolerance, _TOLERANCE),
            "check_error": False,
        }  # fmt: skip
        here = lowered(robot.model_copy(update={"integration": own.model_copy(update=update)}))
        if here.otherwise and explicit_steps(own, here.setup.spectrum.highest) > _EXPLICIT:
            setup = here.setup.by(here.otherwise.method, None)
            here = replace(here, setup=setup, settings=setup.robot.integration)
        self.here = here
        plan, schedule = self.here.setup.planned.plan, self.here.setup.planned.schedule
        width, self.schedule, signals = plan.degree + 1, schedule, {drive.joint: drive.signal for drive in plan.drives}
        pieces = [on_knots(SignalPieces(functions.knots, one), schedule.knots, plan.degree) for one in functions.pieces]
        self.ways = np.zeros((len(joints), len(pieces), *schedule.coefficients.shape))
        for k, joint in enumerate(joints):
            self.ways[k, :, :, signals[joint] * width :][..., :width] = np.array(pieces) * sizes[k]
        self.ways = self.ways.reshape(-1, *schedule.coefficients.shape)
        self.runs = self.slopes = 0

    def run(self, factors: Array) -> Replay:
        """The run, recorded."""
        coefficients = self.schedule.coefficients + np.tensordot(factors, self.ways, 1)
        planned = replace(self.here.setup.planned, schedule=SignalPieces(self.schedule.knots, coefficients))
        self.runs += 1
        return replace(self.here, setup=replace(self.here.setup, planned=planned)).recorded()

    def along(self, replay: Replay) -> Array:
        """Slopes (factors, samples, size) of the samples; the runs of eight factors at once, in threads."""
        count, state, size = len(self.ways), len(self.here.start), len(replay.parameters)
        rows = np.zeros((count, *replay.recording.rows.shape))
        rows[:, :, 1:] = self.ways

        def part(some: slice) -> Array:
            own = rows[some]
            return replay.along(np.zeros((len(own), state)), np.zeros((len(own), size)), own)

        first = [] if self.slopes else [part(slice(0, LANES))]  # which makes the tables that the others read
        self.slopes += 1
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            parts = [slice(k, k + LANES) for k in range(LANES * len(first), count, LANES)]
            return np.concatenate([*first, *pool.map(part, parts)])


class RestToRest:
    """A move of a robot from rest to rest in a fixed time, by torques of its drives.

    ``start`` and ``goal``: of the motors, by joint [rad, m]; ``torque`` and ``speed``: limits of the drives by joint
    [N*m, N], [rad/s, m/s]; ``modes``: how many modes have harmonics of their own. ``near``: a course that the robot
    keeps to as ends and limits allow. ``tips`` (2, 3) [m]: at both ends.
    """

    def __init__(
        self, robot: Robot, start: Mapping[str, float], goal: Mapping[str, float], duration: float, *,
        torque: Mapping[str, float], speed: Mapping[str, float], modes: int = 5, near: Course | None = None,
    ) -> None:  # fmt: skip
        self.joints, self.start, self.end, self.duration = list(goal), start, goal, duration
        self._near = near and near.off(np.linspace(0.0, duration, _SAMPLES + 1))
        none = {joint: table(np.array([0.0, duration]), np.zeros(2)) for joint in goal}
        first, last = (under_torques(robot, pose, none, duration) for pose in (start, goal))
        self.goal, names = _Goal.of(last[1], duration), last[1].model.coordinates
        self.tips = np.array([rest.model.pose(rest.q)[0][0] for _, rest in (first, last)])
        self.places = [names.index(name if (name := f"{k}.motor") in names else k) for k in self.joints]
        rings = self.goal.frequencies[self.goal.frequencies > np.pi / duration][:modes]
        rings, count = rings[rings < _WAVES * np.pi / duration], _POLYNOMIALS if near else POLYNOMIALS
        self.functions = torque_functions(duration, rings.tolist(), count)
        x, (held, holding) = self.functions.knots / duration, (self._holding(*one) for one in (first, last))
        self.base = held[:, None] + np.outer(holding - held, 3 * x**2 - 2 * x**3)
        moved = self._inertia(last[1]) @ (last[1].q - first[1].q)[self.places]
        guess = np.outer(moved, 60 * x - 180 * x**2 + 120 * x**3) / duration**2
        if near:
            guess = near.efforts(self.functions.knots) - self.base
        limits = (np.array([given.get(joint, np.inf) for joint in goal]) for given in (torque, speed))
        self.torque, self.speed = limits
        sizes = np.minimum(np.abs(guess).max(axis=1) + np.abs(self.base).max(axis=1), self.torque)
        self.sizes = np.where(sizes > 0, sizes, sizes.max())
        signals = dict(zip(goal, (table(self.functions.knots, row) for row in self.base), strict=True))
        self.runs = _Runs(under_torques(robot, start, signals, duration)[0], self.joints, self.functions, self.sizes)
        self.guess = self.factors(guess)
        fine, share = np.linspace(0.0, 1.0, len(self.functions.fine)), self.torque[:, None]
        self._torque_base = ((held[:, None] + np.outer(holding - held, 3 * fine**2 - 2 * fine**3)) / share).ravel()
        self._torque_use = np.kron(np.diag(self.sizes / self.torque), self.functions.fine)
        self._bending = (_STIFF if near else 1.0) * np.kron(np.eye(len(goal)), self.functions.bending)
        n = len(self.goal.q)
        poses = np.vstack([first[1].q, *(near.poses if near else ())])
        self.far = float(np.linalg.norm((poses - self.goal.q) @ self.goal.residual[:, :n].T, axis=1).max())

    @property
    def accepted(self) -> float:
        """Swing that is accepted where none is given [m]."""
        return _ACCEPTED * float(np.linalg.norm(self.tips, axis=1).max())

    def factors(self, torques: Array) -> Array:
        """Of the functions (drives x functions,) that come nearest to ``torques`` (drives, rows)."""
        values = self.functions.values
        return (torques / self.sizes[:, None] @ values / len(values)).ravel()

    def begun(self, other: RestToRest, found: Found) -> Array:
        """Factors to begin with, from a move in another time: the same course, torques with its square."""
        share = (other.duration / self.duration) ** 2
        moved = share * (found.torques - other.base)
        x, knots = self.functions.knots / self.duration, found.knots / other.duration
        return self.factors(np.array([np.interp(x, knots, row) for row in moved]))

    def torques(self, factors: Array) -> Array:
        """The torques (drives, rows) [N*m, N] at the knots."""
        return self.base + self.sizes[:, None] * (factors.reshape(len(self.joints), -1) @ self.functions.values.T)

    def _holding(self, robot: Robot, rest: Equilibrium) -> Array:
        """Torques (drives,) that keep it at rest: without them it would accelerate by their motors alone."""
        setup = run_setup(robot)
        rate = setup.model.rate([0.0], setup.start[None], setup.first_row[None])[0]
        return -(rest.matrices[0] @ rate[setup.model.layout.v])[self.places]

    def _inertia(self, rest: Equilibrium) -> Array:
        """Mass matrix (drives, drives) of slow motion: what bends follows the motors as at rest."""
        mass, _, stiffness = rest.matrices
        free = np.setdiff1d(np.arange(len(mass)), self.places)
        ways = np.eye(len(mass))[:, self.places]
        ways[free] = -np.linalg.lstsq(stiffness[free][:, free], stiffness[free][:, self.places])[0]
        return ways.T @ mass @ ways

    def _residual(self, states: Array) -> Array:
        """What shall vanish, of states (..., size) less that at the goal, over what it is at the start."""
        layout = self.runs.here.model.layout
        both = np.concatenate([states[..., layout.q], states[..., layout.v]], axis=-1)
        return both @ self.goal.residual.T / self.far

    def left(self, state: Array) -> Array:
        """What of a state (size,) at the end shall vanish, over what it is at the start."""
        off = state.copy()
        off[self.runs.here.model.layout.q] -= self.goal.q
        return self._residual(off)

    def _used(self, factors: Array, samples: Array) -> Array:
        """Torques and speeds of all drives at all instants, over their limits."""
        speeds = samples[:, self.runs.here.model.layout.v][:, self.places].T / self.speed[:, None]
        return np.concatenate([self._torque_base + self._torque_use @ factors, speeds.ravel()])

    def solve(
        self, tolerance: float, factors: Array | None = None, steps: int = _STEPS,
        progress: Callable[[float], None] = lambda share: None,
    ) -> Found:  # fmt: skip
        """Torques that leave a swing of the tip of at most ``tolerance`` [m] within the limits, or come near to that.

        ``factors``: where to begin; by default with a smooth move of the robot as if it were rigid.
        """
        weight, now = _FIRST, self._at(self.guess if factors is None else factors)
        best, since = now, 0
        for step in range(steps):
            if self._off(now, tolerance) <= 1 or since > _IDLE:
                break
            progress(step / steps)
            linear = self._linear(now)
            aim, least = self._aim(now, linear, weight)
            lowest = max(_LAST_NEAR if self._near else _LAST, _PER_RESIDUAL * float(np.linalg.norm(now.residual)))
            while weight > lowest and least > _NEAR * self._cost(
                now, weight
            ):  # with this weight it is as good as found
                weight = max(lowest, weight / _FALL)
                aim, least = self._aim(now, linear, weight)
            share, before, x = 1.0, self._cost(now, weight), now.factors
            now = self._at(aim)
            while self._cost(now, weight) > before and share > _SHORTEST:
                share /= 2
                now = self._at(x + share * (aim - x))
            since = 0 if self._off(now, tolerance) < _BETTER * self._off(best, tolerance) else since + 1
            best = now if self._off(now, tolerance) < self._off(best, tolerance) else best
            weight = max(lowest, weight / _FALL) if share == 1 else weight * _RISE if share < _SHORT else weight
        swing, excess = self.goal.swing(best.residual * self.far), float(np.abs(best.used).max()) - 1
        runs, torques = self.runs, self.torques(best.factors)
        return Found(self.functions.knots, torques, best.factors, swing, max(0.0, excess), runs.runs, runs.slopes)

    def _off(self, now: _Point, tolerance: float) -> float:
        """How far it is from what is wanted: at most 1 where that is reached."""
        excess = max(0.0, float(np.abs(now.used).max()) - 1)
        return max(self.goal.swing(now.residual * self.far) / tolerance, 1 + excess / (1 - _WITHIN) if excess else 0.0)

    def _at(self, factors: Array) -> _Point:
        replay = self.runs.run(factors)
        samples, layout = replay.recording.samples, self.runs.here.model.layout
        bent = np.concatenate([self._bending @ factors, self._away(samples[:, layout.q])[0].ravel()])
        return _Point(factors, replay, self.left(samples[-1]), self._used(factors, samples), bent)

    def _away(self, q: Array) -> tuple[Array, Array]:
        """How far the robot is from its course at all samples (n, k), and the slopes of that (n, k, nq)."""
        if self._near is None:
            return np.zeros((len(q), 0)), np.zeros((len(q), 0, q.shape[1]))
        off, slope = self._near(q)
        return off / np.sqrt(len(q)), slope / np.sqrt(len(q))

    def _cost(self, now: _Point, weight: float) -> float:
        over = np.maximum(np.abs(now.used) - _WITHIN, 0.0)
        return float(now.residual @ now.residual + _LIMIT**2 * over @ over + weight**2 * now.bent @ now.bent)

    def _linear(self, now: _Point) -> tuple[Array, Array, Array]:
        """Slopes of the residual (residuals, factors), of torques and speeds over their limits, and of what is bent.

        The values of the first and the last stand in one more column.
        """
        slopes, layout = self.runs.along(now.replay), self.runs.here.model.layout
        speeds = slopes[..., layout.v][..., self.places].transpose(2, 1, 0) / self.speed[:, None, None]
        uses = np.concatenate([self._torque_use, speeds.reshape(-1, len(now.factors))])
        away = self._away(now.replay.recording.samples[:, layout.q])[1]
        bends = np.concatenate([self._bending, *np.einsum("nkj,dnj->nkd", away, slopes[..., layout.q])])
        shape: Any = np.linalg.qr(np.column_stack([bends, now.bent]), mode="r")  # the same squares in fewer rows
        response = np.column_stack([self._residual(slopes[:, -1]).T, now.residual])
        return response, np.asarray(uses, dtype=float), shape

    def _aim(self, now: _Point, linear: tuple[Array, Array, Array], weight: float) -> tuple[Array, float]:
        """Where the cost is least by the slopes, and that without bending.

        Limits enter as they are passed; the pushes that keep to them, which are positive, solve the dual problem (C. L.
        Lawson, R. J. Hanson, Solving Least Squares Problems, 1995, chapter 23).
        """
        from scipy.linalg import solve_triangular
        from scipy.optimize import nnls

        response, uses, shape = linear
        rows = np.vstack([response, weight * shape])
        turn, triangle = np.linalg.qr(rows[:, :-1])
        way = free = -solve_triangular(triangle, turn.T @ rows[:, -1])
        both, used, kept = np.vstack([uses, -uses]), np.append(now.used, -now.used), np.zeros(0, dtype=int)
        for _ in range(_TURNS):
            beyond = used + both @ way - _WITHIN  # peaks of it: what is next to one mostly goes with it
            peaks = (beyond > 0) & (beyond >= np.roll(beyond, 1)) & (beyond >= np.roll(beyond, -1))
            passed = np.setdiff1d(np.flatnonzero(peaks), kept)
            if not len(passed):
                break
            kept = np.append(kept, passed)
            across = solve_triangular(triangle, both[kept].T, trans=1)
            beyond = (used + both @ free)[kept] - _WITHIN
            soft = np.vstack([across, np.eye(len(kept)) / _LIMIT])
            try:
                pushes = nnls(soft, np.append(np.zeros(len(free)), _LIMIT * beyond), maxiter=_PER_LIMIT * len(kept))[0]
            except RuntimeError:  # more limits than the torques can keep: as near as it came
                break
            way = free - solve_triangular(triangle, across @ pushes)
        left = response[:, :-1] @ way + response[:, -1]
        over = np.maximum(used + both @ way - _WITHIN, 0.0)
        return now.factors + way, float(left @ left + _LIMIT**2 * over @ over)
