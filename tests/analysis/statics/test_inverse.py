"""Inverse kinematics of bent robots, against reference values computed with exact formulas and collocation."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import tmodes
from command import tmodes as command
from tmodes.errors import InputError

G = 9.81


def arm(lengths: list[float], bodies: list[list[tuple[float, float]]], gears: list[float], **beam: Any) -> tmodes.Robot:
    """A planar arm along x, in the plane x, z: links with (mass, place), gears; perhaps a flexible link at the end."""
    joints, links = [], []
    for k, stiffness in enumerate(gears):
        origin = {"origin": {"position": [lengths[k - 1], 0, 0]}} if k else {}
        gear, motor = {"stiffness": stiffness, "damping": 0.0}, {"inertia": 0.1, "side": "joint"}
        parent = f"l{k - 1}" if k else "base"
        joints.append({"name": f"j{k}", "type": "revolute", "parent": parent, "child": f"l{k}", "axis": [0, -1, 0],
                       "motor": motor, "gear": gear, **origin})  # fmt: skip
        flexible = k == len(gears) - 1 and beam
        where = [{"at": 1.0} if flexible else {"center": [x, 0, 0]} for _, x in bodies[k]]
        own = [{"name": f"b{n}", "mass": mass, "inertia": 1e-9, **where[n]} for n, (mass, _) in enumerate(bodies[k])]
        links.append({"name": f"l{k}", "bodies": own, **({"beam": beam} if flexible else {})})
    last = f"l{len(gears) - 1}"
    tip = {"link": last} if beam else {"link": last, "position": [lengths[-1], 0, 0]}
    data = {"format": 1, "kind": "arm", "name": "arm", "gravity": G, "planar": True, "joints": joints, "links": links}
    return tmodes.Robot.from_data(data | {"tip": tip})


def elastica(length: float, stiffness: float, weight: float) -> dict[str, Any]:
    section = {"bending_stiffness": [stiffness, stiffness], "torsional_stiffness": 60.0, "mass_per_length": weight,
               "polar_inertia_per_length": 1e-6}  # fmt: skip
    return {"model": "strain", "functions": 8, "length": length, "damping_time": 0.0, "section": section}


TWO = arm([0.6, 0.5], [[(4.0, 0.3), (1.2, 0.6)], [(2.5, 0.25), (2.0, 0.5)]], [3000.0, 1500.0])
THREE = arm(
    [0.5, 0.4, 0.15], [[(3.0, 0.25), (1.0, 0.5)], [(2.0, 0.2), (0.5, 0.4)], [(0.6, 0.07), (1.5, 0.15)]],
    [2500.0, 1400.0, 500.0],
)  # fmt: skip
BENT_TWO = arm([0.6], [[(4.0, 0.3), (1.2, 0.6)], [(0.8, 0.5)]], [2000.0, 800.0], **elastica(0.5, 12.0, 0.4))
BENT_ONE = arm([], [[(0.3, 0.8)]], [150.0], **elastica(0.8, 6.0, 0.5))
BENT_THREE = arm(
    [0.5, 0.4], [[(3.0, 0.25), (1.0, 0.5)], [(2.0, 0.2), (0.6, 0.4)], [(0.5, 0.35)]], [2500.0, 1400.0, 400.0],
    **elastica(0.35, 4.0, 0.3),
)  # fmt: skip

REFERENCE = {
    "two": (TWO, (0.7, 0, 0.3), [
        ([-0.310232137314689, 1.6208171836006666], [-0.29447877665638433, 1.6235514770211206]),
        ([1.1200157098848553, -1.6208171836006666], [1.1312587362955162, -1.611494761503879]),
    ]),
    "straight up, where both elbows meet": (TWO, (0, 0, 1.1), [([np.pi / 2, 0.0], [np.pi / 2, 0.0])]),
    "three, level": (THREE, (0.6, 0, 0.25, 0, 0, 0), [
        ([-0.3027433567534987, 1.941745275670037, -1.6390019189165383],
         [-0.2887840649581628, 1.9429285023724812, -1.6337633789165384]),
        ([1.3169403655381728, -1.941745275670037, 0.6248049101318642],
         [1.3260695195541576, -1.93169036733205, 0.6300434501318642]),
    ]),
    "two, an elastica": (BENT_TWO, (0.7, 0, 0.3), [
        ([1.119797489061867, -1.5685992960579014], [1.1271221989908178, -1.5637563948041726]),
        ([-0.31021246140028697, 1.6362968573736065], [-0.2978748809721141, 1.6377142761230383]),
    ]),
    "the height of an elastica": (BENT_ONE, ("free", "free", 0), [
        ([0.15677099641255413], [0.18286676643225605]), ([2.984821657177239], [2.958725887157537]),
    ]),
    "three, an elastica, level": (BENT_THREE, (0.7, 0, 0.3, 0, 0, 0), [
        ([-0.166432332396258, 2.102470273534563, -1.8556904954591977],
         [-0.15587166678830322, 2.101616920842335, -1.8509511599929016]),
        ([1.5523027268849088, -2.102470273534563, 0.6305149923287612],
         [1.5562182684636825, -2.0958478616939615, 0.6352543277950573]),
    ]),
}  # fmt: skip
"""Robot, wanted, joint and motor angles: computed with closed forms and, of an elastica, Chebyshev collocation."""


@pytest.mark.parametrize("name", REFERENCE)
def test_all_branches_of_the_reference(name: str) -> None:
    robot, wanted, known = REFERENCE[name]
    found = robot.inverse(tip=wanted)
    assert len(found.branches) == len(known)
    for joints, motors in known:
        expected = np.array([*motors, *joints])
        apart = [np.abs(one.q[: len(expected)] - expected).max() for one in found.branches]
        assert min(apart) < 1e-9
    assert all(one.stable and max(one.off) < 1e-12 for one in found.branches)


@pytest.mark.parametrize("name", [name for name in REFERENCE if "straight" not in name])
def test_the_motors_bring_the_tip_there(name: str) -> None:
    """Equilibrium found from the unloaded robot, without any of the solver's equations."""
    robot, wanted, _ = REFERENCE[name]
    for branch in robot.inverse(tip=wanted).branches:
        rest = robot.static(hold=branch.motors).rest
        place = rest.model.pose(rest.q)[0][0]
        off = [x - float(y) for x, y in zip(place, wanted, strict=False) if y != "free"]
        assert np.abs(off).max() < 1e-9


def test_out_of_reach_is_said_with_the_nearest_point() -> None:
    """A rigid arm of 1.1 m towards (1.02, 0.45): stretched, the rest of the way missing."""
    found = TWO.inverse(tip=(1.02, 0, 0.45))
    assert not found.reachable
    assert found.nearest is not None
    assert found.nearest.off[0] == pytest.approx(np.hypot(1.02, 0.45) - 1.1, rel=1e-9)
    assert "NOT REACHABLE" in repr(found)
    assert found.info()["nearest"]["off_m"] == found.nearest.off[0]


def test_out_of_the_plane_is_out_of_reach() -> None:
    found = TWO.inverse(tip=(0.7, 0.02, 0.3))
    assert found.nearest is not None
    assert found.nearest.off[0] == pytest.approx(0.02, rel=1e-9)


def test_only_unstable_is_said() -> None:
    """A pendulum upside down on a gear of less than m g l: it holds the pose upright, but does not stay there."""
    robot = arm([0.5], [[(2.0, 0.5)]], [5.0])
    found = robot.inverse(tip=(0, 0, 0.5))
    assert [one.stable for one in found.branches] == [False]
    assert "unstable" in found.warnings[0]
    assert found.branches[0].q == pytest.approx([np.pi / 2, np.pi / 2], abs=1e-9)


def test_velocity_of_the_tip_at_rest() -> None:
    """Against the difference of two equilibria; Eq. (43) inverts it."""
    branch = BENT_TWO.inverse(tip=(0.7, 0, 0.3)).branches[0]
    step, places = 1e-5, []
    for sign in (1.0, -1.0):
        held = {**branch.motors, "j0.motor": branch.motors["j0.motor"] + sign * step}
        rest = BENT_TWO.static(hold=held).rest
        places.append(rest.model.pose(rest.q)[0][0])
    assert branch.velocity_map[:3, 0] == pytest.approx((places[0] - places[1]) / (2 * step), abs=1e-8)
    rates = branch.input_rates(np.array([0.1, 0.0, -0.2]))
    assert branch.velocity_map[:3] @ [*rates.values()] == pytest.approx([0.1, 0.0, -0.2], abs=1e-12)


def test_redundant_moves_least() -> None:
    """Three joints for a place in the plane: no small change along the circle of poses is nearer to where it starts."""
    near = {"j0": 0.4, "j1": 0.5, "j2": -0.4}
    found = THREE.inverse(tip=(0.6, 0, 0.25), near=near)
    assert found.found.redundant == 1
    first, wanted = found.branches[0], np.array([*near.values()])
    model = first.model
    jacobian = model.jacobian(first.q)[0][[0, 2]][:, model.joints]
    null = np.linalg.svd(jacobian)[2][-1]
    assert abs(null @ (first.q[model.joints] - wanted)) < 1e-6
    apart = [np.linalg.norm(one.q[model.joints] - wanted) for one in found.branches]
    assert apart == sorted(apart)


def test_limits_and_loads() -> None:
    limited = TWO.with_({"joints.j1.limits": {"lower": 0.0, "upper": 2.0, "effort": 1.0}})
    found = limited.inverse(tip=(0.7, 0, 0.3), load=["point=tip,force=0,0,-20"])
    assert found.branches[0].named["j1"] > 0
    assert "outside 0 ... 2" in " ".join(found.branches[1].outside)
    assert "at most 1" in " ".join(found.branches[0].outside)
    lever = 0.7 - 0.6 * np.cos(found.branches[0].named["j0"])
    unloaded = limited.inverse(tip=(0.7, 0, 0.3)).branches[0]
    more = found.branches[0].torque["j1.motor"] - unloaded.torque["j1.motor"]
    assert more == pytest.approx(20 * lever, rel=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_random_poses_are_found_again(seed: int) -> None:
    draw = np.random.default_rng(seed)
    robot = tmodes.load("manutec_r3")
    held = {f"joint{k + 1}": float(x) for k, x in enumerate(draw.uniform(-1.5, 1.5, 6))}
    rest = robot.static(hold={name if k > 2 else f"{name}.motor": x for k, (name, x) in enumerate(held.items())}).rest
    places, turns = rest.model.pose(rest.q)
    pitch = np.arctan2(-turns[0][2, 0], np.hypot(turns[0][0, 0], turns[0][1, 0]))
    roll, yaw = np.arctan2(turns[0][2, 1], turns[0][2, 2]), np.arctan2(turns[0][1, 0], turns[0][0, 0])
    found = robot.inverse(tip=[*places[0], roll, pitch, yaw])
    assert min(np.abs(one.q - rest.q).max() for one in found.branches) < 1e-9


def test_the_command() -> None:
    info = json.loads(command("pose", "two_link_arm", "--tip", "0.7,0,0.3", "--json").stdout)
    assert json.loads(json.dumps(tmodes.load("two_link_arm").inverse(tip=(0.7, 0, 0.3)).info())) == info
    assert "reachable" in info
    assert "Twist" in command("pose", "two_link_arm", "--tip", "0.7,0,0.3").stdout


@pytest.mark.parametrize(
    ("wrong", "field"),
    [({"tip": "0.7,0"}, "--tip"), ({"tip": ("free",) * 3}, "--tip"), ({"tip": (0, 0, float("nan"))}, "--tip"),
     ({"tip": (0, 0, 1), "point": "no"}, "point"), ({"tip": (0, 0, 1), "starts": 0}, "starts"),
     ({"tip": (0, 0, 1), "near": {"j9": 1.0}}, "coordinate")],
)  # fmt: skip
def test_refusals(wrong: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as error:
        TWO.inverse(**wrong)
    assert error.value.which.lstrip("-") == field.lstrip("-")
