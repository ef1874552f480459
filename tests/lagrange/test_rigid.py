"""Rigid gears and modes: in the Lagrangian systems, and in links of any number of modes against their own energies."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import tmodes
from lagrange.robot2010 import close
from lagrange.test_systems import double_pendulum
from oracle import any_modes
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.errors import InputError
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.modes import ModesLink
from tmodes.kinds.links.modes_sheet import Mode
from tmodes.model.model import Model
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.plan import Follow

GEAR, FIRST, SECOND = "gear.stiffness", "link.modes.0.bending_stiffness", "link.modes.1.bending_stiffness"
RIGID = [(GEAR,), (FIRST,), (SECOND,), (FIRST, SECOND), (GEAR, FIRST, SECOND)]


@pytest.mark.parametrize(("contact", "follow"), [(True, Follow.SHEET), (False, Follow.WANTED)])
@pytest.mark.parametrize("rigid", RIGID, ids=len)
def test_both_makers_take_rigid_elements(rigid: tuple[str, ...], contact: bool, follow: Follow) -> None:
    """The Lagrangian system and the recursion: the same coordinates, rates, works and forces at random states."""
    robot = tmodes.load("filipovic2010").with_(dict.fromkeys(rigid, math.inf) | {"contact": contact})
    setups = [run_setup(robot.with_({"reading": name}), follow) for name in ("consistent", "recursion")]
    assert setups[0].model.coordinates == setups[1].model.coordinates
    random, size = np.random.default_rng(11), len(setups[0].model.coordinates)
    for _ in range(5):
        state = np.zeros(len(setups[0].start))
        state[: 2 * size] = random.normal(scale=0.2, size=2 * size)
        row = setups[0].planned.schedule.rows_at(np.array([0.3]))[0]
        rates, seen = zip(*((s.model.rate(0.3, state, row)[0], s.model.observe(0.3, state, row)) for s in setups),
                          strict=True)  # fmt: skip
        close(rates[1], rates[0], 1e-10)
        for name in ("drives", "gear", "contact"):
            close(seen[1][name], seen[0][name], 1e-10)


@pytest.mark.parametrize("reading", ["printed", "consistent"])
def test_a_robot_without_elasticity_runs_by_every_reading(reading: str) -> None:
    """Nothing is left of the difference between the readings; the run ends where the recursion's does."""
    settings = {"contact": False, "integration.duration": 0.1, "integration.output_step": 0.02}
    robot = tmodes.load("filipovic2010").with_(dict.fromkeys(RIGID[-1], math.inf) | settings)
    ends = [tmodes.run(robot.with_({"reading": name})).motion["tip"].values[-1] for name in (reading, "recursion")]
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)


def test_a_rigid_gear_in_a_system_of_a_user() -> None:
    """The motor's inertia stands on the diagonal of the system's own, and its coordinate is the system's."""
    motor = {"side": "joint", "inertia": 0.4, "friction": {"viscous": 0.3}}
    drive = {"joint": "first", "command": "torque", "signal": {"type": "constant", "value": 2.0}}
    joints = {"first": {"motor": motor, "gear": {"stiffness": math.inf, "damping": 0.0}}}
    plain = tmodes.Model(double_pendulum("plain").robot().chain())
    model = tmodes.Model(double_pendulum("geared").robot(joints=joints, drives=[drive]).chain())
    assert model.coordinates == plain.coordinates == ("first", "second")
    q, v = np.array([0.4, -1.1]), np.array([1.3, 0.7])
    close(model.mass_matrix(q), plain.mass_matrix(q) + np.diag([0.4, 0.0]), 1e-14)
    forces = np.array([2.0 - 0.3 * v[0], 0.0]) - plain.bias(q, v) - plain.elastic_forces(q, v)
    close(model.forward_dynamics(q, v, [2.0]), np.linalg.solve(model.mass_matrix(q), forces), 1e-12)


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"gravity": [1.0, 0.0, -9.0]}, "gravity"),
        ({"joints.joint.axis": [0.0, 1.0, 0.0]}, "joints"),
        ({"joints.joint.origin": {"position": [0.1, 0.0, 0.0]}}, "joints"),
        ({"tip": {"link": "link", "position": [0.0, 0.0, 0.1]}}, "tip"),
    ],
)
@pytest.mark.parametrize("rigid", [{}, dict.fromkeys((FIRST, SECOND), math.inf)], ids=["bends", "rigid"])
def test_what_the_energies_do_not_know_of_is_refused(changes: dict[str, Any], place: str, rigid: Any) -> None:
    """The recursion takes it."""
    robot = tmodes.load("filipovic2010").with_(changes | rigid)
    with pytest.raises(InputError, match=f"^{place}.*recursion"):
        _ = tmodes.Model(robot.chain()).coordinates
    assert tmodes.Model(robot.with_({"equations": "recursion"}).chain()).coordinates


@pytest.mark.parametrize("free", [(True,), (True, True, True), (True, False, True), (False, True, True)], ids=str)
def test_any_number_of_modes_against_their_energies(free: tuple[bool, ...]) -> None:
    """The recursion of a link with n modes, some of them rigid: H, h, forces of springs and dampers."""
    random, n = np.random.default_rng(len(free)), len(free)
    modes = tuple(
        Mode(
            length=float(random.uniform(0.2, 0.6)),
            bending_stiffness=float(random.uniform(20.0, 900.0)) if bends else math.inf,
            mass_per_length=float(random.uniform(0.3, 3.0)),
            damping_time=float(random.uniform(1e-4, 1e-3)),
        )
        for bends in free
    )
    payload = Body(0.7, np.zeros(3), 2e-3 * np.eye(3))
    joint = Joint("joint", joint_kind("revolute"))
    nodes = (Node("link", -1, joint, ModesLink(modes, ((1.0, payload),))),)
    model = Model(Chain(f"modes {free}", nodes, np.array([0.0, 0.0, -9.81])))
    bends = np.array(free)
    p = {
        "free": bends, "g": 9.81, "l": np.array([mode.length for mode in modes]),
        "m": np.array([mode.tip_mass for mode in modes]) + 0.7 * np.eye(n)[-1],
        "J": np.array([mode.tip_inertia for mode in modes]) + 2e-3 * np.eye(n)[-1],
        "c": np.array([mode.tip_stiffness * mode.length**2 if free[k] else 0.0 for k, mode in enumerate(modes)]),
        "b": np.array([mode.tip_damping * mode.length**2 if free[k] else 0.0 for k, mode in enumerate(modes)]),
    }  # fmt: skip
    for size in (0.05, 0.5):
        q, v = size * random.normal(size=model.nq), random.normal(size=model.nq)
        expected = any_modes.rows(q, v, p)
        close(model.mass_matrix(q), expected["H"], 1e-12)
        close(model.bias(q, v), expected["h"], 1e-12)
        close(model.elastic_forces(q, np.zeros(model.nq)), expected["f_el"], 1e-12)
        close(model.elastic_forces(q, v), expected["f_el"] + expected["f_di"], 1e-12)
        right = np.eye(model.nq)[0] * 3.0 - expected["h"] - expected["f_el"] - expected["f_di"]
        bound = max(1e-12, 1e-14 * float(np.linalg.cond(expected["H"])))
        close(model.forward_dynamics(q, v, [3.0]), np.linalg.solve(expected["H"], right), bound)
