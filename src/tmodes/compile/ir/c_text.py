"""The straight-line programs of a schedule as C, for comparison with a C compiler: the same list of operations."""

from __future__ import annotations

from collections.abc import Sequence

from tmodes.compile.ir.program import Instruction
from tmodes.compile.ir.unroll import Unrolled

__all__ = ["c_text"]

_FORMS = {
    "add": "{} + {}", "sub": "{} - {}", "mul": "{} * {}", "div": "{} / {}", "lt": "{} < {}", "le": "{} <= {}",
    "neg": "-{}", "sq": "{0} * {0}", "twice": "2.0 * {}", "inv": "1.0 / {}", "copy": "{}", "not": "{} == 0.0",
    "sqrt": "sqrt({})", "sin": "sin({})", "cos": "cos({})", "fabs": "fabs({})", "sign": "{} < 0.0 ? -1.0 : 1.0",
    "if_else_zero": "{} != 0.0 ? {} : 0.0",
}  # fmt: skip


def c_text(code: Unrolled, name: str) -> str:
    """Two functions of C, ``NAME_prepare(double *w)`` and ``NAME(double *w)``, on one workspace."""
    parts = (f"{name}_prepare", code.prepare, code.prepared), (name, code.main, code.results)
    return "#include <math.h>\n" + "".join(_function(*part) for part in parts)


def _function(name: str, program: Sequence[Instruction], results: Sequence[tuple[int, int]]) -> str:
    lines = [f"    const double v{index} = {_value(value)};" for index, value in enumerate(program)]
    lines += [f"    w[{place}] = v{index};" for place, index in results]
    return "\n".join([f"void {name}(double *w)", "{", *lines, "}", ""])


def _value(value: Instruction) -> str:
    if value.opcode == "constant":
        return value.value.hex()
    if value.opcode == "input":
        return f"w[{value.source[1]}]"
    return _FORMS[value.opcode].format(*(f"v{arg}" for arg in value.args))
