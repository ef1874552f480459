"""Laws that are designed from the robot: once for all robots that are known alike, again for all others."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.kinds.controllers.lqg import LQG
from tmodes.simulation.control import designs

LAW = {
    "type": "lqg", "sample_time": 0.01, "measured": ["encoder"], "measurement_noise": [1e-6],
    "process_noise": {"joint'": 1e-3, "joint.motor'": 1e-3}, "state_weights": {"joint": 100.0, "joint'": 1.0},
}  # fmt: skip


def under_lqg(**changes: Any) -> tmodes.Robot:
    control = [{"name": "law", "drives": ["joint"], "delay": 0.004, "block": LAW | changes}]
    own = {"drives.0.controller": None, "control": control, "integration.duration": 0.2}
    return tmodes.load("spong1987").with_(own | {"sensors": [{"name": "encoder", "type": "encoder", "joint": "joint"}]})


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[LQG]:
    """The laws that were designed."""
    found: list[LQG] = []
    design = LQG.designed

    def designed(self: LQG, *arguments: Any) -> LQG:
        found.append(self)
        return design(self, *arguments)

    monkeypatch.setattr(LQG, "designed", designed)
    return found


def test_actual_robots_share_the_design_of_the_one_that_is_known(made: list[LQG]) -> None:
    robot = under_lqg(load_noise=1.1e-4)
    factors = [0.8, 0.9, 1.0, 1.1]
    together = tmodes.simulate_batch(robot, {"real.joints.joint.gear.stiffness": factors})
    assert len(made) == 1
    alone = robot.with_({"real": {"joints.joint.gear.stiffness": 0.8}}).run(error_estimate=False, model_error=False)
    assert len(made) == 1
    robot.with_({"drives.0.signal": {"type": "constant", "value": 0.1}}).run(error_estimate=False, model_error=False)
    assert len(made) == 2
    angles = together.states[0][:, together.coordinates.index("joint")]
    assert np.allclose(angles, alone.output("joint.position"), rtol=1e-6, atol=1e-9)


def test_numbers_of_the_known_robot_make_another_design() -> None:
    robot = under_lqg()
    soft = robot.with_({"joints.joint.gear.stiffness": 50.0})
    weighted = under_lqg(state_weights={"joint": 50.0})
    numbers = [designs(one)["law"].numbers() for one in (robot, soft, weighted, under_lqg())]
    assert numbers[0] == numbers[3]
    assert len({*numbers}) == 3


def test_equations_of_the_same_name_make_another_design() -> None:
    def of(mass: float) -> tuple[float, ...]:
        system = tmodes.System("pushed cart", {"x": "m"}, {}, lambda q, v, p: mass * v.x**2 / 2)
        block = {"type": "lqr", "state_weights": {"x": 1.0, "x'": 1.0}}
        drive = {"joint": "x", "command": "position", "signal": {"type": "constant", "value": 0.0}}
        robot = system.robot(drives=[drive], control=[{"name": "law", "drives": ["x"], "block": block}],
                             integration={"duration": 0.1, "output_step": 0.01})  # fmt: skip
        return designs(robot)["law"].numbers()

    assert of(1.0) != of(2.0)


def test_a_law_that_changes_what_it_is_given_changes_no_other() -> None:
    from tmodes.simulation.design import linear_plant

    robot = under_lqg()
    first = linear_plant(robot, ("encoder",), ("joint",))
    kept = first.A.copy()
    first.A[:] = 0.0
    assert (kept == linear_plant(robot, ("encoder",), ("joint",)).A).all()


def test_cases_with_the_same_weights_are_arrays(made: list[LQG]) -> None:
    """One design for all, and one note of how their numbers follow."""
    robot = under_lqg(load_noise=1e-4).with_({"integration.method": "rk4", "integration.step": 1e-3})
    softer = np.linspace(0.7, 1.2, 40)
    vary = {"control.law.block.load_noise": np.full(40, 2.3e-4), "real.joints.joint.gear.stiffness": softer}
    batch = tmodes.simulate_batch(robot, vary)
    assert set(batch.status) == {"finished"}
    assert len(made) <= 3
