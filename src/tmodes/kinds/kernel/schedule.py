"""Kernels, and a schedule of them: small functions of blocks of numbers, called in order on blocks of one workspace.

A kernel is written as expressions once and compiled once per structure. All is structure, and no backend.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial, wraps
from operator import attrgetter
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.noted.functions import array

__all__ = ["Divisible", "Kernel", "Numbers", "Schedule", "Slot", "kernel"]


@dataclass(frozen=True)
class Kernel:
    """``build`` takes a vector of symbols for each input size and returns a list of entries for each output size.

    ``key`` names the structure: two kernels of the same key are the same function. ``long``: thousands of operations,
    too many to be written out at each call. ``plain``: made of sums, products and quotients alone.
    """

    key: str
    inputs: tuple[int, ...]
    outputs: tuple[int, ...]
    build: Callable[..., Sequence[list[Any]]]
    long: bool = False
    plain: bool = False


def kernel(
    key: str, inputs: Sequence[int | str], outputs: Sequence[int | str], *, long: str = "", plain: bool = False
) -> Callable[[Callable[..., Sequence[list[Any]]]], Callable[..., Kernel]]:
    """Turn a function of symbols into one that gives its :class:`Kernel`; a method into that of its structure.

    ``long`` and sizes that depend on the structure are names of its attributes; ``{0}`` in ``key`` is the structure.
    """

    def decorate(build: Callable[..., Sequence[list[Any]]]) -> Callable[..., Kernel]:
        @wraps(build)
        def made(*structure: Any) -> Kernel:
            def of(part: Any) -> Any:
                return attrgetter(part)(*structure) if isinstance(part, str) else part

            sizes = tuple(map(of, inputs)), tuple(map(of, outputs))
            return Kernel(key.format(*structure), *sizes, partial(build, *structure), bool(long and of(long)), plain)

        return made

    return decorate


@dataclass(frozen=True)
class Slot:
    """A block of the workspace: ``size`` numbers from ``start``, in the region of parameters or of what changes."""

    region: str
    start: int
    size: int

    def part(self, start: int, size: int) -> Slot:
        """A block inside this one."""
        return Slot(self.region, self.start + start, size)


class Divisible(Protocol):
    """A block, or what stands for one, of which smaller blocks are taken."""

    def part(self, start: int, size: int) -> Slot:
        """A block inside this one."""
        ...


class Numbers:
    """The parameters of a robot in one vector, in blocks; ``start``: how many others stand before them."""

    def __init__(self, start: int = 0) -> None:
        self._values: list[NDArray[np.float64]] = []
        self.size = start

    def block(self, values: ArrayLike) -> Slot:
        """Append a block of numbers."""
        row = array(values).ravel()
        slot = Slot("parameters", self.size, row.size)
        self._values.append(row)
        self.size += row.size
        return slot

    @property
    def vector(self) -> NDArray[np.float64]:
        """All numbers of the blocks."""
        return np.concatenate(self._values) if self._values else np.zeros(0)


@dataclass
class Schedule:
    """Calls in order. Parameters stand first in the workspace, then inputs, then what is computed."""

    parameters: int
    inputs: dict[str, Slot] = field(default_factory=dict)
    outputs: dict[str, list[Slot]] = field(default_factory=dict)
    calls: list[tuple[Kernel, tuple[Slot, ...], tuple[Slot, ...]]] = field(default_factory=list)
    changing: int = 0
    gate: Slot | None = None
    """Pairs of numbers, each pair positive while a force acts that starts and ends at once."""
    sampled: Schedule | None = None
    """Of a right-hand side with sampled controllers: (time, state, row, step) -> the state after the samples there."""
    switches: Slot | None = None
    """Numbers that are positive while what sticks, slips or touches continues to do so."""
    switched: Schedule | None = None
    """Of a right-hand side with ``switches``: (time, state, row, step) -> the state after what ends there."""
    jolts: bool = False
    """Whether ``switched`` changes rates because given motions jump: a sample there is after it."""
    narrow: Slot | None = None
    """Rates at which friction changes within a narrow band about zero, then the width of each band."""
    zeros: tuple[Slot, ...] = ()
    """Parameters that are zero whatever the robot's numbers."""
    often: bool = False
    """Called so often that much work for its code pays."""
    _known: dict[tuple[str, tuple[Slot, ...], tuple[int, ...]], tuple[Slot, ...]] = field(
        default_factory=dict, repr=False, compare=False
    )

    def input(self, name: str, size: int) -> Slot:
        """A block that the caller fills."""
        self.inputs[name] = self._block(size)
        return self.inputs[name]

    def call(self, kernel: Kernel, *inputs: Slot) -> tuple[Slot, ...]:
        """Call a kernel; its outputs are new blocks, those of an earlier call of the same where there is one."""
        sizes = tuple(slot.size for slot in inputs)
        assert sizes == kernel.inputs, f"{kernel.key}: blocks of {sizes} for inputs of {kernel.inputs}"  # noqa: S101
        same = (kernel.key, inputs, kernel.outputs)
        if same not in self._known:
            self._known[same] = tuple(self._block(size) for size in kernel.outputs)
            self.calls.append((kernel, inputs, self._known[same]))
        return self._known[same]

    def output(self, name: str, *slots: Slot) -> None:
        """Blocks that make an output, one after the other."""
        self.outputs[name] = list(slots)

    def only(self, outputs: Sequence[str], *, watched: bool = False) -> Schedule:
        """The same schedule with these outputs alone, and only the calls that they, or what is ``watched``, need."""
        wanted, kept = np.zeros(self.workspace, dtype=bool), []
        given = {name: self.outputs[name] for name in outputs}
        for slot in (*(self.watched if watched else ()), *(slot for slots in given.values() for slot in slots)):
            wanted[self.span(slot)] = True
        for call in reversed(self.calls):
            if any(wanted[self.span(slot)].any() for slot in call[2]):
                for slot in call[1]:
                    wanted[self.span(slot)] = True
                kept.append(call)
        return replace(self, calls=kept[::-1], outputs=given)

    def reads(self, block: Slot) -> bool:
        """Whether a call takes, or an output is, a number of a block."""
        taken = [slot for call in self.calls for slot in call[1]] + [
            slot for slots in self.outputs.values() for slot in slots
        ]
        ends = block.start, block.start + block.size
        return any(
            one.region == block.region and one.start < ends[1] and ends[0] < one.start + one.size for one in taken
        )

    def _block(self, size: int) -> Slot:
        slot = Slot("changing", self.changing, size)
        self.changing += size
        return slot

    @property
    def watched(self) -> list[Slot]:
        """What the time loops read of the workspace besides the outputs."""
        return [slot for slot in (self.gate, self.narrow, self.switches) if slot]

    @property
    def workspace(self) -> int:
        """Numbers of the whole workspace."""
        return self.parameters + self.changing

    def offset(self, slot: Slot) -> int:
        """Where a block begins in the workspace."""
        return slot.start + (self.parameters if slot.region == "changing" else 0)

    def span(self, slot: Slot) -> slice:
        """Where a block stands in the workspace."""
        start = self.offset(slot)
        return slice(start, start + slot.size)

    @property
    def input_size(self) -> int:
        """Numbers that the caller fills."""
        return sum(slot.size for slot in self.inputs.values())

    @property
    def output_size(self) -> int:
        """Numbers that the caller gets."""
        return sum(slot.size for slots in self.outputs.values() for slot in slots)

    @cached_property
    def key(self) -> str:
        """All of the structure of a finished schedule, as a digest: same key, same code."""
        kinds: dict[tuple[str, tuple[int, ...], tuple[int, ...]], int] = {}
        info: list[int] = []
        for kernel, inputs, outputs in self.calls:
            info.append(kinds.setdefault((kernel.key, kernel.inputs, kernel.outputs), len(kinds)))
            info += [slot.start if slot.region == "changing" else -1 - slot.start for slot in (*inputs, *outputs)]
        head = [self.parameters, self.changing, self.gate, self.zeros, self.often, self.inputs, self.outputs, [*kinds]]
        head += [self.switches, self.narrow] + [each.key if each else "" for each in (self.sampled, self.switched)]
        return hashlib.sha256(repr(head).encode() + np.array(info, dtype="<i8").tobytes()).hexdigest()
