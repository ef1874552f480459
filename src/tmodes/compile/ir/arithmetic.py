"""What a number is in compiled code: a double, a vector of lanes, or a value with its derivative.

One straight-line program becomes the code of each, so that lanes and derivatives need no second set of equations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from typing import Any, NamedTuple

from llvmlite import ir

from tmodes.compile.ir.emit import F64, at, number, spread, whole
from tmodes.compile.ir.trigonometry import sine_and_cosine, sines_and_cosines
from tmodes.compile.native import WIDTH

__all__ = ["Derivative", "Double", "Exact", "Lanes", "Second", "Wide"]

_FUSE = ("contract",)  # a product and a sum may become one operation with one rounding; nothing else is rearranged
_SIDE_BY_SIDE = 8  # sines that go at once: where a vector holds fewer, as two halves

_PLAIN: dict[str, Callable[..., Any]] = {
    "add": lambda b, x, y, numbers: b.fadd(x, y, flags=numbers.fuse),
    "sub": lambda b, x, y, numbers: b.fsub(x, y, flags=numbers.fuse),
    "mul": lambda b, x, y, numbers: b.fmul(x, y, flags=numbers.fuse),
    "sq": lambda b, x, _, numbers: b.fmul(x, x, flags=numbers.fuse),
    "twice": lambda b, x, _, numbers: b.fmul(x, numbers.constant(2.0), flags=numbers.fuse),
    "div": lambda b, x, y, _: b.fdiv(x, y),
    "inv": lambda b, x, _, numbers: b.fdiv(numbers.constant(1.0), x),
    "neg": lambda b, x, _, __: b.fneg(x),
    "copy": lambda b, x, _, __: x,
}


class Double:
    """One double; other kinds of numbers override how they are kept and computed with. ``stride`` doubles each."""

    stride = 1
    name = "double"
    kind: Any = F64
    unrolls = True
    """Whether small schedules become one program."""
    fuse: tuple[str, ...] = _FUSE
    packs = False
    """Whether blocks of a workspace share their room (:class:`tmodes.compile.ir.calls.Layout`)."""

    def __init__(self, module: Any) -> None:
        self.module = module

    def load(self, b: Any, base: Any, index: int) -> Any:
        """Number ``index`` of a block."""
        return b.load(self._place(b, base, index), align=8, typ=self.kind)

    def store(self, b: Any, value: Any, base: Any, index: int) -> None:
        """Keep a number in a block."""
        b.store(value, self._place(b, base, index), align=8)

    def _place(self, b: Any, base: Any, index: int) -> Any:
        return b.bitcast(at(b, base, index * self.stride), self.kind.as_pointer())

    def constant(self, value: float) -> Any:
        """A number known beforehand."""
        return number(value)

    def turn(self, b: Any, angle: Any) -> tuple[Any, Any]:
        """Sine and cosine."""
        alone = self.stride == 1
        function = sine_and_cosine(self.module) if alone else sines_and_cosines(self.module, self.stride)
        pair = b.call(function, [angle])
        return b.extract_value(pair, 0), b.extract_value(pair, 1)

    def turns(self, b: Any, angles: Sequence[Any]) -> list[tuple[Any, Any]]:
        """Sine and cosine of several angles, single ones eight at a time: to the bit those of each alone."""
        if self.stride > 1:
            return [self.turn(b, angle) for angle in angles]
        found: list[tuple[Any, Any]] = []
        for start in range(0, len(angles), _SIDE_BY_SIDE):
            found += self._turn_together(b, angles[start : start + _SIDE_BY_SIDE])
        return found

    def _turn_together(self, b: Any, angles: Sequence[Any]) -> list[tuple[Any, Any]]:
        if len(angles) == 1:
            return [self.turn(b, angles[0])]
        lanes = 1 << (len(angles) - 1).bit_length()
        packed = ir.Constant(ir.VectorType(F64, lanes), [0.0] * lanes)
        for lane, angle in enumerate(angles):
            packed = b.insert_element(packed, angle, whole(lane))
        pair = b.call(sines_and_cosines(self.module, lanes), [packed])
        sines, cosines = (b.extract_value(pair, k) for k in range(2))
        places = [whole(lane) for lane in range(len(angles))]
        return [(b.extract_element(sines, place), b.extract_element(cosines, place)) for place in places]

    def packed(self, b: Any, doubles: Sequence[Any]) -> Any:  # noqa: ARG002
        """A number from its doubles."""
        return doubles[0]

    def parts(self, b: Any, value: Any) -> list[Any]:  # noqa: ARG002
        """The doubles of a number."""
        return [value]

    def operation(self, b: Any, kind: str, x: Any, y: Any = None) -> Any:
        """The result of an operation of a program."""
        if kind in ("sqrt", "fabs"):
            return self.call(b, kind, x)
        if kind in _PLAIN:
            return _PLAIN[kind](b, x, y, self)
        return self._condition(b, kind, x, y)

    def call(self, b: Any, kind: str, *values: Any) -> Any:
        """An LLVM intrinsic: ``sqrt``, ``minnum``, ..."""
        name = f"llvm.{kind}.{'' if self.stride == 1 else f'v{self.stride}'}f64"
        function = self.module.globals.get(name)
        if function is None:
            function = ir.Function(self.module, ir.FunctionType(self.kind, [self.kind] * len(values)), name)
        return b.call(function, list(values))

    def _condition(self, b: Any, kind: str, x: Any, y: Any) -> Any:
        """Truth values are the numbers 1 and 0."""
        zero = self.constant(0.0)
        if kind == "sign":  # of 0 it is 1: the slope of the absolute value, taken from above
            return b.select(b.fcmp_ordered("<", x, zero), self.constant(-1.0), self.constant(1.0))
        if kind == "if_else_zero":
            return b.select(b.fcmp_unordered("!=", x, zero), y, zero)
        sign = {"lt": "<", "le": "<=", "not": "=="}[kind]
        holds = b.fcmp_ordered(sign, x, zero if kind == "not" else y)
        return b.select(holds, self.constant(1.0), zero)


class Lanes(Double):
    """Four doubles side by side: the same robot with other numbers in each."""

    stride = 4
    name = "lanes"
    kind: Any = ir.VectorType(F64, 4)
    packs = True

    def constant(self, value: float) -> Any:
        """A number known beforehand."""
        return _vector(float(value).hex(), self.kind)

    def packed(self, b: Any, doubles: Sequence[Any]) -> Any:
        """A vector from the numbers of its lanes; from one alone: that in all lanes."""
        if len(doubles) == 1:
            return self.spread(b, doubles[0])
        vector = self.constant(0.0)
        for lane, value in enumerate(doubles):
            vector = b.insert_element(vector, value, whole(lane))
        return vector

    def parts(self, b: Any, value: Any) -> list[Any]:
        """The doubles of a number."""
        return [b.extract_element(value, whole(lane)) for lane in range(self.stride)]

    def spread(self, b: Any, value: Any) -> Any:
        """A double in all lanes."""
        return spread(b, value, self.kind)


class Wide(Lanes):
    """As many lanes as a vector of this processor holds: eight doubles where it has AVX-512, else four.

    What a lane computes does not depend on how many are next to it.
    """

    stride = WIDTH
    name = f"wide{stride}"
    kind: Any = ir.VectorType(F64, stride)


class Exact(Wide):
    """Lanes in which every sum and product is rounded by itself, to the bits that NumPy finds."""

    name = f"exact{WIDTH}"
    fuse = ()


@lru_cache(maxsize=4096)
def _vector(value: str, kind: Any) -> Any:
    """A number in hexadecimal digits in all lanes; that it is written as text once is a third of the time to write."""
    return ir.Constant(kind, [float.fromhex(value)] * kind.count)


class _Pair(NamedTuple):
    """A value and its derivative, None where that is zero for certain."""

    value: Any
    slope: Any


def _linear(kind: str, do: Callable[..., Any], _: Any, x: Any) -> Any:
    return do(kind, x.slope)


_SLOPES: dict[str, Callable[[Callable[..., Any], Any, Any], Any]] = {
    "sq": lambda do, _, x: do("mul", do("twice", x.value), x.slope),
    "inv": lambda do, value, x: do("neg", do("mul", do("mul", value, value), x.slope)),
    "sqrt": lambda do, value, x: do("div", x.slope, do("twice", value)),
    "fabs": lambda do, _, x: do("mul", do("sign", x.value), x.slope),
}
"""Slope of a function of one number that is not linear: of (operations, its value, the number)."""


class Derivative(Double):
    """A value with its derivative in one direction: forward differentiation, exact."""

    stride = 2
    name = "derivative"
    unrolls = False  # seldom called, and twice as long
    inner: type[Double] = Double
    """Of the value and of the derivative."""

    def __init__(self, module: Any) -> None:
        super().__init__(module)
        self._plain, self._rounded = self.inner(module), self.inner(module)
        self._rounded.fuse = ()

    def load(self, b: Any, base: Any, index: int) -> Any:
        """Number ``index`` of a block."""
        return _Pair(self._plain.load(b, base, 2 * index), self._plain.load(b, base, 2 * index + 1))

    def store(self, b: Any, value: Any, base: Any, index: int) -> None:
        """Keep a number in a block."""
        slope = self._plain.constant(0.0) if value.slope is None else value.slope
        self._plain.store(b, value.value, base, 2 * index)
        self._plain.store(b, slope, base, 2 * index + 1)

    def packed(self, b: Any, doubles: Sequence[Any]) -> Any:
        """A value and its derivative; a value alone does not change."""
        half = len(doubles) // 2
        if not half:
            return _Pair(self._plain.packed(b, doubles), None)
        return _Pair(*(self._plain.packed(b, part) for part in (doubles[:half], doubles[half:])))

    def parts(self, b: Any, value: Any) -> list[Any]:
        """The doubles of a number."""
        return [part for one in value for part in self._plain.parts(b, one)]

    def constant(self, value: float) -> Any:
        """A number known beforehand."""
        return _Pair(self._plain.constant(value), None)

    def turn(self, b: Any, angle: Any) -> tuple[Any, Any]:
        """Sine and cosine."""
        sine, cosine = self._plain.turn(b, angle.value)
        slope = angle.slope
        if slope is None:
            return _Pair(sine, None), _Pair(cosine, None)
        return _Pair(sine, self._times(b, cosine, slope)), _Pair(cosine, self._less(b, self._times(b, sine, slope)))

    def operation(self, b: Any, kind: str, x: Any, y: Any = None) -> Any:
        """The result of an operation of a program."""
        value = self._plain.operation(b, kind, x.value, y.value if y else None)
        return _Pair(value, self._slope(b, kind, value, x, y))

    def _slope(self, b: Any, kind: str, value: Any, x: Any, y: Any) -> Any:
        if kind in ("lt", "le", "not", "sign"):
            return None
        if kind == "if_else_zero":
            return None if y.slope is None else self._plain.operation(b, kind, x.value, y.slope)
        if kind == "div":
            top = self._plus(b, x.slope, self._less(b, self._times(b, y.slope, value)))
            return None if top is None else self._plain.operation(b, kind, top, y.value)
        if kind == "mul":
            return self._plus(b, self._times(b, x.slope, y.value), self._times(b, y.slope, x.value))
        if kind in ("add", "sub"):
            return self._plus(b, x.slope, y.slope if kind == "add" else self._less(b, y.slope))
        do = partial(self._rounded.operation, b)
        return None if x.slope is None else _SLOPES.get(kind, partial(_linear, kind))(do, value, x)

    def _times(self, b: Any, slope: Any, factor: Any) -> Any:
        return None if slope is None else self._plain.operation(b, "mul", slope, factor)

    def _less(self, b: Any, slope: Any) -> Any:
        return None if slope is None else self._plain.operation(b, "neg", slope)

    def _plus(self, b: Any, one: Any, other: Any) -> Any:
        if one is None or other is None:
            return other if one is None else one
        return self._plain.operation(b, "add", one, other)


class Second(Derivative):
    """A value with its derivatives along two directions and along both; those of parameters count too."""

    stride = 4
    name = "second"
    inner = Derivative
