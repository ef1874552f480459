"""Native loops over the recorded steps of an extrapolated run: once more, along directions, and in reverse.

A step is a list of linearly implicit Euler steps, row by row, and a sum of where the rows end, whose weights are data.
Each Euler step is one pass of the recursion with its length among the inputs; that length stays as it was, so the
derivatives are those of the discrete solution: A. Griewank, A. Walther, Evaluating Derivatives (2008), section 15.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from tmodes.compile.ir.emit import I64, at, counted, load, number, store, whole
from tmodes.compile.loops.extrapolation_loop import FEW, ROWS
from tmodes.compile.native import Library
from tmodes.compile.replay.replay_frame import ReplayLoop, written_loops

__all__ = ["extrapolated_loops"]


@cache
def extrapolated_loops() -> Library:
    """The loops, as :func:`tmodes.compile.replay.replay_frame.written_loops` names them."""
    return written_loops("replay_extrapolated", (_ExtrapolatedAgain, _ExtrapolatedAlong, _ExtrapolatedBack))


class _Extrapolated(ReplayLoop):
    """Places are the states of a step: 0 its start, then row by row those after each Euler step.

    ``a`` gives the row of a place and the place before it, ``b`` the share of each place in the end of a step, of all
    rows and of few, ``c`` the time of a place as a share of the step.
    """

    def few(self, step: Any) -> Any:
        """Whether a step is one of few rows."""
        return self.b.icmp_signed("<", self.word("used", step), self.n["stages"])

    def share(self, step: Any, place: Any) -> Any:
        """Of a place in the end of a step."""
        return self.number("b", self.b.zext(self.few(step), I64), place)

    def part(self, step: Any, place: Any) -> Any:
        """Length of the Euler step that ends at a place."""
        return self.b.fdiv(self.number("h", step), self.number("a", whole(0), place))

    def before(self, place: Any) -> Any:
        """The place at which that step starts."""
        return self.b.fptosi(self.number("a", whole(1), place), I64)

    def euler(self, step: Any, place: Any, values: Any) -> None:
        """The Euler step that ends at a place: v+ = v + h a, q+ = q + h v+; what follows them explicit."""
        b, n = self.b, self.n
        part, source = self.part(step, place), self.row_of("states", self.before(place), n["size"])
        store(b, part, values, n["step_at"])
        self.ahead(source, part, (at(b, values, n["state_at"]), at(b, values, n["start_at"])), whole(1))
        self.evaluate(
            step, b.fadd(self.number("t", step), b.fmul(self.number("c", place), self.number("h", step))), values
        )
        rates = at(b, values, n["out_at"])
        self.move(self.row_of("states", place, n["size"]), source, rates, part, whole(1))

    def ahead(self, source: Any, part: Any, targets: tuple[Any, Any], lanes: Any) -> None:
        """Where the rates are taken: coordinates moved on by the rates; and where springs start from."""
        b, (state, start) = self.b, targets
        pairs = b.mul(self.n["pairs"], lanes)
        self.copy(state, source, b.mul(self.n["size"], lanes))
        with counted(b, pairs, "ahead") as i:
            paired = b.add(i, pairs)
            rate = load(b, source, paired)
            moved = b.fadd(load(b, source, i), b.fmul(part, rate))
            store(b, moved, state, i)
            store(b, moved, start, i)
            store(b, rate, start, paired)

    def move(self, target: Any, source: Any, rates: Any, part: Any, lanes: Any) -> None:
        """A state moved on by ``part``, or slopes of one."""
        b = self.b
        pairs, size = (b.mul(self.n[label], lanes) for label in ("pairs", "size"))
        with counted(b, pairs, "pair") as i:
            paired = b.add(i, pairs)
            rate = b.fadd(load(b, source, paired), b.fmul(part, load(b, rates, paired)))
            store(b, rate, target, paired)
            store(b, b.fadd(load(b, source, i), b.fmul(part, rate)), target, i)
        twice = b.add(pairs, pairs)
        with counted(b, b.sub(size, twice), "rest") as i:
            place = b.add(i, twice)
            store(b, b.fadd(load(b, source, place), b.fmul(part, load(b, rates, place))), target, place)

    def add_end(self, step: Any, target: Any, label: str, width: Any) -> None:
        """The end of a step, from the ends of its rows."""
        self.zero(target, width)
        with counted(self.b, self.word("used", step), "share") as place:
            self.more(target, self.share(step, place), self.row_of(label, place, width), width)

    def zero(self, target: Any, count: Any) -> None:
        """Zeros."""
        with counted(self.b, count, "zero") as k:
            store(self.b, number(0.0), target, k)


class _ExtrapolatedAgain(_Extrapolated):
    name = "again"

    def step(self, step: Any) -> None:
        b, size = self.b, self.n["size"]
        here, places = self.row_of("y", step, size), self.word("used", step)
        self.copy(self.array["states"], here, size)
        with counted(b, b.sub(places, whole(1)), "place") as k:
            self.euler(step, b.add(k, whole(1)), self.array["values"])
        self.add_end(step, self.row_of("y", b.add(step, whole(1)), size), "states", size)
        self.tell(step, here, size, (places, lambda j: self.row_of("states", j, size)))


class _ExtrapolatedAlong(_Extrapolated):
    name = "along"

    def step(self, step: Any) -> None:
        b, n, values, moved = self.b, self.n, self.array["values"], self.array["moved"]
        wide, places = b.mul(n["size"], n["lanes"]), self.word("used", step)
        self.set_row_slopes(step)
        self.copy(self.array["states"], self.row_of("y", step, n["size"]), n["size"])
        self.copy(self.array["stage_slopes"], moved, wide)
        with counted(b, b.sub(places, whole(1)), "place") as k:
            place = b.add(k, whole(1))
            self.euler(step, place, values)
            self._slopes(step, place, values, wide)
        self.tell(step, moved, wide, (places, lambda j: self.row_of("stage_slopes", j, wide)))
        self.add_end(step, moved, "stage_slopes", wide)

    def _slopes(self, step: Any, place: Any, values: Any, wide: Any) -> None:
        b, n, slopes = self.b, self.n, self.array["slopes"]
        part, source = self.part(step, place), self.row_of("stage_slopes", self.before(place), wide)
        targets = tuple(at(b, slopes, b.mul(n[label], n["lanes"])) for label in ("state_at", "start_at"))
        self.ahead(source, part, (targets[0], targets[1]), n["lanes"])
        self.differentiate(values)
        rates = at(b, slopes, n["slopes_out_at"])
        self.move(self.row_of("stage_slopes", place, wide), source, rates, part, n["lanes"])


class _ExtrapolatedBack(_Extrapolated):
    name = "back"

    def step(self, step: Any) -> None:
        b, size, moved = self.b, self.n["size"], self.array["moved"]
        step = self.backwards(step)
        places = self.word("used", step)
        self.zero(self.array["stage_slopes"], b.mul(places, size))
        with counted(b, places, "seed") as place:
            self.more(self.row_of("stage_slopes", place, size), self.share(step, place), moved, size)
        self.zero(moved, size)
        self.collect(step, places)
        self.copy(self.array["states"], self.row_of("y", step, size), size)
        with counted(b, b.select(self.few(step), whole(FEW), whole(ROWS)), "row") as row:
            self._row_back(step, row)
        self.more(moved, number(1.0), self.array["stage_slopes"], size)

    def _row_back(self, step: Any, row: Any) -> None:
        """Take the Euler steps of a row, then carry its weights back through them."""
        b, n = self.b, self.n
        first = b.add(b.sdiv(b.mul(row, b.add(row, whole(1))), whole(2)), whole(1))
        count = b.add(row, whole(1))
        with counted(b, count, "taken") as k:
            self.euler(step, b.add(first, k), self.row_of("values", k, n["values"]))
        with counted(b, count, "reverse") as k:
            last = b.sub(row, k)
            self._euler_back(step, b.add(first, last), self.row_of("values", last, n["values"]))

    def _euler_back(self, step: Any, place: Any, values: Any) -> None:
        b, n, slopes = self.b, self.n, self.array["slopes"]
        part, size, pairs = self.part(step, place), n["size"], n["pairs"]
        after = self.row_of("stage_slopes", place, size)
        self._seed(after, part, at(b, slopes, n["slopes_out_at"]))
        self.differentiate(values)
        source = self.row_of("stage_slopes", self.before(place), size)
        state, start = (at(b, slopes, n[label]) for label in ("state_at", "start_at"))
        self.more(source, number(1.0), after, size)
        self.more(source, number(1.0), state, size)
        twice = b.add(pairs, pairs)
        self.more(source, number(1.0), start, twice)
        rates = at(b, source, pairs)
        self.more(rates, part, state, pairs)
        self.more(rates, part, start, pairs)
        self.add_row_weights(step)

    def _seed(self, after: Any, part: Any, seeds: Any) -> None:
        """Weights of the rates of an Euler step; those of the coordinates it ends with are moved to its rates first."""
        b, pairs, size = self.b, self.n["pairs"], self.n["size"]
        self.more(at(b, after, pairs), part, after, pairs)
        self.zero(seeds, pairs)
        with counted(b, b.sub(size, pairs), "seed") as k:
            place = b.add(k, pairs)
            store(b, b.fmul(part, load(b, after, place)), seeds, place)
