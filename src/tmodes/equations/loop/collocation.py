"""Optimal control by direct collocation: the closed loop's equations on symbols, and IPOPT.

Hermite-Simpson in separated form on even intervals, the controls linear in each (J. T. Betts, Practical Methods for
Optimal Control and Estimation Using Nonlinear Programming, 2010, section 4.5).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.rigid_terms import symbolic_outputs
from tmodes.errors import SimulationError
from tmodes.kinds.kernel.schedule import Schedule

__all__ = ["Collocated", "Transcription"]

Array = NDArray[np.float64]

_STEPS = 300
"""Of IPOPT at most."""

_SHORTEST, _LONGEST = 0.01, 100.0
"""Of times that are searched, over the first one."""


class Collocated(NamedTuple):
    """``states`` (2 n + 1, size) at the ends and in the middle of n intervals, ``controls`` (n + 1, m) at the ends."""

    duration: float
    states: Array
    controls: Array


@dataclass(frozen=True, eq=False)
class Transcription:
    """A right-hand side (time, state, row) -> rate, some of whose ``row`` are the controls, from rest to rest.

    ``moving``: of the state, what counts; ``controls``: places in the row; ``first``, ``last`` (size,): ends of what
    counts; ``most`` (m,), ``fastest`` (size,): limits, infinite for none; ``sizes`` (m,) of the controls.
    """

    schedule: Schedule
    parameters: Array
    row: Array
    moving: Sequence[int]
    controls: Sequence[int]
    first: Array
    last: Array
    most: Array
    fastest: Array
    sizes: Array

    @property
    def rate(self) -> Any:
        """The rates of what counts, a function of that and of the controls over their sizes."""
        x, u = ca.SX.sym("x", len(self.moving)), ca.SX.sym("u", len(self.controls))
        state: list[Any] = [0.0] * self.schedule.inputs["state"].size
        row: list[Any] = self.row.tolist()
        for k, place in enumerate(self.moving):
            state[place] = x[k]
        for k, place in enumerate(self.controls):
            row[place] = u[k] * float(self.sizes[k])
        given = {"time": [0.0], "state": state, "row": row}
        found = symbolic_outputs(self.schedule, self.parameters.tolist(), given)["rate"]
        return ca.Function("rate", [x, u], [ca.SX(ca.vertcat(*(found[place] for place in self.moving)))])

    def solved(self, guess: Collocated, *, least_time: bool) -> Collocated:
        """The controls of least mean square, over their sizes, or of the least time, on the intervals of the guess.

        Raises :class:`tmodes.errors.SimulationError` where IPOPT finds none.
        """
        count, rate = len(guess.controls) - 1, self.rate
        x, u = ca.MX.sym("x", len(self.moving), 2 * count + 1), ca.MX.sym("u", len(self.controls), count + 1)
        time = ca.MX.sym("time")
        ends, between = x[:, ::2], x[:, 1::2]
        before, after = u[:, :-1], u[:, 1:]
        at_ends, at_middle = rate.map(count + 1)(ends, u), rate.map(count)(between, (before + after) / 2)
        step, low, high = time / count, at_ends[:, :-1], at_ends[:, 1:]
        defects = [
            ends[:, 1:] - ends[:, :-1] - step / 6 * (low + 4 * at_middle + high),
            between - (ends[:, :-1] + ends[:, 1:]) / 2 - step / 8 * (low - high),
        ]
        square = ca.sumsqr(before) + ca.sumsqr(after) + ca.sum2(ca.sum1(before * after))
        problem = {
            "x": ca.vertcat(ca.vec(x), ca.vec(u), time),
            "f": time / guess.duration if least_time else square / (3 * count),
            "g": ca.vertcat(*map(ca.vec, defects)),
        }
        quiet = {
            "print_time": 0,
            "ipopt": {"print_level": 0, "sb": "yes", "max_iter": _STEPS, "tol": 1e-9, "honor_original_bounds": "yes"},
        }
        solver = ca.nlpsol("solver", "ipopt", problem, quiet)
        low_states = np.tile(-self.fastest, (2 * count + 1, 1))
        high_states = -low_states
        for row, end in ((0, self.first), (-1, self.last)):
            low_states[row] = high_states[row] = end
        bound = np.tile(self.most / self.sizes, count + 1)
        times = np.array([_SHORTEST, _LONGEST] if least_time else [1.0, 1.0]) * guess.duration
        found = solver(
            x0=np.concatenate([guess.states.ravel(), (guess.controls / self.sizes).ravel(), [guess.duration]]),
            lbx=np.concatenate([low_states.ravel(), -bound, times[:1]]),
            ubx=np.concatenate([high_states.ravel(), bound, times[1:]]),
            lbg=0.0,
            ubg=0.0,
        )
        if not solver.stats()["success"]:
            why = solver.stats()["return_status"]
            raise SimulationError(f"collocation: IPOPT found no motion ({why}); give more time or higher limits")
        numbers = np.array(found["x"]).ravel()
        split = guess.states.size
        states, controls = numbers[:split].reshape(guess.states.shape), numbers[split:-1].reshape(guess.controls.shape)
        return Collocated(float(numbers[-1]), states, controls * self.sizes)
