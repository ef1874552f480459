"""Laws designed from the linear robot: LQR, pole placement, and what all such laws have in common.

The robot as known is linearised about its rest at the last (or first) setpoints. Deviations from that rest are followed
with the setpoints: those of a drive's motor and joint move with its signal, all other coordinates are wanted at rest,
unless a ``reference`` says what they do. What is fed forward at that rest is taken off the efforts that hold it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from enum import StrEnum
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, LinearPlant, Measured, OwnState
from tmodes.kinds.controllers.discrete import arriving, held_late, unreached, unseen, zero_order_hold
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.quantity import LARGEST, Issue, not_negative, positive
from tmodes.kinds.signals.registry import Signal

__all__ = [
    "LQR", "Design", "DesignedLaw", "Number", "PolePlacement", "Weight", "WeightedLaw", "diagonal", "riccati",
    "weights_by_name",
]  # fmt: skip

Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Weight = Annotated[float, Field(ge=0.0, le=LARGEST)]

_Decaying = Annotated[float, Field(gt=0.0, le=1e6)]

_MARGIN = 1e-9
"""Share of the fastest pole by which the slowest one must decay."""


class Design(NamedTuple):
    """What follows from the robot: ``plant``, and in discrete time ``Ad``, ``Bd``; feedback ``K`` (drives, states).

    The states of ``K`` are followed by the integrals of the drives' errors, where there are any; where the delay is in
    the design by past commands, the last ones first, which follow the states of ``Ad``, too. ``C``: outputs by states
    and past commands. ``M`` (states, measured): gain of an estimator.
    """

    plant: LinearPlant
    Ad: Any
    Bd: Any
    K: Any
    C: Any = None
    M: Any = None


class At(StrEnum):
    """Where the robot is linearised."""

    END = "end"
    START = "start"


def weights_by_name(unit: str, symbol: str, meaning: str) -> Any:
    """A field of numbers by the names of states."""
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

    reference: dict[str, Signal] = Field(
        default_factory=dict,
        description="what coordinates, or currents as `JOINT.current`, do by name along the reference [coordinate]",
    )

    found: ClassVar[Any] = None
    """Of an instance that is designed: what was found, beside its fields; it has the ``plant``."""

    @property
    def period(self) -> float | None:
        """T [s]."""
        return self.sample_time

    @property
    def sees(self) -> tuple[str, ...]:
        """Sensors and outputs that it reads."""
        return ()

    @property
    def given(self) -> Mapping[str, Any]:
        """What coordinates shall do."""
        return {f"{name}.reference": signal for name, signal in self.reference.items()}

    def following(self, sheet: Any) -> Self:
        """With its reference."""
        if sheet.reference is self.reference:
            return self
        made = self.model_copy()
        vars(made)["reference"] = sheet.reference
        return made

    @property
    def reads(self) -> tuple[str, ...]:
        """What is measured, what coordinates shall do, and what is fed forward, as far as it counts with that."""
        added = [name for one in self._added for name, _ in one] if self.found else []
        return tuple(dict.fromkeys((*self.sees, *(f"{one}{rate}" for one in self.given for rate in ("", "'")), *added)))

    @property
    def _added(self) -> tuple[Any, ...]:
        """What is fed forward to each drive, as far as it counts with that."""
        return ()

    @property
    def design(self) -> Any:
        """What follows from the robot; raises RuntimeError before it is designed."""
        if self.found is None:
            raise RuntimeError(f"the law {type(self).__name__} is not designed yet")
        return self.found

    def designed(self, plant: Callable[..., LinearPlant], drives: tuple[str, ...]) -> Self:
        """With gains for the robot; raises :class:`tmodes.errors.InputError` where there are none."""
        made = self.model_copy()
        linear = plant(self.sees, drives, start=self.at is At.START)
        diagonal(dict.fromkeys(self.reference, 0.0), linear, "reference")
        vars(made)["found"] = self._designed(linear)
        return made

    def _designed(self, linear: LinearPlant) -> Any:
        raise NotImplementedError

    def remarks(self) -> list[str]:
        """Modes that no drive reaches, or that nothing measured shows."""
        plant = self.design.plant
        return [*unreached(plant, len(plant.states) - self._loads), *(unseen(plant) if self.sees else [])]

    @property
    def _loads(self) -> int:
        """How many of the plant's states, the last ones, are loads that are estimated."""
        return 0

    def _own(self, plant: LinearPlant) -> list[int]:
        """Places of the positions that the drives keep."""
        return [_place(plant, joint) for joint in plant.drives]

    def _moved(self, rest: list[Any], m: Measured) -> list[Any]:
        """How far setpoints and reference have moved each state from the rest."""
        plant, moved = self.design.plant, [0.0] * len(self.design.plant.states)
        for joint, own in zip(plant.drives, self._own(plant), strict=True):
            setpoint = m.setpoint(joint)
            for name in (f"{joint}.motor", joint):
                if name in plant.states:
                    moved[plant.states.index(name)] = setpoint[0] - rest[own]
                    moved[plant.states.index(f"{name}'")] = setpoint[1]
        for name, signal in zip(self.reference, self.given, strict=True):
            place = plant.states.index(name)
            moved[place] = m.signals[signal] - rest[place]
            if (rate := f"{name}'") in plant.states:
                moved[plant.states.index(rate)] = m.signals[f"{signal}'"]
        return moved


class _StateSpace(DesignedLaw):
    """u = u_0 - K (x - x_r) - K_i z, z' = th - r.

    With its delay in the design x and z are those of the instant in which the command acts, predicted exactly by the
    commands that are on their way: the loop has the poles of one without delay (Z. Artstein, Linear systems with
    delayed controls: a reduction, IEEE Trans. Autom. Control 27, 1982).
    """

    integral: bool = Field(default=False, description="feed back the integral of each drive's error, too")
    delay_in_design: bool = Field(default=False, description="know the delay of its commands; sampled laws alone")

    def _issues(self) -> Iterator[Issue]:
        if self.delay_in_design and self.sample_time is None:
            yield Issue("delay_in_design", "true", "false without samples", "write `sample_time: 1 ms`, too")

    @property
    def gains(self) -> Any:
        """K (drives, states and integrals)."""
        return self.design.K

    def _designed(self, linear: LinearPlant) -> Design:
        A, B = _with_integrals(linear, self._own(linear)) if self.integral else (linear.A, linear.B)
        return self._late(linear, A, B, self._gain(A, B, linear))

    def _gain(self, A: Any, B: Any, plant: LinearPlant) -> Any:
        """K without a delay."""
        sampled = (A, B) if self.sample_time is None else zero_order_hold(A, B, self.sample_time)
        return self._feedback(*sampled, plant)

    def _late(self, plant: LinearPlant, A: Any, B: Any, K: Any) -> Design:
        """The design with such gains of the states of ``A``, which begin with the plant's, when its commands act."""
        n, seen = len(plant.A), np.hstack([plant.C, plant.D])
        if self.sample_time is None:
            return Design(plant, plant.A, plant.B, K, seen)
        delay = plant.delay if self.delay_in_design else 0.0
        Ad, Bd, C, _ = held_late(plant.A, plant.B, plant.C, plant.D, self.sample_time, delay)
        if len(Ad) == n:
            return Design(plant, Ad, Bd, K, seen)
        return Design(plant, Ad[:n], Bd[:n], K @ np.hstack(arriving(A, B, self.sample_time, delay)), C)

    def remarks(self) -> list[str]:
        """Those of all designed laws, and a delay that its gains do not know."""
        late = self.sample_time is not None and self.design.plant.delay > 0 and not self.delay_in_design
        words = f"its gains do not know that its commands act {1e3 * self.design.plant.delay:g} ms late"
        return [*super().remarks(), *([f"{words}; `delay_in_design: true` takes that in"] if late else [])]

    def _feedback(self, A: Any, B: Any, plant: LinearPlant) -> Any:
        raise NotImplementedError

    def numbers(self) -> tuple[float, ...]:
        """u_0, x at rest, K row by row."""
        return (*self.design.plant.effort, *self.design.plant.rest, *np.asarray(self.design.K).ravel())

    def _parts(self, p: Any) -> tuple[Any, Any, Any]:
        """The numbers apart: u_0, rest, rows of K."""
        d = self.design
        m, n, width = len(d.plant.drives), len(d.plant.states), np.shape(d.K)[1]
        rows = [[p[m + n + k * width + j] for j in range(width)] for k in range(m)]
        return [p[k] for k in range(m)], [p[m + k] for k in range(n)], rows

    def _state(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The deviation of the state from the rest."""
        del x
        rest = self._parts(p)[1]
        return [value - each for value, each in zip([*m.q, *m.v, *m.currents], rest, strict=True)]

    def _fed_back(self, p: Any, m: Measured, deviation: list[Any], x: list[Any]) -> list[Any]:
        """The commands for a deviation from the rest, and own states."""
        effort, rest, rows = self._parts(p)
        far = self._off(deviation, self._moved(rest, m))
        more = [*x[: self._sums], *self._past(p, x)[: self._kept]]
        return [
            push - vectors.total([k * value for k, value in zip(row, [*far, *more], strict=True)])
            for push, row in zip(effort, rows, strict=True)
        ]

    def _off(self, deviation: list[Any], moved: list[Any]) -> list[Any]:
        """How far the state is from where it shall be."""
        return [value - each for value, each in zip(deviation, moved, strict=True)]

    def _errors(self, m: Measured) -> list[Any]:
        """Positions less setpoints of all drives."""
        plant = self.design.plant
        return [m.q[_place(plant, joint)] - m.setpoint(joint)[0] for joint in plant.drives]

    @property
    def _sums(self) -> int:
        return len(self.design.plant.drives) if self.integral else 0

    @property
    def _kept(self) -> int:
        """How many past commands are fed back."""
        return np.shape(self.design.K)[1] - len(self.design.plant.states) - self._sums

    @property
    def remembered(self) -> int:
        """How many past commands are the last ones of its states."""
        return self._kept

    def _past(self, p: Any, x: list[Any]) -> list[Any]:
        """The past commands less those at rest, the last ones first."""
        return self._less_rest(p, x[len(x) - self.remembered :])

    def _less_rest(self, p: Any, commands: list[Any]) -> list[Any]:
        """Commands, of all drives or several times these, less those at rest."""
        return [u - p[k % len(self.design.plant.drives)] for k, u in enumerate(commands)]

    def initial(self) -> tuple[float, ...]:
        """The integrals, and past commands: until a run sets those to what holds the motors, those at rest."""
        drives = len(self.design.plant.drives)
        return (0.0,) * self._sums + self.numbers()[:drives] * (self.remembered // drives)

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The integrals of the drives' errors, and past commands."""
        drives = self.design.plant.drives
        integrals = [OwnState(f"{joint}.integral", "rad*s|m*s") for joint in drives[: self._sums]]
        ages = [f".last{k}" if k > 1 else ".last" for k in range(1, 1 + self.remembered // len(drives))]
        return (*integrals, *(OwnState(f"{joint}{age}") for age in ages for joint in drives))

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        return self._fed_back(p, m, self._state(p, m, x), x)

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Those of the integrals."""
        del p, x
        return self._errors(m)[: self._sums]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The integrals after a sample, and the commands."""
        errors = self._errors(m)[: self._sums]
        sums = [value + (self.sample_time or 0.0) * rate for value, rate in zip(x, errors, strict=False)]
        given = self.command(p, m, x) if self.remembered else []
        return [*sums, *[*given, *x[len(x) - self.remembered :]][: self.remembered]]

    @property
    def structure(self) -> str:
        """The names of its states are part of the code."""
        sizes = f"{self._sums} {self.remembered} {self._kept} {self.sample_time}"
        return f"{super().structure} {self.design.plant.states} {self.design.plant.drives} {sizes}"


def _place(plant: LinearPlant, joint: str) -> int:
    name = f"{joint}.motor" if f"{joint}.motor" in plant.states else joint
    return plant.states.index(name)


def _with_integrals(plant: LinearPlant, own: list[int]) -> tuple[Any, Any]:
    n, m = len(plant.A), len(own)
    A, B = np.zeros((n + m, n + m)), np.zeros((n + m, plant.B.shape[1]))
    A[:n, :n], B[:n] = plant.A, plant.B
    A[n + np.arange(m), own] = 1.0
    return A, B


class WeightedLaw(_StateSpace):
    """Gains that minimise the integral (or sum) of x' Q x + u' R u."""

    tuned: ClassVar[tuple[str, ...]] = ("state_weights", "integral_weight")

    state_weights: dict[str, Weight] = weights_by_name(
        "1", "Q", "weight on the square of a coordinate, or of its rate as `NAME'`; others 0"
    )
    integral_weight: float = not_negative("1", "Qi", "weight on the squares of the integrals", default=1.0)
    effort_weight: float = positive("1", "R", "weight on the squares of the commands", default=1.0)

    def _feedback(self, A: Any, B: Any, plant: LinearPlant) -> Any:
        Q = diagonal(self.state_weights, plant, "state_weights")
        Q = np.diag([*Q, *[self.integral_weight] * (len(A) - len(Q))])
        R, sampled = self.effort_weight * np.eye(B.shape[1]), self.sample_time is not None
        return riccati(A, B, Q, R, sampled=sampled, why=lambda: unreached(plant), which="state_weights")[0]


def diagonal(weights: dict[str, float], plant: LinearPlant, which: str) -> list[float]:
    """Numbers by the names of states, 0 for those that are not named."""
    for name in weights:
        if name not in plant.states:
            raise InputError(which, f"the unknown state `{name}`", f"one of {', '.join(plant.states)}", "correct it")
    return [weights.get(name, 0.0) for name in plant.states]


def riccati(
    A: Any, B: Any, Q: Any, R: Any, *, sampled: bool, why: Callable[[], list[str]], which: str
) -> tuple[Any, Any]:
    """Gain and solution of the Riccati equation.

    Raises :class:`tmodes.errors.InputError` of ``which`` where there is none under which all decays.
    """
    from scipy.linalg import solve_continuous_are, solve_discrete_are

    try:
        if sampled:
            X = solve_discrete_are(A, B, Q, R)
            K = np.linalg.solve(R + B.T @ X @ B, B.T @ X @ A)
        else:
            X = solve_continuous_are(A, B, Q, R)
            K = np.linalg.solve(R, B.T @ X)
        poles = np.linalg.eigvals(A - B @ K)
        slowest = np.abs(poles).max() - 1 if sampled else poles.real.max() + _MARGIN * np.abs(poles).max()
        if slowest >= 0 and not why():  # of what no gain reaches a run warns
            raise ValueError("a motion would not decay")
    except (np.linalg.LinAlgError, ValueError) as error:
        hint = "give a weight to each motion that does not decay by itself, or leave out what no drive moves"
        if which == "process_noise":
            hint = "give noise to each motion that does not decay by itself, or measure what shows it"
        got = f"no solution ({'; '.join(why()) or error})"
        expected = "such that all motions decay under the gains that follow"
        raise InputError(which, got, expected, hint) from error
    return K, X


@CONTROLLERS.register
class LQR(WeightedLaw):
    """Linear-quadratic regulator of the measured state (H. Kwakernaak, R. Sivan, Linear Optimal Control Systems)."""

    type: Literal["lqr"] = Field(description="kind of controller")


@CONTROLLERS.register
class PolePlacement(_StateSpace):
    """State feedback that puts the poles of the closed loop where they are wanted.

    Method of A. L. Tits, Y. Yang, Globally convergent algorithms for robust pole assignment by state feedback, IEEE
    Trans. Autom. Control 41, 1996 (SciPy).
    """

    type: Literal["pole_placement"] = Field(description="kind of controller")
    poles: tuple[Annotated[tuple[_Decaying, _Decaying], Field(strict=False)], ...] = Field(
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
