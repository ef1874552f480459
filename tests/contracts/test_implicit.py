"""What implicit steps take of each kind is the exact derivative of the rates, for random numbers of every member.

With h D + h^2 K of controllers, contacts, gears and friction added to the masses M, a force F moves a slide, whose mass
does not change, by (M + h D + h^2 K) da/dF = 1; exact derivatives of the rates by the state are -D/M and -K/M.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from contracts import test_controllers as of_a_user
from contracts.test_contacts import LAWS
from simulation.sheets import ZERO, arm
from tmodes.kinds.contacts.registry import CONTACTS, SURFACES
from tmodes.kinds.controllers.registry import CONTROLLERS
from tmodes.model.passes import evaluate
from tmodes.simulation.initial_state import RunSetup, run_setup

Array = NDArray[np.float64]
FRICTION = {"viscous": 0.3, "coulomb": 0.8, "smoothing": 0.02, "static_extra": 0.5, "stribeck_rate": 0.1}
MEMBERS: dict[str, dict[str, Any]] = {
    "pd": {"position_gain": 80.0, "velocity_gain": 9.0},
    "pid": {"position_gain": 80.0, "integral_gain": 50.0, "velocity_gain": 9.0, "limit": 500.0},
    "sampled_pid": {"position_gain": 80.0, "integral_gain": 50.0, "velocity_gain": 9.0, "sample_time": 0.004},
    "state_feedback": {"position_gains": {"s.motor": 80.0}, "velocity_gains": {"s.motor": 9.0}},
    "own_lqr": {"row": [7.0, 0.0, 3.0, 0.0, 2.0]},
}
"""Numbers of one of each controller, that of a user among them; one without an entry fails."""

assert of_a_user.LQR

MET = {"plane": 0.0, "wall": 0.4, "ball": 0.0}
"""How far along its direction the slide meets each surface [m]."""

SHAPES = {
    "plane": lambda d: {"position": [0.0, 0.0, 0.0], "normal": list(d)},
    "wall": lambda d: {"distance": MET["wall"], "heading": float(np.arctan2(d[1], d[0]))},
    "ball": lambda d: {"center": list(-0.4 * np.array(d)), "radius": 0.4},
}
"""Of each surface one that a slide along a direction meets head on."""


def slide(direction: Any, force: float, mass: float = 1.5, **more: Any) -> RunSetup:
    """A mass on a slide along a direction, and a force on it."""
    joint = {"name": "s", "type": "prismatic", "child": "l", "axis": list(direction), **more.pop("joint", {})}
    push = {"point": "tip", "force": [force * float(each) for each in direction], "frame": "world"}
    body = {"name": "b", "mass": mass, "center": [0, 0, 0]}
    drive = {"joint": "s", "command": "effort", "signal": ZERO} | more.pop("drive", {})
    return run_setup(arm(gravity=0.0, joints=[joint], links=[{"name": "l", "bodies": [body]}], loads=[push],
                         drives=[drive], initial={"state": "zero"}, **more))  # fmt: skip


def accelerations(setup: RunSetup, rate: str, state: Array, step: float) -> Array:
    """Of the coordinates, as a step of an implicit method has them from a state on."""
    size = len(setup.model.coordinates)
    instant = {"time": [[0.01]], "state": [state], "start": [state[: 2 * size]], "step": [[step]]}
    blocks = {name: np.array(value) for name, value in instant.items()}
    blocks["row"] = setup.planned.schedule.rows_at([0.01])
    found = evaluate(setup.model.numbers, getattr(setup.model.loop, rate), blocks, 1)["rate"][0]
    return found[size : 2 * size]


def assert_exact(build: Any, rate: str, place: float, speed: float) -> None:
    """The share of every force in a step is the one by exact derivatives; some derivative is there."""
    free, pushed = build(0.0), build(1.0)
    size = len(free.model.coordinates)
    state = free.start.copy()
    state[:size], state[size : 2 * size] = place, speed
    exact = free.model.jacobian(0.01, state, free.planned.schedule.rows_at([0.01])[0])[size : 2 * size]
    by_place, by_speed = exact[:, :size], exact[:, size : 2 * size]
    shares = {
        step: accelerations(pushed, rate, state, step) - accelerations(free, rate, state, step)
        for step in (0.0, 1e-3, 0.05, 0.4)
    }
    for step, share in shares.items():
        taken = (np.eye(size) - step * by_speed - step**2 * by_place) @ share
        assert np.abs(taken - shares[0.0]).max() < 1e-9 * np.abs(shares[0.0]).max()


unit = st.floats(-1.0, 1.0).filter(lambda x: abs(x) > 0.05)
directions = st.tuples(unit, unit, unit).map(lambda d: tuple(float(x) for x in np.array(d) / np.linalg.norm(d)))
scales = st.floats(0.1, 10.0)


def scaled(value: Any, by: float) -> Any:
    if isinstance(value, dict):
        return {key: scaled(item, by) for key, item in value.items()}
    if isinstance(value, list):
        return [scaled(item, by) for item in value]
    return value * by if isinstance(value, float) else value


KINDS = [(name, "euler_rate", False) for name in sorted({*CONTROLLERS} - of_a_user.AT_THE_ROBOT)]
KINDS += [("pd", "implicit_rate", False), ("pd", "euler_rate", True)]


@pytest.mark.parametrize(("name", "rate", "electric"), KINDS)
@settings(max_examples=5, phases=[Phase.generate])
@given(by=scales, place=unit, speed=unit, mass=scales)
def test_controllers(name: str, rate: str, electric: bool, by: float, place: float, speed: float, mass: float) -> None:
    motor = {"inertia": 0.7, "side": "joint", "friction": scaled(FRICTION, by)}
    winding = {"resistance": 0.4, "torque_constant": 3.0, "back_emf_constant": 3.0} if electric else {}
    law = {"type": name, **scaled(MEMBERS[name], by)}
    drive = {"command": "position", "signal": {"type": "constant", "value": 0.1}, "controller": law}

    def build(force: float) -> RunSetup:
        joint = {"motor": motor | winding, "gear": {"stiffness": 300.0 * by, "damping": 0.5 * by}}
        return slide((0.0, 0.0, 1.0), force, mass, joint=joint, drive=drive)

    assert_exact(build, rate, place, speed)


@pytest.mark.parametrize(
    ("law", "shape"), [*((law, "plane") for law in sorted(CONTACTS)), *(("bilateral", one) for one in sorted(SURFACES))]
)
@settings(max_examples=5, phases=[Phase.generate])
@given(direction=directions, by=scales, depth=st.floats(1e-3, 0.1), speed=unit)
def test_contacts(law: str, shape: str, direction: Any, by: float, depth: float, speed: float) -> None:
    if shape == "wall":
        direction = (direction[0] / np.hypot(*direction[:2]), direction[1] / np.hypot(*direction[:2]), 0.0)
    contact = {"law": law, "shape": {"type": shape, **SHAPES[shape](direction)}, **scaled(LAWS[law], by)}
    if "friction_law" in contact:  # the paper's is along the normal too, and not taken implicitly
        contact["friction"] = 0.0

    def build(force: float) -> RunSetup:
        return slide(direction, force, contact=contact)

    for away in (-depth, depth):
        assert_exact(build, "euler_rate", MET[shape] + away, 0.1 * speed)
