"""Rodas5P, a Rosenbrock method of order 5(4), stiffly accurate and L-stable, with dense output, as a native loop.

Eight stages with one LU decomposition of 1/(h gamma) - J: G. Steinebach, BIT Numer. Math. 63 (2023) 27, whose
coefficients these are, for the form with u_i in which J is not multiplied (E. Hairer, G. Wanner, Solving Ordinary
Differential Equations II, section IV.7). The Jacobian is exact, so is the derivative by time: a check on the methods
that need none, and for small stiff arms.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.arithmetic import Derivative
from tmodes.compile.ir.block import ScheduleRate, write_main
from tmodes.compile.ir.emit import F64, POINTER, VOID, Builder, counted, declare, load, number, store, whole
from tmodes.compile.ir.linear_solve import lu_functions
from tmodes.compile.ir.rows import take_rows
from tmodes.compile.loops.frame import MotionNorm
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.step_control import ImplicitControl
from tmodes.compile.loops.time_loop import Status, TimeLoop
from tmodes.errors import CompileError
from tmodes.integrate.implicit import MOST_STATES

__all__ = ["STAGE_RATES", "STAGE_STATES", "RateJacobian", "write_rosenbrock_loop"]

GAMMA = 0.21193756319429014
TIMES = (0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664, 1.0, 1.0, 1.0)
BY_TIME = (0.21193756319429014, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069)
_LAST = (-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946)
STAGE_STATES = (
    (),
    (3.0,),
    (2.849394379747939, 0.45842242204463923),
    (-6.954028509809101, 2.489845061869568, -10.358996098473584),
    (2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641),
    _LAST,
    (*_LAST, 1.0),
    (*_LAST, 1.0, 1.0),
)
"""Weights of the u_j before it in the state of each stage; the step ends at that of the last and its own u."""
STAGE_RATES = (
    (),
    (-14.155112264123755,),
    (-17.97296035885952, -2.859693295451294),
    (147.12150275711716, -1.41221402718213, 71.68940251302358),
    (165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306),
    (24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471),
    (30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783, -19.097331116725623,
     -28.087943162872662),
    (37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047, -40.06618937091002,
     -54.66780262877968, -9.48861652309627),
)  # fmt: skip
"""Weights of the u_j before it, over h, in the right side of each stage."""
DENSE = (
    (25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204, 0.524948541321073,
     1.1241088310450404, 0.4272876194431874, -0.17202221070155493),
    (-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796, 20.176138334709044,
     15.98066361424651, -6.789040303419874, -6.710236069923372),
    (11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643, -52.072871366152654,
     -59.78993625266729, -0.15582684282751913, 4.883087185713722),
)  # fmt: skip
"""Weights of the u_j in the bow of the motion between both ends: (1 - s) s (B1 + s (B2 + s B3))."""

_CONTROL = ImplicitControl(exponent=1 / 5, smallest=0.2, first=1e-6)
_STAGES = tuple(f"u{i}" for i in range(1, 9))


def write_rosenbrock_loop(
    module: Any, name: str, lowered: ScheduleRate, guarded: int, *, schedule: Any, pairs: int, columns: int
) -> None:
    """Write the loop; steps end on knots, samples are interpolated.

    ``columns``: numbers of the state that rates depend on, its first; what is left (works) is integrated along. Raises
    :class:`CompileError` for more than ``MOST_STATES`` of them.
    """
    if columns > MOST_STATES:
        raise CompileError(
            f"integration.method: the Jacobian of rosenbrock does not fit for a state of {columns} numbers, only up to "
            f"{MOST_STATES}; take extrapolation, which needs no Jacobian"
        )
    loop = TimeLoop(module, name, lowered, (*_STAGES, "probe", "by_time", "low", "new"), guarded)
    _RosenbrockWriter(loop, RateJacobian(module, schedule, columns, f"{name}.jacobian"), pairs).write()


class _RosenbrockWriter:
    """Writes the body of the loop."""

    def __init__(self, loop: TimeLoop, jacobian: RateJacobian, pairs: int) -> None:
        self.loop, self.b, self.jacobian, self.columns = loop, loop.builder, jacobian, jacobian.columns
        self.factor, self.solve = lu_functions(loop.module, self.columns)
        self.norm, self.gate = MotionNorm(loop, pairs), Gate(loop, implicit=True)
        m = self.columns
        sizes = {"slopes": jacobian.held_size, "by_state": loop.size * m, "matrix": m * m, "order": m}
        with self.b.goto_entry_block():
            for label, size in sizes.items():
                loop.array[label] = self.b.alloca(F64, size=whole(max(size, 1)), name=label)
            self.b.call(jacobian.prepare, [loop.argument["p"], loop.array["slopes"]])

    def write(self) -> None:
        """One attempt of a step, from the block ``again`` back to it."""
        loop, b = self.loop, self.b
        self.gate.begin("y", "u1")
        step = _CONTROL.begin(loop)
        self._decompose(step.time, step.h)
        for stage in range(len(_STAGES)):
            self._stage(stage, step.time, step.h)
        loop.combine("new", {"u8": number(1.0)}, base="probe")
        loop.copy("low", "probe")
        grown = _CONTROL.judge(loop, step, self.norm.of_difference("new", "low", "y", step.h))
        if self.gate.exists:
            loop.evaluate(step.time_after, "new", "low")
            self.gate.meet(step.h)
        loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
        with loop.due_samples(step.time_after) as target:
            self._write_sample(b.fdiv(b.fsub(loop.sample_time(), step.time), step.h), target)
        loop.take(step, grown)
        b.branch(loop.again)

    def _decompose(self, time: Any, h: Any) -> None:
        """LU factors of 1/(h gamma) - J at the start of the step."""
        loop, b, m = self.loop, self.b, self.columns
        arrays = [loop.array[label] for label in ("slopes", "by_state", "by_time")]
        b.call(self.jacobian.call, [time, loop.array["y"], loop.row(), *arrays])
        diagonal = b.fdiv(number(1.0 / GAMMA), h)
        with counted(b, m * m, "entry") as k:
            store(b, b.fneg(load(b, loop.array["by_state"], k)), loop.array["matrix"], k)
        with counted(b, m, "diagonal") as k:
            place = b.mul(k, whole(m + 1))
            store(b, b.fadd(load(b, loop.array["matrix"], place), diagonal), loop.array["matrix"], place)
        b.call(self.factor, [loop.array["matrix"], loop.array["order"]])

    def _stage(self, stage: int, time: Any, h: Any) -> None:
        """The u of a stage; its state stays in ``probe``."""
        loop, b, label = self.loop, self.b, _STAGES[stage]
        loop.combine("probe", {_STAGES[j]: number(a) for j, a in enumerate(STAGE_STATES[stage])})
        loop.evaluate(b.fadd(time, b.fmul(number(TIMES[stage]), h)), "probe", label)
        weights = {_STAGES[j]: b.fdiv(number(c), h) for j, c in enumerate(STAGE_RATES[stage])}
        if stage < len(BY_TIME):
            weights["by_time"] = b.fmul(number(BY_TIME[stage]), h)
        loop.combine(label, weights, base=label)
        b.call(self.solve, [loop.array["matrix"], loop.array["order"], loop.array[label]])
        self._follow(loop.array[label], b.fmul(h, number(GAMMA)))

    def _follow(self, u: Any, share: Any) -> None:
        """What no rate depends on: u = h gamma (right side + J u)."""
        loop, b, m = self.loop, self.b, self.columns
        total = loop.local("total")
        with counted(b, loop.size - m, "rest") as k:
            place = b.add(k, whole(m))
            b.store(load(b, u, place), total)
            with counted(b, m, "known") as j:
                entry = load(b, loop.array["by_state"], b.add(b.mul(place, whole(m)), j))
                b.store(b.fadd(b.load(total, typ=F64), b.fmul(entry, load(b, u, j))), total)
            store(b, b.fmul(share, b.load(total, typ=F64)), u, place)

    def _write_sample(self, share: Any, target: Any) -> None:
        """Between both ends at the share of the step: the chord and its bow."""
        loop, b = self.loop, self.b
        rest = b.fsub(number(1.0), share)
        bow = b.fmul(share, rest)
        powers = [bow, b.fmul(bow, share), b.fmul(b.fmul(bow, share), share)]
        with counted(b, loop.size, "value") as i:
            ends = (b.fmul(rest, loop.load("y", i)), b.fmul(share, loop.load("new", i)))
            total = b.fadd(*ends)
            for stage, label in enumerate(_STAGES):
                weight: Any = number(0.0)
                for factor, row in zip(powers, DENSE, strict=True):
                    weight = b.fadd(weight, b.fmul(factor, number(row[stage])))
                total = b.fadd(total, b.fmul(weight, loop.load(label, i)))
            store(b, total, target, i)


class RateJacobian:
    """Writes ``prepare(parameters, held)`` and ``call(time, state, row, held, by_state, by_time)`` into a module.

    ``by_state``: (outputs, columns), row by row, the derivatives by the first ``columns`` numbers of the state;
    ``by_time``: (outputs,). ``held_size``: numbers of the memory that the caller keeps.
    """

    def __init__(self, module: Any, schedule: Any, columns: int, name: str) -> None:
        self.schedule, self.columns, self.held_size = schedule, columns, 2 * schedule.workspace
        self.numbers = Derivative(module)
        self.main = write_main(module, schedule, self.numbers, f"{name}.main")
        self.prepare = self._write_prepare(module, f"{name}.prepare")
        self.call = self._write_call(module, f"{name}.call")

    def _write_prepare(self, module: Any, name: str) -> Any:
        function = declare(module, name, VOID, [("parameters", POINTER), ("held", POINTER)], private=True)
        parameters, held = function.args
        b = Builder(function.append_basic_block("entry"))
        with counted(b, self.held_size, "number") as k:
            store(b, number(0.0), held, k)
        take_rows(b, self.numbers, parameters, held, [(0, self.schedule.parameters)], 1)
        b.ret_void()
        return function

    def _write_call(self, module: Any, name: str) -> Any:
        pointers = [(label, POINTER) for label in ("state", "row", "held", "by_state", "by_time")]
        function = declare(module, name, VOID, [("time", F64), *pointers], private=True)
        function.attributes.add("noinline")
        time, state, row, held, by_state, by_time = function.args
        b = Builder(function.append_basic_block("entry"))
        inputs = self.schedule.inputs
        for label, source in (("state", state), ("row", row)):
            take_rows(b, self.numbers, source, held, self.main.blocks([inputs[label]]), 1)
        first, instant = (self.schedule.offset(inputs[label]) for label in ("state", "time"))
        self.numbers.store(b, self.numbers.packed(b, [time]), held, instant)
        with counted(b, self.columns, "column") as k:
            self._column(b, held, b.add(k, whole(first)), by_state, k, self.columns)
        self._column(b, held, whole(instant), by_time, whole(0), 1)
        b.ret_void()
        return function

    def _column(self, b: Any, held: Any, place: Any, into: Any, column: Any, width: int) -> None:
        """The derivatives of all outputs along one number of the workspace."""
        slope = b.add(b.mul(place, whole(2)), whole(1))
        store(b, number(1.0), held, slope)
        b.call(self.main.function, [held])
        first = 0
        for offset, size in self.main.blocks(slot for slots in self.schedule.outputs.values() for slot in slots):
            with counted(b, size, "output") as k:
                found = load(b, held, b.add(b.mul(k, whole(2)), whole(2 * offset + 1)))
                store(b, found, into, b.add(b.mul(b.add(k, whole(first)), whole(width)), column))
            first += size
        store(b, number(0.0), held, slope)  # not before: an output may be an input itself
