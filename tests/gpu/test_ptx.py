"""The text of kernels: written for all kinds of robots, and assembled for three kinds of GPUs where that can be.

Each night all of them; with each change one program and one of kernels, each method, each kind of GPU.
"""

from __future__ import annotations

import re

import pytest
from benchmarks.assembler import NONE, assembled

import tmodes
from tmodes.compile.gpu.case_loop import BLOCK, CASE_ARGUMENTS, LEAST_TARGET
from tmodes.equations.loop.outputs import OWN, Outputs
from tmodes.simulation.initial_state import run_setup

from .conftest import NIGHTLY

ROBOTS = ("filipovic2010", "spong1987", "flexarm1990", "deluca_siciliano1991")
"""By energies; elastic joints; elastic links as modes; two links that bend, as beams."""

METHODS = ("dormand_prince", "rk4", "reduced")
"""The last one: dormand_prince with series that are reduced."""


def shown(model):
    """Outputs of which a kernel is made: a place, a speed, an effort, and a distance of the tip."""
    outputs = Outputs(model.loop, (OWN,))
    names = ("tip.x", "tip.speed", f"{model.plan.drives[0].joint}.effort", OWN)
    return tuple(outputs[name] for name in names)


TARGETS = ("sm_70", "sm_80", "sm_90")

DAILY = {
    ("filipovic2010", "rk4"): "sm_80", ("spong1987", "dormand_prince"): "sm_90", ("spong1987", "reduced"): "sm_80",
    ("deluca_siciliano1991", "rk4"): "sm_90",
}  # fmt: skip
"""What is written with each change, and for which GPU it is assembled then."""

WRITTEN = [
    pytest.param(robot, method, marks=[] if (robot, method) in DAILY else NIGHTLY)
    for robot in ROBOTS
    for method in METHODS
]

ASSEMBLED = [
    pytest.param(robot, method, target, marks=[] if DAILY.get((robot, method)) == target else NIGHTLY)
    for robot in ROBOTS
    for method in METHODS
    for target in TARGETS
]


@pytest.fixture(scope="module")
def loop():
    models = {}

    def found(robot, method):
        if robot not in models:
            models[robot] = run_setup(tmodes.load(robot)).model
        if method == "reduced":
            return models[robot].lean_case_loop("dormand_prince", shown(models[robot]), 3, folds=True)
        return models[robot].case_loop(method)

    return found


@pytest.mark.parametrize(("robot", "method"), WRITTEN)
def test_a_kernel_needs_nothing_but_itself(loop, robot, method):
    """No function of the C library, no indirect call, no arithmetic in single precision, no shared memory."""
    ptx = loop(robot, method).ptx()
    assert f".target {LEAST_TARGET}\n" in ptx
    assert re.findall(r"\.visible .*", ptx) == [".visible .entry run("]
    assert f".maxntid {BLOCK}" in ptx
    assert ".extern" not in ptx
    assert ".callprototype" not in ptx
    assert ".f32" not in ptx
    assert ".shared" not in ptx
    assert len(re.findall(r"\.param \.u?b?64 (?:\.ptr[^,]* )?run_param_\d+", ptx)) == len(CASE_ARGUMENTS)


def test_only_what_may_be_fused_is(loop):
    """Sums and products that LLVM must not fuse are rounded each by itself; the assembler leaves these alone, too."""
    ptx = loop("filipovic2010", "rk4").ptx()
    for operation in ("add", "sub", "mul"):
        assert f"{operation}.rn.f64" in ptx
    assert "fma.rn.f64" in ptx
    assert not re.search(r"(sqrt|div|rcp)\.(approx|full)", ptx)


def test_the_text_is_the_same_each_time(loop):
    one = loop("spong1987", "rk4")
    assert one._ptx(LEAST_TARGET) == one._ptx(LEAST_TARGET) == one.ptx()


@pytest.mark.parametrize(("robot", "method", "target"), ASSEMBLED)
def test_an_assembler_takes_it(loop, robot, method, target, tmp_path_factory):
    """All that a thread needs is known beforehand and small: a GPU has 512 kB of local memory for a thread."""
    found = assembled(loop(robot, method).ptx(), target, tmp_path_factory.mktemp("ptx"))
    if found is None:
        pytest.skip(NONE.format(target))
    assert found.registers <= 255
    assert found.stack < 32_000
    assert found.spilled < 6_000
