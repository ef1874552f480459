"""Loops opened at the command of a drive: against plant times law, closed again, and by what a larger delay does."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.errors import InputError, SimulationError
from tmodes.kinds.controllers.discrete import zero_order_hold
from tmodes.simulation.drive_loops import drive_loops, loop_warnings, sampled_loops, sampled_margins
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.linear import closed_loop

PERIOD, KP, KV = 5e-3, 40.0, 3.0
SPONG = tmodes.load("spong1987").with_({"gravity": 0.0})
AT = np.array([0.3, 1.1, 4.0, 17.0])


def under(controller: dict[str, Any], **more: Any) -> tmodes.Robot:
    return SPONG.with_({"drives.0.controller": controller} | {f"drives.0.{key}": value for key, value in more.items()})


def plant(period: float | None = None, delay: float = 0.0) -> Any:
    outputs = "joint.motor.position,joint.motor.velocity"
    found = SPONG.linearize(inputs="joint.torque", outputs=outputs, period=period, delay=delay)
    return found.frequency_response(AT).values[:, :, 0] @ [KP, KV]


@pytest.mark.parametrize("delay", [None, 0.0, 2e-3, 12.5e-3])
def test_is_the_plant_times_its_law(delay: float | None) -> None:
    law = {"type": "pd", "position_gain": KP, "velocity_gain": KV}
    if delay is None:
        loop, wanted = under(law), plant()
    else:
        loop, wanted = under(law, sample_time=PERIOD, delay=delay), plant(PERIOD, delay)
    found = loop.linearize(loop="joint").frequency_response(AT).values[:, 0, 0]
    assert found == pytest.approx(wanted, rel=1e-8)


def closed_again(robot: tmodes.Robot) -> int:
    own = np.linalg.eigvals(closed_loop(robot, (), ()).A)
    loops = drive_loops(robot)
    for one in loops.values():
        poles = np.linalg.eigvals(one.A - one.B @ one.C / (1 + one.D[0, 0]))
        apart = np.abs(np.sort_complex(poles)[:, None] - np.sort_complex(own)[None]).min(axis=0)
        assert (apart < 1e-6 * np.maximum(np.abs(own), 1.0)).all()
    return len(loops)


@pytest.mark.parametrize("name", ["two_link_arm", "moberg2009", "filipovic2010"])
def test_closed_again_has_the_poles_under_control(name: str) -> None:
    robot = tmodes.load(name)
    assert closed_again(robot) == len([one for one in robot.drives if one.command.is_controlled])


LQG = {
    "type": "lqg", "sample_time": PERIOD, "measured": ["joint.motor.position"], "measurement_noise": [1e-6],
    "process_noise": {"joint'": 1e-3, "joint.motor'": 1e-3}, "state_weights": {"joint": 1e4, "joint.motor'": 1.0},
}  # fmt: skip


PID = {"type": "sampled_pid", "sample_time": PERIOD, "position_gain": 40.0, "velocity_gain": 3.0, "integral_gain": 5.0,
       "filter_time": 0.01}  # fmt: skip
SOFT = {"type": "low_pass", "input": "law", "frequency": 30.0}


@pytest.mark.parametrize("control", [
    [{"name": "law", "drives": ["joint"], "delay": 3e-3, "block": LQG}],
    [{"name": "law", "of": "joint", "delay": 3e-3, "block": PID}, {"name": "soft", "drives": ["joint"], "block": SOFT}],
    [{"name": "law", "of": "joint", "block": PID},
     {"name": "soft", "drives": ["joint"], "block": SOFT | {"sample_time": PERIOD}}],
])  # fmt: skip
def test_of_blocks_behind_which_a_filter_stands(control: list[dict[str, Any]]) -> None:
    assert closed_again(SPONG.with_({"drives.0.controller": None, "control": control})) == 1


def test_a_delay_of_its_margin_is_the_most_that_it_bears() -> None:
    robot = tmodes.load("moberg2009")
    margin = robot.linearize(loop="motor").margins().delay
    for share, stable in ((0.97, True), (1.03, False)):
        late = robot.with_({"drives.motor.delay": 5e-4 + share * margin})
        assert late.linearize(closed=True).is_stable == stable


def test_check_and_runs_name_a_loop_that_bears_little() -> None:
    late = tmodes.load("moberg2009").with_({"drives.motor.delay": 6e-3, "integration.duration": 0.02})
    found = late.check()
    assert 0.05 < found.loops["motor"].disk < 0.2
    assert [text for text in found.warnings if "disk margin" in text]
    assert [text for text in late.run().warnings if "disk margin" in text]
    wild = late.with_({"drives.motor.controller.velocity_gain": 80.0}).check()
    assert not wild.loops["motor"].stable
    assert [text for text in wild.warnings if "unstable under its sampled controllers" in text]
    assert not tmodes.load("moberg2009").check().warnings


def test_a_drive_without_a_loop_is_refused() -> None:
    with pytest.raises(InputError) as caught:
        SPONG.linearize(loop="elbow")
    assert caught.value.which == "loop"
    assert "joint" in caught.value.expected


def test_a_queue_of_hundreds_of_commands_is_left_to_linear() -> None:
    """Its eigenvalues would take minutes: the run says that it did not look at them."""
    late = under({"type": "pd", "position_gain": KP, "velocity_gain": KV}, sample_time=1e-3, delay=0.4)
    closed = sampled_loops(run_setup(late))
    assert closed is not None
    assert len(closed.A) > 400
    assert not sampled_margins(closed)
    (said,) = loop_warnings(closed)
    assert f"{len(closed.A)} states" in said
    with pytest.raises(SimulationError):
        late.modes()


def test_a_run_needs_no_common_period() -> None:
    """Samples every 1.41421 and 3.14159 ms: it has no modes under control, and says so."""
    law = {"type": "pd", "position_gain": KP, "velocity_gain": KV}
    idle = [{"name": "teeth", "type": "encoder", "joint": "joint", "sample_time": 3.14159e-3}]
    robot = under(law, sample_time=1.41421e-3).with_({"sensors": idle, "integration.duration": 0.02})
    run = robot.run()
    assert run.status == "finished"
    assert not run.frequencies
    assert len([text for text in run.warnings if "common period" in text]) == 2
    assert [text for text in robot.check().warnings if "common period" in text]
    with pytest.raises(SimulationError):
        robot.linearize(closed=True)


def test_what_waits_takes_no_part_in_a_hold() -> None:
    A = np.array([[-1.0, 0.0, 2.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    Ad, Bd = zero_order_hold(A, np.zeros((3, 1)), 0.5)
    e = np.exp(-0.5)
    assert Ad == pytest.approx(np.array([[e, 0.0, 2 * (1 - e)], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), abs=1e-15)
    assert not Bd.any()
