"""Laws: the compiled form of a block, from what it reads to its outputs, sampled or in continuous time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import casadi as ca

from tmodes.equations.loop.rigid_terms import RigidModel
from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.errors import InputError, TmodesError, error_words
from tmodes.kinds.controllers.registry import Block, Measured, OwnState
from tmodes.kinds.kernel.functions import if_else
from tmodes.kinds.kernel.schedule import Kernel
from tmodes.kinds.noted.functions import isfinite, number

__all__ = ["Delay", "Law", "View"]


class View(NamedTuple):
    """What a block that sees all sees: names of coordinates and drives, currents, its own coordinate (-1: none).

    ``orders``: numbers of each setpoint; ``commands``: the joints that it commands.
    """

    names: tuple[str, ...]
    drives: tuple[str, ...]
    currents: int
    own: int = -1
    orders: int = SIGNAL
    commands: tuple[str, ...] = ()

    @property
    def sizes(self) -> tuple[int, ...]:
        """Sizes of the blocks q, v, currents, setpoints."""
        return len(self.names), len(self.names), self.currents, self.orders * len(self.drives)


class Delay(NamedTuple):
    """From a sample to its output: whole ``periods``, and whether a part of one more (``late``)."""

    periods: int = 0
    late: bool = False

    @property
    def kept(self) -> int:
        """How many earlier outputs are kept."""
        return self.periods + self.late


class _Inputs(NamedTuple):
    """What a kernel is called with, by what it is."""

    signal: Any
    position: Any
    velocity: Any
    current: Any
    noise: Any
    limit: Any
    state: Any
    view: list[Any]
    reads: Any
    clocks: list[Any]


@dataclass(frozen=True)
class Law:
    """A block with all that is structure around it.

    ``owned``: it has a drive of its own, whose setpoint, position, rate and current it sees; ``noisy``: with an error
    on that setpoint; ``limited``: the drive has a largest command. ``outputs``: how many it gives. ``timed``: a block
    of continuous time that its drive samples. ``settles``: a sampled block as one in continuous time whose rates are
    the changes of its own states from sample to sample: zero where constant inputs leave it as it is. ``model``: the
    rigid robot that it computes with. ``fed``: an effort is fed forward to the drive of its own.
    """

    block: Block
    owned: bool = True
    view: View | None = None
    outputs: int = 1
    noisy: bool = False
    limited: bool = False
    timed: bool = False
    settles: bool = False
    delay: Delay = field(default_factory=Delay)
    model: RigidModel | None = None
    fed: bool = False

    @property
    def is_sampled(self) -> bool:
        """Whether it holds its outputs between samples."""
        return (self.timed or self.block.period is not None) and not self.settles

    @property
    def held(self) -> int:
        """How many of the states are outputs, held now or kept for later."""
        return self.outputs * (1 + self.delay.kept) if self.is_sampled else 0

    @property
    def start(self) -> tuple[float, ...]:
        """Its states at time 0: held outputs, which the first sample sets, those kept, then the block's own."""
        return (*(0.0,) * self.held, *_answered(self.block, "initial", self.block.initial))

    @property
    def states(self) -> int:
        """Number of its states, the held outputs among them."""
        return len(self.start)

    @property
    def own_numbers(self) -> int:
        """How many numbers the block itself has."""
        return len(self.block.numbers())

    @property
    def count(self) -> int:
        """How many numbers it reads: those of the block, of the model, and the period of a timed one."""
        return self.own_numbers + self.model_count + self.timed

    @property
    def model_count(self) -> int:
        """How many numbers the rigid robot has."""
        return len(self.model.numbers) if self.model else 0

    def numbers(self, period: float | None = None) -> tuple[Any, ...]:
        """What it reads: numbers of the block, of the rigid robot, and the ``period`` [s] of a timed one."""
        robot = self.model.numbers if self.model else ()
        return (*_answered(self.block, "numbers", self.block.numbers), *robot, *((period,) if self.timed else ()))

    @property
    def key(self) -> str:
        """The structure in words."""
        words = {"noisy": self.noisy, "settles": self.settles, "limited": self.limited, "timed": self.timed,
                 "fed": self.fed}  # fmt: skip
        more = [word for word, holds in words.items() if holds]
        more += [f"view {self.view}"] if self.view else []
        more += [f"{self.delay}"] if self.delay.kept and self.is_sampled else []
        more += [f"reads {self.block.reads}"] if self.block.reads else []
        more += [f"model {self.model.key} {self.model.drives}"] if self.model else []
        return " ".join([f"{self.block.structure} owned {self.owned} {self.outputs}", *more])

    @property
    def inputs(self) -> tuple[int, ...]:
        """Sizes of the blocks that both kernels take."""
        own = (SIGNAL, 1, 1, 1) if self.owned else ()
        more = (SIGNAL,) * self.noisy + (1,) * self.limited + ((self.states,) if self.states else ())
        read = (len(self.block.reads),) if self.block.reads else ()
        return (self.count, *own, *more, *(self.view.sizes if self.view else ()), *read)

    def kernel(self) -> Kernel:
        """(numbers, setpoint, position, rate, current, ...) -> (outputs, fall per own position and rate, rates).

        Further inputs, where the structure has them: noise (3), limit, states, blocks of the view, what it reads.
        Outputs of a sampled one are those that it holds. The slopes are of its first output, for implicit steps.
        """

        def build(p: Any, *blocks: Any) -> list[list[Any]]:
            given = self._given(blocks)
            if self.is_sampled:
                found, slopes = [given.state[k] for k in range(self.outputs)], [0.0, 0.0]
                return [found, slopes, *([[0.0] * self.states] if self.states else [])]
            found, slopes, rates = self._at(p, given)
            return [found, slopes, *([rates] if rates else [])]

        rates = (self.states,) if self.states else ()
        return Kernel(f"law {self.key}", self.inputs, (self.outputs, 2, *rates), build)

    def sample_kernel(self) -> Kernel:
        """(numbers, ..., clock, clock of late outputs) -> its states, new where a clock is 0; inputs as :meth:`kernel`.

        At a sample the block's outputs are put behind those that are kept, and the first of these is given: at once,
        or where the second clock is 0.
        """

        def build(p: Any, *blocks: Any) -> list[list[Any]]:
            given = self._given(blocks)
            x = [given.state[k] for k in range(self.states)]
            held, own, m = x[: self.held], x[self.held :], self._measured(p, given, None)
            numbers, k = [p[i] for i in range(self.own_numbers)], self.outputs
            kept = [*held[k:], *self._outputs(numbers, m, own)]
            fresh = given.clocks[0][0] <= 0
            after = [if_else(fresh, new, old) for new, old in zip(self._updated(p, m, own), own, strict=True)]
            if not self.delay.late:
                return [[*(if_else(fresh, new, old) for new, old in zip(kept, held, strict=True)), *after]]
            moved = kept[k:]  # what is kept has no room for the output that is given now
            queue = [if_else(fresh, new, old) for new, old in zip(moved, held[k:], strict=True)]
            due = given.clocks[1][0] <= 0
            return [[*(if_else(due, new, old) for new, old in zip(queue, held[:k], strict=False)), *queue, *after]]

        clocks = (SIGNAL,) * (1 + self.delay.late)
        return Kernel(f"sampling {self.key}", (*self.inputs, *clocks), (self.states,), build)

    def _given(self, blocks: tuple[Any, ...]) -> _Inputs:
        """The inputs by what they are, zeros in the place of those that are not there."""
        left = list(blocks)

        def take(there: bool, otherwise: Any) -> Any:
            return left.pop(0) if there else otherwise

        signal, position, velocity, current = (take(self.owned, [0.0] * size) for size in (SIGNAL, 1, 1, 1))
        noise, limit, state = take(self.noisy, None), take(self.limited, None), take(bool(self.states), [])
        view = [left.pop(0) for _ in self.view.sizes] if self.view else []
        reads = take(bool(self.block.reads), [])
        return _Inputs(signal, position, velocity, current, noise, limit, state, view, reads, left)

    def _at(self, p: Any, given: _Inputs) -> tuple[list[Any], list[Any], list[Any]]:
        """Outputs, the fall of the first per own position and rate, and the rates of the own states."""
        x = [given.state[k] for k in range(self.states)]
        own = ca.SX.sym("own", 2)
        measured = self._measured(p, given, own if self.owned else None)
        numbers = [p[k] for k in range(self.own_numbers)]
        found = ca.SX(ca.vertcat(*self._outputs(numbers, measured, x)))
        rates = ca.SX(ca.vertcat(*self._rates(p, measured, x)))
        slopes = -ca.jacobian(found[0], own)
        place = ca.vertcat(given.position[0], given.velocity[0])
        found, slopes, rates = ca.substitute([found, slopes, rates], [own], [place])
        return [found[k] for k in range(self.outputs)], [slopes[0], slopes[1]], [rates[k] for k in range(len(x))]

    def _outputs(self, numbers: list[Any], m: Measured, x: list[Any]) -> list[Any]:
        return _answered(self.block, "command", lambda: self.block.command(numbers, m, x), self.outputs)

    def _further(self, p: Any, m: Measured, x: list[Any], *, rates: bool) -> list[Any]:
        """Rates of the own states, or their values after a sample."""
        numbers, method = [p[k] for k in range(self.own_numbers)], "rates" if rates else "updates"
        return _answered(self.block, method, lambda: getattr(self.block, method)(numbers, m, x), len(x))

    def _rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        if self.timed or self.block.period is None:
            return self._further(p, m, x, rates=True)
        new = self._further(p, m, x, rates=False)
        return [after - before for after, before in zip(new, x, strict=True)]

    def _updated(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        if not self.timed:
            return self._further(p, m, x, rates=False)
        period, rates = p[self.count - 1], self._further(p, m, x, rates=True)
        return [value + period * rate for value, rate in zip(x, rates, strict=True)]

    def _measured(self, p: Any, given: _Inputs, own: Any) -> Measured:
        """What the block sees; ``own``: symbols of its own position and rate in place of what is given."""
        signal, noise = given.signal, given.noise
        wanted = [signal[k] + noise[k] for k in range(SIGNAL)] if self.noisy else [signal[k] for k in range(SIGNAL)]
        position, velocity = (given.position[0], given.velocity[0]) if own is None else (own[0], own[1])
        here: dict[str, Any] = {
            "wanted": wanted[0], "wanted_rate": wanted[1], "wanted_acceleration": wanted[2],
            "position": position, "velocity": velocity, "current": given.current[0],
            "signals": {name: given.reads[k] for k, name in enumerate(self.block.reads)},
            "at_rest": self.settles, "fed": self.fed,
            "limit": given.limit[0] if self.limited else None, "period": p[self.count - 1] if self.timed else None,
        }  # fmt: skip
        if self.view:
            here |= self._seen(self.view, given, wanted, (position, velocity))
        if self.model:
            here["model"] = self.model.terms([p[self.own_numbers + k] for k in range(self.model_count)])
        return Measured(**here)

    def _seen(self, view: View, given: _Inputs, wanted: list[Any], own: tuple[Any, Any]) -> dict[str, Any]:
        """What a block that sees all sees: of its own drive as the others' measurements are."""
        q, v = ([block[k] for k in range(len(view.names))] for block in given.view[:2])
        orders = range(view.orders)
        setpoints = [[given.view[3][view.orders * k + i] for i in orders] for k in range(len(view.drives))]
        joint = view.names[view.own].removesuffix(".motor") if view.own >= 0 else ""
        if joint:
            q[view.own], v[view.own] = own
            setpoints[view.drives.index(joint)][:SIGNAL] = wanted
        currents = [given.view[2][k] for k in range(view.currents)]
        named = {"names": view.names, "drives": view.drives, "joint": joint, "commands": view.commands}
        return {"q": q, "v": v, "setpoints": setpoints, "currents": currents, **named}

    def named_states(self, units: tuple[str, ...], names: tuple[str, ...] = ("command",)) -> tuple[OwnState, ...]:
        """Names and units of the states; ``units`` and ``names``: of the outputs that it holds."""
        if not self.is_sampled:
            return self.block.states
        later = [f"{name}_due{k + 1}" for k in range(self.delay.kept) for name in names]
        held = zip([*names, *later], units * (1 + self.delay.kept), strict=True)
        return (*(OwnState(name, unit) for name, unit in held), *self.block.states)


def _answered(block: Block, method: str, ask: Callable[[], Any], count: int | None = None) -> list[Any]:
    """What a method of a block gives, as ``count`` formulas; without a count, finite numbers.

    Raises :class:`tmodes.errors.InputError` for what it raises, and for another answer, as a kind of a user may.
    """
    expected = "finite numbers" if count is None else f"{count} formula{'s' * (count != 1)} of what it is given"
    hint = "correct the class; formulas are sums, products and functions of tmodes.kinds.kernel.functions, without `if`"
    try:
        found = ask()
        listed = list(found) if isinstance(found, list | tuple) else [found]
    except TmodesError:
        raise
    except Exception as error:
        raise InputError(f"{type(block).__name__}.{method}", error_words(error), expected, hint) from error
    outside = not type(block).__module__.startswith("tmodes.")
    wrong = next((one for one in listed if outside and not (_is_finite if count is None else _is_formula)(one)), listed)
    if wrong is not listed or count not in (None, len(listed)):
        got = f"{len(listed)} of them" if wrong is listed else f"{wrong!r:.60}"
        raise InputError(f"{type(block).__name__}.{method}", got, expected, hint)
    return listed


def _is_finite(one: Any) -> bool:
    try:
        return bool(isfinite(number(one)))
    except (TypeError, ValueError):
        return False


def _is_formula(one: Any) -> bool:
    """Whether it is one number or symbol; functions of `math` make not a number of symbols."""
    try:
        return ca.SX(one).is_scalar() and "nan" not in str(ca.SX(one))
    except NotImplementedError:
        return False
