"""A schedule as one straight program: all its calls written into each other. For small robots, and for comparison."""

from __future__ import annotations

from typing import Any

import casadi as ca

__all__ = ["c_text", "inlined"]


def inlined(schedule: Any, name: str = "inlined") -> ca.Function:
    """All calls of a schedule as one function of its inputs, in their order, and the parameters; one output vector."""
    parameters = ca.SX.sym("parameters", schedule.parameters)
    values: dict[int, ca.SX] = {}

    def put(slot: Any, block: Any) -> None:
        values.update((slot.start + k, block[k]) for k in range(slot.size))

    def get(slot: Any) -> Any:
        if slot.region == "parameters":
            return parameters[slot.start : slot.start + slot.size]
        return ca.vertcat(*(values[slot.start + k] for k in range(slot.size)))

    symbols = {label: ca.SX.sym(label, slot.size) for label, slot in schedule.inputs.items()}
    for label, slot in schedule.inputs.items():
        put(slot, symbols[label])
    made: dict[str, ca.Function] = {}
    for kernel, inputs, outputs in schedule.calls:
        function = made.setdefault(f"{kernel.key} {kernel.inputs}", kernel.function())
        for slot, block in zip(outputs, function.call([get(slot) for slot in inputs]), strict=True):
            put(slot, ca.densify(block))
    results = ca.vertcat(*(get(slot) for slots in schedule.outputs.values() for slot in slots))
    return ca.Function(name, [*symbols.values(), parameters], [ca.densify(results)], {"cse": True})


def c_text(function: ca.Function) -> str:
    """The instruction list of a function as C, with CasADi's calling convention and the function's own name."""
    generator = ca.CodeGenerator(function.name(), {"with_header": False})
    generator.add(function)
    return generator.dump()
