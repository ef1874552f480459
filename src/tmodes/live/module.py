"""A robot's equations as one WebAssembly module, and what its engine in JavaScript must know of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, OPTIONS, Status
from tmodes.compile.wasm.wasm import Part, wasm_module
from tmodes.compile.wasm.wasm_parts import each_once
from tmodes.simulation.native_run import BOUND, EVENT_TIME, MOST_EVENTS

__all__ = ["FORMAT", "Functions", "LiveModule"]

FORMAT = 1
"""Number of the way in which a layout is written."""


@dataclass(frozen=True)
class LiveModule:
    """``wasm``: the module, with memory of its own; ``layout``: plain data by which the engine calls it."""

    wasm: bytes
    layout: dict[str, Any]


@dataclass
class Functions:
    """What goes into a module: code, and by the names that the engine knows, loops and functions over samples."""

    parts: list[Part] = field(default_factory=list)
    loops: dict[str, dict[str, Any]] = field(default_factory=dict)
    samples: dict[str, dict[str, Any]] = field(default_factory=dict)

    def loop(self, name: str, parts: Sequence[Part], *, size: int, row: int, parameters: int) -> None:
        """A time loop, whose function is the first part's: numbers of its state, of a row of signals, of parameters."""
        self.parts += parts
        info = {"export": parts[0].symbols[0], "size": size, "row": row, "parameters": parameters}
        self.loops[name] = info | {"method": name.rpartition(".")[2]}

    def program(
        self, name: str, export: str, inputs: Mapping[str, int], outputs: Mapping[str, int], parameters: int
    ) -> None:
        """A function over samples of a part already there, each input and the output an array of its own."""
        info: dict[str, Any] = {"export": export, "kind": "program", "inputs": dict(inputs), "outputs": dict(outputs)}
        self.samples[name] = info | {"parameters": parameters, "workspace": 0}

    def schedule(self, name: str, parts: Sequence[Part], schedule: Any, *, stride: int = 1) -> None:
        """A schedule over samples, whose function is the first part's; ``stride`` 2: with derivatives."""
        self.parts += parts
        inputs = {label: slot.size for label, slot in schedule.inputs.items()}
        outputs = {label: sum(slot.size for slot in slots) for label, slots in schedule.outputs.items()}
        self.samples[name] = {
            "export": parts[0].symbols[0], "kind": "schedule" if stride == 1 else "slopes", "inputs": inputs,
            "outputs": outputs, "parameters": schedule.parameters, "workspace": stride * schedule.workspace,
        }  # fmt: skip

    def module(self, name: str, **info: Any) -> LiveModule:
        """The compiled module; ``info``: what else its layout holds."""
        parts = each_once(self.parts)
        layout = {
            "format": FORMAT, "cells": [*CELLS], "options": [*OPTIONS], "arguments": [*ARGUMENTS],
            "statuses": {status.name.lower(): int(status) for status in Status},
            "limits": {"bound": BOUND, "most_events": MOST_EVENTS, "event_time": EVENT_TIME},
            "simd": any(part.simd for part in parts), "loops": self.loops, "samples": self.samples,
        }  # fmt: skip
        return LiveModule(wasm_module(name, parts), layout | info)
