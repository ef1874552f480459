"""A whole schedule as one straight-line program: no calls, and nothing computed that is zero, known, or known twice.

What follows from the parameters alone is computed once per set of parameters and kept in the workspace, where nothing
else stands: the kernels' blocks between inputs and outputs do not exist here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from tmodes.compile.ir.program import BlockProgram, Instruction, kernel_program, needed

__all__ = ["Unrolled", "c_text", "unrolled"]

_COMMUTATIVE = ("add", "mul")
_ZERO_OF_ZERO = ("neg", "sq", "twice", "sin", "fabs", "sqrt", "copy")
_ZERO_OF_ANY = ("mul", "div", "if_else_zero")


@dataclass(frozen=True)
class Unrolled:
    """Two programs on one workspace; an input's ``source`` is (0, its place in the workspace).

    ``prepare`` follows from the parameters, ``main`` from these and from what prepare gave. Results are (place, index).
    """

    prepare: list[Instruction]
    prepared: list[tuple[int, int]]
    main: list[Instruction]
    results: list[tuple[int, int]]


def unrolled(schedule: Any) -> Unrolled:
    """The programs of a schedule; its outputs and its gate are given where the kernels would have put them."""
    numbered = _Numbered()
    given = [range(schedule.parameters), *(_span(schedule, slot) for slot in schedule.inputs.values())]
    memory = {place: numbered.value("input", source=(0, place)) for places in given for place in places}
    inputs = set(memory)
    memory |= {place: numbered.zero for slot in schedule.zeros for place in _span(schedule, slot)}
    for kernel, *slots in schedule.calls:
        taken, put = ([_span(schedule, slot) for slot in side] for side in slots)
        for output, element, value in numbered.inlined(kernel_program(kernel), [[memory[i] for i in s] for s in taken]):
            memory[put[output][element]] = value
    info = [*(slot for slots in schedule.outputs.values() for slot in slots), *schedule.watched]
    wanted = sorted({place for slot in info for place in _span(schedule, slot)} - inputs)
    results = [(place, memory[place]) for place in wanted]
    return _parted(numbered.values, results, schedule, set(wanted))


def _span(schedule: Any, slot: Any) -> range:
    return range(schedule.offset(slot), schedule.offset(slot) + slot.size)


class _Numbered:
    """Values in the order in which they are first computed, each once (value numbering); zeros and ones fold away."""

    def __init__(self) -> None:
        self._known: dict[Instruction, int] = {}
        self.zero = self.value("constant")
        self.one = self.value("constant", value=1.0)

    @property
    def values(self) -> list[Instruction]:
        return list(self._known)

    def value(self, kind: str, args: tuple[int, ...] = (), source: tuple[int, int] = (0, 0), value: float = 0.0) -> int:
        """Index of a value."""
        if self.zero_in(args):
            folded = self._folded(kind, args)
            if folded is not None:
                return folded
        if kind == "mul" and self.one in args:
            return args[0] if args[1] == self.one else args[1]
        args = tuple(sorted(args)) if kind in _COMMUTATIVE else args
        return self._known.setdefault(Instruction(kind, args, source, value), len(self._known))

    def zero_in(self, args: tuple[int, ...]) -> bool:
        """Whether any of the values is zero for certain."""
        return bool(args) and self.zero in args

    def _folded(self, kind: str, args: tuple[int, ...]) -> int | None:
        """The value of an operation with a zero, None where it is nothing simpler."""
        if kind in _ZERO_OF_ZERO or (kind in _ZERO_OF_ANY and (kind != "div" or args[0] == self.zero)):
            return self.zero
        if kind == "add":
            return args[0] if args[1] == self.zero else args[1]
        if kind == "sub":
            return args[0] if args[1] == self.zero else self.value("neg", (args[1],))
        return None

    def inlined(self, program: BlockProgram, inputs: list[list[int]]) -> list[tuple[int, int, int]]:
        """The values of a kernel for given inputs; its results as (output, element, index)."""
        here: list[int] = []
        for step in program.values:
            if step.opcode == "input":
                here.append(inputs[step.source[0]][step.source[1]])
            else:
                here.append(self.value(step.opcode, tuple(here[arg] for arg in step.args), value=step.value))
        return [(out, element, self.zero if i is None else here[i]) for out, element, i in program.results]


def _parted(values: list[Instruction], results: list[tuple[int, int]], schedule: Any, taken: set[int]) -> Unrolled:
    """What follows from the parameters apart from what changes, and a place in the workspace for what is kept."""
    fixed: list[bool] = []
    for value in values:
        known = value.opcode == "constant" or (value.opcode == "input" and value.source[1] < schedule.parameters)
        fixed.append(known or (value.opcode != "input" and all(fixed[arg] for arg in value.args)))
    ends = [index for _, index in results]
    used = {arg for index in needed(values, ends) if not fixed[index] for arg in values[index].args} | {*ends}
    kept = [i for i in sorted(used) if fixed[i] and values[i].opcode not in ("input", "constant")]
    taken |= {place for slot in schedule.inputs.values() for place in _span(schedule, slot)}
    free = [place for place in range(schedule.parameters, schedule.workspace) if place not in taken]
    prepared = [(place, index) for place, index in zip(free, kept, strict=False)]
    main = list(values)
    for place, index in prepared:
        main[index] = Instruction("input", source=(0, place))
    return Unrolled(*_shortened(values, prepared), *_shortened(main, results))


def _shortened(
    values: Sequence[Instruction], results: Sequence[tuple[int, int]]
) -> tuple[list[Instruction], list[tuple[int, int]]]:
    """The part of a program that its results need."""
    chosen = needed(values, [index for _, index in results])
    places = dict(zip(chosen, range(len(chosen)), strict=True))
    kept: list[Instruction] = []
    for index in chosen:
        kind, args, source, value = values[index]
        kept.append(Instruction(kind, tuple([places[arg] for arg in args]), source, value))
    return kept, [(place, places[index]) for place, index in results]


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
