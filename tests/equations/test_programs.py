"""Kernels as programs: as CasADi has them, in an order that may be run, as C, and no more of them for a longer arm."""

from __future__ import annotations

import ctypes
import gc
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from benchmarks.engines.gcc import build
from benchmarks.engines.rigid import RigidChain

from random_chains import random_chain
from tmodes.chain.chain import Chain, Gear, Motor
from tmodes.compile.ir import kernels
from tmodes.compile.ir.program import (
    READ,
    Instruction,
    block_program,
    in_good_order,
    kernel_function,
    kernel_program,
    traced,
)
from tmodes.compile.ir.unroll import Unrolled, c_text
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.kernel.schedule import Kernel
from tmodes.model.model import Model

OPERATIONS: dict[str, Any] = {
    "add": lambda x, y: x + y, "sub": lambda x, y: x - y, "mul": lambda x, y: x * y, "div": lambda x, y: x / y,
    "neg": lambda x: -x, "sq": lambda x: x * x, "twice": lambda x: 2 * x, "inv": lambda x: 1 / x, "copy": lambda x: x,
    "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos, "fabs": np.abs, "sign": lambda x: -1.0 if x < 0 else 1.0,
    "lt": lambda x, y: float(x < y), "le": lambda x, y: float(x <= y), "not": lambda x: float(x == 0),
    "if_else_zero": lambda x, y: y if x else 0.0,
}  # fmt: skip


def values_of(program: Any, inputs: Any) -> list[float]:
    found: list[float] = []
    for value in program:
        if value.opcode == "constant":
            found.append(value.value)
        elif value.opcode == "input":
            found.append(inputs[value.source[0]][value.source[1]])
        else:
            found.append(OPERATIONS[value.opcode](*(found[arg] for arg in value.args)))
    return found


def results_of(program: Any, inputs: Any, sizes: Any) -> list[float]:
    found, info = values_of(program.values, inputs), [np.zeros(size) for size in sizes]
    for output, element, index in program.results:
        info[output][element] = 0.0 if index is None else found[index]
    return np.concatenate(info).tolist()


def plain_kernels() -> list[Kernel]:
    """Those of trees with motors, sliding joints and given motions, and of the chain of the benchmark."""
    chains = [*(random_chain(seed, 5, rigid=True) for seed in range(4)), RigidChain(3).chain()]
    found = [call[0] for chain in chains for call in Model(chain).passes.schedule("forward").calls]
    return [*{kernel.key: kernel for kernel in found if kernel.plain}.values()]


def test_traced_kernels_are_casadis() -> None:
    """And so are those in another order, at random numbers."""
    rng, info = np.random.default_rng(2), plain_kernels()
    assert len(info) > 12
    for kernel in info:
        inputs = [rng.uniform(0.5, 2.0, size) for size in kernel.inputs]
        wanted = np.concatenate([np.array(out).ravel() for out in kernel_function(kernel).call(inputs)])
        scale = np.abs(wanted).max()
        for program in (traced(kernel), kernel_program(kernel), block_program(kernel_function(kernel))):
            found = results_of(program, inputs, kernel.outputs)
            assert found == pytest.approx(wanted, rel=1e-11, abs=1e-12 * scale), kernel.key


def test_traced_kernels_have_no_more_operations_than_casadis() -> None:
    """But for a few that CasADi knows by heart."""
    for kernel in plain_kernels():
        counts = [sum(value.opcode not in READ for value in one.values)
                  for one in (kernel_program(kernel), block_program(kernel_function(kernel)))]  # fmt: skip
        assert counts[0] <= 1.1 * counts[1] + 2, kernel.key


def test_what_is_known_folds_away() -> None:
    def build(a: Any) -> list[list[Any]]:
        x, y = a[0], a[1]
        return [[x * 0.0, 1.0 * y, 0.0 - (-x), x - (-y), 0.0 - x, (-x) * (-y), 2.0 + x * 0, 1 / y, y * x, 0.0 / y]]

    program = kernel_program(Kernel("folds", (2,), (10,), build, plain=True))
    kinds = [value.opcode for value in program.values]
    assert sorted(kinds) == ["add", "constant", "input", "input", "inv", "mul", "neg"]
    assert results_of(program, [[3.0, 5.0]], (10,)) == [0.0, 5.0, 3.0, 8.0, -3.0, 15.0, 2.0, 0.2, 15.0, 0.0]


def test_formula_that_decides_is_not_traced() -> None:
    kernel = Kernel("decides", (1,), (1,), lambda a: [[a[0] or 0.0]], plain=True)
    with pytest.raises(TypeError, match="not known while it is noted"):
        traced(kernel)


@pytest.mark.parametrize("seed", range(5))
def test_order_can_be_run_and_leaves_out_what_nobody_needs(seed: int) -> None:
    rng = np.random.default_rng(seed)
    values = [Instruction("input", source=(0, k)) for k in range(6)]
    for _ in range(80):
        kind = str(rng.choice(["add", "sub", "mul", "neg", "div"]))
        args = rng.integers(len(values), size=1 if kind == "neg" else 2)
        values.append(Instruction(kind, tuple(args.tolist())))
    results = [20, 50, 85]
    order = in_good_order(values, results)
    places = {index: place for place, index in enumerate(order)}
    assert len(places) == len(order)
    assert all(places[arg] < places[index] for index in order for arg in values[index].args)
    assert set(results) <= set(order)
    assert all(index in results or any(index in values[k].args for k in order) for index in order)


@pytest.mark.usefixtures("working_gcc")
def test_c_does_all_operations() -> None:
    main = [
        Instruction("input", source=(0, 0)),
        Instruction("input", source=(0, 1)),
        Instruction("constant", value=0.1),
    ]
    two = ("add", "sub", "mul", "div", "lt", "le", "if_else_zero")
    for kind in OPERATIONS:
        main += [Instruction(kind, args) for args in ([(0, 1), (1, 0), (2, 2)] if kind in two else [(1,), (2,)])]
    results = [(2 + k, 3 + k) for k in range(len(main) - 3)]
    prepare = [Instruction("constant", value=0.7)]
    library, _ = build(c_text(Unrolled(prepare, [(1, 0)], main, results), "f"), ["-O0", "-ffp-contract=off"])
    work = np.zeros(2 + len(results))
    work[0] = -1.3
    wanted = values_of(main, [[-1.3, 0.7]])[3:]
    for name in ("f_prepare", "f"):
        library[name](ctypes.c_void_p(work.ctypes.data))
    assert work[1] == 0.7
    assert work[2:] == pytest.approx(wanted, rel=1e-15)


def chain(joints: int, *, geared: bool) -> Chain:
    rigid = RigidChain(joints).chain()
    changed = {"drive": drive_kind("elastic"), "motor": Motor(0.1), "gear": Gear((50.0,))} if geared else {}
    return replace(rigid, nodes=tuple(replace(node, joint=replace(node.joint, **changed)) for node in rigid.nodes))


@pytest.mark.parametrize("geared", [False, True])
def test_longer_arms_have_the_same_kernels(geared: bool) -> None:
    """So that a thousand joints take no longer to compile than two hundred; rigid ones start no spring."""
    kinds = [
        {call[0].key for call in Model(chain(n, geared=geared)).passes.schedule("forward").calls} for n in (16, 40)
    ]
    assert kinds[0] == kinds[1]
    assert any(key.startswith("ahead") for key in kinds[0]) == geared


def test_key_of_a_schedule_reports_where_its_blocks_are() -> None:
    one, same = (Model(RigidChain(5).chain()).passes.schedule("forward") for _ in range(2))
    assert one.key == same.key
    other = Model(RigidChain(5).chain()).passes.schedule("forward")
    kernel, inputs, outputs = other.calls[3]
    other.calls[3] = (kernel, (inputs[0].part(1, inputs[0].size), *inputs[1:]), outputs)
    assert other.key != one.key


def test_collector_goes_on_where_code_cannot_be_made(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TMODES_CACHE", "")

    def write() -> Any:
        assert not gc.isenabled()
        raise RuntimeError("no module")

    assert gc.isenabled()
    with pytest.raises(RuntimeError, match="no module"):
        kernels.library("no module", "test", write, {}, 0)
    assert gc.isenabled()
