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


def spatial(link: float = 0.4) -> tmodes.Robot:
    """A waist about z, a shoulder at 0.4 m and an elbow, both about -y, behind elastic gears."""
    axes, places = [[0, 0, 1], [0, -1, 0], [0, -1, 0]], [[0, 0, 0], [0, 0, 0.4], [0.5, 0, 0]]
    gear = {"motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 5000.0, "damping": 0.0}}
    joints = [
        {"name": f"j{k}", "type": "revolute", "parent": f"l{k - 1}" if k else "base", "child": f"l{k}",
         "axis": axes[k], "origin": {"position": places[k]}, **gear} for k in range(3)
    ]  # fmt: skip
    bodies = [{"name": "b", "mass": 2.0, "center": [0.2, 0, 0], "inertia": 0.01}]
    links = [{"name": f"l{k}", "bodies": bodies} for k in range(3)]
    data = {"format": 1, "kind": "arm", "name": "spatial", "gravity": G, "joints": joints, "links": links}
    return tmodes.Robot.from_data(data | {"tip": {"link": "l2", "position": [link, 0, 0]}})


SPATIAL = spatial()


def test_the_tip_on_the_axis_of_the_first_joint_is_one_family_for_each_elbow() -> None:
    """Law of cosines at 0.6 m above the shoulder; the waist turns and leaves the tip where it is."""
    found = SPATIAL.inverse(tip=(0, 0, 1.0))
    bend = np.pi - np.arccos((0.5**2 + 0.4**2 - 0.6**2) / (2 * 0.5 * 0.4))
    assert sorted(one.named["j2"] for one in found.branches) == pytest.approx([-bend, bend], abs=1e-9)
    for one in found.branches:
        (way,) = one.ways
        assert way == {"j0": 1.0, "j1": 0.0, "j2": 0.0}
        assert one.named["j0"] == pytest.approx(0.0, abs=1e-8)
    assert "one of a family along j0 1" in "".join(str(one) for one in found.tables())
    assert sum(one.starts for one in found.branches) == found.found.ended
    near = SPATIAL.inverse(tip=(0, 0, 1.0), near={"j0": 0.7})
    assert near.branches[0].named["j0"] == pytest.approx(0.7, abs=1e-8)


def test_stretched_is_no_family() -> None:
    """Two elbows meet where the arm is stretched: singular, but no joint can go on."""
    stretched = SPATIAL.inverse(tip=(0.9, 0, 0.4)).branches
    assert [one.singular for one in stretched] == [True, True]
    assert [one.ways for one in stretched] == [(), ()]


def rpy(turn: Any) -> list[float]:
    pitch = np.arctan2(-turn[2, 0], np.hypot(turn[0, 0], turn[1, 0]))
    return [np.arctan2(turn[2, 1], turn[2, 2]), pitch, np.arctan2(turn[1, 0], turn[0, 0])]


def manutec(angles: list[float]) -> tuple[tmodes.Robot, list[float]]:
    robot = tmodes.load("manutec_r3")
    held = {f"joint{k + 1}.motor" if k < 3 else f"joint{k + 1}": x for k, x in enumerate(angles)}
    rest = robot.static(hold=held).rest
    places, turns = rest.model.pose(rest.q)
    return robot, [*places[0].tolist(), *rpy(turns[0])]


def test_a_wrist_singularity_is_one_family() -> None:
    """Where joints 4 and 6 lie in line, only their sum matters, also whole turns on."""
    robot, tip = manutec([0.3, 0.4, -0.5, 0.7, 0.0, 0.2])
    family = [one for one in robot.inverse(tip=tip).branches if one.ways]
    assert len(family) == 1
    assert family[0].named["joint4"] + family[0].named["joint6"] == pytest.approx(0.9, abs=1e-8)
    moved = {name: abs(value) for name, value in family[0].ways[0].items() if value}
    assert moved == pytest.approx({"joint4": 1.0, "joint6": 1.0})


@pytest.mark.parametrize("free", [(0,), (1,), (2,), (0, 1), (0, 2), (1, 2)])
def test_free_angles(free: tuple[int, ...]) -> None:
    """The angles that are wanted are met, by the extraction of roll, pitch and yaw; joints left over are counted."""
    robot, tip = manutec([0.3, 0.4, -0.5, 0.7, 0.6, 0.2])
    wanted: list[Any] = ["free" if k - 3 in free else x for k, x in enumerate(tip)]
    found = robot.inverse(tip=wanted, starts=16)
    assert found.found.redundant == len(free)
    best = found.branches[0]
    places, turns = best.model.pose(best.q)
    assert places[0] == pytest.approx(tip[:3], abs=1e-9)
    got, known = np.array(rpy(turns[0])), np.array(tip[3:])
    other = np.array([got[0] + np.pi, np.pi - got[1], got[2] + np.pi])  # the same axes by a pitch beyond a right angle
    kept = [k for k in range(3) if k not in free]
    apart = [np.abs((one - known + np.pi) % (2 * np.pi) - np.pi)[kept].max() for one in (got, other)]
    assert min(apart) < 1e-9
    assert found.info()["rpy_rad"] == [None if k in free else tip[3 + k] for k in range(3)]
    assert len(best.ways) == len(free)


def test_more_numbers_than_joints_has_a_nearest_pose() -> None:
    """Against SciPy's least squares of the place over the size of the robot and the turn, from many starts."""
    from scipy.optimize import least_squares
    from scipy.spatial.transform import Rotation

    wanted = [0.5, 0.2, 0.6, 1.0, 0.3, -2.0]
    found = SPATIAL.inverse(tip=wanted)
    near = found.nearest
    assert near is not None
    assert near.off[0] > 0.01
    size, turn = 0.0, Rotation.from_euler("xyz", wanted[3:])
    model, q = near.model, near.q.copy()
    from tmodes.analysis.statics.inverse import tip_problem

    size = tip_problem(SPATIAL)[0].size

    def off(angles: Any) -> Any:
        q[model.joints] = angles
        places, turns = model.pose(q)
        return [*((places[0] - wanted[:3]) / size), *(Rotation.from_matrix(turns[0]) * turn.inv()).as_rotvec()]

    best = min(least_squares(off, x).cost for x in np.random.default_rng(0).uniform(-3, 3, (20, 3)))
    assert np.hypot(near.off[0] / size, near.off[1]) ** 2 / 2 == pytest.approx(best, rel=1e-6)
    assert "NOT REACHABLE" in repr(found)
    assert any("at most 3 of the 6" in one for one in found.warnings)
    assert any("the place alone can be held" in one for one in found.warnings)


@pytest.mark.parametrize("seed", range(4))
def test_a_nearest_pose_is_found_far_from_the_turn(seed: int) -> None:
    draw = np.random.default_rng(seed)
    tip = [*draw.uniform(-0.8, 0.8, 3), *draw.uniform(-3, 3, 3)]
    assert tmodes.load("two_link_arm").inverse(tip=tip).nearest is not None


@pytest.mark.parametrize(
    ("tip", "code"), [("0.7,0,0.3", 0), ("1.9,0,0.3", 3), ("0.7,0,0.3,free,free,free", 0), ("0.7,0,0.3,1,1,1", 3)]
)
def test_the_exit_code(tip: str, code: int) -> None:
    said = command("pose", "two_link_arm", "--tip", tip, "--json", code=code)
    assert json.loads(said.stdout)["reachable"] == (code == 0)


def test_the_exit_code_beyond_all_limits() -> None:
    """Branches are printed all the same."""
    tight = ("--set", "joints.0.limits.upper=0.01", "--set", "joints.0.limits.lower=0.0")
    said = json.loads(command("pose", "two_link_arm", *tight, "--tip", "0.7,0,0.3", "--json", code=3).stdout)
    assert said["reachable"]
    assert all(one["outside"] for one in said["branches"])
