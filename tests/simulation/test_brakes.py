"""Brakes: dry friction whose level is scheduled, against closed forms."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from simulation.sheets import arm
from tmodes.errors import InputErrors
from tmodes.simulation.simulate import simulate_motion

INERTIA, TORQUE = 2.0, 8.0
MOVING = {"state": "zero", "rates": {"hub": 3.0}}


def rotor(
    brake: dict[str, Any], *, effort: float = 0.0, initial: Any = None, method: str = "auto", **joint: Any
) -> Any:
    """A disc about a vertical axis; ``effort`` [N*m] on its motor, or on itself."""
    signal = {"type": "constant", "value": effort}
    command = "torque" if "motor" in joint else "effort"
    inertia = {"xx": 1.0, "yy": 1.0, "zz": INERTIA}
    return arm(
        gravity=0.0,
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "disc", "axis": [0, 0, 1], **joint}],
        links=[{"name": "disc", "bodies": [{"name": "disc", "mass": 1.0, "center": [0, 0, 0], "inertia": inertia}]}],
        tip={"link": "disc", "position": [0.1, 0, 0]},
        drives=[{"joint": "hub", "command": command, "signal": signal, "brake": {"type": "brake", **brake}}],
        loads=[{"point": "tip", "moment": [0, 0, 3.0 if "motor" in joint else 0.0], "frame": "world"}],
        initial=initial or {"state": "zero"},
        integration={"duration": 2.0, "output_step": 0.01, "method": method},
    )  # fmt: skip


@pytest.mark.parametrize("method", ["auto", "rosenbrock", "rk4", "extrapolation"])
def test_a_rotor_stops_after_its_momentum_over_the_torque(method: str) -> None:
    """From 3 rad/s by 8 N m on 2 kg m^2: within J w/T = 0.75 s of the end of the delay; its energy is heat."""
    data = simulate_motion(
        rotor({"torque": TORQUE, "engage_at": 0.3, "engage_delay": 0.1}, initial=MOVING, method=method)
    )
    t = data.times
    slowed = np.clip(t - 0.4, 0.0, INERTIA * 3.0 / TORQUE)
    assert data.q[:, 0] == pytest.approx(3.0 * np.minimum(t, 0.4) + 3.0 * slowed - 2.0 * slowed**2, abs=1e-9)
    assert not data.v[t > 1.2].any()
    assert data.works["friction"][-1] == pytest.approx(INERTIA * 9.0 / 2, rel=1e-9)


@pytest.mark.parametrize("method", ["auto", "extrapolation"])
def test_a_brake_that_stops_at_once_is_no_divergence(method: str) -> None:
    """1e9 N m: within 6 ns, of which the step that comes next would go to -2e8 rad/s without an estimated error."""
    data = simulate_motion(rotor({"torque": 1e9, "engage_at": 0.3, "engage_delay": 0.1001}, initial=MOVING,
                                 method=method))  # fmt: skip
    assert data.status == "finished"
    assert data.q[-1, 0] == pytest.approx(3.0 * 0.4001, abs=1e-7)
    assert not data.v[-1].any()
    assert data.works["friction"][-1] == pytest.approx(INERTIA * 9.0 / 2, rel=1e-3)


def test_it_holds_what_is_below_its_torque_and_slips_above() -> None:
    """A load of 5 N m: held by 8 N m until the release has its delay, driven through 4 N m from the start."""
    held = simulate_motion(rotor({"torque": TORQUE, "engaged_until": 0.7, "release_delay": 0.1}, effort=5.0))
    assert held.q[:, 0] == pytest.approx(5.0 / INERTIA / 2 * np.clip(held.times - 0.8, 0.0, None) ** 2, abs=1e-9)
    slips = simulate_motion(rotor({"torque": 4.0}, effort=5.0))
    assert slips.q[:, 0] == pytest.approx(0.25 * slips.times**2, abs=1e-9)


def test_released_under_load_the_gear_rings() -> None:
    """Behind a gear the brake holds the motor; released, twist and motor swing as two masses on a spring."""
    motor, stiffness, load = 0.5, 200.0, 3.0
    joint: dict[str, Any] = {
        "motor": {"inertia": motor, "side": "joint"}, "gear": {"stiffness": stiffness, "damping": 0.0}
    }  # fmt: skip
    start = {"state": "zero", "coordinates": {"hub": load / stiffness, "hub.motor": 0.0}}
    data = simulate_motion(rotor({"torque": 4.0, "engaged_until": 0.5}, initial=start, **joint))
    free = np.clip(data.times - 0.5, 0.0, None)
    mean, rate = load * motor / stiffness / (motor + INERTIA), np.sqrt(stiffness * (1 / motor + 1 / INERTIA))
    twist = mean + (load / stiffness - mean) * np.cos(rate * free)
    centre = (motor * data.q[:, 0] + INERTIA * data.q[:, 1]) / (motor + INERTIA)
    assert data.q[:, 1] - data.q[:, 0] == pytest.approx(twist, abs=1e-8)
    assert centre - centre[0] == pytest.approx(load / (motor + INERTIA) / 2 * free**2, abs=1e-8)


def test_a_brake_has_its_conditions() -> None:
    """No brake of a given motion; it engages after it is released."""
    with pytest.raises(InputErrors, match=r"engage_at"):
        rotor({"torque": 4.0, "engaged_until": 0.5, "engage_at": 0.4})
    with pytest.raises(InputErrors, match=r"brake"):
        rotor({"torque": 4.0}).with_({"drives.0.command": "prescribed"})


def test_smoothed_it_has_derivatives_and_batches_have_the_brake() -> None:
    """By the smoothing of the friction that it is part of; the tip's way by the torque, against central differences."""
    robot = rotor({"torque": TORQUE, "engage_at": 0.3}, initial=MOVING, friction={"viscous": 0.0, "smoothing": 0.05})
    path = "drives.0.brake.torque"
    error = tmodes.tracking_error("tip", [0.1, 0.0, 0.0])
    slope = tmodes.gradient(robot, error, [path, "drives.0.brake.engage_at"]).by
    for name, value in ((path, TORQUE), ("drives.0.brake.engage_at", 0.3)):
        sides = (tmodes.gradient(robot.with_({name: value + step}), error, [path]).value for step in (1e-4, -1e-4))
        high, low = sides
        assert slope[name] == pytest.approx((high - low) / 2e-4, rel=1e-4)
    for one in (robot, rotor({"torque": TORQUE, "engage_at": 0.3}, initial=MOVING)):
        tips = tmodes.batch(one, vary={path: (4.0, TORQUE, 2)}).data["tip_difference_at_end_m"].values
        apart = [tmodes.run(one.with_({path: torque})).data["tip"].values[-1] for torque in (4.0, TORQUE)]
        assert tips == pytest.approx([np.linalg.norm(apart[0] - apart[1]), 0.0], abs=1e-8)
