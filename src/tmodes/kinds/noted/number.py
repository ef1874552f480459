"""Noted numbers: a value, and the node of a tape that stands for it.

Arithmetic, and the functions that NumPy calls on the items of arrays of objects (``sqrt``, ``sin``, ...), add nodes to
the tape. Comparisons are decided at the value and add a guard. What would lose the node without a trace (``float``,
``int``, ``hash``, a format) raises, so that nothing is lost silently.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NoReturn

import numpy as np

__all__ = ["OPERATIONS", "RELATIONS", "Lost", "Noted", "NotedTape", "follow_no", "is_noted", "plain_value"]

OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": np.add, "sub": np.subtract, "mul": np.multiply, "div": np.divide, "pow": np.power, "neg": np.negative,
    "abs": np.abs, "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos, "tan": np.tan, "exp": np.exp, "log": np.log,
    "arcsin": np.arcsin, "arccos": np.arccos, "arctan": np.arctan, "arctan2": np.arctan2, "hypot": np.hypot,
    "tanh": np.tanh, "fmin": np.fmin, "fmax": np.fmax,
}  # fmt: skip
"""The operations of a tape, on numbers and on arrays of them."""

_QUICK: dict[str, Callable[..., Any]] = {
    "add": operator.add, "sub": operator.sub, "mul": operator.mul, "div": operator.truediv, "neg": operator.neg,
}  # fmt: skip
"""The most common ones on two numbers, faster than those of NumPy."""

RELATIONS: dict[str, Callable[..., Any]] = {
    "<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal, "==": np.equal, "!=": np.not_equal,
    "not <": lambda a, b: ~np.less(a, b), "not <=": lambda a, b: ~np.less_equal(a, b),
    "not >": lambda a, b: ~np.greater(a, b), "not >=": lambda a, b: ~np.greater_equal(a, b),
    "not ==": np.not_equal, "not !=": np.equal, "finite": lambda a, b: np.isfinite(a + 0 * b),
}  # fmt: skip
"""What a guard asks of two nodes."""


class Lost(TypeError):
    """An operation by which a noted ``number`` would become a plain one, so that a program could not follow."""

    def __init__(self, message: str, number: Any = None) -> None:
        super().__init__(message)
        self.number = number


class NotedTape:
    """Operations in order, each once: ``nodes`` of (operation, operands); constants and inputs are nodes too."""

    def __init__(self) -> None:
        self.nodes: list[tuple[Any, ...]] = []
        self.values: list[float] = []
        self.guards: dict[tuple[str, int, int], None] = {}
        self.names: dict[str, int] = {}
        self._known: dict[tuple[Any, ...], int] = {}

    def input(self, value: float, name: str = "") -> Noted:
        """One more input."""
        self.names[name] = len(self.nodes)
        return Noted(self, self._node(("input", len(self.nodes)), float(value)), float(value))

    def constant(self, value: float) -> int:
        """The node of a constant; zeros of both signs are different ones."""
        return self._node(("constant", value, math.copysign(1.0, value)), value)

    def _node(self, node: tuple[Any, ...], value: float) -> int:
        found = self._known.get(node)
        if found is None:
            found = self._known[node] = len(self.nodes)
            self.nodes.append(node)
            self.values.append(value)
        return found

    def operand(self, x: Any) -> int | None:
        """The node of a number; None for what is none."""
        if type(x) is Noted:
            if x.tape is not self:
                raise Lost("numbers of two tapes do not mix")
            return x.node
        if isinstance(x, (float, int, np.floating, np.integer)):
            return self.constant(float(x))
        return None

    def noted(self, operation: str, *operands: int) -> Noted:
        """The result of an operation on nodes."""
        node = (operation, *operands)
        found = self._known.get(node)
        if found is None:
            values = [self.values[k] for k in operands]
            try:
                value = _QUICK[operation](*values)
            except (KeyError, ZeroDivisionError, OverflowError):
                with np.errstate(all="ignore"):
                    value = float(OPERATIONS[operation](*map(np.float64, values)))
            found = self._node(node, value)
        return Noted(self, found, self.values[found])

    def inputs_of(self, node: int) -> set[int]:
        """The inputs that a node depends on."""
        found, stack, seen = set[int](), [node], set[int]()
        while stack:
            own = stack.pop()
            if own in seen:
                continue
            seen.add(own)
            operation, *operands = self.nodes[own]
            if operation == "input":
                found.add(own)
            elif operation != "constant":
                stack += operands
        return found

    def guard(self, relation: str, a: int, b: int) -> bool:
        """Decide a relation at the values, and note the decision."""
        holds = bool(RELATIONS[relation](self.values[a], self.values[b]))
        plain = self.nodes[a][0] == "constant" and self.nodes[b][0] == "constant"
        if a != b and not plain:
            self.guards[relation if holds else f"not {relation}", a, b] = None
        return holds


def _binary(operation: str, *, reflected: bool = False) -> Callable[[Noted, Any], Any]:
    def method(self: Noted, other: Any) -> Any:
        if type(other) is not Noted:
            if not isinstance(other, (float, int, np.floating, np.integer)):
                return NotImplemented
            folded = _folded(operation, self, float(other), reflected)
            if folded is not None:
                return folded
        elif other.node == self.node and operation in ("sub", "div"):  # x/x of zero is met by a guard before
            return 0.0 if operation == "sub" else 1.0
        b = self.tape.operand(other)
        assert b is not None  # noqa: S101
        return self.tape.noted(operation, *((b, self.node) if reflected else (self.node, b)))

    return method


def _folded(operation: str, x: Noted, other: float, reflected: bool) -> Any:
    """The result of an operation with 0 or 1 that needs none; None where it does."""
    if operation in ("add", "sub") and other == 0.0:
        return -x if operation == "sub" and reflected else x
    if operation == "mul" and other in (0.0, 1.0):
        return x if other else 0.0
    if operation == "div" and (other == 0.0 if reflected else other == 1.0):
        return 0.0 if reflected else x
    if operation == "pow" and not reflected and other in (0.0, 1.0):
        return x if other else 1.0
    return None


def _unary(operation: str) -> Callable[[Noted], Noted]:
    return lambda self: self.tape.noted(operation, self.node)


def _compared(relation: str) -> Callable[[Noted, Any], Any]:
    def method(self: Noted, other: Any) -> Any:
        b = self.tape.operand(other)
        return NotImplemented if b is None else self.tape.guard(relation, self.node, b)

    return method


def _lost(what: str) -> Callable[..., NoReturn]:
    def method(self: Noted, *_: Any) -> NoReturn:
        raise Lost(f"{what} would lose what a noted number depends on; see tmodes.kinds.noted.functions", self)

    return method


class Noted:
    """A number with a ``value`` and the ``node`` of a ``tape``."""

    __slots__ = ("node", "tape", "value")

    def __init__(self, tape: NotedTape, node: int, value: float) -> None:
        self.tape, self.node, self.value = tape, node, value

    def __repr__(self) -> str:
        return f"noted({self.value!r})"

    def __bool__(self) -> bool:
        return self.tape.guard("!=", self.node, self.tape.constant(0.0))

    def __pos__(self) -> Noted:
        return self

    def conjugate(self) -> Noted:
        """Itself."""
        return self

    @property
    def finite(self) -> bool:
        """Whether it is finite, noted as a guard."""
        return self.tape.guard("finite", self.node, self.tape.constant(0.0))

    __add__, __radd__ = _binary("add"), _binary("add", reflected=True)
    __sub__, __rsub__ = _binary("sub"), _binary("sub", reflected=True)
    __mul__, __rmul__ = _binary("mul"), _binary("mul", reflected=True)
    __truediv__, __rtruediv__ = _binary("div"), _binary("div", reflected=True)
    __pow__, __rpow__ = _binary("pow"), _binary("pow", reflected=True)
    arctan2, hypot = _binary("arctan2"), _binary("hypot")
    fmin, fmax = _binary("fmin"), _binary("fmax")
    __neg__, __abs__ = _unary("neg"), _unary("abs")
    sqrt, sin, cos, tan, exp, log = map(_unary, ("sqrt", "sin", "cos", "tan", "exp", "log"))
    arcsin, arccos, arctan, tanh = map(_unary, ("arcsin", "arccos", "arctan", "tanh"))
    __lt__, __le__, __gt__, __ge__ = map(_compared, ("<", "<=", ">", ">="))
    __eq__, __ne__ = _compared("=="), _compared("!=")
    __float__, __int__, __index__, __complex__ = map(_lost, ("float()", "int()", "an index", "complex()"))
    __round__, __floor__, __ceil__, __trunc__ = map(_lost, ("round()", "floor()", "ceil()", "trunc()"))
    __hash__, __format__ = _lost("a key of a set or a dict"), _lost("a format")  # pyright: ignore[reportAssignmentType]


def is_noted(x: Any) -> bool:
    """Whether a number, or any item of an array or of nested lists, is noted."""
    if isinstance(x, np.ndarray):
        return x.dtype == object and any(type(item) is Noted for item in x.flat)
    if isinstance(x, (list, tuple)):
        return any(map(is_noted, x))
    return type(x) is Noted


def plain_value(x: Any) -> float:
    """The value of a number, noted or not, by which nothing may be decided that a program has to follow."""
    return x.value if type(x) is Noted else float(x)


def follow_no(what: str, *values: Any) -> None:
    """Raise :class:`Lost` where any of ``values``, of lists and mappings too, is noted: no program holds that."""
    if found := [*_noted_in(values)]:
        raise Lost(what, sum(found))


def _noted_in(x: Any) -> Iterator[Noted]:
    if isinstance(x, (list, tuple, np.ndarray, Mapping)):
        for item in x.values() if isinstance(x, Mapping) else x:
            yield from _noted_in(item)
    elif type(x) is Noted:
        yield x
