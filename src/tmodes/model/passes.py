"""The schedules of a chain's equations with its numbers, evaluated at rows of states by native code."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.ir import kernels
from tmodes.compile.native import WIDTH, Library
from tmodes.equations.line.schedule import Lines, line_schedule
from tmodes.equations.mechanics import Mechanics
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import BASE, resting_base
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.kinds.noted.functions import array, zeros
from tmodes.kinds.noted.number import follow_no, plain_value
from tmodes.kinds.noted.program import Program
from tmodes.model.rows import StateRows

__all__ = [
    "ChainPasses", "PointMotion", "derivatives", "evaluate", "evaluate_program", "evaluate_wide", "packed",
    "second_derivatives", "split",
]  # fmt: skip

Array = NDArray[np.float64]
Blocks = dict[str, Array]


def packed(schedule: Any, blocks: Blocks) -> Array:
    """The inputs of a schedule at each sample, one after the other, (n, numbers)."""
    return np.ascontiguousarray(np.concatenate([blocks[name] for name in schedule.inputs], axis=1))


def evaluate(parameters: Array, schedule: Any, blocks: Blocks, count: int) -> Blocks:
    """Outputs of a schedule at ``count`` samples by name, each (count, numbers); ``blocks`` are its inputs by name.

    ``parameters`` (numbers,), or (count, numbers): of each sample its own.
    """
    library = kernels.schedule_function("arm", schedule, "double")
    inputs = packed(schedule, blocks)
    out, workspace = np.empty((count, schedule.output_size)), np.zeros(schedule.workspace)
    _call(library, count, parameters, workspace, inputs, out)
    return split(out, schedule.outputs)


def evaluate_wide(
    parameters: Array, schedule: Any, blocks: Blocks, count: int, *, arithmetic: str = f"wide{WIDTH}"
) -> Blocks:
    """The same as :func:`evaluate` for one set of ``parameters`` (numbers,), vectors of samples at once."""
    library, groups = kernels.schedule_function("arm", schedule, arithmetic), -(-count // WIDTH)
    inputs, out = np.zeros((groups * WIDTH, schedule.input_size)), np.empty((groups * WIDTH, schedule.output_size))
    inputs[:count] = packed(schedule, blocks)
    inputs[count:] = inputs[count - 1]
    _call(library, groups, parameters, np.zeros(WIDTH * schedule.workspace), inputs, out)
    return split(out[:count], schedule.outputs)


def evaluate_program(program: Program, values: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The same as calling a program of lowering, by native code: to the bit, but for powers, sines and cosines.

    Raises ValueError as the program's ``schedule`` does.
    """
    blocks = {"values": np.asarray(values, dtype=float)}
    found = evaluate_wide(program.constants, program.schedule, blocks, len(values), arithmetic=f"exact{WIDTH}")
    return found["numbers"], (found["holds"][:, 0] != 0) & np.isfinite(blocks["values"]).all(axis=1)


def _call(library: Library, count: int, parameters: Array, *arrays: Array) -> None:
    """Raise :class:`tmodes.kinds.noted.number.Lost` where parameters are noted numbers: these are no doubles."""
    if parameters.dtype == object:
        follow_no("what compiled code computes", parameters)
    given = np.ascontiguousarray(parameters), *arrays
    library["run"](count, parameters.ndim - 1, *(array.ctypes.data for array in given))


def derivatives(parameters: Array, schedule: Any, blocks: Blocks, directions: Blocks, count: int) -> Blocks:
    """Exact derivatives of the outputs at ``count`` samples, each along its own direction of the inputs named.

    ``parameters`` as of :func:`evaluate`.
    """
    library = kernels.schedule_function("arm", schedule, "derivative")
    values = np.concatenate([blocks[name] for name in schedule.inputs], axis=1)
    slopes = [directions.get(name, np.zeros_like(blocks[name])) for name in schedule.inputs]
    inputs = np.ascontiguousarray(np.stack([values, np.concatenate(slopes, axis=1)], axis=1))
    out, workspace = np.empty((count, 2, schedule.output_size)), np.zeros(2 * schedule.workspace)
    _call(library, count, parameters, workspace, inputs, out)
    return split(np.ascontiguousarray(out[:, 1]), schedule.outputs)


def second_derivatives(schedule: Any, shape: tuple[int, ...], blocks: Mapping[str, Sequence[ArrayLike]]) -> Blocks:
    """Outputs by name (*shape, 4, size): values, exact derivatives along two directions, and along both.

    ``blocks``: values and both directions of the inputs, and of the ``parameters``, by name; other inputs are 0.
    """
    sizes = {"parameters": schedule.parameters} | {name: slot.size for name, slot in schedule.inputs.items()}
    rows = {
        name: np.stack([np.broadcast_to(one, (*shape, size)) for one in (*blocks.get(name, (0.0,) * 3), 0.0)], axis=-2)
        for name, size in sizes.items()
    }
    library = kernels.schedule_function("arm", schedule, "second")
    inputs = np.ascontiguousarray(np.concatenate([rows[name] for name in schedule.inputs], axis=-1))
    out, workspace = np.empty((*inputs.shape[:-1], schedule.output_size)), np.zeros(4 * schedule.workspace)
    _call(library, int(np.prod(shape)), rows["parameters"].reshape(-1, 4 * schedule.parameters), workspace, inputs, out)
    found = split(out.reshape(-1, schedule.output_size), schedule.outputs)
    return {name: one.reshape(*shape, 4, one.shape[1]) for name, one in found.items()}


def split(out: Array, outputs: Mapping[str, Sequence[Slot]]) -> Blocks:
    """Outputs that stand one after the other in the columns of ``out``, by name."""
    parts, start = {}, 0
    for name, slots in outputs.items():
        size = sum(slot.size for slot in slots)
        parts[name] = out[:, start : start + size]
        start += size
    return parts


@dataclass(frozen=True, eq=False)
class ChainPasses:
    """Forward dynamics, forces of inertia, elastic forces; each schedule is made at its first use.

    ``base`` is a row of 24 numbers (None: at rest), ``wrenches`` (n, points, 6) or None: no force on any point.
    """

    mechanics: Mechanics

    @property
    def parts(self) -> Parts:
        """The chain as kernels and numbers."""
        return self.mechanics.parts

    @cached_property
    def parameters(self) -> Array:
        """All numbers of the chain."""
        return self.parts.numbers.vector

    @cached_property
    def _schedules(self) -> dict[tuple[str, bool], Schedule]:
        return {}

    def schedule(self, name: str, *, loaded: bool = False) -> Schedule:
        """``forward``, ``inertia`` or ``elastic``; ``loaded``: forces act on the points."""
        if (name, loaded) not in self._schedules:
            self._schedules[name, loaded] = self.mechanics.schedule(name, loaded=loaded)
        return self._schedules[name, loaded]

    def forward(self, rows: StateRows, inputs: Blocks, base: ArrayLike | None, wrenches: ArrayLike | None) -> Array:
        """Accelerations of the coordinates; ``inputs``: effort, given, step."""
        schedule = self.schedule("forward", loaded=wrenches is not None)
        return evaluate(self.parameters, schedule, inputs | self._common(rows, base, wrenches), rows.count)["a"]

    def inertia(self, rows: StateRows, a: ArrayLike, base: ArrayLike | None, wrenches: ArrayLike | None) -> Blocks:
        """Outputs of :func:`tmodes.equations.recursion.forces.inertia_forces`, the rotors among the forces."""
        schedule, blocks = self.schedule("inertia", loaded=wrenches is not None), self.inertial(rows, a, base, wrenches)
        found = evaluate(self.parameters, schedule, blocks, rows.count)
        return found | {"forces": found["forces"] + blocks["a"] * self.rotor_inertias}

    def inertial(self, rows: StateRows, a: ArrayLike, base: ArrayLike | None, wrenches: ArrayLike | None) -> Blocks:
        """The inputs of the forces of inertia."""
        return {"a": rows.of(a, self.parts.size, "a"), **self._common(rows, base, wrenches)}

    def dynamic(
        self, rows: StateRows, effort: ArrayLike, given: ArrayLike, base: ArrayLike | None, wrenches: ArrayLike | None
    ) -> Blocks:
        """The inputs of the forward dynamics, without an implicit step."""
        efforts, held = len(self.parts.efforts), len(self.parts.given)
        drives = {"effort": rows.of(effort, efforts, "effort"), "given": rows.of(given, held, "given")}
        return {**drives, "step": rows.of(0.0, 1, "step"), **self._common(rows, base, wrenches)}

    def elastic(self, rows: StateRows) -> Blocks:
        """Outputs of :func:`tmodes.equations.recursion.forces.elastic_forces`."""
        return evaluate(self.parameters, self.schedule("elastic"), self._common(rows, None, None), rows.count)

    @cached_property
    def _tip(self) -> Schedule:
        """Position of the first point in the world."""
        whole = self.schedule("inertia")
        pose = whole.outputs["points"][0]
        tip = replace(whole, outputs={"tip": [pose.part(9, 3)]}).only(("tip",))
        return replace(tip, often=True)

    def tips(self, q: Sequence[Array], base: Sequence[Array], parameters: Array) -> Array:
        """Positions of the first point in the world (m, n, 3) [m], in poses (n, nq) of m robots of this structure each.

        ``base`` (24,), or (n, 24) where it moves, and ``parameters`` (m, size) of each; vectors of poses go at once.
        """
        library, count = kernels.schedule_function("arm", self._tip, f"wide{WIDTH}"), len(q[0])
        groups = -(-count // WIDTH)
        inputs = np.zeros((groups * WIDTH, self._tip.input_size))
        given, out = (
            split(inputs, {name: [slot] for name, slot in self._tip.inputs.items()}),
            np.empty((len(inputs), 3)),
        )
        workspace, found = np.zeros(WIDTH * self._tip.workspace), np.empty((len(q), count, 3))
        for k in range(len(q)):
            given["q"][:count], given["base"][:count] = q[k], base[k]
            _call(library, groups, parameters[k], workspace, inputs, out)
            found[k] = out[:count]
        return found

    @cached_property
    def _lines(self) -> dict[tuple[tuple[float, ...], bool], Lines]:
        return {}

    def lines(self, s: tuple[float, ...], *, loaded: bool = False) -> Lines:
        """The elastic lines at the places ``s`` along each link; ``loaded``: forces act on the points."""
        known = tuple(map(plain_value, s)), loaded
        if known not in self._lines:
            self._lines[known] = line_schedule(self.parts, array(s), self.mechanics.drawn, loaded=loaded)
        return self._lines[known]

    def on_lines(
        self, lines: Lines, rows: StateRows, a: ArrayLike, base: ArrayLike | None, wrenches: ArrayLike | None
    ) -> Blocks:
        """Outputs of the schedule of the elastic lines."""
        return evaluate(lines.numbers, lines.schedule, self.inertial(rows, a, base, wrenches), rows.count)

    @cached_property
    def rotor_inertias(self) -> Array:
        """Inertia of the rotors along each coordinate."""
        inertias = [axis.node.joint.motor.inertia for axis in self.parts.axes if axis.node.joint.motor]
        rotors = zeros(self.parts.size, inertias)
        for axis in self.parts.axes:
            motor = axis.node.joint.motor
            if motor and axis.effort >= 0:
                rotors[axis.input] += motor.inertia
        return rotors

    def at_rest(self, *, gravity: float = 1.0) -> Array:
        """The row of a base at rest; ``gravity``: share of it that pulls."""
        return resting_base(self.parts.chain, gravity)

    def _common(self, rows: StateRows, base: ArrayLike | None, wrenches: ArrayLike | None) -> Blocks:
        blocks = {"q": rows.q, "v": rows.v, "base": rows.of(self.at_rest() if base is None else base, BASE, "base")}
        if wrenches is not None:
            blocks["wrenches"] = rows.of(wrenches, 6 * len(self.parts.points), "wrenches")
        return blocks


_POINT = 24
"""Numbers reported of a point: pose (15), rate (3), acceleration (6)."""


class PointMotion(NamedTuple):
    """Motion of the named points in world axes: (n, points, 3), rotation (n, points, 3, 3) [SI]."""

    position: Array
    rotation: Array
    velocity: Array
    rate: Array
    acceleration: Array
    angular_acceleration: Array

    @classmethod
    def of(cls, info: Array) -> PointMotion:
        """From rows of the output ``points`` of the inertia pass."""
        rows = info.reshape(len(info), -1, _POINT)
        rotation = rows[..., :9].reshape(*rows.shape[:2], 3, 3)
        parts = (rows[..., k : k + 3] for k in (12, 15, 18, 21))
        return cls(rows[..., 9:12], rotation, *parts)
