"""All derivatives of a robot's accelerations at one state by one table: it costs one call from Python."""

from __future__ import annotations

import threading
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.ir.linear_solve import BLOCK, aligned, padded
from tmodes.compile.loops.tape_loop import RowTable, operations
from tmodes.model.derivatives import Columns

__all__ = ["AccelerationDerivatives", "AccelerationTable"]

Array = NDArray[np.float64]


class AccelerationDerivatives(NamedTuple):
    """Derivatives of the accelerations at one state: by q and by v, (nq, nq), and by the efforts, (nq, efforts)."""

    q: Array
    v: Array
    effort: Array


class AccelerationTable:
    """Forward dynamics, derivatives of all forces by a, q and v, and the solution with the mass matrix.

    ``forward`` gives the accelerations; ``inertia`` the derivatives by a, q and v, with the columns of a in their own
    order, ``elastic`` those by q and v. ``driven``: the coordinates of the efforts.
    """

    def __init__(
        self, parameters: Array, forward: Columns, inertia: Columns, elastic: Columns, rotors: Array, driven: list[int]
    ) -> None:
        self._parameters, self._tapes = parameters, [forward.tape, inertia.tape, elastic.tape]
        self._bases = np.cumsum([0, *(tape.size for tape in self._tapes)]).tolist()
        size, width = len(rotors), 3 * padded(len(rotors))
        self._size, self._stride, self._rotors, self._driven = size, width + padded(len(driven)), rotors, driven
        starts = [
            0,
            sum(inertia.ready.found),
            sum(elastic.ready.found),
            size * self._stride,
            size * padded(len(driven)),
        ]
        self._inner, self._elastic, self._rows, self._units, self._diagonal = np.cumsum(starts).tolist()
        self._own, self._kept, self.table = threading.local(), [forward, inertia, elastic], RowTable()
        self._write(forward, inertia, elastic)

    def solved(self, inputs: Array) -> tuple[Array, int]:
        """Derivatives of the accelerations (nq, columns) by q, by v and by the efforts, each padded.

        And the row, from 1, in which the mass matrix is not positive definite, else 0. ``inputs``: those of the forward
        dynamics.
        """
        desk = getattr(self._own, "desk", None)
        if desk is None:
            desk = self._own.desk = self._desk()
        run, arguments, held, rows, failed = desk
        held[:] = inputs
        run(*arguments)
        return np.negative(rows[:, padded(self._size) :]), int(failed[0])

    def _write(self, forward: Columns, inertia: Columns, elastic: Columns) -> None:
        table, stride, size = self.table, self._stride, self._size
        self._call(forward, 0, 0)
        for base, columns in zip(self._bases[1:], (inertia, elastic), strict=False):
            for name in columns.tape.schedule.inputs:
                to, count = columns.tape.span(name)
                source = forward.tape.end if name == "a" else forward.tape.span(name)[0]
                table.operation("move_values", base + to, source, count)
        table.operation("clear", self._diagonal + size, 1)
        self._call(inertia, self._bases[1], self._inner)
        lanes = padded(size) // BLOCK
        table.operation("columns", self._rows, stride, self._inner + inertia.ready.found[0], size, 3 * lanes)
        if elastic.calls:
            self._call(elastic, self._bases[2], self._elastic)
            there = self._elastic + elastic.ready.found[0]
            table.operation("more_columns", self._rows + padded(size), stride, there, size, 2 * lanes)
        table.operation("diagonal", self._rows, stride + 1, self._diagonal, size)
        units = padded(len(self._driven)) // BLOCK
        table.operation("columns", self._rows + 3 * padded(size), stride, self._units, size, units)
        table.operation("solve", size, stride // BLOCK, self._rows, self._diagonal + size)

    def _call(self, columns: Columns, values: int, slopes: int) -> None:
        table = columns.ready.table
        self.table.operation("table", table.words.ctypes.data, table.rows, values, slopes)

    def _desk(self) -> tuple[Any, ...]:
        """Memory of one thread, kept between calls."""
        values, slopes = np.zeros(self._bases[-1]), aligned(self._diagonal + self._size + 1)
        for base in self._bases[:-1]:
            values[base : base + len(self._parameters)] = self._parameters
        units = np.zeros((self._size, padded(len(self._driven))))
        units[self._driven, range(len(self._driven))] = -1.0
        groups = units.reshape(self._size, -1, BLOCK).transpose(1, 0, 2)
        slopes[self._units : self._diagonal] = groups.ravel()
        slopes[self._diagonal : self._diagonal + self._size] = self._rotors
        schedule = self._tapes[0].schedule
        held = np.empty(schedule.input_size)
        counts = (1, self.table.rows, schedule.parameters, schedule.input_size, 0, 0, 0, 0)
        arrays = (self.table.words, values, slopes, held, held, held)
        rows = slopes[self._rows : self._units].reshape(self._size, self._stride)
        arguments = (*counts, *(array.ctypes.data for array in arrays))
        # The arrays that are only known by their addresses are kept with the function that gets them.
        self._own.arrays = arrays
        return operations()["samples"], arguments, held, rows, slopes[self._diagonal + self._size :]
