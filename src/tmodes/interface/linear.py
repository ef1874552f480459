"""Linear models of a robot: what ``tmodes linear`` computes and prints."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.margins import Margins, margins, response, step_duration, step_values, transmission_zeros
from tmodes.errors import InputError
from tmodes.interface.poses import Pose, pose_of, pose_words
from tmodes.interface.statics import Linearization, circumstances
from tmodes.interface.variants import uncertain_of, uncertain_robots
from tmodes.io.arguments import checked_arguments
from tmodes.io.files import FilePath
from tmodes.io.printed import Table
from tmodes.kinds.controllers.discrete import Mode, lost_modes, named_modes

if TYPE_CHECKING:
    from xarray import DataArray

    from tmodes.sheet import Robot
    from tmodes.simulation.linear import StateSpace

__all__ = ["LinearModel", "Margins", "linearize"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Progress = Callable[[str, float], None]

_POINTS, _MOST_PAIRS = 400, 12


@checked_arguments
def linearize(
    robot: Robot,
    *,
    at: Pose | None = None,
    time: float | None = None,
    inputs: str | Sequence[str] | None = None,
    outputs: str | Sequence[str] | None = None,
    closed: bool = False,
    period: float | None = None,
    delay: float = 0.0,
    contact: bool = True,
    uncertain: Mapping[str, Any] | FilePath | None = None,
    cases: int = 50,
    seed: int = 0,
    progress: Progress = lambda stage, share: None,
) -> LinearModel:
    """The robot in small motions about its rest: M, D, K, and x' = A x + B u, y = C x + D u with named signals.

    At the pose ``at`` [rad, m], or the ``time`` [s] of its run (where ``system.rate`` is how the states change, and
    M, D, K are of its start), else where the first commands of its drives hold it, under weight and loads;
    ``contact`` with the surface that it touches. ``inputs``: commands of drives (``shoulder.torque``, ``.voltage``,
    ``.effort``) and loads on points (``tip.force.z``, ``tip.moment.x``); ``outputs``: any names of ``tmodes outputs``,
    and sensors. Without names: all drives, and the angles of their joints.

    Open loop, or under the controllers of the sheet about the start of its run (``closed``), with ``JOINT.setpoint``
    and, apart, ``JOINT.setpoint_rate`` as inputs: a law that uses the rate needs both for smooth motions. With a
    ``period`` [s] sampled, with a zero-order hold and a ``delay`` [s] of any length; sampled controllers sample by
    themselves. Where drives or the base turn at constant speed M, D, K are about that motion, and A, B, C, D
    about rest. Dry friction that sticks is left out. The derivatives are exact, of the compiled equations.

    ``uncertain``: as of :func:`tmodes.compare`, or its file: then ``family`` has the models of so many ``cases``.

    Errors: :class:`tmodes.errors.InputError` for an unknown name, :class:`tmodes.errors.SimulationError` where it finds
    no rest. Source: K. J. Astrom, B. Wittenmark, Computer-Controlled Systems, 3rd ed., chapters 2 and 3.

    >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.position")
    >>> linear.mass.shape, linear.A.shape, linear.B.shape
    ((2, 2), (4, 4), (4, 1))
    >>> round(float(abs(linear.poles[0])), 3)
    2.738
    """
    from tmodes.analysis.statics.at_rest import robot_rest
    from tmodes.simulation.linear import all_inputs, closed_loop, delayed, open_loop

    chosen, outs = (_names(inputs), _names(outputs)), tuple(f"{drive.joint}.position" for drive in robot.drives)
    if closed and at is not None:
        hint = "leave out `at`: it is the start of the run, see `initial` in the sheet"
        raise InputError("at", str(pose_words(at)), "left out with `closed`", hint)
    if time is not None and (at is not None or not 0 <= time <= robot.integration.duration):
        expected = f"a time within the run of {robot.integration.duration:g} s, without `at`"
        raise InputError("time", f"{time:g} s", expected, "write time=0.5, or at={'shoulder': 0.4}")
    if (period is None and delay) or (period is not None and not period > 0) or delay < 0:
        expected = "a period above 0 s, and a delay of 0 s or more"
        raise InputError("period", f"{period!r} s with a delay of {delay:g} s", expected, "write period=1e-3 for 1 kHz")
    held = pose_of(at, robot)
    rest = robot_rest(robot, held=held, contact=contact, moving=True, progress=progress)

    def made() -> StateSpace:
        own = chosen[0] or all_inputs(robot, closed=closed), chosen[1] or outs
        if closed:
            found = closed_loop(robot, *own, time)
        else:
            pose = dict(rest.named) if held is None else held
            found = open_loop(robot, *own, held=_drives(robot, pose), time=time, contact=contact, progress=progress)
        if period is not None and found.period is not None:
            got, expected = f"{period:g} s", f"left out: the controllers sample by themselves, every {found.period:g} s"
            raise InputError("period", got, expected, "remove it; delays stand in the sheet")
        return found if period is None else delayed(found, period, delay)

    where = circumstances(robot, contact=contact, at=pose_words(at))
    where = where if time is None else f"at {time:g} s of its run"
    matrices = rest.matrices
    family = []
    for k, one in enumerate(uncertain_robots(robot, uncertain_of(uncertain), cases, seed)):
        progress("uncertain robots", k / cases)
        same = {"at": at, "time": time, "inputs": inputs, "outputs": outputs, "closed": closed, "period": period}
        family.append(linearize(one, **same, delay=delay, contact=contact).system)
    found = LinearModel(robot.name, where, rest.model.coordinates, rest.q, *matrices, made, closed, tuple(family))
    if inputs is not None or outputs is not None or closed or period is not None or time is not None:
        _ = found.system  # wrong names are said at once
    return found


def _names(given: str | Sequence[str] | None) -> tuple[str, ...]:
    return tuple(name.strip() for name in given.split(",")) if isinstance(given, str) else tuple(given or ())


def _drives(robot: Robot, pose: Mapping[str, Any]) -> dict[str, Any]:
    """Of a pose the coordinates that drives hold."""
    names = robot.undriven.chain().coordinates
    motors = [f"{one.joint}.motor" if f"{one.joint}.motor" in names else one.joint for one in robot.drives]
    return {name: value for name, value in pose.items() if name in motors or name.removesuffix(".motor") in pose}


@dataclass(frozen=True, eq=False, repr=False)
class LinearModel(Linearization):
    """A robot in small motions: ``mass``, ``damping``, ``stiffness`` by ``coordinates``, and A, B, C, D by names.

    ``states``: coordinates, ``NAME'`` for their rates, currents, states of controllers, past inputs; ``inputs``,
    ``outputs``; ``period`` [s] of a sampled one, else None; ``system`` has all of it with the point ``x0, u0, y0``.
    """

    made: Callable[[], StateSpace] = field(repr=False)
    closed: bool = False
    family: tuple[StateSpace, ...] = field(default=(), repr=False)
    """Models of uncertain robots, where they were asked for."""
    error: float | None = None
    """Of one with fewer states: bound of the difference of the responses, None where none is known."""

    @cached_property
    def system(self) -> StateSpace:
        """Matrices, names and the point about which they are."""
        return self.made()

    @property
    def A(self) -> Array:
        """(states, states) [SI]."""
        return self.system.A

    @property
    def B(self) -> Array:
        """(states, inputs) [SI]."""
        return self.system.B

    @property
    def C(self) -> Array:
        """(outputs, states) [SI]."""
        return self.system.C

    @property
    def D(self) -> Array:
        """(outputs, inputs) [SI]."""
        return self.system.D

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the rows of A."""
        return self.system.states

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of the columns of B."""
        return self.system.inputs

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the rows of C."""
        return self.system.outputs

    @property
    def period(self) -> float | None:
        """Time between samples [s]; None in continuous time."""
        return self.system.period

    @property
    def poles(self) -> Complex:
        """Eigenvalues of A [1/s], the slowest first; of a sampled one in the z plane, the largest first."""
        found = np.linalg.eigvals(self.A).astype(complex)
        return found[np.argsort(np.abs(found) * (-1 if self.period else 1), kind="stable")]

    @property
    def modes(self) -> list[Mode]:
        """Each of the ``poles`` with the ``state`` that takes part most in its motion.

        >>> tmodes.load("spong1987").linearize().modes[-1].state
        'joint.motor'
        """
        return sorted(named_modes(self.A, self.states), key=lambda one: abs(one.pole) * (-1 if self.period else 1))

    @property
    def sentence(self) -> str:
        """Whether it is stable, its slowest modes, its margins in open loop, what is non-minimum phase."""
        from tmodes.interface.linear_words import sentence

        return sentence(self)

    @property
    def uncontrollable(self) -> list[Mode]:
        """Modes (``pole``, ``state`` that has most of it) that no input reaches."""
        return lost_modes(self.A, self.B, self.states)

    @property
    def unobservable(self) -> list[Mode]:
        """Modes that no output shows."""
        return lost_modes(self.A.T, self.C.T, self.states)

    @property
    def is_stable(self) -> bool:
        """Whether all poles decay."""
        return bool((np.abs(self.poles) < 1).all() if self.period else (self.poles.real < 0).all())

    def zeros(self, output: str | None = None, input: str | None = None) -> Complex:  # noqa: A002
        """Transmission zeros [1/s] from an input to an output, of all of them together without names.

        Those at infinity are left out. A zero to the right (outside of the unit circle) makes the system non-minimum
        phase. Method: generalised eigenvalues of the Rosenbrock pencil (A. J. Laub, B. C. Moore, Automatica 14, 1978).
        Raises :class:`tmodes.errors.InputError` for an unknown name, and where inputs and outputs are not as many.

        >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.motor.position")
        >>> abs(linear.zeros().imag).round(3).tolist()
        [10.478, 10.478]
        """
        A, B, C, D = self._part(output, input)
        if len(C) != B.shape[1]:
            got, expected = f"{B.shape[1]} inputs and {len(C)} outputs", "as many of both"
            raise InputError("zeros", got, expected, "name one input and one output")
        return transmission_zeros(A, B, C, D)

    def _part(self, output: str | None, input: str | None) -> tuple[Array, Array, Array, Array]:  # noqa: A002
        rows, columns = self._place("outputs", output), self._place("inputs", input)
        return self.A, self.B[:, columns], self.C[rows], self.D[np.ix_(rows, columns)]

    def _place(self, kind: str, name: str | None) -> list[int]:
        names = getattr(self, kind)
        if name is None:
            return list(range(len(names)))
        if name not in names:
            raise InputError(kind, f"the unknown name `{name}`", f"one of {', '.join(names)}", "correct it")
        return [names.index(name)]

    def frequencies(self) -> Array:
        """Frequencies [Hz] (n,) of its response: from below the slowest pole to above the fastest."""
        with np.errstate(divide="ignore", invalid="ignore"):  # a pole at 0 of a delay
            sizes = np.abs(np.log(self.poles) / self.period) if self.period else np.abs(self.poles)
        sizes = sizes[(sizes > 1e-6) & np.isfinite(sizes)] / (2 * np.pi)
        low, high = (sizes.min() / 10, sizes.max() * 10) if len(sizes) else (0.01, 100.0)
        high = min(high, 0.5 / self.period) if self.period else high
        return np.unique(
            np.append(np.geomspace(min(low, high / 10), high, _POINTS), sizes[(sizes > low) & (sizes < high)])
        )

    def frequency_response(self, frequencies: ArrayLike | None = None) -> DataArray:
        """The response G(2 pi i f), complex, by ``frequency`` [Hz], ``output`` and ``input``.

        >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.position")
        >>> linear.frequency_response([1.0]).shape
        (1, 1, 1)
        """
        from xarray import DataArray

        at = self.frequencies() if frequencies is None else np.atleast_1d(np.asarray(frequencies, dtype=float))
        values = response(self.A, self.B, self.C, self.D, self._points(at))
        where = {"frequency": at, "output": list(self.outputs), "input": list(self.inputs)}
        return DataArray(values, where, ("frequency", "output", "input"), "response")

    def family_response(self, frequencies: ArrayLike | None = None) -> DataArray:
        """The same of its ``family``, along ``case`` first.

        >>> k = {"k": {"path": "joints.0.gear.stiffness", "relative": True,
        ...            "distribution": {"type": "uniform", "low": 0.9, "high": 1.1}}}
        >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", uncertain=k, cases=3)
        >>> linear.family_response([1.0, 2.0]).shape
        (3, 2, 1, 1)
        """
        from xarray import concat

        at = self.frequencies() if frequencies is None else frequencies
        each = [replace(self, made=partial(replace, one)).frequency_response(at) for one in self.family]
        return concat(each, "case")

    def _points(self, frequencies: Array) -> Complex:
        turns = 2j * np.pi * frequencies
        return np.asarray(np.exp(turns * self.period) if self.period else turns, dtype=np.complex128)

    def singular_values(self, frequencies: ArrayLike | None = None) -> DataArray:
        """Singular values of the response, the largest first, by ``frequency`` [Hz]."""
        from xarray import DataArray

        found = self.frequency_response(frequencies)
        values = np.linalg.svd(found.values, compute_uv=False)
        return DataArray(values, {"frequency": found.frequency.values}, ("frequency", "number"), "singular_values")

    def margins(self, output: str | None = None, input: str | None = None) -> Margins:  # noqa: A002
        """Margins of the loop from an input to an output that negative feedback closes; infinite where there is none.

        Crossings are found on a fine grid of frequencies and sharpened by bisection.
        """
        part = self._part(output, input)
        if part[1].shape[1] != 1 or len(part[2]) != 1:
            got = f"{part[1].shape[1]} inputs and {len(part[2])} outputs"
            raise InputError("margins", got, "one of each", "name an input and an output")
        A, B, C, D = part
        poles = np.linalg.eigvals(A - B @ C / (1 + D[0, 0]))
        stable = bool((np.abs(poles) < 1).all() if self.period else (poles.real < 0).all())
        return margins(lambda f: response(*part, self._points(np.atleast_1d(f)))[:, 0, 0], self.frequencies(), stable)

    def reduce(self, order: int, method: str = "balanced") -> LinearModel:
        """A model with ``order`` states; ``method``: ``balanced`` truncation, or ``modal`` (the slowest poles).

        ``error`` of a balanced one bounds the difference of the responses: twice the sum of the Hankel singular values
        that are left out (K. Glover, Int. J. Control 39, 1984). Balanced truncation needs a stable model.
        """
        from tmodes.analysis.reduction import balanced, hankel_values, modal

        if method not in {"balanced", "modal"} or not 0 < order <= len(self.A):
            got, expected = f"{order} by `{method}`", f"1 to {len(self.A)} states, by `balanced` or `modal`"
            raise InputError("reduce", got, expected, "linear.reduce(4)")
        how = balanced if method == "balanced" else modal
        A, B, C, D = how(self.A, self.B, self.C, self.D, order, self.period)
        names = tuple(f"{method}{k + 1}" for k in range(len(A)))
        zero = np.zeros(len(A))
        system = replace(self.system, states=names, A=A, B=B, C=C, D=D, x0=zero, rate=zero)
        left = hankel_values(self.A, self.B, self.C, self.period)[order:] if how is balanced else None
        return replace(self, family=(), made=lambda: system, error=None if left is None else 2 * float(left.sum()))

    def to_control(self) -> Any:
        """The same as a ``StateSpace`` of python-control (``pip install control``)."""
        try:
            import control  # pyright: ignore[reportMissingImports]
        except ImportError as error:
            hint = "pip install control"
            raise InputError("to_control", "no python-control here", "that package", hint) from error
        names = {"states": list(self.states), "inputs": list(self.inputs), "outputs": list(self.outputs)}
        plain = {key: [one.replace(".", "_") for one in value] for key, value in names.items()}
        return control.ss(self.A, self.B, self.C, self.D, self.period or 0, **plain)

    def to_scipy(self) -> Any:
        """The same as a ``StateSpace`` of SciPy's signal package."""
        from scipy.signal import StateSpace as Plain

        matrices = self.A, self.B, self.C, self.D
        return Plain(*matrices, dt=self.period) if self.period else Plain(*matrices)

    def save(self, path: str | Path) -> None:
        """Write it as ``.mat`` (for MATLAB), ``.json`` or ``.npz``; raises :class:`tmodes.errors.InputError` else.

        >>> tmodes.load("spong1987").linearize().save("spong.json")
        """
        from tmodes.io.matrices import save_matrices

        numbers = {"A": self.A, "B": self.B, "C": self.C, "D": self.D, "x0": self.system.x0, "u0": self.system.u0,
                   "y0": self.system.y0, "period": self.period or 0.0}  # fmt: skip
        names = {key: list(getattr(self, key)) for key in ("states", "inputs", "outputs")}
        save_matrices(Path(path), numbers, names, self.info())

    def info(self) -> dict[str, Any]:
        """Plain data; complex numbers as [real, imaginary]."""
        s = self.system
        pairs = [[float(one.real), float(one.imag)] for one in self.poles]
        more = {key: getattr(s, key).tolist() for key in ("A", "B", "C", "D", "x0", "u0", "y0", "rate")}
        names = {"states": list(s.states), "inputs": list(s.inputs), "outputs": list(s.outputs)}
        lost = {key: [[mode.pole.real, mode.pole.imag, mode.state] for mode in getattr(self, key)]
                for key in ("uncontrollable", "unobservable")}  # fmt: skip
        rest = {"units": dict(s.units), "period": s.period, "closed": self.closed, "poles": pairs} | lost
        return super().info() | names | more | rest

    def tables(self) -> Iterator[str | Table]:
        """Poles with what they are, zeros of each input to each output, and the point."""
        from tmodes.interface import linear_words as words

        s = self.system
        yield words.heading(self)
        yield Table("poles", words.POLES, words.pole_rows(self))
        yield from words.lost_modes(self)
        if len(s.inputs) * len(s.outputs) <= _MOST_PAIRS:
            yield Table("zeros", words.ZEROS, list(words.zero_rows(self)))
        yield Table("inputs", ["name", "value there"], [[n, f"{v:.5g}"] for n, v in zip(s.inputs, s.u0, strict=True)])
        units = [s.units.get(name, "") for name in s.outputs]
        rows = [[n, u, f"{v:.5g}"] for n, u, v in zip(s.outputs, units, s.y0, strict=True)]
        yield Table("outputs", ["name", "unit", "value there"], rows)

    def step_response(self, duration: float | None = None) -> DataArray:
        """Outputs after a step of 1 of each input, by ``time`` [s], ``output`` and ``input``; exact at its times.

        ``duration`` [s]: until the slowest motion is down to 1 %, or one that grows is 20 times as large.

        >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.position")
        >>> round(float(linear.step_response(1.0)[-1, 0, 0]), 3)
        0.142
        """
        from xarray import DataArray

        matrices = self.A, self.B, self.C, self.D
        length = step_duration(self.poles, self.period) if duration is None else duration
        step = self.period * max(int(length / self.period / _POINTS), 1) if self.period else length / _POINTS
        times = np.arange(0.0, length * (1 + 1e-9), step)
        values = step_values(*matrices, len(times), step, self.period)
        where = {"time": times, "output": list(self.outputs), "input": list(self.inputs)}
        return DataArray(values, where, ("time", "output", "input"), "step_response")

    def plot(self, ax: Any = None, *, chart: str = "bode") -> list[Any]:
        """Every input to every output as a ``chart``: ``bode`` (with its ``family``, shaded), ``nyquist`` or ``step``.

        Raises :class:`tmodes.errors.InputError` for another name.
        """
        from tmodes.plot import commands

        if chart == "bode":
            family = self.family_response() if self.family else None
            return commands.bode(self.frequency_response(), family=family, title=self.name, ax=ax)
        if chart == "nyquist":
            return commands.nyquist(self.frequency_response(), title=self.name, ax=ax)
        if chart != "step":
            hint = "tmodes linear FILE --chart nyquist"
            raise InputError("chart", f"`{chart}`", "bode, nyquist or step", hint)
        found, units = self.step_response(), self.system.units
        lines = {f"{source} to {name} [{units.get(name, '')}]": (found.time, found.sel(input=source, output=name))
                 for source in self.inputs for name in self.outputs}  # fmt: skip
        return commands.points(lines, "time [s]", "after a step of 1", title=self.name, ax=ax, line="-", marks=False)

    def page(self, path: FilePath) -> Path:
        """One self-contained HTML file: its sentence, charts, tables; raises :class:`tmodes.errors.ResultFileError`.

        >>> tmodes.load("spong1987").linearize().page("linear.html").name
        'linear.html'
        """
        from tmodes.interface.linear_page import write_page

        return write_page(self, Path(path))
