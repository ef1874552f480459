"""Laws designed from the linear robot: LQR, pole placement, LQG from what sensors say.

The robot as known is linearised about its rest at the last (or first) setpoints. Deviations from that rest are followed
with the setpoints: those of a drive's motor and joint move with its signal, all other coordinates are wanted at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from enum import StrEnum
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, LinearPlant, Measured, OwnState
from tmodes.kinds.controllers.discrete import unreached, unseen, zero_order_hold
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, Issue, not_negative, positive

__all__ = ["LQG", "LQR", "Design", "DesignedLaw", "PolePlacement", "riccati"]

Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


class Design(NamedTuple):
    """What follows from the robot: ``plant``, and in discrete time ``Ad``, ``Bd``; feedback ``K`` (drives, states).

    The states of ``K`` are followed by the integrals of the drives' errors, where there are any. ``M`` (states,
    measured): gain of an estimator.
    """

    plant: LinearPlant
    Ad: Any
    Bd: Any
    K: Any
    M: Any = None


class At(StrEnum):
    """Where the robot is linearised."""

    END = "end"
    START = "start"


def _weights(unit: str, symbol: str, meaning: str) -> Any:
    extra: Any = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    return Field(default_factory=dict, description=f"{meaning} [{unit}]", json_schema_extra=extra)


class DesignedLaw(Controller):
    """A law that follows from the linear robot, continuous or sampled."""

    sees_all: ClassVar[bool] = True
    needs_drives: ClassVar[bool] = True
    is_designed: ClassVar[bool] = True

    at: At = Field(default=At.END, strict=False, description="rest about which it is designed: end or start of moves")
    sample_time: float | None = positive(
        "s", "T", "time between samples; none: continuous time", default=None, plausible=(1e-5, 1.0)
    )

    found: ClassVar[Any] = None
    """Of an instance that is designed: what was found, beside its fields; it has the ``plant``."""

    @property
    def period(self) -> float | None:
        """T [s]."""
        return self.sample_time

    @property
    def design(self) -> Any:
        """What follows from the robot; raises RuntimeError before it is designed."""
        if self.found is None:
            raise RuntimeError(f"the law {type(self).__name__} is not designed yet")
        return self.found

    def designed(self, plant: Callable[..., LinearPlant], drives: tuple[str, ...]) -> Self:
        """With gains for the robot; raises :class:`tmodes.errors.InputError` where there are none."""
        made = self.model_copy()
        vars(made)["found"] = self._designed(plant(self.reads, drives, start=self.at is At.START))
        return made

    def _designed(self, linear: LinearPlant) -> Any:
        raise NotImplementedError

    def remarks(self) -> list[str]:
        """Modes that no drive reaches, or that nothing measured shows."""
        plant = self.design.plant
        return [*unreached(plant, len(plant.states) - self._loads), *(unseen(plant) if self.reads else [])]

    @property
    def _loads(self) -> int:
        """How many of the plant's states, the last ones, are loads that are estimated."""
        return 0

    def _own(self, plant: LinearPlant) -> list[int]:
        """Places of the positions that the drives keep."""
        return [_place(plant, joint) for joint in plant.drives]

    def _moved(self, ends: list[Any], m: Measured) -> list[Any]:
        """How far the setpoints have moved each state from the rest, whose setpoints were ``ends``."""
        plant, moved = self.design.plant, [0.0] * len(self.design.plant.states)
        for joint, end in zip(plant.drives, ends, strict=True):
            setpoint = m.setpoint(joint)
            for name in (f"{joint}.motor", joint):
                if name in plant.states:
                    moved[plant.states.index(name)] = setpoint[0] - end
                    moved[plant.states.index(f"{name}'")] = setpoint[1]
        return moved


class _StateSpace(DesignedLaw):
    """u = u_0 - K (x - x_r) - K_i z, z' = th - r."""

    integral: bool = Field(default=False, description="feed back the integral of each drive's error, too")

    @property
    def gains(self) -> Any:
        """K (drives, states and integrals)."""
        return self.design.K

    def _designed(self, linear: LinearPlant) -> Design:
        A, B = _with_integrals(linear, self._own(linear)) if self.integral else (linear.A, linear.B)
        if self.sample_time is not None:
            A, B = zero_order_hold(A, B, self.sample_time)
        n = len(linear.A)
        return Design(linear, A[:n, :n], B[:n], self._feedback(A, B, linear))

    def _feedback(self, A: Any, B: Any, plant: LinearPlant) -> Any:
        raise NotImplementedError

    def numbers(self) -> tuple[float, ...]:
        """u_0, x at rest, setpoints there, K row by row."""
        d = self.design
        own = [d.plant.rest[k] for k in self._own(d.plant)]
        return (*d.plant.effort, *d.plant.rest, *own, *np.asarray(d.K).ravel())

    def _parts(self, p: Any) -> tuple[Any, Any, Any, Any]:
        """The numbers apart: u_0, rest, setpoints there, rows of K."""
        d, at = self.design, 0
        sizes = (len(d.plant.drives), len(d.plant.states), len(d.plant.drives), np.size(d.K))
        found = []
        for size in sizes:
            found.append([p[at + k] for k in range(size)])
            at += size
        width = np.shape(d.K)[1]
        found[3] = [found[3][k * width : (k + 1) * width] for k in range(len(d.plant.drives))]
        return tuple(found)  # pyright: ignore[reportReturnType]

    def _state(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The deviation of the state from the rest."""
        del x
        rest = self._parts(p)[1]
        return [value - each for value, each in zip([*m.q, *m.v, *m.currents], rest, strict=True)]

    def _fed_back(self, p: Any, m: Measured, deviation: list[Any], integrals: list[Any]) -> list[Any]:
        """The commands for a deviation from the rest."""
        effort, _, ends, rows = self._parts(p)
        far = [value - each for value, each in zip(deviation, self._moved(ends, m), strict=True)]
        return [
            push - vectors.total([k * value for k, value in zip(row, [*far, *integrals], strict=True)])
            for push, row in zip(effort, rows, strict=True)
        ]

    def _errors(self, m: Measured) -> list[Any]:
        """Positions less setpoints of all drives."""
        plant = self.design.plant
        return [m.q[_place(plant, joint)] - m.setpoint(joint)[0] for joint in plant.drives]

    @property
    def _sums(self) -> int:
        return len(self.design.plant.drives) if self.integral else 0

    def initial(self) -> tuple[float, ...]:
        """The integrals."""
        return (0.0,) * self._sums

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The integrals of the drives' errors."""
        return tuple(OwnState(f"{joint}.integral", "rad*s|m*s") for joint in self.design.plant.drives[: self._sums])

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        return self._fed_back(p, m, self._state(p, m, x), x[: self._sums])

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Those of the integrals."""
        del p, x
        return self._errors(m)[: self._sums]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The integrals after a sample."""
        del p
        return [value + (self.sample_time or 0.0) * rate for value, rate in zip(x, self._errors(m), strict=False)]

    @property
    def structure(self) -> str:
        """The names of its states are part of the code."""
        d = self.design
        return f"{super().structure} {d.plant.states} {d.plant.drives} {self._sums} {self.sample_time}"


def _place(plant: LinearPlant, joint: str) -> int:
    name = f"{joint}.motor" if f"{joint}.motor" in plant.states else joint
    return plant.states.index(name)


def _with_integrals(plant: LinearPlant, own: list[int]) -> tuple[Any, Any]:
    n, m = len(plant.A), len(own)
    A, B = np.zeros((n + m, n + m)), np.zeros((n + m, plant.B.shape[1]))
    A[:n, :n], B[:n] = plant.A, plant.B
    A[n + np.arange(m), own] = 1.0
    return A, B


class _Weighted(_StateSpace):
    """Gains that minimise the integral (or sum) of x' Q x + u' R u."""

    tuned: ClassVar[tuple[str, ...]] = ("state_weights", "integral_weight")

    state_weights: dict[str, Number] = _weights(
        "1", "Q", "weight on the square of a coordinate, or of its rate as `NAME'`; others 0"
    )
    integral_weight: float = not_negative("1", "Qi", "weight on the squares of the integrals", default=1.0)
    effort_weight: float = positive("1", "R", "weight on the squares of the commands", default=1.0)

    def _feedback(self, A: Any, B: Any, plant: LinearPlant) -> Any:
        Q = diagonal(self.state_weights, plant, "state_weights")
        Q = np.diag([*Q, *[self.integral_weight] * (len(A) - len(Q))])
        R = self.effort_weight * np.eye(B.shape[1])
        return riccati(A, B, Q, R, sampled=self.sample_time is not None, why=lambda: unreached(plant))[0]


def diagonal(weights: dict[str, float], plant: LinearPlant, which: str) -> list[float]:
    """Numbers by the names of states, 0 for those that are not named."""
    for name in weights:
        if name not in plant.states:
            raise InputError(which, f"the unknown state `{name}`", f"one of {', '.join(plant.states)}", "correct it")
    return [weights.get(name, 0.0) for name in plant.states]


def riccati(A: Any, B: Any, Q: Any, R: Any, *, sampled: bool, why: Callable[[], list[str]]) -> tuple[Any, Any]:
    """Gain and solution of the Riccati equation; raises :class:`tmodes.errors.InputError` where there is none."""
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    try:
        if sampled:
            X = solve_discrete_are(A, B, Q, R)
            return np.linalg.solve(R + B.T @ X @ B, B.T @ X @ A), X
        X = solve_continuous_are(A, B, Q, R)
        return np.linalg.solve(R, B.T @ X), X
    except (np.linalg.LinAlgError, ValueError) as error:
        hint = "give a weight to each motion that does not decay by itself, or leave out what no drive moves"
        got = f"no solution ({'; '.join(why()) or error})"
        raise InputError("control", got, "a robot that the drives can stabilise", hint) from error


@CONTROLLERS.register
class LQR(_Weighted):
    """Linear-quadratic regulator of the measured state (H. Kwakernaak, R. Sivan, Linear Optimal Control Systems)."""

    type: Literal["lqr"] = Field(description="kind of controller")


@CONTROLLERS.register
class PolePlacement(_StateSpace):
    """State feedback that puts the poles of the closed loop where they are wanted.

    Method of A. L. Tits, Y. Yang, Globally convergent algorithms for robust pole assignment by state feedback, IEEE
    Trans. Autom. Control 41, 1996 (SciPy).
    """

    type: Literal["pole_placement"] = Field(description="kind of controller")
    poles: tuple[Annotated[tuple[float, float], Field(strict=False)], ...] = Field(
        strict=False, min_length=1, max_length=400,
        description="natural frequency [Hz] and damping ratio of each pair of poles",
    )  # fmt: skip

    def _feedback(self, A: Any, B: Any, plant: LinearPlant) -> Any:
        from scipy.signal import place_poles

        del plant
        wanted = []
        for frequency, ratio in self.poles:
            rate, part = 2 * np.pi * frequency, np.emath.sqrt(ratio**2 - 1)
            wanted += [rate * (-ratio + part), rate * (-ratio - part)]
        if len(wanted) != len(A):
            got, expected = f"{len(self.poles)} pairs", f"{len(A) / 2:g}, for {len(A)} states"
            raise InputError("poles", got, expected, "write [frequency in Hz, damping ratio] of each pair")
        if self.sample_time is not None:
            wanted = [np.exp(pole * self.sample_time) for pole in wanted]
        try:
            return place_poles(A, B, wanted).gain_matrix  # pyright: ignore[reportAttributeAccessIssue]
        except ValueError as error:
            raise InputError("poles", str(error), "poles that the drives can give", "move them apart") from error


class Form(StrEnum):
    """Whether a command is of the estimate with (filter) or without (predictor) the measurement of its own instant."""

    FILTER = "filter"
    PREDICTOR = "predictor"


@CONTROLLERS.register
class LQG(_Weighted):
    """LQR of the state that a Kalman filter estimates from what is measured; sampled.

    x_f = x_p + M (y - C x_p - D u_-), x_p+ = Ad x_f + Bd u, of deviations from the rest (K. J. Astrom, B. Wittenmark,
    Computer-Controlled Systems, 3rd ed., chapter 11). It sees sensors and outputs by name, never the state. With
    ``load_noise`` it estimates a constant load on each drive, too, and takes it off the command, which is integral
    action.
    """

    type: Literal["lqg"] = Field(description="kind of controller")
    sample_time: float = positive(  # pyright: ignore[reportIncompatibleVariableOverride]
        "s", "T", "time between samples", plausible=(1e-5, 1.0)
    )
    measured: tuple[str, ...] = Field(
        strict=False, min_length=1, max_length=200, description="sensors or outputs that it reads"
    )
    process_noise: dict[str, Number] = _weights("1", "W", "variance by which a state changes in a sample; others 0")
    measurement_noise: tuple[Number, ...] = list_of_numbers("SI", "V", "variance of each that is measured; one: of all")
    load_noise: float = not_negative(
        "1", "W_d", "variance by which a load on a drive changes in a sample; 0: no loads are estimated", default=0.0
    )
    form: Form = Field(default=Form.FILTER, strict=False, description="filter or predictor")
    estimate: dict[str, Number] = _weights("coordinate", "x_p", "first estimate, as deviation from the rest; others 0")

    def _issues(self) -> Iterator[Issue]:
        if self.integral:
            hint = "write `load_noise: 1e-6`, or take `lqr`, which sees the positions themselves"
            yield Issue("integral", "true", "false: it never sees the position itself", hint)

    @property
    def reads(self) -> tuple[str, ...]:
        """What is measured."""
        return self.measured

    @property
    def _loads(self) -> int:
        return len(self.design.plant.drives) if self.load_noise else 0

    def _designed(self, linear: LinearPlant) -> Design:
        plant, Ad, Bd, K, _ = super()._designed(linear)
        if self.load_noise:
            (n, m), names = linear.B.shape, tuple(f"{joint}.load" for joint in linear.drives)
            plant = replace(
                linear, states=(*linear.states, *names), rest=np.pad(linear.rest, (0, m)),
                A=np.block([[linear.A, linear.B], [np.zeros((m, n + m))]]), B=np.pad(linear.B, ((0, m), (0, 0))),
                C=np.hstack([linear.C, linear.D]),
            )  # fmt: skip
            (Ad, Bd), K = zero_order_hold(plant.A, plant.B, self.sample_time), np.hstack([K, np.eye(m)])
        return Design(plant, Ad, Bd, K, self._observer(plant, Ad, len(linear.states)))

    def _observer(self, plant: LinearPlant, Ad: Any, own: int) -> Any:
        noise = diagonal(self.process_noise, plant, "process_noise")
        W = np.diag([*noise[:own], *[self.load_noise] * (len(noise) - own)])
        given = self.measurement_noise
        if len(given) not in {1, len(self.measured)} or not all(0 < one <= LARGEST for one in given):
            got, expected = f"{list(given)}", f"1 or {len(self.measured)} variances above 0"
            raise InputError("measurement_noise", got, expected, "write the variance of each that is measured")
        V = np.diag(given if len(given) > 1 else given * len(self.measured))
        P = riccati(Ad.T, plant.C.T, W, V, sampled=True, why=lambda: unseen(plant))[1]
        return P @ plant.C.T @ np.linalg.inv(plant.C @ P @ plant.C.T + V)

    def numbers(self) -> tuple[float, ...]:
        """Those of an LQR, then y at rest, C, D, M, Ad, Bd row by row."""
        d = self.design
        rows = [np.asarray(one, dtype=float).ravel() for one in self._matrices(d)]
        return (*super().numbers(), *np.concatenate(rows))

    @staticmethod
    def _matrices(d: Design) -> list[Any]:
        return [np.asarray(d.plant.measured)[:, None], d.plant.C, d.plant.D, d.M, d.Ad, d.Bd]

    def _observing(self, p: Any) -> list[list[list[Any]]]:
        """Those matrices, as rows of numbers."""
        at, found = len(super().numbers()), []
        for matrix in self._matrices(self.design):
            rows, columns = np.shape(matrix)
            found.append([[p[at + i * columns + j] for j in range(columns)] for i in range(rows)])
            at += rows * columns
        return found

    def initial(self) -> tuple[float, ...]:
        """Integrals, the estimate, the last commands less those at rest."""
        first = diagonal(self.estimate, self.design.plant, "estimate")
        return (*super().initial(), *first, *(0.0,) * len(self.design.plant.drives))

    @property
    def states(self) -> tuple[OwnState, ...]:
        """Integrals, the estimate, the last commands less those at rest."""
        plant = self.design.plant
        last = tuple(OwnState(f"{joint}.last") for joint in plant.drives)
        return (*super().states, *(OwnState(f"estimate.{name}") for name in plant.states), *last)

    def _filtered(self, p: Any, m: Measured, x: list[Any]) -> tuple[list[Any], list[Any]]:
        """The estimate before and after the measurement."""
        at, plant = self._sums, self.design.plant
        before, last = x[at : at + len(plant.states)], x[at + len(plant.states) :]
        rest, C, D, M, _, _ = self._observing(p)
        new = []
        for k, name in enumerate(self.measured):
            predicted = [c * value for c, value in zip(C[k], before, strict=True)]
            predicted += [d * value for d, value in zip(D[k], last, strict=True)]
            new.append(m.signals[name] - rest[k][0] - vectors.total(predicted))
        after = [
            value + vectors.total([gain * each for gain, each in zip(row, new, strict=True)])
            for value, row in zip(before, M, strict=True)
        ]
        return before, after

    def _state(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The estimate."""
        return self._filtered(p, m, x)[self.form is Form.FILTER]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The integrals, the estimate for the next sample, the commands of this one."""
        effort = self._parts(p)[0]
        pushed = [u - each for u, each in zip(self.command(p, m, x), effort, strict=True)]
        _, after = self._filtered(p, m, x)
        *_, Ad, Bd = self._observing(p)
        predicted = [
            vectors.total([*(a * value for a, value in zip(row, after, strict=True)),
                           *(b * value for b, value in zip(pushes, pushed, strict=True))])
            for row, pushes in zip(Ad, Bd, strict=True)
        ]  # fmt: skip
        return [*super().updates(p, m, x[: self._sums]), *predicted, *pushed]

    @property
    def structure(self) -> str:
        """What it reads, and when, is part of the code."""
        return f"{super().structure} {self.measured} {self.form}"
