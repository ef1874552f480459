"""What a linear model of a robot is and gives: poles, zeros, responses, margins, reduction, other tools' forms."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.margins import (
    Margins,
    frequencies,
    loop_margins,
    points,
    response,
    step_duration,
    step_values,
    transmission_zeros,
)  # fmt: skip
from tmodes.errors import InputError
from tmodes.interface.statics import Linearization
from tmodes.io.files import FilePath
from tmodes.io.printed import Table
from tmodes.kinds.controllers.discrete import Mode, lost_modes, named_modes

if TYPE_CHECKING:
    from xarray import DataArray

    from tmodes.simulation.linear import StateSpace

__all__ = ["LinearModel"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

_POINTS, _MOST_PAIRS = 400, 12

_CANCELS, _ROUNDING, _NO_EFFECT = 1e-5, 1e-9, 1e-12
"""Shares: of a pole by which a zero that cancels it is off, of the fastest pole that is 0, of no response."""


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
    """Of one with fewer states: largest gain of the difference of the responses; None where there is none."""
    reduction: str = ""
    """How it has fewer states, and this error, in words."""
    opened: Callable[[], Mapping[str, StateSpace]] = field(default=dict, repr=False)
    e_max: Mapping[str, float] = field(default_factory=dict, repr=False)
    """Of a closed one by the laws of `loop_shaping`: largest change of their weighted loop that they bear, 0 to 1."""

    @cached_property
    def system(self) -> StateSpace:
        """Matrices, names and the point about which they are."""
        return self.made()

    @cached_property
    def loops(self) -> dict[str, LinearModel]:
        """Of a closed loop by joint: L from the command of its drive to what its controllers make of it, others closed.

        >>> loop = tmodes.load("spong1987").linearize(closed=True).loops["joint"].margins()
        >>> round(float(loop.phase), 3), round(loop.disk, 3)
        (0, 0)
        """
        return {name: self._opened(one) for name, one in self.opened().items()} if self.closed else {}

    def loop(self, name: str) -> LinearModel:
        """One of the ``loops``; raises :class:`tmodes.errors.InputError` for a drive that has none.

        >>> tmodes.load("spong1987").linearize(closed=True).loop("joint").inputs
        ('joint.command',)
        """
        if name not in self.loops:
            known = ", ".join(self.loops) or "none: no controller closes one that is linear and samples once a period"
            raise InputError("loop", f"`{name}`", f"a drive with a loop of its own: {known}", "name one of these")
        return self.loops[name]

    def _opened(self, system: StateSpace) -> LinearModel:
        return replace(self, made=lambda: system, closed=False, family=(), opened=dict, e_max={})

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
        """Transmission zeros [1/s], of a sampled system in the z plane, from an input to an output.

        Without names of all of them together. Those at infinity are left out, and between two names those that cancel
        modes which these do not share. A zero to the right (outside of the unit circle) makes the system non-minimum
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
        zeros = transmission_zeros(A, B, C, D)
        lost = [*lost_modes(A, B, self.states), *lost_modes(A.T, C.T, self.states)]  # they are zeros of every channel
        for pole in {one for mode in lost for one in (mode.pole, mode.pole.conjugate())}:
            near = np.abs(zeros - pole)
            if near.min(initial=np.inf) < _CANCELS * abs(pole) + _ROUNDING * np.abs(self.poles).max():
                zeros = np.delete(zeros, near.argmin())
        return zeros

    def acts(self, output: str, input: str) -> bool:  # noqa: A002
        """Whether an input moves an output at all.

        >>> tmodes.load("spong1987").linearize(inputs="joint.torque").acts("joint.position", "joint.torque")
        True
        """
        row, column = self._place("outputs", output)[0], self._place("inputs", input)[0]
        sizes = self._sizes
        return bool(sizes[row, column] > _NO_EFFECT * min(sizes[row].max(), sizes[:, column].max()))

    @cached_property
    def _sizes(self) -> Array:
        """Largest response of each output to each input at some frequencies; solved one by one, 0 stays 0."""
        at = self._points(self.frequencies()[::40])[:, None, None]
        return np.abs(self.C @ np.linalg.solve(at * np.eye(len(self.A)) - self.A, self.B) + self.D).max(axis=0)

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
        return frequencies(self.poles, self.period)

    def frequency_response(self, frequencies: ArrayLike | None = None) -> DataArray:
        """The response G(2 pi i f), complex, by ``frequency`` [Hz], ``output`` and ``input``.

        >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.position")
        >>> linear.frequency_response([1.0]).shape
        (1, 1, 1)
        """
        from xarray import DataArray

        at = self.frequencies() if frequencies is None else np.atleast_1d(np.asarray(frequencies, dtype=float))
        values = response(self.A, self.B, self.C, self.D)(self._points(at))
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
        return points(frequencies, self.period)

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
        return loop_margins(*part, self.period)

    def reduce(self, order: int | None = None, method: str = "balanced") -> LinearModel:
        """A model with ``order`` states; ``method``: ``balanced`` truncation, or ``modal`` (the slowest poles).

        ``minimal``, without an order: the part that inputs reach and outputs show (Kalman), of the same response; of
        unstable models, too, and of motors that no spring holds. ``error`` of the others: the largest gain of the
        difference of the responses (largest singular value over all frequencies, H-infinity norm), 1e-6 of it more at
        most; infinite where a motion that grows, or an integrator, is left out. Balanced truncation needs a stable one.

        >>> linear = tmodes.load("spong1987").linearize(inputs="joint.torque", outputs="joint.motor.position")
        >>> small = linear.reduce(2, "modal")
        >>> len(small.states), len(linear.reduce(method="minimal").states), round(small.error, 4)
        (2, 4, 0.0107)
        """
        from tmodes.analysis.reduction import balanced, largest_gain, minimal, modal

        least, all_of_it = method == "minimal", (self.A, self.B, self.C, self.D)
        if method not in {"balanced", "modal", "minimal"} or (
            order is not None if least else not 0 < (order or 0) <= len(self.A)
        ):
            expected = f"1 to {len(self.A)} states, by `balanced` or `modal`; none by `minimal`, which finds them"
            raise InputError("reduce", f"{order} by `{method}`", expected, "linear.reduce(4)")
        how, left = balanced if method == "balanced" else modal, None
        system, left = (minimal(*all_of_it), None) if least else how(*all_of_it, order or 0, self.period)
        A, B, C, D = system
        names = tuple(f"{method}{k + 1}" for k in range(len(A)))
        system = replace(self.system, states=names, A=A, B=B, C=C, D=D, x0=np.zeros(len(A)), rate=np.zeros(len(A)))
        error = None if left is None else largest_gain(*left, self.period)
        lost = "the same responses" if error is None else f"responses differ by {error:.3g} at most (largest gain, SI)"
        return replace(self, family=(), made=lambda: system, error=error,
                       reduction=f"Reduced from {len(self.A)} to {len(A)} states, {method}: {lost}.")  # fmt: skip

    def to_control(self) -> Any:
        """The same as a ``StateSpace`` of python-control (``pip install control``)."""
        try:
            import control  # pyright: ignore[reportMissingImports]
        except ImportError as error:
            raise InputError(
                "the package python-control", "nothing", "for to_control()", "pip install control"
            ) from error
        names = {key: [one.replace(".", "_") for one in getattr(self, key)] for key in ("states", "inputs", "outputs")}
        return control.ss(self.A, self.B, self.C, self.D, self.period or 0, **names)

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
        return super().info() | {key: list(getattr(s, key)) for key in ("states", "inputs", "outputs")} | {
            key: getattr(s, key).tolist() for key in ("A", "B", "C", "D", "x0", "u0", "y0", "rate")
        } | {
            "units": dict(s.units), "period": s.period, "closed": self.closed,
            "poles": [[float(one.real), float(one.imag)] for one in self.poles],
            "loops": {name: one.margins()._asdict() for name, one in self.loops.items()},
            "e_max": dict(self.e_max), "reduction": self.reduction, "error": self.error,
        } | {key: [[mode.pole.real, mode.pole.imag, mode.state] for mode in getattr(self, key)]
             for key in ("uncontrollable", "unobservable")}  # fmt: skip

    def tables(self) -> Iterator[str | Table]:
        """Poles with what they are, zeros of each input to each output, and the point."""
        from tmodes.interface import linear_words as words

        s = self.system
        yield words.heading(self)
        yield from [self.reduction] if self.reduction else []
        yield Table("poles", words.POLES, words.pole_rows(self))
        yield from words.lost_modes(self)
        if self.loops:
            yield Table("loops, each opened at the command of its drive", words.LOOPS, words.loop_rows(self))
        for law, most in self.e_max.items():
            yield f"Law {law}: e_max = {most:.3g}, the change of its weighted loop's coprime factors that it bears."
        if len(s.inputs) * len(s.outputs) <= _MOST_PAIRS:
            yield Table("zeros", words.SAMPLED_ZEROS if self.period else words.ZEROS, list(words.zero_rows(self)))
        for title, names, values in (("inputs", s.inputs, s.u0), ("outputs", s.outputs, s.y0)):
            rows = [[n, s.units.get(n, ""), f"{v:.5g}"] for n, v in zip(names, values, strict=True)]
            yield Table(title, ["name", "unit", "value there"], rows)

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
        from tmodes.interface.linear_page import chart_of

        return chart_of(self, chart, ax)

    def page(self, path: FilePath) -> Path:
        """One self-contained HTML file: its sentence, charts, tables; raises :class:`tmodes.errors.ResultFileError`.

        >>> tmodes.load("spong1987").linearize().page("linear.html").name
        'linear.html'
        """
        from tmodes.interface.linear_page import write_page

        return write_page(self, Path(path))
