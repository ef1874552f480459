"""A small schedule as one program, and a long one as a loop over data, do what the kernels called one by one do."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from random_chains import random_chain
from simulation.sheets import arm, pendulum, torque
from tmodes.compile import native
from tmodes.compile.ir import calls, kernels, unroll
from tmodes.compile.ir.program import block_program, kernel_function
from tmodes.model.model import Model
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned
from tmodes.simulation.simulate import simulate_motion


def landing() -> Any:
    """A block on a slider and a hinge, over a surface that pushes."""
    body = {"bodies": [{"name": "m", "mass": 1.5}]}
    return arm(
        gravity=9.81,
        joints=[{"name": "s", "type": "prismatic", "child": "b", "axis": [1, 0, 0]},
                {"name": "h", "type": "revolute", "parent": "b", "child": "c", "axis": [0, 1, 0],
                 "origin": {"position": [0.1, 0.2, 0]}}],
        links=[{"name": "b", **body}, {"name": "c", "bodies": [{"name": "n", "mass": 1.0, "center": [0.3, 0, 0.1]}]}],
        drives=[{"joint": name, "command": "effort", "signal": {"type": "constant", "value": 0.0}} for name in "sh"],
        initial={"state": "zero", "coordinates": {"s": -0.05}, "rates": {"s": 0.8}},
        contact={"shape": {"type": "plane", "position": [0.02, 0, 0], "normal": [-1, 0, 0]}, "law": "unilateral",
                 "stiffness": 2e4, "damping": 60.0},
        integration={"duration": 0.1, "output_step": 0.01, "method": "extrapolation", "relative_tolerance": 1e-9},
    )  # fmt: skip


def rate_of(sheet: Any) -> tuple[Any, Any]:
    model = LoopModel(planned(sheet).plan)
    return model.loop.rate, model.numbers


def forward_of(chain: Any) -> tuple[Any, Any]:
    model = Model(chain)
    return model.passes.schedule("forward"), model.parameters


SCHEDULES = {
    "rigid": lambda: forward_of(random_chain(5, 4, rigid=True)),
    "gears": lambda: forward_of(replace(random_chain(8, 3, rigid=True), couplings=None)),
    "run with a gear": lambda: rate_of(
        pendulum({"inertia": 0.3, "friction": {"viscous": 0.1}}, {"stiffness": 100.0}, torque(1.0))
    ),
    "run into a surface": lambda: rate_of(landing()),
}


def evaluated(name: str, schedule: Any, arithmetic: str, numbers: Any, rows: Any, *, each: bool = False) -> Any:
    width, out = (4 if arithmetic == "lanes" else 1), np.empty((len(rows), schedule.output_size))
    workspace = np.zeros(width * schedule.workspace)
    run = kernels.schedule_function(f"test {name}", schedule, arithmetic)["run"]
    run(len(rows) // width, int(each), *(array.ctypes.data for array in (numbers, workspace, rows, out)))
    return out


def random_rows(schedule: Any, count: int) -> Any:
    rows = np.random.default_rng(3).normal(size=(count, schedule.input_size))
    places = np.cumsum([0, *(slot.size for slot in schedule.inputs.values())])
    step = list(schedule.inputs).index("step")
    known_zero = schedule.inputs["step"] in schedule.zeros
    rows[:, places[step]] = np.abs(rows[:, places[step]]) * (0.0 if known_zero else 1e-3)  # of an implicit step
    return rows


@pytest.mark.parametrize("name", SCHEDULES)
def test_one_program_is_the_kernels(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    schedule, numbers = SCHEDULES[name]()
    assert native.pays(schedule)
    rows = random_rows(schedule, 8)
    one = evaluated("unrolled", schedule, "double", numbers, rows)
    monkeypatch.setattr(native, "LIMIT", 0)
    monkeypatch.setattr(calls, "DIRECT", 0)
    assert not native.pays(schedule)
    other = evaluated("called", schedule, "double", numbers, rows)
    assert np.isfinite(other).all()
    assert np.abs(one - other).max() <= 1e-12 * np.abs(other).max()


@pytest.mark.parametrize("arithmetic", ["double", "lanes"])
def test_each_sample_has_what_follows_from_its_own_numbers(arithmetic: str) -> None:
    """Numbers of each sample are prepared again; lanes agree with single samples to the bit."""
    schedule, numbers = SCHEDULES["run with a gear"]()
    rows, scale = random_rows(schedule, 8), np.linspace(0.5, 1.5, 8)[:, None]
    own = np.ascontiguousarray(numbers * scale)
    found = evaluated("each", schedule, arithmetic, own, rows, each=True)
    for k in range(8):
        alone = evaluated("each", schedule, "double", own[k], rows[k : k + 1])
        assert alone.tobytes() == found[k : k + 1].tobytes()


def test_zeros_and_twins_are_gone() -> None:
    """Fewer operations than all calls have, none twice, and none that the parameters alone decide."""
    schedule, _ = SCHEDULES["rigid"]()
    code = unroll.unrolled(schedule)
    called = sum(len(block_program(kernel_function(kernel)).values) for kernel, _, _ in schedule.calls)
    assert len(code.main) < 0.8 * called
    assert len(set(code.main)) == len(code.main)
    places = {value.source[1] for value in code.main if value.opcode == "input"}
    zeros = {schedule.offset(slot) + k for slot in schedule.zeros for k in range(slot.size)}
    assert not places & zeros
    assert {place for place, _ in code.prepared} <= places


def test_long_and_seldom_schedules_are_called() -> None:
    """Links that bend are thousands of operations; what runs once is not worth the wait for its code."""
    bending = next(chain for chain in map(random_chain, range(20)) if "bend" in str(Model(chain).coordinates))
    assert not native.pays(Model(bending).passes.schedule("forward"))
    assert not native.pays(Model(random_chain(5, 4, rigid=True)).passes.schedule("inertia"))


def test_run_is_the_same_however_it_is_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """A whole run into a surface, whose gate ends steps: the same steps either way."""
    monkeypatch.setenv("TMODES_CACHE", "")
    one = simulate_motion(landing())
    kernels._loaded.clear()
    monkeypatch.setattr(native, "LIMIT", 0)
    other = simulate_motion(landing())
    kernels._loaded.clear()
    assert one.contact_normal is not None
    assert one.contact_normal.max() > 1
    assert np.abs(one.q - other.q).max() < 1e-9
