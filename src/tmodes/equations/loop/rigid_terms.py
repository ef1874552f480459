"""The rigid robot inside a control law: efforts for a motion with their time derivatives, and where the tip is.

The schedules of a chain are run on symbols, so that a law is exact and compiled as one function (R. M. Murray, Z. Li,
S. S. Sastry, A Mathematical Introduction to Robotic Manipulation, 1994, chapter 4; M. W. Spong, Modeling and control of
elastic joint robots, ASME J. Dyn. Sys. Meas. Control 109, 1987).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.equations.mechanics import mechanics
from tmodes.equations.recursion.passes import BASE, resting_base
from tmodes.kinds.kernel.schedule import Schedule

__all__ = ["RigidModel", "RigidTerms", "symbolic_outputs"]


def symbolic_outputs(schedule: Schedule, parameters: Sequence[Any], inputs: dict[str, Any]) -> dict[str, list[Any]]:
    """The outputs of a schedule as expressions of its ``parameters`` and ``inputs``; inputs left out are zero."""
    numbers: list[Any] = [*parameters, *([0.0] * schedule.changing)]
    for name, slot in schedule.inputs.items():
        if name in inputs:
            numbers[schedule.span(slot)] = list(inputs[name])
    for kernel, given, found in schedule.calls:
        blocks = kernel.build(*(ca.SX(ca.vertcat(*numbers[schedule.span(slot)])) for slot in given))
        for slot, block in zip(found, blocks, strict=True):
            numbers[schedule.span(slot)] = [block[k] for k in range(slot.size)]
    return {name: [each for slot in slots for each in numbers[schedule.span(slot)]]
            for name, slots in schedule.outputs.items()}  # fmt: skip


@dataclass(frozen=True)
class RigidModel:
    """A chain of rigid links and gears as a law reads it: its structure, and its numbers in one row.

    Behind the numbers of the chain stand those of a base at rest, then of each drive, in the order of ``drives``:
    rotor inertia, viscous friction of the motor, stiffness of the gear (0 of a rigid one).
    """

    chain: Chain = field(compare=False)
    drives: tuple[str, ...]
    numbers: tuple[float, ...] = field(compare=False)
    key: str

    @classmethod
    def of(cls, chain: Chain, drives: tuple[str, ...], motors: NDArray[np.float64]) -> RigidModel:
        """Of a chain; ``motors`` (drives, 3): inertia, viscous friction, stiffness."""
        made = mechanics(chain)
        numbers = (*made.parts.numbers.vector, *resting_base(chain), *np.asarray(motors).ravel())
        return cls(chain, drives, tuple(numbers), made.schedule("inertia").key)

    def terms(self, p: Sequence[Any]) -> RigidTerms:
        """Its functions, of its numbers as symbols."""
        return RigidTerms(self, list(p))


class RigidTerms:
    """Functions of angles q, rates v, accelerations a (lists in the order of the drives), as expressions."""

    def __init__(self, model: RigidModel, p: list[Any]) -> None:
        made = mechanics(model.chain)
        self._schedule, names = made.schedule("inertia"), list(made.parts.names)
        count, size = len(p) - BASE - 3 * len(model.drives), len(names)
        self._numbers, self._base = p[:count], p[count : count + BASE]
        self._order, self._size = [names.index(name) for name in model.drives], size
        motors = [p[count + BASE + 3 * k :][:3] for k in range(len(model.drives))]
        self.inertia, self.viscous, self.stiffness = ([row[k] for row in motors] for k in range(3))

    def _found(self, q: list[Any], v: list[Any], a: list[Any]) -> dict[str, list[Any]]:
        def placed(values: list[Any]) -> list[Any]:
            whole: list[Any] = [0.0] * self._size
            for place, value in zip(self._order, values, strict=True):
                whole[place] = value
            return whole

        given = {"q": placed(q), "v": placed(v), "a": placed(a), "base": self._base}
        return symbolic_outputs(self._schedule, self._numbers, given)

    def torque(self, q: list[Any], v: list[Any], a: list[Any]) -> list[Any]:
        """Efforts on the links: M(q) a + c(q, v) + g(q), without rotors and friction [N*m or N]."""
        found = self._found(q, v, a)["forces"]
        return [found[place] for place in self._order]

    def gravity(self, q: list[Any]) -> list[Any]:
        """Efforts that hold the links at q [N*m or N]."""
        none = [0.0] * len(q)
        return self.torque(q, none, none)

    def acceleration(self, q: list[Any], v: list[Any], effort: list[Any]) -> list[Any]:
        """Accelerations of the links under efforts on them."""
        bias = self.torque(q, v, [0.0] * len(q))
        return self._solved(q, [push - each for push, each in zip(effort, bias, strict=True)])

    def jerk(self, q: list[Any], v: list[Any], a: list[Any], rate: list[Any]) -> list[Any]:
        """Rates of the accelerations, where the efforts on the links change at a ``rate``."""
        none = [0.0] * len(q)
        _, bias, _ = self.torque_rates(q, v, a, none, none)
        return self._solved(q, [push - each for push, each in zip(rate, bias, strict=True)])

    def _solved(self, q: list[Any], right: list[Any]) -> list[Any]:
        """M(q)^-1 times the right side."""
        n, a, none = len(q), ca.SX.sym("a", len(q)), [0.0] * len(q)
        mass = ca.jacobian(ca.SX(ca.vertcat(*self.torque(q, none, ca.vertsplit(a)))), a)
        return _solved([[*(mass[i, j] for j in range(n)), right[i]] for i in range(n)])

    def torque_along(self, q: list[Any], v: list[Any], along: list[Any], a: list[Any]) -> list[Any]:
        """M(q) a + C(q, v) along + g(q), where C is that of Christoffel's symbols, with which M' - 2 C is skew.

        c(q, v) = C(q, v) v is a quadratic form of v, so that its differences give C.
        """
        ahead = self.torque(q, [x + y for x, y in zip(v, along, strict=True)], [2 * each for each in a])
        behind = self.torque(q, [x - y for x, y in zip(v, along, strict=True)], [-2 * each for each in a])
        rows = zip(ahead, behind, self.gravity(q), strict=True)
        return [(one - other) / 4 + weight for one, other, weight in rows]

    def torque_rates(self, *motion: list[Any]) -> tuple[list[Any], list[Any], list[Any]]:
        """The efforts with their first and second derivative by time, of q and its first four derivatives."""
        return self.time_derivatives(lambda q: self.torque(*q[:3]), motion)

    @staticmethod
    def time_derivatives(
        of: Callable[..., list[Any]], *motions: Sequence[list[Any]]
    ) -> tuple[list[Any], list[Any], list[Any]]:
        """What a function gives, with its first and second derivative by time.

        ``of(*motions)``; each motion: a list of values, of their rates, and so on, up to what the result depends on.
        """
        symbols = [[ca.SX.sym(f"m{j}{k}", len(one)) for k, one in enumerate(each)] for j, each in enumerate(motions)]
        chain = [pair for each in symbols for pair in pairwise(each)]
        first = ca.SX(ca.vertcat(*of(*([ca.vertsplit(one) for one in each] for each in symbols))))

        def rate(expression: Any) -> Any:
            return sum((ca.jtimes(expression, one, after) for one, after in chain), ca.SX.zeros(first.shape[0]))

        second = rate(first)
        values = [ca.SX(ca.vertcat(*one)) for each in motions for one in each]
        found = ca.substitute([first, second, rate(second)], [one for each in symbols for one in each], values)
        return tuple([one[k] for k in range(first.shape[0])] for one in found)  # pyright: ignore[reportReturnType]

    def tip(self, q: list[Any]) -> list[Any]:
        """Position of the tip in the world [m]."""
        none = [0.0] * len(q)
        return self._found(q, none, none)["points"][9:12]

    def tip_jacobian(self, q: list[Any]) -> list[list[Any]]:
        """Its derivatives by q: a row for each of x, y, z."""
        symbols = ca.SX.sym("q", len(q))
        place = ca.SX(ca.vertcat(*self.tip(ca.vertsplit(symbols))))
        (found,) = ca.substitute([ca.jacobian(place, symbols)], [symbols], [ca.SX(ca.vertcat(*q))])
        return [[found[i, j] for j in range(len(q))] for i in range(3)]


def _solved(rows: list[list[Any]]) -> list[Any]:
    """Solution of symmetric positive equations by elimination; each row ends with its right side."""
    n = len(rows)
    for k in range(n):
        for i in range(k + 1, n):
            share = rows[i][k] / rows[k][k]
            rows[i] = [
                *rows[i][:k],
                0.0,
                *(x - share * y for x, y in zip(rows[i][k + 1 :], rows[k][k + 1 :], strict=True)),
            ]
    found: list[Any] = [0.0] * n
    for i in reversed(range(n)):
        rest = rows[i][n]
        for j in range(i + 1, n):
            rest = rest - rows[i][j] * found[j]
        found[i] = rest / rows[i][i]
    return found
