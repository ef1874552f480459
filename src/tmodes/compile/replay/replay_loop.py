"""Native loops over the recorded steps of an explicit Runge-Kutta run: once more, along directions, and in reverse.

A step is a list of combinations and evaluations, whose tableau is data: one piece of code serves every such method and
every robot, whose evaluations are tables of rows. Discrete adjoints of Runge-Kutta methods: W. W. Hager, Numerische
Mathematik 87 (2000) 247-282.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from tmodes.compile.ir.emit import at, counted, load, number, store, whole
from tmodes.compile.native import Library
from tmodes.compile.replay.replay_frame import ReplayLoop, written_loops

__all__ = ["replay_loops"]


@cache
def replay_loops() -> Library:
    """The loops, as :func:`tmodes.compile.replay.replay_frame.written_loops` names them."""
    return written_loops("replay", (_Again, _Along, _Back))


class _Explicit(ReplayLoop):
    """Stages that follow from those before."""

    def stage(self, step: Any, i: Any) -> Any:
        """Evaluate stage i; the address of its values."""
        b, n = self.b, self.n
        values, h = self.row_of("values", i, n["values"]), self.number("h", step)
        state = at(b, values, n["state_at"])
        self.copy(state, self.row_of("y", step, n["size"]), n["size"])
        with counted(b, i, "before") as j:
            self.more(state, b.fmul(h, self.number("a", i, j)), self.rate(j), n["size"])
        self.evaluate(step, b.fadd(self.number("t", step), b.fmul(self.number("c", i), h)), values)
        return values

    def rate(self, j: Any) -> Any:
        """Where the rates of stage j stand."""
        return at(self.b, self.row_of("values", j, self.n["values"]), self.n["out_at"])


class _Again(_Explicit):
    name = "again"

    def step(self, step: Any) -> None:
        b, size, used = self.b, self.n["size"], self.word("used", step)
        with counted(b, used, "stage") as i:
            self.stage(step, i)
        here, after = self.row_of("y", step, size), self.row_of("y", b.add(step, whole(1)), size)
        self.copy(after, here, size)
        with counted(b, used, "share") as j:
            self.more(after, b.fmul(self.number("h", step), self.number("b", j)), self.rate(j), size)
        self.tell(step, here, size, (used, self.rate))


class _Along(_Explicit):
    name = "along"

    def step(self, step: Any) -> None:
        b, n, h = self.b, self.n, self.number("h", step)
        wide, moved, slopes = b.mul(n["size"], n["lanes"]), self.array["moved"], self.array["slopes"]
        used = self.word("used", step)
        self.set_row_slopes(step)
        with counted(b, used, "stage") as i:
            values = self.stage(step, i)
            state = at(b, slopes, b.mul(n["state_at"], n["lanes"]))
            self.copy(state, moved, wide)
            with counted(b, i, "earlier") as j:
                self.more(state, b.fmul(h, self.number("a", i, j)), self.row_of("stage_slopes", j, wide), wide)
            self.differentiate(values)
            self.copy(self.row_of("stage_slopes", i, wide), at(b, slopes, n["slopes_out_at"]), wide)
        self.tell(step, moved, wide, (used, lambda j: self.row_of("stage_slopes", j, wide)))
        with counted(b, used, "share") as j:
            self.more(moved, b.fmul(h, self.number("b", j)), self.row_of("stage_slopes", j, wide), wide)


class _Back(_Explicit):
    name = "back"

    def step(self, step: Any) -> None:
        b, n = self.b, self.n
        step = self.backwards(step)
        h, size, moved, used = self.number("h", step), n["size"], self.array["moved"], self.word("used", step)
        with counted(b, used, "stage") as i:
            self.stage(step, i)
            place = self.row_of("stage_slopes", i, size)
            share = b.fmul(h, self.number("b", i))
            with counted(b, size, "seed") as k:
                store(b, b.fmul(share, load(b, moved, k)), place, k)
        self.collect(step, used)
        with counted(b, used, "reverse") as k:
            self._stage_back(step, b.sub(b.sub(used, whole(1)), k))

    def _stage_back(self, step: Any, i: Any) -> None:
        b, n, slopes = self.b, self.n, self.array["slopes"]
        size, h = n["size"], self.number("h", step)
        self.copy(at(b, slopes, n["slopes_out_at"]), self.row_of("stage_slopes", i, size), size)
        self.differentiate(self.row_of("values", i, n["values"]))
        state = at(b, slopes, n["state_at"])
        self.more(self.array["moved"], number(1.0), state, size)
        with counted(b, i, "earlier") as j:
            self.more(self.row_of("stage_slopes", j, size), b.fmul(h, self.number("a", i, j)), state, size)
        self.add_row_weights(step)
