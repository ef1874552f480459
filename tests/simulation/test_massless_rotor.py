"""A rotor whose motion is prescribed needs no inertia: the motion of the rest is the same whatever it has."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.errors import InputErrors
from tmodes.integrate.registry import integrators
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.vary.simulate import simulate_batch

MOVE = {"type": "quintic", "start": 0.0, "end": 0.6, "duration": 0.2}


def two_joints(inertia: float, seed: int = 0, command: str = "prescribed", **integration: Any) -> Robot:
    """An elastic joint with such a rotor, which carries another with one of its own, both with random gears."""
    dice = np.random.default_rng(seed)

    def joint(name: str, child: str, rotor: float) -> dict[str, Any]:
        gear = {
            "stiffness": [*dice.uniform(200.0, 900.0, 2)],
            "torque_limits": [1.0],
            "damping": dice.uniform(0.0, 0.5),
        }
        return {"name": name, "type": "revolute", "child": child, "axis": [*dice.normal(size=3)], "gear": gear,
                "origin": {"position": [*dice.uniform(-0.3, 0.3, 3)]},
                "motor": {"inertia": rotor, "side": "joint"}}  # fmt: skip

    def link(name: str) -> dict[str, Any]:
        body = {"name": "b", "mass": dice.uniform(0.5, 2.0), "center": [*dice.uniform(-0.2, 0.2, 3)], "inertia": 0.02}
        return {"name": name, "bodies": [body]}

    servo = {"type": "pd", "position_gain": 300.0, "velocity_gain": 20.0}
    first = {"joint": "a", "command": command, "signal": MOVE} | (
        {"controller": servo} if command == "position" else {}
    )
    return arm(joints=[joint("a", "la", inertia), joint("b", "lb", 0.2)], links=[link("la"), link("lb")],
               drives=[first, {"joint": "b", "command": "position", "signal": MOVE, "controller": servo}],
               integration={"duration": 0.3, "output_step": 0.01, "step": 1e-3, "relative_tolerance": 1e-9,
                            "absolute_tolerance": 1e-11} | integration)  # fmt: skip


@pytest.mark.parametrize("method", sorted(integrators()))
def test_the_motion_is_that_with_a_rotor_of_any_inertia(method: str) -> None:
    bare, heavy = (simulate_motion(two_joints(inertia, method=method)) for inertia in (0.0, 0.4))
    assert bare.status == heavy.status == "finished"
    assert np.abs(bare.q).max() > 0.3
    assert bare.q == pytest.approx(heavy.q, abs=1e-5)
    assert np.abs(bare.energy_balance).max() < 1e-4 * bare.energy_moved


@pytest.mark.parametrize("seed", range(1, 4))
def test_modes_and_batches_know_it(seed: int) -> None:
    robot, heavy = two_joints(0.0, seed), two_joints(0.4, seed)
    one, other = (vibrations(each).states for each in (robot, heavy))
    assert [mode["frequency_Hz"] for mode in one["locked"]] == pytest.approx(
        [mode["frequency_Hz"] for mode in other["locked"]]
    )
    assert len(one["free"]) == len(other["free"]) - 1
    batch = simulate_batch(robot, {"gravity": [9.81, 1.6]})
    single = simulate_motion(robot)
    assert batch.states[0, -1, :4] == pytest.approx(single.q[-1], abs=1e-5)


@pytest.mark.parametrize("command", ["position", "torque"])
def test_one_that_turns_by_itself_is_refused(command: str) -> None:
    with pytest.raises(InputErrors, match=r"joints\.a\.motor\.inertia.*turns by itself, got 0.*prescribed"):
        two_joints(0.0, command=command)
