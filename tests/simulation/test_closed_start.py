"""A run at constant setpoints stands still from its first instant on: it starts in the closed loop's equilibrium."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

from simulation.sheets import ZERO, arm
from tmodes import load, simulate_batch
from tmodes.gradients.changes import changes_of
from tmodes.gradients.lowering import lowered
from tmodes.robots import names
from tmodes.simulation.departure import departure
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.plan import Follow
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.vary import arrays
from tmodes.simulation.warnings import departures

ROBOTS = int(os.environ.get("TMODES_STANDING", "4"))
"""How many random robots are asked to stand still."""

STILL = 1e-9


def controller(rng: np.random.Generator, name: str, scale: float, motor: str) -> dict[str, Any]:
    """Any controller whose gains keep a joint of inertia of about 1; ``scale``: command per effort."""
    gains = {"position_gain": scale * rng.uniform(300, 900), "velocity_gain": scale * rng.uniform(30, 60)}
    kind = rng.choice(["pd", "pid", "sampled_pid", "sampled_pd", "state_feedback"])
    if kind == "state_feedback":
        position, velocity = gains.values()
        return {"type": kind, "position_gains": {motor: position}, "velocity_gains": {motor: velocity, name: 0.0},
                "feedforward": float(scale * rng.normal())}  # fmt: skip
    integral = {"integral_gain": scale * rng.uniform(20, 200)}
    if kind == "sampled_pd":
        return {"type": "sampled_pid", "sample_time": 1e-3, **gains}
    return {"type": kind, **gains, **(integral if kind != "pd" else {}),
            **({"sample_time": 1e-3} if kind == "sampled_pid" else {})}  # fmt: skip


def joint_of(rng: np.random.Generator, k: int) -> tuple[dict[str, Any], dict[str, Any]]:
    """A joint with its motor, gear and friction, and its drive at a constant setpoint."""
    name, motor = f"j{k}", {"inertia": float(rng.uniform(0.05, 0.3)), "side": "joint"}
    scale = 1.0
    if rng.random() < 0.5:
        motor |= {"resistance": 0.5, "back_emf_constant": 1.5, "torque_constant": 1.5}
        scale = 1 / 3.0
        if rng.random() < 0.5:
            motor["inductance"] = 5e-4
    if rng.random() < 0.4:
        motor["friction"] = {"viscous": 0.1, "coulomb": float(rng.uniform(0.1, 1.0)), "static_extra": 0.1}
    axis = rng.normal(size=3)
    joint: dict[str, Any] = {
        "name": name, "type": "prismatic" if rng.random() < 0.2 else "revolute", "child": f"l{k}",
        "axis": (axis / np.linalg.norm(axis)).tolist(), "motor": motor,
        "origin": {"position": rng.uniform(-0.2, 0.2, 3).tolist()},
    }  # fmt: skip
    elastic = rng.random() < 0.7
    if elastic:
        joint["gear"] = {"stiffness": float(rng.uniform(500, 3000)), "damping": 2.0}
        if rng.random() < 0.3:
            joint["gear"] |= {"backlash": 0.002}
    if rng.random() < 0.3:
        joint["friction"] = {"viscous": 0.5, "coulomb": float(rng.uniform(0.1, 1.0))}
    drive = {"joint": name, "command": "position", "signal": {"type": "constant", "value": float(rng.uniform(-1, 1))},
             "controller": controller(rng, name, scale, f"{name}.motor" if elastic else name)}  # fmt: skip
    return joint, drive


def random_robot(seed: int) -> Any:
    """One to three joints under any control, rigid and bending links, in half of them with a contact."""
    rng = np.random.default_rng(seed)
    joints, links, drives = [], [], []
    for k in range(rng.integers(1, 4)):
        joint, drive = joint_of(rng, k)
        joints.append(joint)
        drives.append(drive)
        link: dict[str, Any] = {"name": f"l{k}", "bodies": [{"name": "body", "mass": float(rng.uniform(0.2, 1.0)),
                                "center": rng.uniform(-0.2, 0.2, 3).tolist(), "inertia": 0.02}]}  # fmt: skip
        if rng.random() < 0.5:
            link["bodies"][0] |= {"at": 1.0}
            section = {"shape": "box", "width": 0.02, "height": 0.01}
            link["beam"] = {"model": "strain", "functions": 2, "length": 0.4, "material": "steel",
                            "section": section, "damping_time": 1e-3}  # fmt: skip
        links.append(link)
    more: dict[str, Any] = {}
    if rng.random() < 0.5:
        normal = rng.normal(size=3)
        more["contact"] = {
            "law": str(rng.choice(["bilateral", "unilateral"])), "stiffness": 500.0, "damping": 20.0, "friction": 0.2,
            "shape": {"type": "plane", "normal": (normal / np.linalg.norm(normal)).tolist(), "position": [0, 0, 0]},
        }  # fmt: skip
    return arm(joints=joints, links=links, drives=drives, integration={"duration": 0.2, "output_step": 0.02}, **more)


@pytest.mark.nightly("2")
@pytest.mark.parametrize("seed", range(ROBOTS))
def test_a_random_robot_stands_still(seed: int) -> None:
    run = simulate_motion(random_robot(seed))
    assert run.status == "finished"
    assert np.abs(run.q - run.q[0]).max() < STILL * (1 + np.abs(run.q).max())
    assert not any("energy" in warning for warning in run.warnings)
    assert departure(run.setup, run.setup.first_row) is None


@pytest.mark.parametrize("name", [name for name in names() if name not in ("panda_elastic", "ur5_elastic")])
def test_a_published_robot_stands_still(name: str) -> None:
    robot = load(name)
    until = robot.integration.duration
    held = {f"drives.{k}.signal": {"type": "constant", "value": float(drive.signal.schedule(until).at(0.0))}
            for k, drive in enumerate(robot.drives)}  # fmt: skip
    run = simulate_motion(robot.with_({**held, "integration.duration": 0.1, "integration.output_step": 0.01}))
    assert np.abs(run.q - run.q[0]).max() < STILL * (1 + np.abs(run.q).max())
    moving = run_setup(robot)
    assert departure(moving, moving.first_row) is None


LEVER, LOAD = 0.5, 0.5 * 9.81 * 2.0
PD = {"type": "pd", "position_gain": 400.0, "velocity_gain": 30.0}


def lever(control: dict[str, Any] | None = PD, gear: bool = True, motor: Any = None, **more: Any) -> Any:
    """A lever of 0.5 m with 2 kg at its end, level: 9.81 N*m on its joint."""
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, -1, 0],
             "motor": {"inertia": 0.1, "side": "joint", **(motor or {})},
             **({"gear": {"stiffness": 2000.0, "damping": 1.0}} if gear else {})}  # fmt: skip
    drive = {"joint": "j", "command": "position", "signal": ZERO, "controller": control} if control else {
        "joint": "j", "command": "torque", "signal": ZERO}  # fmt: skip
    return arm(joints=[joint], links=[{"name": "l", "bodies": [{"name": "m", "mass": 2.0, "center": [LEVER, 0, 0]}]}],
               tip={"link": "l", "position": [LEVER, 0, 0]}, drives=[drive],
               **({"integration": {"duration": 0.1, "output_step": 0.01}} | more))  # fmt: skip


def load_on(setup: Any) -> float:
    """What the weight asks of the joint [N*m]."""
    q = dict(zip(setup.model.coordinates, setup.start, strict=False))
    return LOAD * float(np.cos(q["j"]))


@pytest.mark.parametrize("kind", ["pid", "sampled_pid"])
@pytest.mark.parametrize("gear", [True, False])
def test_an_integral_carries_the_load_with_the_motor_on_its_setpoint(kind: str, gear: bool) -> None:
    law = PD | {"type": kind, "integral_gain": 50.0} | ({"sample_time": 0.002} if kind == "sampled_pid" else {})
    setup = run_setup(lever(law, gear))
    layout = setup.model.layout
    *command, integral = setup.start[layout.controls]
    assert setup.start[0] == pytest.approx(0.0, abs=1e-14)
    assert 50 * integral == pytest.approx(load_on(setup), rel=1e-12)
    assert command == pytest.approx([50 * integral] * len(command), rel=1e-12)


def test_currents_stand_at_what_the_torque_takes() -> None:
    """Voltage R i and torque CM i, of a state with an inductance: u = R i = Kp (0 - th)."""
    electric = {"resistance": 0.8, "inductance": 1e-3, "back_emf_constant": 2.0, "torque_constant": 2.0}
    setup = run_setup(lever(PD, motor=electric))
    (current,) = setup.start[setup.model.layout.currents]
    assert 2.0 * current == pytest.approx(load_on(setup), rel=1e-12)
    assert 400.0 * -setup.start[0] == pytest.approx(0.8 * current, rel=1e-12)


def test_a_state_that_influences_nothing_may_drift() -> None:
    """An integral without a gain: the motor stands where a PD lets it stand."""
    law = PD | {"type": "pid", "integral_gain": 0.0}
    assert np.allclose(run_setup(lever(law)).start[:2], run_setup(lever(PD)).start[:2], atol=1e-14, rtol=0)
    assert run_setup(lever(law)).off is None


def test_a_start_with_held_motors_is_asked_for_and_said() -> None:
    """Its effort, the one that would hold the joint, and how far the tip is from its equilibrium."""
    held, still = (run_setup(lever(initial={"state": state})) for state in ("held", "rest"))
    assert held.start[0] == 0.0
    assert held.off is not None
    assert (held.off.joint, held.off.given) == ("j", 0.0)
    assert held.off.needed == pytest.approx(load_on(held), rel=1e-9)
    assert held.off.distance == pytest.approx(2 * LEVER * np.sin(abs(still.start[1] - held.start[1]) / 2), rel=1e-9)
    assert [len([*departures(setup, setup.first_row)]) for setup in (held, still)] == [1, 0]


@pytest.mark.parametrize(("control", "given"), [(None, 0.0), (PD | {"type": "pid", "integral_gain": 50.0, "limit": 5.0},
                                                5.0)], ids=["torque", "limit"])  # fmt: skip
def test_a_joint_that_nothing_holds_is_named_and_starts_as_held(control: Any, given: float) -> None:
    sheet = lever(control)
    setup, held = run_setup(sheet), run_setup(sheet.with_({"initial.state": "held"}))
    assert setup.off is not None
    assert (setup.off.joint, setup.off.distance) == ("j", None)
    assert setup.off.given == pytest.approx(given, rel=1e-3)
    assert setup.off.needed == pytest.approx(load_on(setup), rel=1e-3)
    assert np.array_equal(setup.start, held.start)


@pytest.mark.parametrize("more", [{"gravity": 0.0}, {"initial": {"coordinates": {"j": 0.1}}},
                                  {"initial": {"state": "zero"}}], ids=["no load", "placed", "zero"])  # fmt: skip
def test_a_start_that_needs_no_other_or_is_placed_is_the_held_one(more: dict[str, Any]) -> None:
    setup = run_setup(lever(**more))
    assert np.array_equal(setup.start, setup.held)


def test_a_base_that_is_tilted_at_first_tilts_the_rest() -> None:
    turned = {"roll": {"type": "constant", "value": 0.0}, "pitch": {"type": "constant", "value": 0.4}}
    run = simulate_motion(lever(base_motion=turned))
    assert np.abs(run.q - run.q[0]).max() < 1e-12
    assert run.reference is not None
    assert np.abs(run.reference.q - run.reference.q[0]).max() < 1e-12


@pytest.mark.parametrize("kind", ["pd", "pid", "sampled_pid"])
def test_a_batch_starts_as_its_cases_do(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    law = PD if kind == "pd" else PD | {"type": kind, "integral_gain": 50.0}
    sheet = lever(law | ({"sample_time": 0.002} if kind == "sampled_pid" else {}))
    vary = {"joints.j.gear.stiffness": np.linspace(1500, 2500, 12), "gravity": np.linspace(9.0, 10.0, 12)}
    monkeypatch.setattr(arrays, "_FEW", 2)
    found = simulate_batch(sheet, vary)
    for k in (4, 7):
        case = sheet.with_({path: float(values[k]) for path, values in vary.items()})
        assert np.abs(found.states[k, 0] - run_setup(case).start).max() < 1e-12


@pytest.mark.parametrize("path", ["joints.j.gear.stiffness", "drives.0.controller.position_gain",
                                  "links.l.bodies.m.mass", "drives.0.signal.value"])  # fmt: skip
def test_derivatives_of_the_start_are_those_of_the_equilibrium(path: str) -> None:
    sheet = lever().with_({"drives.0.signal.value": 0.3})
    value = {"stiffness": 2000.0, "position_gain": 400.0, "mass": 2.0, "value": 0.3}[path.rpartition(".")[2]]
    here = lowered(sheet)
    found = changes_of(sheet, here, here.recorded(), [path])[path].start
    ends = {k: run_setup(sheet.with_({path: value * (1 + k * 1e-3)})).start for k in (-2, -1, 1, 2)}
    true = (ends[-2] - 8 * ends[-1] + 8 * ends[1] - ends[2]) / (12e-3 * value)
    assert np.abs(true[:2]).max() > 1e-6
    assert np.abs(found - true).max() < 1e-7 * np.abs(true).max()


def test_a_surface_that_moves_drags_the_nominal_robot_into_its_equilibrium_too() -> None:
    """Of motors that are where they should be, the joints behind their gears and the links still give way."""
    robot = load("filipovic2010").with_({"contact.velocity.0": 0.1, "contact.velocity.1": 0.05})
    setup = run_setup(robot.pair().nominal, Follow.WANTED)
    accelerations = setup.model.observe([0.0], setup.start, setup.first_row)["a"][0]
    given = [driver.coordinate for driver in setup.model.loop.drivers]
    assert np.abs(np.delete(accelerations, given)).max() < 1e-9


def observed(estimate: float = 0.0, **more: Any) -> Any:
    """A link on an elastic joint that moves by 1 rad, under an LQG about the end of its move."""
    law = {"type": "lqg", "sample_time": 1e-3, "measured": ["joint.motor.position"], "measurement_noise": [1e-9],
           "state_weights": {"joint.motor": 1e6, "joint.motor'": 1e3}, "estimate": {"joint.motor": estimate},
           "process_noise": {"joint'": 1e-3, "joint.motor'": 1e-3}}  # fmt: skip
    sheet = load("spong1987").model_dump(mode="json", by_alias=True, exclude_none=True)
    sheet["drives"][0].pop("controller")
    return load("spong1987").from_data(sheet | {"control": [{"name": "law", "drives": ["joint"], "block": law}]} | more)


def test_an_estimator_that_begins_far_from_its_rest_settles_first() -> None:
    """Its first estimate alone would ask for more than the drive gives."""
    setup = run_setup(observed(1.0).with_({"drives.0.saturation": {"torque": 20.0}}))
    rates = setup.model.rate([0.0], setup.model.settled(setup.start, setup.planned.first_row), setup.planned.first_row)
    assert setup.off is None
    assert np.abs(rates[0]).max() < STILL


@pytest.mark.parametrize("initial", [{"state": "held"}, {"state": "zero"}, {"coordinates": {"joint": 1e-9}}])
def test_an_estimate_begins_where_the_setpoints_do(initial: Any) -> None:
    """Wherever the start is given, the law does there what it does at rest."""
    still, begun = (run_setup(observed(gravity=0.0, **more)) for more in ({}, {"initial": initial}))
    assert np.abs(begun.start - still.start).max() < 1e-4
    assert begun.off is None


@pytest.mark.parametrize("path", ["drives.0.signal.start", "drives.0.signal.end", "control.law.block.estimate.joint"])
def test_a_first_estimate_is_differentiated(path: str) -> None:
    sheet = observed(initial={"state": "zero"}).with_({"control.law.block.estimate.joint": 0.1})
    here, value = lowered(sheet), {"start": 0.0, "end": 1.0}.get(path.rpartition(".")[2], 0.1)
    found = changes_of(sheet, here, here.recorded(), [path])[path].start
    low, high = (run_setup(sheet.with_({path: value + step})).start for step in (-1e-4, 1e-4))
    own = here.model.layout.controls
    assert found[own] == pytest.approx((high - low)[own] / 2e-4, abs=1e-6)
    assert np.abs(found[own]).max() > 0.1
