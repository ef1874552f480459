"""sin and cos as inlined native code: both from one argument reduction, without a call in the loop.

Cody-Waite reduction by pi/2 in three parts and the minimax polynomials of Sun's fdlibm (k_sin.c, k_cos.c, e_rem_pio2.c;
Ng, 1992). Beyond |x| = 2^19 pi/2 the C library is called, which reduces exactly. Checked against mpmath in the tests.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.emit import F64, I64, declare, number, whole

__all__ = ["FAR_COSINE", "FAR_SINE", "sine_and_cosine"]

FAR_SINE, FAR_COSINE = "tmodes_far_sin", "tmodes_far_cos"
"""Symbols bound to the C library's sin and cos."""

_REACH = 2.0**19 * 1.5707963267948966
_TWO_OVER_PI = 6.36619772367581382433e-01
_HALF_PI = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
_SIN = (-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
        2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10)  # fmt: skip
_COS = (4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
        -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11)  # fmt: skip


def sine_and_cosine(module: Any) -> Any:
    """The private function ``sincos(x) -> {sin x, cos x}`` of a module, made at its first use."""
    if "sincos" in module.globals:
        return module.globals["sincos"]
    function = declare(module, "sincos", ir.LiteralStructType([F64, F64]), [("x", F64)], private=True)
    function.attributes.add("alwaysinline")
    builder = ir.IRBuilder(function.append_basic_block("entry"))
    near, far = function.append_basic_block("near"), function.append_basic_block("far")
    x = function.args[0]
    magnitude = builder.call(module.declare_intrinsic("llvm.fabs", [F64]), [x])
    builder.cbranch(builder.fcmp_ordered("<", magnitude, number(_REACH)), near, far)
    builder.position_at_end(near)
    _answer(builder, *_near(builder, module, x))
    builder.position_at_end(far)
    names = (FAR_SINE, FAR_COSINE)
    _answer(builder, *(builder.call(declare(module, name, F64, [("x", F64)]), [x]) for name in names))
    return function


def _answer(builder: Any, sine: Any, cosine: Any) -> None:
    pair = ir.Constant(ir.LiteralStructType([F64, F64]), ir.Undefined)
    builder.ret(builder.insert_value(builder.insert_value(pair, sine, 0), cosine, 1))


def _near(b: Any, module: Any, x: Any) -> tuple[Any, Any]:
    """Sine and cosine of an argument within reach: x = n pi/2 + (head + tail), then a polynomial and a quadrant."""
    turns = b.call(module.declare_intrinsic("llvm.rint", [F64]), [b.fmul(x, number(_TWO_OVER_PI))])
    first = b.fsub(x, b.fmul(turns, number(_HALF_PI[0])))
    second = b.fmul(turns, number(_HALF_PI[1]))
    rest = b.fsub(first, second)
    lost = b.fsub(b.fsub(first, rest), second)
    third = b.fsub(b.fmul(turns, number(_HALF_PI[2])), lost)
    head = b.fsub(rest, third)
    tail = b.fsub(b.fsub(rest, head), third)
    sine, cosine = _sine(b, head, tail), _cosine(b, head, tail)
    quadrant = b.fptosi(turns, I64)
    odd = b.icmp_signed("!=", b.and_(quadrant, whole(1)), whole(0))
    sign_of_sine = b.and_(quadrant, whole(2))
    sign_of_cosine = b.and_(b.add(quadrant, whole(1)), whole(2))
    return (
        _signed(b, b.select(odd, cosine, sine), sign_of_sine),
        _signed(b, b.select(odd, sine, cosine), sign_of_cosine),
    )


def _signed(b: Any, value: Any, bit: Any) -> Any:
    """``value``, negated where bit 1 is set: the sign bit is flipped, without a branch."""
    return b.bitcast(b.xor(b.bitcast(value, I64), b.shl(bit, whole(62))), F64)


def _polynomial(b: Any, z: Any, coefficients: tuple[float, ...]) -> Any:
    value: Any = number(coefficients[-1])
    for coefficient in reversed(coefficients[:-1]):
        value = b.fadd(number(coefficient), b.fmul(z, value, flags=("contract",)), flags=("contract",))
    return value


def _sine(b: Any, y: Any, tail: Any) -> Any:
    z = b.fmul(y, y)
    cube = b.fmul(z, y)
    r = _polynomial(b, z, _SIN[1:])
    inner = b.fsub(b.fmul(number(0.5), tail), b.fmul(cube, r))
    correction = b.fsub(b.fsub(b.fmul(z, inner), tail), b.fmul(cube, number(_SIN[0])))
    return b.fsub(y, correction)


def _cosine(b: Any, y: Any, tail: Any) -> Any:
    z = b.fmul(y, y)
    r = b.fmul(z, _polynomial(b, z, _COS))
    half = b.fmul(number(0.5), z)
    main = b.fsub(number(1.0), half)
    lost = b.fsub(b.fsub(number(1.0), main), half)
    return b.fadd(main, b.fadd(lost, b.fsub(b.fmul(z, r), b.fmul(y, tail))))
