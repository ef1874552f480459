"""The recorded steps of a run once more: with other numbers, along directions, and in reverse.

The steps stay as they were: their lengths are constants, so derivatives are those of the discrete solution. Samples of
controllers at the start of a step change the state there: ``states`` are those after it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.ir.derivative_kernels import LANES
from tmodes.compile.ir.linear_solve import aligned
from tmodes.compile.loops.tape_loop import RowTable, operations
from tmodes.compile.replay.replay_frame import ARRAYS, COUNTS
from tmodes.compile.replay.tables import loops_of, table_of
from tmodes.integrate.registry import integrator
from tmodes.model.derivatives import Desk, differentiated
from tmodes.model.passes import packed
from tmodes.simulation.recording import Recording

__all__ = ["Gradients", "Replay"]

Array = NDArray[np.float64]


class Gradients(NamedTuple):
    """Derivatives of a sum of weighted samples: by the state at the start, the parameters, the rows (segments, row).

    The first number of a row is the time at which its piece starts. ``inner``: by the states at the start of some
    steps, of what comes after.
    """

    start: Array
    parameters: Array
    rows: Array
    inner: dict[int, Array]


class _Piece(NamedTuple):
    """Steps that follow one another, and the state at the start of each and after the last.

    ``before``: by step, the state before the samples with which it begins.
    """

    steps: slice
    states: Array
    before: dict[int, Array]

    def cut(self, starts: Collection[int]) -> list[_Piece]:
        """The pieces that some steps begin."""
        first, stop = self.steps.start, self.steps.stop
        ends = [first, *sorted(step for step in {*starts, *self.before} if first < step < stop), stop]
        return [_Piece(slice(a, b), self.states[a - first :], self.before) for a, b in itertools.pairwise(ends)]


class _Samples:
    """What samples at the start of steps do to the state, and its derivatives; ``due``: which steps."""

    def __init__(self, schedule: Any, recording: Recording) -> None:
        self._of, self._done, self.size = differentiated(schedule, ["state"]), recording, recording.samples.shape[1]
        self.due = frozenset(np.flatnonzero(np.diff(recording.segments, prepend=-1)).tolist())
        start = self._of.tape.span("state")[0] - schedule.parameters
        self._state = slice(start, start + self.size)

    def after(self, parameters: Array, steps: Sequence[int], states: Array) -> Array:
        """The states (k, size) after the samples at the start of steps, from those before."""
        return self._of.values(parameters, self._blocks(steps, states))["state"]

    def along(self, parameters: Array, before: Mapping[int, Array]) -> Callable[[int, Array], Array]:
        """(step, slopes (size, 8) of the state before its samples) -> slopes (size, 8) of that after them."""
        desk, inputs = self._desk("along", parameters, before)
        seeds, found = (array.reshape(-1, LANES) for array in (desk.seeds, desk.found))

        def slopes(step: int, moved: Array) -> Array:
            desk.inputs[:], seeds[self._state] = inputs[step], moved
            desk.run()
            return found

        return slopes

    def pushed(self, parameters: Array, before: Mapping[int, Array], change: Array, rows: Array) -> dict[int, Array]:
        """By step, the slopes (size, 8) along changes of parameters (parameters, 8) and rows (segments, row, 8)."""
        steps, blocks = [*before], self._blocks([*before], np.array([*before.values()]))
        own = rows[self._done.segments[steps]]
        lanes = [
            self._of.along(parameters, blocks, {"row": own[..., k]}, change=change[:, k])["state"] for k in range(LANES)
        ]
        return dict(zip(steps, np.stack(lanes, axis=-1), strict=True))

    def back(self, parameters: Array, before: Mapping[int, Array]) -> Callable[[int, Array], Array]:
        """(step, weights (size,) of the state after its samples) -> those of the state before them."""
        desk, inputs = self._desk("back", parameters, before)

        def weights(step: int, moved: Array) -> Array:
            desk.inputs[:], desk.seeds[:] = inputs[step], moved
            desk.run()
            return desk.found[self._state]

        return weights

    def pulled(
        self, parameters: Array, before: Mapping[int, Array], weights: Mapping[int, Array]
    ) -> tuple[Array, Array]:
        """Derivatives of weighted states after samples by the parameters, and by the rows (segments, row)."""
        steps, rows = [*weights], np.zeros_like(self._done.rows)
        blocks = self._blocks(steps, np.array([before[step] for step in steps]))
        seeds = {"state": np.array([*weights.values()])}
        found = self._of.back(parameters, blocks, seeds, ("row", "parameters"))
        np.add.at(rows, self._done.segments[steps], found["row"])
        return found["parameters"], rows

    def _desk(self, way: str, parameters: Array, before: Mapping[int, Array]) -> tuple[Desk, dict[int, Array]]:
        desk, steps = self._of.desk(way, "state"), [*before]
        desk.values[: len(parameters)] = parameters
        states = np.array([*before.values()]).reshape(len(steps), self.size)
        return desk, dict(zip(steps, packed(self._of.schedule, self._blocks(steps, states)), strict=True))

    def _blocks(self, steps: Sequence[int], states: Array) -> dict[str, Array]:
        rows = self._done.rows[self._done.segments[list(steps)]]
        return {"time": rows[:, :1], "state": states, "row": rows, "step": np.zeros((len(rows), 1))}


class Replay:
    """Recorded steps of a model whose rates are a ``schedule`` of (time, state, row), with its ``parameters``.

    Steps by extrapolation take a schedule of (time, state, row, step, start), ``pairs`` of whose states are coordinates
    with their rates.
    """

    def __init__(self, schedule: Any, parameters: Array, recording: Recording, pairs: int = 0) -> None:
        self.recording, self.parameters = recording, parameters
        self._of = differentiated(schedule, ["rate"])
        self.tape = self._of.tape
        self._forward, self._settled = (
            self._of.kept(("values", settled), lambda settled=settled: self.tape.values(settled=settled))
            for settled in (False, True)
        )
        self._tableau, self._pairs = table_of(integrator(recording.method)), pairs
        self._sampling = _Samples(schedule.sampled, recording) if schedule.sampled else None
        self._moved = [name for name in ("state", "row", "start") if name in ("state", "row", *self._tableau.inputs)]

    def samples(self, parameters: Array | None = None, start: Array | None = None) -> Array:
        """The samples (n, size) by the same steps, with other numbers or from another state."""
        done = self.recording
        samples, state = np.empty_like(done.samples), done.samples[0] if start is None else np.asarray(start)
        samples[0] = state
        self._again(slice(0, len(done.t)), state, self.parameters if parameters is None else parameters, samples)
        return samples

    def starts(self, steps: Collection[int]) -> dict[int, Array]:
        """The states (size,) at the start of some steps."""
        found: dict[int, Array] = {}
        for piece in self._pieces() if steps else ():
            first, stop, _ = piece.steps.indices(len(self.recording.t))
            found |= {step: piece.states[step - first].copy() for step in steps if first <= step < stop}
        return found

    def along(self, start: Array, parameters: Array, rows: Array, jumps: Mapping[int, Array] | None = None) -> Array:
        """Slopes of the samples, (directions, n, size), along directions.

        ``start`` (directions, size), ``parameters`` (directions, parameters), ``rows`` (directions, segments, row);
        ``jumps`` (directions, size): by which slopes jump at the start of some steps.
        """
        given, found = jumps or {}, []
        for k in range(0, len(start), LANES):
            part = slice(k, k + LANES)
            own = {step: _lanes(jump[part]) for step, jump in given.items()}
            found.append(self._along_lanes(_lanes(start[part]), _lanes(parameters[part]), _lanes(rows[part]), own))
        return np.concatenate(found)[: len(start)]

    def back(self, weights: Array, inner: Collection[int] = ()) -> Gradients:
        """Derivatives of the sum of ``weights`` (n, size) times the samples; ``inner``: of which steps, too."""
        done, tape = self.recording, self.tape
        table, last = self._tables("back", lambda marks, own, settled: tape.back(marks | own, own, settled=settled))
        values, slopes = self._values(self.parameters), aligned(tape.size)
        moved, rows = np.zeros(done.samples.shape[1]), np.zeros_like(done.rows)
        samples = np.ascontiguousarray(weights, dtype=float)
        stages, at = np.zeros((self._tableau.stages, len(moved))), dict[int, Array]()
        more = {"moved": moved, "row_slopes": rows, "stage_slopes": stages, "slopes": slopes}
        sweep = self._loop("back", values, other=table, samples=samples, **more)
        sampled, own = np.zeros(len(self.parameters)), np.zeros_like(rows)
        for whole in self._pieces(backwards=True):
            sampling, carried = self._sampling if whole.before else None, dict[int, Array]()
            weigh = sampling.back(self.parameters, whole.before) if sampling else None
            for piece in whole.cut(inner)[::-1]:
                sweep(piece)
                at[piece.steps.start] = moved.copy()
                if weigh and piece.steps.start in whole.before:
                    carried[piece.steps.start] = at[piece.steps.start]
                    moved[:] = weigh(piece.steps.start, moved)
            if sampling and carried:
                by, signals = sampling.pulled(self.parameters, whole.before, carried)
                sampled, own = sampled + by, own + signals
        _run(last, values[0], slopes)
        numbers = slopes[: len(self.parameters)] + sampled
        return Gradients(moved + samples[0], numbers, rows + own, {step: at[step] for step in inner})

    def _along_lanes(self, start: Array, parameters: Array, rows: Array, jumps: Mapping[int, Array]) -> Array:
        """Eight directions, the last axis."""
        done, tape = self.recording, self.tape
        size, count = len(start), len(self.parameters)
        slopes = aligned(LANES * tape.size)
        slopes[: LANES * count] = parameters.ravel()
        values = self._values(self.parameters)
        table, first = self._tables(
            "along", lambda marks, own, settled: tape.along(marks | own, LANES, settled=settled)
        )
        _run(first, values[0], slopes)
        samples = np.empty((len(done.times), size, LANES))
        samples[0] = start
        more = {"moved": np.ascontiguousarray(start), "row_slopes": np.ascontiguousarray(rows), "slopes": slopes}
        stages = np.zeros((self._tableau.stages, size, LANES))
        sweep = self._loop("along", values, LANES, other=table, samples=samples, stage_slopes=stages, **more)
        for whole in self._pieces():
            sampling, given = self._sampling if whole.before else None, (self.parameters, whole.before)
            carry = sampling.along(*given) if sampling else None
            pushed = sampling.pushed(*given, parameters, rows) if sampling else {}
            for piece in whole.cut(jumps):
                step = piece.steps.start
                if carry and step in pushed:
                    more["moved"][:] = carry(step, more["moved"]) + pushed[step]
                more["moved"] += jumps.get(step, 0.0)
                sweep(piece)
        return samples.transpose(2, 0, 1)

    def _tables(self, kind: str, make: Callable[[Any, Any, bool], RowTable]) -> list[RowTable]:
        """The tables of what changes in a run, and of what does not, from marks of inputs and of the parameters."""
        marks = self.tape.marked([self.tape.span(name) for name in self._moved])
        own = self.tape.marked([(0, len(self.parameters))])
        return [
            self._of.kept((kind, settled), lambda settled=settled: make(marks, own, settled))
            for settled in (False, True)
        ]

    def _values(self, parameters: Array) -> Array:
        """Memory of the evaluations that are kept at once, with what does not change in a run."""
        values = np.zeros((self._tableau.memory, self.tape.size))
        values[0, : len(parameters)] = parameters
        _run(self._settled, values[0], np.empty(0))
        values[1:] = values[0]
        return values

    def _pieces(self, *, backwards: bool = False) -> Iterator[_Piece]:
        """Steps between two kept states, with all states, one piece at a time."""
        done = self.recording
        if done.every == 1:
            states, before = done.kept, dict[int, Array]()
            if self._sampling:
                due, states = sorted(self._sampling.due), states.copy()
                before = dict(zip(due, done.kept[due], strict=True))
                states[due] = self._sampling.after(self.parameters, due, done.kept[due])
            yield _Piece(slice(0, len(done.t)), states, before)
            return
        samples = np.empty_like(done.samples)
        for k in range(len(done.kept))[:: -1 if backwards else 1]:
            steps = slice(k * done.every, min((k + 1) * done.every, len(done.t)))
            yield self._again(steps, done.kept[k], self.parameters, samples)

    def _again(self, steps: slice, state: Array, parameters: Array, samples: Array) -> _Piece:
        """Steps with all states, from the one before the first; fills ``samples``."""
        first, stop = steps.start, steps.stop
        states = np.empty((stop - first + 1, len(state)))
        states[0] = state
        whole = _Piece(steps, states, {})
        due, take = (
            self._sampling.due if self._sampling else (),
            self._loop("again", self._values(parameters), samples=samples),
        )
        for piece in whole.cut(due):
            step = piece.steps.start
            if self._sampling and step in due:
                whole.before[step] = piece.states[0].copy()
                piece.states[0] = self._sampling.after(parameters, [step], piece.states[:1])[0]
            take(piece)
        return whole

    def _loop(
        self, loop: str, values: Array, lanes: int = 1, *, other: RowTable | None = None, **arrays: Array
    ) -> Callable[[_Piece], None]:
        """A native loop, to be called for pieces of steps one after the other."""
        done, tape, tableau = self.recording, self.tape, self._tableau
        table = other or self._forward
        place = {f"{name}_at": tape.span(name)[0] for name in ("time", "state", "row", *tableau.inputs)}
        known = {
            "size": done.samples.shape[1], "row": done.rows.shape[1], "stages": tableau.stages,
            "values": values.shape[1], "out_at": tape.end, "lanes": lanes, "slopes_out_at": lanes * tape.end,
            "forward_rows": self._forward.rows, "other_rows": table.rows, "pairs": self._pairs, **place,
        }  # fmt: skip
        counts = np.array([known.get(name, 0) for name in COUNTS], dtype=np.int64)
        by_step = {name: getattr(done, name) for name in ("segments", "used", "first_sample", "t", "h")}
        given = {
            "counts": counts, "forward": self._forward.words, "other": table.words, "rows": done.rows, "a": tableau.a,
            "b": tableau.b, "c": tableau.c, "weights": done.weights, "values": values,
            "states": np.empty((tableau.stages, done.samples.shape[1])), **by_step, **arrays,
        }  # fmt: skip
        empty, function, steps = np.empty(0), loops_of(done.method)[loop], COUNTS.index("steps")
        addresses = [given.get(name, empty).ctypes.data for name in ARRAYS]
        moving = [(ARRAYS.index(name), addresses[ARRAYS.index(name)], one.strides[0]) for name, one in by_step.items()]
        y = ARRAYS.index("y")

        def call(piece: _Piece) -> None:
            given["counts"][steps] = piece.steps.stop - piece.steps.start
            for k, first, stride in moving:
                addresses[k] = first + stride * piece.steps.start
            addresses[y] = piece.states.ctypes.data
            function(*addresses)

        return call


def _run(table: RowTable, values: Array, slopes: Array) -> None:
    """Run a table once."""
    arrays = (table.words, values, slopes, slopes, slopes, slopes)
    operations()["samples"](1, table.rows, 0, 0, 0, 0, 0, 0, *(array.ctypes.data for array in arrays))


def _lanes(array: Array) -> Array:
    """Directions as the last axis, eight of them."""
    wide = np.zeros((*array.shape[1:], LANES))
    wide[..., : len(array)] = np.moveaxis(array, 0, -1)
    return wide
