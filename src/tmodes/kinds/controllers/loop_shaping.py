"""H-infinity loop shaping: a weighted loop made as robust as it can be against changes of its coprime factors.

D. McFarlane, K. Glover, A loop shaping design procedure using H-infinity synthesis, IEEE Trans. Autom. Control 37,
759-769, 1992; formulas of S. Skogestad, I. Postlethwaite, Multivariable Feedback Control, 2nd ed., section 9.4.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, cast

import numpy as np
from pydantic import Field, field_validator

from tmodes.errors import InputError
from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, LinearPlant, Measured, OwnState
from tmodes.kinds.controllers.discrete import held_late, unreached, unseen
from tmodes.kinds.controllers.state_space import DesignedLaw, riccati
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.quantity import LARGEST, Issue, not_negative, positive, quantity

__all__ = ["LoopShaping", "robust"]

_TURN = 2 * np.pi

_ENOUGH = 0.25
"""A margin below this says that the weights ask for too much (Skogestad and Postlethwaite, section 9.4.1)."""

_Gain = Annotated[float, Field(gt=0, le=LARGEST)]

System = tuple[Any, Any, Any, Any]
"""A, B, C, D."""


def robust(plant: System, factor: float = 1.1, why: Callable[[], list[str]] = list) -> tuple[System, float]:
    """The law u = K y that stabilises a plant with gamma = ``factor`` times the least one, and that least one.

    The closed loop [K; I] (I - G K)^-1 [I, G] has at most the norm gamma: it bears all changes of the normalised
    coprime factors of G below 1/gamma. Continuous time, of any D; ``why``: what a message says where there is none.
    """
    A, B, C, D = plant
    S, R = np.eye(B.shape[1]) + D.T @ D, np.eye(len(C)) + D @ D.T
    inner = A - B @ np.linalg.solve(S, D.T @ C)
    X = riccati(inner, B, C.T @ np.linalg.solve(R, C), S, sampled=False, why=why, which="gains")[1]
    Z = riccati(inner.T, C.T, B @ np.linalg.solve(S, B.T), R, sampled=False, why=why, which="gains")[1]
    least = float(np.sqrt(1 + np.abs(np.linalg.eigvals(X @ Z)).max(initial=0.0)))
    gamma = factor * least
    F = -np.linalg.solve(S, D.T @ C + B.T @ X)
    H = gamma**2 * np.linalg.solve(((1 - gamma**2) * np.eye(len(A)) + X @ Z).T, Z @ C.T)
    return (A + B @ F + H @ (C + D @ F), H, B.T @ X, -D.T), least


def chained(first: System, then: System) -> System:
    """One system after another."""
    (A1, B1, C1, D1), (A2, B2, C2, D2) = first, then
    A = np.block([[A1, np.zeros((len(A1), len(A2)))], [B2 @ C1, A2]])
    return A, np.vstack([B1, B2 @ D1]), np.hstack([D2 @ C1, C2]), D2 @ D1


def unsampled(system: System, period: float) -> System:
    """The continuous system that Tustin's rule samples to this one; both have the same norms."""
    A, B, C, D = system
    rate, back = 2 / period, np.linalg.inv(np.eye(len(A)) + A)
    root = np.sqrt(2 * rate)
    return rate * back @ (A - np.eye(len(A))), root * back @ B, root * C @ back, D - C @ back @ B


def tustin(system: System, period: float) -> System:
    """The system sampled by Tustin's rule."""
    A, B, C, D = system
    rate = 2 / period
    back, root = np.linalg.inv(rate * np.eye(len(A)) - A), np.sqrt(2 * rate)
    return back @ (rate * np.eye(len(A)) + A), root * back @ B, root * C @ back, D + C @ back @ B


class Shaped(NamedTuple):
    """What is found: the ``plant``, the law ``K`` from what is measured, the weight ``W`` behind it, least gamma."""

    plant: LinearPlant
    K: System
    W: System
    gamma: float


@CONTROLLERS.register
class LoopShaping(DesignedLaw):
    """u = u_0 + W K V (y - y_r), K by H-infinity loop shaping of the loop V G W, as robust as it can be.

    W = gain (s + w_i)/s (1 + s sqrt(r)/w_l)/(1 + s/(sqrt(r) w_l)) at each drive, times the filters of ``weight``; V:
    weights of what is measured; G: the robot as known. Sampled: G with its hold and delay, exactly; W, and the design,
    by Tustin's rule, under which norms are the same. A limit of its only drive holds the integral (self-conditioned:
    R. Hanus, M. Kinnaert, J.-L. Henrotte, Automatica 23, 1987). It sees sensors and outputs by name, never the state.
    """

    tuned: ClassVar[tuple[str, ...]] = ("gains", "integral_frequency", "lead_frequency")

    type: Literal["loop_shaping"] = Field(description="kind of controller")
    measured: tuple[str, ...] = Field(
        strict=False, min_length=1, max_length=200, description="sensors or outputs that it reads"
    )
    gains: dict[str, _Gain] = Field(
        description="gain of the weight of each drive, by its joint [gain]",
        json_schema_extra={"unit": "gain", "symbol": "W", "smallest": 0.0, "plausible": None},
    )
    integral_frequency: float = not_negative("Hz", "f_i", "up to which it integrates, w_i/(2 pi)", default=0.0)
    lead_frequency: float | None = positive("Hz", "f_l", "where the weight leads or lags most", default=None)
    lead_ratio: float = positive("1", "r", "pole over zero: above 1 leads, below 1 lags", default=1.0, at_most=1e6)
    weight: tuple[Controller, ...] = Field(
        default=(), strict=False, description="filters one after another that W has, too; their `input` is left out"
    )
    output_weights: dict[str, _Gain] = Field(
        default_factory=dict, description="weight of what is measured, by its name; others 1 [1/output]",
        json_schema_extra={"unit": "1/output", "symbol": "V", "smallest": 0.0, "plausible": None},
    )  # fmt: skip
    factor: float = quantity("1", "gamma", "gamma over the least that there is", default=1.1, above=1.0, at_most=100.0)

    @field_validator("weight", mode="before")
    @classmethod
    def _without_input(cls, given: Any) -> Any:
        """A filter of the weight reads what the law wants."""
        several = isinstance(given, list | tuple)
        return [{"input": "law"} | one if isinstance(one, dict) else one for one in given] if several else given

    def _issues(self) -> Iterator[Issue]:
        for k, one in enumerate(self.weight):
            if not hasattr(one, "system") or one.period is not None:
                kind = getattr(one, "type", "")
                got = f"`{kind}`{'' if one.period is None else ' with samples of its own'}"
                hint = "write `{type: notch, frequency: 12 Hz}`, say; the law samples it"
                yield Issue(f"weight.{k}", got, "a filter of continuous time: notch, low_pass, lead_lag", hint)
        if (self.lead_frequency is None) != (self.lead_ratio == 1.0):
            got = "nothing" if self.lead_frequency is None else f"{self.lead_frequency:g} Hz"
            hint = "write both, `lead_frequency: 5 Hz` and `lead_ratio: 4`, or none"
            yield Issue("lead_frequency", got, "a frequency where a `lead_ratio` other than 1 is given", hint)
        for name in self.output_weights:
            if name not in self.measured:
                yield Issue("output_weights", f"`{name}`", f"one of {', '.join(self.measured)}", "correct it")

    @property
    def sees(self) -> tuple[str, ...]:
        """What is measured."""
        return self.measured

    @property
    def robustness(self) -> float:
        """e_max: 1/gamma."""
        return 1 / self.design.gamma

    def remarks(self) -> list[str]:
        """Modes that are out of reach, and a weighted loop that no law makes robust."""
        hint = "take lower `gains` or a lower `integral_frequency`, or a lead where the loop crosses 1"
        weak = [f"its loop bears little: e_max = {self.robustness:.3g}, below {_ENOUGH}; {hint}"]
        return [*super().remarks(), *(weak if self.robustness < _ENOUGH else [])]

    def _weight(self, joints: tuple[str, ...]) -> tuple[System, System]:
        """W (drives, drives) in continuous time: filters without gain at the highest frequencies, then all others.

        Behind the first the command can be cut at once, so that a limit holds the states of the others.
        """
        if {*self.gains} != {*joints}:
            got, hint = ", ".join(self.gains) or "nothing", "write `gains: {JOINT: 5.0}`"
            raise InputError("gains", got, f"a gain for each of {', '.join(joints)}", hint)
        one, none = np.eye(len(joints)), np.zeros((len(joints), 0))
        low, found = (
            (none.T @ none, none.T, none, size) for size in (one, np.diag([self.gains[joint] for joint in joints]))
        )
        if self.integral_frequency:
            found = chained(found, (0 * one, one, _TURN * self.integral_frequency * one, one))
        if self.lead_frequency is not None:
            root, rate = np.sqrt(self.lead_ratio), _TURN * self.lead_frequency
            zero, pole = rate / root, rate * root
            found = chained(found, (-pole * one, one, self.lead_ratio * (zero - pole) * one, self.lead_ratio * one))
        for stage in self.weight:
            A, B, C, D = (np.kron(part, one) for part in cast("Any", stage).system())
            low, found = (low, chained(found, (A, B, C, D))) if D.any() else (chained(low, (A, B, C, D)), found)
        return low, found

    def _designed(self, linear: LinearPlant) -> Shaped:
        G, period = (linear.A, linear.B, linear.C, linear.D), self.sample_time
        if period is not None:
            G = held_late(*G, period, linear.delay)
            if G[3].any():  # it sees what follows from the commands before the sample
                m = linear.B.shape[1]
                last = np.zeros((m, m)), np.eye(m), np.vstack([np.zeros((m, m)), np.eye(m)]), np.eye(2 * m, m)
                G = chained(last, (G[0], np.hstack([G[1], 0 * G[1]]), G[2], np.hstack([0 * G[3], G[3]])))
            G = unsampled(G, period)
        low, W = self._weight(linear.drives)
        weights = np.array([self.output_weights.get(one, 1.0) for one in self.measured])
        A, B, C, D = chained(chained(low, W), G)
        shaped = A, B, weights[:, None] * C, weights[:, None] * D
        K, gamma = robust(shaped, self.factor, lambda: [*unreached(linear), *unseen(linear)])
        K = chained((K[0], K[1] * weights, K[2], K[3] * weights), low)
        if period is not None:
            K, W = tustin(K, period), tustin(W, period)
        return Shaped(linear, K, W, gamma)

    def _matrices(self) -> list[Any]:
        """u_0, state and what is measured at rest, C, and those of K and W, all with two dimensions."""
        plant, K, W, _ = self.design
        columns = [np.asarray(one, dtype=float)[:, None] for one in (plant.effort, plant.rest, plant.measured)]
        return [*columns, plant.C, *K, *W]

    def numbers(self) -> tuple[float, ...]:
        """Those matrices, row by row."""
        return tuple(np.concatenate([np.ravel(one) for one in self._matrices()]).tolist())

    def _rows(self, p: Any) -> Iterator[list[list[Any]]]:
        """Those matrices of the numbers."""
        at = 0
        for matrix in self._matrices():
            rows, columns = matrix.shape
            yield [[p[at + i * columns + j] for j in range(columns)] for i in range(rows)]
            at += rows * columns

    def initial(self) -> tuple[float, ...]:
        """Nothing was measured yet."""
        return (0.0,) * (len(self.design.K[0]) + len(self.design.W[0]))

    @property
    def states(self) -> tuple[OwnState, ...]:
        """Those of the law, then those of the weight."""
        law, weight = len(self.design.K[0]), len(self.design.W[0])
        named = [*(f"law{k + 1}" for k in range(law)), *(f"weight{k + 1}" for k in range(weight))]
        return tuple(OwnState(name) for name in named)

    def _flow(self, p: Any, m: Measured, x: list[Any]) -> tuple[list[Any], list[Any]]:
        """The commands, and what becomes of the states."""
        effort, still, rest, C, AK, BK, CK, DK, AW, BW, CW, DW = self._rows(p)
        moved = self._moved([one[0] for one in still], m)
        off = [
            m.signals[name] - y[0] - each for name, y, each in zip(self.measured, rest, _sums(C, moved), strict=True)
        ]
        law, weight = x[: len(AK)], x[len(AK) :]
        wanted = _sums(CK, law, DK, off)
        given = [u[0] + each for u, each in zip(effort, _sums(CW, weight, DW, wanted), strict=True)]
        if m.limit is not None:
            wanted = [wanted[0] + (f.fmax(f.fmin(given[0], m.limit), -m.limit) - given[0]) / DW[0][0]]
        return given, [*_sums(AK, law, BK, off), *_sums(AW, weight, BW, wanted)]

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """As above."""
        return self._flow(p, m, x)[0]

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Those of the law and of the weight."""
        return self._flow(p, m, x)[1]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Those of the next sample."""
        return self._flow(p, m, x)[1]

    @property
    def structure(self) -> str:
        """What it reads and commands, and how many states it has, is part of the code."""
        plant, K, W, *_ = self.design
        size = f"{len(K[0])} {len(W[0])}"
        return f"{super().structure} {plant.states} {plant.drives} {self.measured} {size} {self.sample_time}"


def _sums(A: list[list[Any]], x: list[Any], B: list[list[Any]] | None = None, u: list[Any] | None = None) -> list[Any]:
    """A x + B u by rows of numbers."""
    pairs = [[*zip(row, x, strict=True), *(zip(B[k], u or [], strict=True) if B else ())] for k, row in enumerate(A)]
    return [vectors.total([a * each for a, each in pair]) if pair else 0.0 for pair in pairs]
