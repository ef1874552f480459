"""Memory stays flat: over ten to the eighth steps, and over ten thousand robots compiled in one process."""

from __future__ import annotations

from functools import cached_property
from typing import Any, cast

import numpy as np
import pytest

from tmodes.chain.chain import Chain, Gear, Joint, Motor, Node
from tmodes.compile.ir import kernels
from tmodes.compile.loops.loops import schedule_loop
from tmodes.frame import Placement
from tmodes.integrate.settings import Integration
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.kernel.functions import sqrt
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.model.model import Model
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

from .scale import memory, often

pytestmark = pytest.mark.nightly


class Oscillator:
    """x'' = -p x: the smallest thing that moves."""

    coordinates = ("x",)

    @property
    def batch_widths(self) -> dict[str, int]:
        return {"parameters": 1, "states": 2, "schedules": 2}

    @cached_property
    def loops(self) -> dict[str, Any]:
        rates = Kernel("oscillator", (2, 1), (2,), lambda x, p: [[x[1], -p[0] * x[0]]], plain=True)
        schedule = Schedule(1)
        schedule.input("time", 1)
        state = schedule.input("state", 2)
        schedule.input("row", 2)
        schedule.output("rate", *schedule.call(rates, state, Slot("parameters", 0, 1)))
        return {"rk4": schedule_loop(schedule, 2, "rk4")["rk4"]}

    def rate(self, time: Any, state: Any, row: Any, parameters: Any) -> Any:
        """Not asked for: nothing diverges."""
        raise NotImplementedError


def test_many_steps_in_one_process() -> None:
    """The memory of a run does not grow with its steps, and its end is that of the method, by powers of one step."""
    steps, step = often(2_000_000, 100_000_000), 0.01
    still = SignalPieces(np.array([0.0, 1.0]), np.zeros((1, 1)))
    numbers, oscillator = np.ones(1), cast("Any", Oscillator())

    def run(count: int) -> Any:
        settings = Integration(
            method="rk4", step=step, duration=count * step, output_step=count * step / 100, max_steps=10**9
        )
        return solve(problem_of(oscillator, numbers, still, np.array([1.0, 0.0]), settings))

    run(100_000)
    before = memory()
    done = run(steps)
    assert done.status == "finished"
    assert done.statistics["steps"] == steps
    assert memory() - before < 4.0
    step_to_step = np.array([[0.0, 1.0], [-1.0, 0.0]]) * step
    once = sum((np.linalg.matrix_power(step_to_step, k) / np.prod(range(1, k + 1)) for k in range(5)), np.zeros((2, 2)))
    wanted = np.linalg.matrix_power(once, steps) @ [1.0, 0.0]
    assert np.abs(done.states[-1] - wanted).max() < 1e-6


def robot(number: int) -> Chain:
    """Nine joints, of which each is revolute, prismatic or elastic: the digits of a number to base 3."""
    nodes = []
    for k in range(9):
        digit = number // 3**k % 3
        kind = joint_kind("prismatic") if digit == 1 else joint_kind("revolute")
        elastic: dict[str, Any] = {"drive": drive_kind("elastic"), "motor": Motor(0.1), "gear": Gear((100.0,))}
        place = Placement(np.eye(3), np.array([0.1, 0.0, 0.0]))
        joint = Joint(f"j{k}", kind, place, **(elastic if digit == 2 else {}))
        nodes.append(Node(f"l{k}", k - 1, joint, RigidLink((Body(1.0, np.array([0.05, 0, 0]), 0.01 * np.eye(3)),))))
    return Chain("any", tuple(nodes), np.array([0.0, 0.0, -9.81]))


@pytest.mark.slow
def test_many_robots_in_one_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Code is freed with its robot: memory grows until as many libraries are kept as may be, and then no more.

    A hundred robots whose code stayed would take some 6 MB, ten thousand 600 MB.
    """
    monkeypatch.setenv("TMODES_CACHE", "")
    monkeypatch.setattr(kernels, "_KEPT", 32)
    count, first = often(150, 10_000), often(50, 1000)
    before = 0.0
    for number in range(count):
        if number == first:
            before = memory()
        model = Model(robot(number))
        assert np.isfinite(model.forward_dynamics(np.zeros(model.nq), np.zeros(model.nq))).all()
    assert len(kernels._loaded) <= 32
    assert memory() - before < often(3, 50)


def test_compiled_code_is_freed(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a library is made of goes with it: passes, object, linked code; each leaves less than 5 kB behind."""
    monkeypatch.setenv("TMODES_CACHE", "")
    monkeypatch.setattr(kernels, "_KEPT", 4)

    def compiled(number: int) -> None:
        schedule = Schedule(0, often=True)  # so that all of its code is in one library
        root = Kernel(f"root {number}", (1,), (1,), lambda x: [[sqrt(x[0]) + number]])
        schedule.output("out", *schedule.call(root, schedule.input("in", 1)))
        kernels.schedule_function("freed", schedule, "double")

    for number in range(100):
        compiled(number)
    before, more = memory(), often(300, 3000)
    for number in range(100, 100 + more):
        compiled(number)
    assert memory() - before < 0.5 + 0.005 * more
