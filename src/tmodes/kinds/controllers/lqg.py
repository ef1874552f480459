"""LQG: state feedback of what a Kalman filter estimates from sensors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from enum import StrEnum
from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.controllers.contract import CONTROLLERS, LinearPlant, Measured, OwnState
from tmodes.kinds.controllers.discrete import unseen, zero_order_hold
from tmodes.kinds.controllers.state_space import (
    Design,
    Number,
    Weight,
    WeightedLaw,
    diagonal,
    riccati,
    weights_by_name,
)
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, Issue, not_negative, positive

__all__ = ["LQG"]


class Form(StrEnum):
    """Whether a command is of the estimate with (filter) or without (predictor) the measurement of its own instant."""

    FILTER = "filter"
    PREDICTOR = "predictor"


@CONTROLLERS.register
class LQG(WeightedLaw):
    """LQR of the state that a Kalman filter estimates from what is measured; sampled.

    x_f = x_p + M (y - C x_p - D u_-), x_p+ = Ad x_f + Bd u, of deviations from the rest (K. J. Astrom, B. Wittenmark,
    Computer-Controlled Systems, 3rd ed., chapter 11); with its delay in the design of the commands as they act. It sees
    sensors and outputs by name, never the state. With ``load_noise`` it estimates a constant load on each drive, too,
    and takes it off the command, which is integral action. What is fed forward is part of u. With a ``reference``, of
    which that is the effort, x is the deviation from the reference, and u that of the command from what is fed forward.
    """

    type: Literal["lqg"] = Field(description="kind of controller")
    sample_time: float = positive(  # pyright: ignore[reportIncompatibleVariableOverride]
        "s", "T", "time between samples", plausible=(1e-5, 1.0)
    )
    measured: tuple[str, ...] = Field(
        strict=False, min_length=1, max_length=200, description="sensors or outputs that it reads"
    )
    process_noise: dict[str, Weight] = weights_by_name(
        "1", "W", "variance by which a state changes in a sample; others 0"
    )
    measurement_noise: tuple[Number, ...] = list_of_numbers("SI", "V", "variance of each that is measured; one: of all")
    load_noise: float = not_negative(
        "1", "W_d", "variance by which a load on a drive changes in a sample; 0: no loads are estimated", default=0.0
    )
    form: Form = Field(default=Form.FILTER, strict=False, description="filter or predictor")
    estimate: dict[str, Number] = weights_by_name(
        "coordinate", "x_p", "first estimate, as deviation from the first setpoints; others 0"
    )

    def _issues(self) -> Iterator[Issue]:
        if self.integral:
            hint = "write `load_noise: 1e-6`, or take `lqr`, which sees the positions themselves"
            yield Issue("integral", "true", "false: it never sees the position itself", hint)
        yield from super()._issues()

    @property
    def sees(self) -> tuple[str, ...]:
        """What is measured."""
        return self.measured

    @property
    def _added(self) -> tuple[Any, ...]:
        """What is fed forward to each drive."""
        return self.design.plant.added

    @property
    def _loads(self) -> int:
        return len(self.design.plant.drives) if self.load_noise else 0

    def _designed(self, linear: LinearPlant) -> Design:
        plant, K = linear, self._gain(linear.A, linear.B, linear)
        if self.load_noise:
            (n, m), names = linear.B.shape, tuple(f"{joint}.load" for joint in linear.drives)
            plant = replace(
                linear, states=(*linear.states, *names), rest=np.pad(linear.rest, (0, m)),
                A=np.block([[linear.A, linear.B], [np.zeros((m, n + m))]]), B=np.pad(linear.B, ((0, m), (0, 0))),
                C=np.hstack([linear.C, linear.D]),
            )  # fmt: skip
            K = np.hstack([K, np.eye(m)])
        found = self._late(plant, plant.A, plant.B, K)
        return found._replace(M=self._observer(plant, found.Ad[:, : len(plant.states)], len(linear.states)))

    def _observer(self, plant: LinearPlant, Ad: Any, own: int) -> Any:
        noise = diagonal(self.process_noise, plant, "process_noise")
        W = np.diag([*noise[:own], *[self.load_noise] * (len(noise) - own)])
        given = self.measurement_noise
        if len(given) not in {1, len(self.measured)} or not all(0 < one <= LARGEST for one in given):
            got, expected = f"{list(given)}", f"1 or {len(self.measured)} variances above 0"
            raise InputError("measurement_noise", got, expected, "write the variance of each that is measured")
        V = np.diag(given if len(given) > 1 else given * len(self.measured))
        P = riccati(Ad.T, plant.C.T, W, V, sampled=True, why=lambda: unseen(plant), which="process_noise")[1]
        return P @ plant.C.T @ np.linalg.inv(plant.C @ P @ plant.C.T + V)

    def numbers(self) -> tuple[float, ...]:
        """Those of an LQR, y at rest, C, M, Ad, Bd row by row, what counts with what is fed forward, the estimate."""
        rows = [np.asarray(one, dtype=float).ravel() for one in self._matrices(self.design)]
        return (*super().numbers(), *np.concatenate(rows), *self._begun(self.design.plant))

    def _begun(self, plant: LinearPlant) -> list[float]:
        """The first estimate: what is given, about where the setpoints begin."""
        still = Measured(setpoints=[[one, 0.0] for one in plant.first], drives=plant.drives)
        far = diagonal(self.estimate, plant, "estimate")
        return far if self.reference else [a + b for a, b in zip(far, self._moved(plant.rest, still), strict=True)]

    def _matrices(self, d: Design) -> list[Any]:
        """Where something is fed forward: its states' changes and outputs by it, its value at rest, its factors."""
        found = [np.asarray(d.plant.measured)[:, None], d.C, d.M, d.Ad, d.Bd]
        if not any(d.plant.added):
            return found
        plant, still = d.plant, np.asarray(d.plant.added_at_rest)[:, None]
        factors = np.array([factor for one in plant.added for _, factor in one])[:, None]
        return [*found, zero_order_hold(plant.A, plant.B, self.sample_time)[1], plant.D, still, factors]

    def _observing(self, p: Any) -> list[list[list[Any]]]:
        """Those matrices, as rows of numbers."""
        at, found = len(super().numbers()), []
        for matrix in self._matrices(self.design):
            rows, columns = np.shape(matrix)
            found.append([[p[at + i * columns + j] for j in range(columns)] for i in range(rows)])
            at += rows * columns
        return found

    @property
    def remembered(self) -> int:
        """At least the last commands, which are in force when it measures."""
        return max(self._kept, len(self.design.plant.drives))

    def initial(self) -> tuple[float, ...]:
        """The estimate, and past commands."""
        return (*self.numbers()[-len(self.design.plant.states) :], *super().initial())

    @property
    def states(self) -> tuple[OwnState, ...]:
        """The estimate, and past commands."""
        return (*(OwnState(f"estimate.{name}") for name in self.design.plant.states), *super().states)

    def _fed(self, p: Any, m: Measured) -> list[Any]:
        """What is fed forward to each drive, less that at rest; nothing: none."""
        *_, still, factors = self._observing(p)
        each, found = iter(factors), []
        for k, one in enumerate(self._added):
            added = [next(each)[0] * m.signals[name] for name, _ in one] or [0.0]  # of a drive that is not fed
            found.append(vectors.total(added) - still[k][0])
        return found if any(self._added) else []

    def _filtered(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The estimate after the measurement."""
        before, (rest, C, M, _, _, *more) = x[: len(self.design.plant.states)], self._observing(p)
        before += self._past(p, x)
        moved = self._moved(self._parts(p)[1], m) if self.reference else []
        fed, new = self._fed(p, m), []
        for k, name in enumerate(self.measured):
            predicted = [c * value for c, value in zip(C[k], before, strict=False)]
            predicted += [c * value for c, value in zip(C[k], moved, strict=False)]
            predicted += [d * value for d, value in zip(more[1][k], fed, strict=True)] if fed else []
            new.append(m.signals[name] - rest[k][0] - vectors.total(predicted))
        return [
            value + vectors.total([gain * each for gain, each in zip(row, new, strict=True)])
            for value, row in zip(before, M, strict=False)
        ]

    def _state(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The estimate."""
        return self._filtered(p, m, x) if self.form is Form.FILTER else x[: len(self.design.plant.states)]

    def _off(self, deviation: list[Any], moved: list[Any]) -> list[Any]:
        """With a reference the estimate is of that itself."""
        return deviation if self.reference else super()._off(deviation, moved)

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The estimate for the next sample, and the commands of this one."""
        given, (_, _, _, Ad, Bd, *more) = self.command(p, m, x), self._observing(p)
        pushed, after = self._less_rest(p, given), [*self._filtered(p, m, x), *self._past(p, x)[: self._kept]]
        fed = [] if self.reference else self._fed(p, m)
        pushes = [[*row, *(more[0][k] if fed else ())] for k, row in enumerate(Bd)]
        predicted = [
            vectors.total([*(a * value for a, value in zip(row, after, strict=True)),
                           *(b * value for b, value in zip(push, [*pushed, *fed], strict=True))])
            for row, push in zip(Ad, pushes, strict=True)
        ]  # fmt: skip
        return [*predicted, *[*given, *x[len(x) - self.remembered :]][: self.remembered]]

    @property
    def structure(self) -> str:
        """What it reads, and when, is part of the code."""
        return f"{super().structure} {self.measured} {self.form}"
