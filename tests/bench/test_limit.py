"""Limits of programs that can be reckoned by hand, and the chains of operations that the machine is measured with."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from benchmarks.engines.latency import BODY, OPERATIONS, chains
from benchmarks.engines.limit import critical_path, machine, throughput

from tmodes.compile.ir.program import block_program

LATENCY = {"add": 2.0, "mul": 3.0, "div": 10.0, "sqrt": 20.0, "sin": 50.0, "fma": 4.0}
COST = {"add": 0.5, "mul": 0.5, "div": 5.0, "sqrt": 8.0, "sin": 20.0, "fma": 0.5, "mixed": 0.5}


def program(expression, *inputs):
    return block_program(ca.Function("f", list(inputs), [expression]))


def test_a_chain_and_a_tree() -> None:
    """Four sums one after the other wait for each other; as a tree they do not; their cost is the same."""
    x = ca.SX.sym("x", 4)
    chain = program(((x[0] + x[1]) + x[2]) + x[3], x)
    tree = program((x[0] + x[1]) + (x[2] + x[3]), x)
    assert (critical_path(chain, LATENCY), critical_path(tree, LATENCY)) == (6.0, 4.0)
    assert throughput(chain, COST) == throughput(tree, COST) == 1.5


def test_a_product_that_one_sum_reads_is_fused() -> None:
    """x y + z is one operation; where the product is read twice it is two."""
    x = ca.SX.sym("x", 3)
    product = x[0] * x[1]
    assert throughput(program(product + x[2], x), COST) == 0.5
    assert throughput(program(ca.vertcat(product + x[2], product), x), COST) == 1.0


def test_sums_go_next_to_products_where_there_are_units_for_both() -> None:
    """Two sums and three products: on units of their own the products are what takes time."""
    x = ca.SX.sym("x", 4)
    both = program(ca.vertcat(x[0] + x[1], x[2] + x[3], x[0] * x[1], x[1] * x[2], x[2] * x[3]), x)
    assert throughput(both, COST) == 2.5
    assert throughput(both, COST | {"mixed": 0.25}) == 1.5
    assert throughput(both, COST | {"mixed": 0.4}) == pytest.approx(0.8 * 2.5)


def test_sine_and_cosine_of_an_angle_cost_once() -> None:
    x = ca.SX.sym("x")
    both = program(ca.sin(x) / ca.cos(x), x)
    assert throughput(both, COST) == 25.0
    assert critical_path(both, LATENCY) == 60.0


@pytest.mark.parametrize("width", [1, 3])
def test_chains_do_what_they_are_timed_for(width: int) -> None:
    """So that no compiler has left the work out."""
    library, loops = chains(width), 2
    count = loops * BODY
    start = np.linspace(1.0, 1.5, width)
    for name, wanted in {
        "add": start + count * 1e-9,
        "mul": start * (1 - 1e-12) ** count,
        "div": start / (1 + 1e-12) ** count,
        "sqrt": start ** (0.5**count),
        "fma": 1 + (start - 1) * 0.999999**count,
    }.items():
        numbers = start.copy()
        library[name](loops, numbers.ctypes.data)
        assert numbers == pytest.approx(wanted, rel=1e-13), name
    numbers, sine = start.copy(), start.copy()
    library["sin"](1, numbers.ctypes.data)
    for _ in range(BODY):
        sine = np.sin(sine)
    assert numbers == pytest.approx(sine, rel=1e-13)


def test_mixed_chains_take_turns() -> None:
    """Sums on one number, fused operations on the next."""
    numbers = np.linspace(1.0, 1.5, 4)
    chains(4)["mixed"](1, numbers.ctypes.data)
    wanted = np.linspace(1.0, 1.5, 4)
    wanted[::2] += BODY * 1e-9
    wanted[1::2] = 1 + (wanted[1::2] - 1) * 0.999999**BODY
    assert numbers == pytest.approx(wanted, rel=1e-13)


def test_chain_of_cycles() -> None:
    """Sums and exclusive ors, in 64 bits."""
    cell = np.array([42], dtype=np.uint64)
    chains(1)["cycle"](3, cell.ctypes.data)
    wanted = 42
    for _ in range(3):
        for k in range(BODY // 2):
            wanted = ((wanted ^ (0x5555 + k)) + 12345 + k) % 2**64
    assert int(cell[0]) == wanted


def test_machine_is_measured() -> None:
    """Every operation has a time; a result is not there before a cycle has passed."""
    here = machine()
    assert set(here.latency) == set(here.cost) - {"mixed"} == set(OPERATIONS)
    assert min([here.cycle, *here.latency.values(), *here.cost.values()]) > 0
    assert here.latency["div"] > here.cycle
