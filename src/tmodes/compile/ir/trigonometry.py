"""sin and cos as inlined native code: both from one argument reduction, without a call in the loop.

Of one double, or of a vector of them to the same bits: one piece of code writes both. Cody-Waite reduction by pi/2 in
three parts and the minimax polynomials of Sun's fdlibm (k_sin.c, k_cos.c, e_rem_pio2.c; Ng, 1992). Beyond
|x| = 2^19 pi/2 the C library is called, which reduces exactly. Checked against mpmath in the tests.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.emit import F64, I64, POINTER, Builder, counted, declare, load, number, store
from tmodes.compile.native import FAR_COSINE, FAR_SINE

__all__ = ["of_quarter_turns", "sine_and_cosine", "sines_and_cosines"]

_REACH = 2.0**19 * 1.5707963267948966
_TO_INTEGER = 1.5 * 2.0**52  # added to a whole number below 2^51, it leaves that number in the low bits
_TWO_OVER_PI = 6.36619772367581382433e-01
_HALF_PI = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
_SIN = (-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
        2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10)  # fmt: skip
_COS = (4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
        -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11)  # fmt: skip


@dataclass(frozen=True)
class _Width:
    """How wide the numbers are: constants and intrinsics of one double (0 lanes) or of a vector."""

    module: Any
    lanes: int = 0

    @cached_property
    def kind(self) -> Any:
        return ir.VectorType(F64, self.lanes) if self.lanes else F64

    @cached_property
    def integer(self) -> Any:
        return ir.VectorType(I64, self.lanes) if self.lanes else I64

    def number(self, value: float) -> Any:
        return ir.Constant(self.kind, [value] * self.lanes if self.lanes else value)

    def whole(self, value: int) -> Any:
        return ir.Constant(self.integer, [value] * self.lanes if self.lanes else value)

    def call(self, b: Any, name: str, x: Any) -> Any:
        """Call of an intrinsic of one number; llvmlite names those of single numbers only."""
        name = f"llvm.{name}.v{self.lanes}f64" if self.lanes else f"llvm.{name}.f64"
        known = self.module.globals.get(name)
        return b.call(known or ir.Function(self.module, ir.FunctionType(self.kind, [self.kind]), name), [x])


def sine_and_cosine(module: Any) -> Any:
    """The private function ``sincos(x) -> {sin x, cos x}`` of a module, made at its first use."""
    if "sincos" in module.globals:
        return module.globals["sincos"]
    function = declare(module, "sincos", ir.LiteralStructType([F64, F64]), [("x", F64)], private=True)
    function.attributes.add("alwaysinline")
    builder = Builder(function.append_basic_block("entry"))
    near, far = function.append_basic_block("near"), function.append_basic_block("far")
    x, width = function.args[0], _Width(module)
    magnitude = width.call(builder, "fabs", x)
    builder.cbranch(builder.fcmp_ordered("<", magnitude, number(_REACH)), near, far)
    builder.position_at_end(near)
    _answer(builder, *_near(builder, width, x))
    builder.position_at_end(far)
    names = (FAR_SINE, FAR_COSINE)
    _answer(builder, *(builder.call(declare(module, name, F64, [("x", F64)]), [x]) for name in names))
    return function


def sines_and_cosines(module: Any, lanes: int) -> Any:
    """The private function ``{sin x, cos x}`` of a vector of a power of two of lanes; bits as those of one double.

    Where any lane is beyond the reach, all go one by one.
    """
    name = f"sincos{lanes}"
    if name in module.globals:
        return module.globals[name]
    width = _Width(module, lanes)
    pair = ir.LiteralStructType([width.kind, width.kind])
    function = declare(module, name, pair, [("x", width.kind)], private=True)
    function.attributes.add("alwaysinline")
    builder = Builder(function.append_basic_block("entry"))
    near, far = function.append_basic_block("near"), function.append_basic_block("far")
    x = function.args[0]
    within = builder.fcmp_ordered("<", width.call(builder, "fabs", x), width.number(_REACH))
    mask = ir.IntType(lanes)
    builder.cbranch(builder.icmp_unsigned("==", builder.bitcast(within, mask), ir.Constant(mask, -1)), near, far)
    builder.position_at_end(near)
    _answer(builder, *_near(builder, width, x))
    builder.position_at_end(far)
    builder.ret(builder.call(_one_by_one(module, f"{name}.far", pair, width), [x]))
    return function


def _one_by_one(module: Any, name: str, pair: Any, width: _Width) -> Any:
    """The same function lane by lane, in a loop and kept out of the way."""
    function = declare(module, name, pair, [("x", width.kind)], private=True)
    function.attributes.add("noinline")
    function.attributes.add("cold")
    b = Builder(function.append_basic_block("entry"))
    lanes = [b.bitcast(b.alloca(width.kind), POINTER) for _ in range(3)]
    whole_vectors = [b.bitcast(each, width.kind.as_pointer()) for each in lanes]
    b.store(function.args[0], whole_vectors[0])
    with counted(b, width.lanes, "lane") as lane:
        found = b.call(sine_and_cosine(module), [load(b, lanes[0], lane)])
        for k in range(2):
            store(b, b.extract_value(found, k), lanes[1 + k], lane)
    _answer(b, *(b.load(each, typ=width.kind) for each in whole_vectors[1:]))
    return function


def _answer(builder: Any, sine: Any, cosine: Any) -> None:
    pair = ir.Constant(ir.LiteralStructType([sine.type, cosine.type]), ir.Undefined)
    builder.ret(builder.insert_value(builder.insert_value(pair, sine, 0), cosine, 1))


def _near(b: Any, width: _Width, x: Any) -> tuple[Any, Any]:
    """Sine and cosine of an argument within reach: x = n pi/2 + (head + tail), then a polynomial and a quadrant."""
    turns = width.call(b, "rint", b.fmul(x, width.number(_TWO_OVER_PI)))
    first = b.fsub(x, b.fmul(turns, width.number(_HALF_PI[0])))
    second = b.fmul(turns, width.number(_HALF_PI[1]))
    rest = b.fsub(first, second)
    lost = b.fsub(b.fsub(first, rest), second)
    third = b.fsub(b.fmul(turns, width.number(_HALF_PI[2])), lost)
    head = b.fsub(rest, third)
    tail = b.fsub(b.fsub(rest, head), third)
    return _turned(b, width, turns, head, tail)


def of_quarter_turns(b: Any, module: Any, turns: Any, head: Any, tail: Any) -> tuple[Any, Any]:
    """Sine and cosine of ``turns`` pi/2 + (head + tail), of doubles: a whole number below 2^51 and a rest to pi/4."""
    return _turned(b, _Width(module), turns, head, tail)


def _turned(b: Any, width: _Width, turns: Any, head: Any, tail: Any) -> tuple[Any, Any]:
    sine, cosine = _sine(b, width, head, tail), _cosine(b, width, head, tail)
    quadrant = b.bitcast(b.fadd(turns, width.number(_TO_INTEGER)), width.integer)
    odd = b.icmp_signed("!=", b.and_(quadrant, width.whole(1)), width.whole(0))
    sign_of_sine = b.and_(quadrant, width.whole(2))
    sign_of_cosine = b.and_(b.add(quadrant, width.whole(1)), width.whole(2))
    return (
        _signed(b, width, b.select(odd, cosine, sine), sign_of_sine),
        _signed(b, width, b.select(odd, sine, cosine), sign_of_cosine),
    )


def _signed(b: Any, width: _Width, value: Any, bit: Any) -> Any:
    """``value``, negated where bit 1 is set: the sign bit is flipped, without a branch."""
    return b.bitcast(b.xor(b.bitcast(value, width.integer), b.shl(bit, width.whole(62))), width.kind)


def _polynomial(b: Any, width: _Width, z: Any, coefficients: tuple[float, ...]) -> Any:
    value: Any = width.number(coefficients[-1])
    for coefficient in reversed(coefficients[:-1]):
        value = b.fadd(width.number(coefficient), b.fmul(z, value, flags=("contract",)), flags=("contract",))
    return value


def _sine(b: Any, width: _Width, y: Any, tail: Any) -> Any:
    z = b.fmul(y, y)
    cube = b.fmul(z, y)
    r = _polynomial(b, width, z, _SIN[1:])
    inner = b.fsub(b.fmul(width.number(0.5), tail), b.fmul(cube, r))
    correction = b.fsub(b.fsub(b.fmul(z, inner), tail), b.fmul(cube, width.number(_SIN[0])))
    return b.fsub(y, correction)


def _cosine(b: Any, width: _Width, y: Any, tail: Any) -> Any:
    z = b.fmul(y, y)
    r = b.fmul(z, _polynomial(b, width, z, _COS))
    half = b.fmul(width.number(0.5), z)
    main = b.fsub(width.number(1.0), half)
    lost = b.fsub(b.fsub(width.number(1.0), main), half)
    return b.fadd(main, b.fadd(lost, b.fsub(b.fmul(z, r), b.fmul(y, tail))))
