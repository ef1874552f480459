"""Published arms: they load, say what is assumed, and ring as printed."""

from __future__ import annotations

import copy
import math
from importlib import resources

import numpy as np
import pytest
from scipy.linalg import eigh

import tmodes
from kinds.exact import UniformBeam
from tmodes.io.yaml_file import parse_yaml
from tmodes.model.model import Model
from tmodes.robots import names
from tmodes.sheet import Robot

FOLDER = resources.files("tmodes.robots")
IMPORTED = ("filipovic2010", "filipovic2010_vibrating")
"""Stand in the format of the 2010 paper; the tests of its importer and of the paper check them."""
NAMES = [name for name in names() if name not in IMPORTED]
OVER_URDF = ["panda_elastic", "ur5_elastic"]
WHOLE = [name for name in NAMES if name not in OVER_URDF]


def sheet(name):
    """The plain data of a published arm, to be changed at will; its drives are left out."""
    data, _ = parse_yaml((FOLDER / f"{name}.yaml").read_text(encoding="utf-8"), name)
    data = copy.deepcopy(data)
    data.pop("drives")
    return data


def held(data, *joints):
    """The same arm with these joints held (all, when none is named)."""
    for joint in data["joints"]:
        if not joints or joint["name"] in joints:
            joint["state"] = "locked"
    return data


def ringing(data):
    """All frequencies [Hz] of an arm at its zero pose, straight."""
    model = Model(Robot.model_validate(data).chain())
    mass, _, stiffness = (
        np.asarray(matrix).reshape(model.nq, model.nq) for matrix in model.linearize(np.zeros(model.nq))
    )
    return np.sqrt(np.maximum(eigh(stiffness, mass, eigvals_only=True), 0)) / (2 * np.pi)


def test_there_are_nine():
    assert len(NAMES) == 9
    assert set(OVER_URDF) < set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_sheet_cites_and_reports_what_is_assumed(name):
    text = (FOLDER / f"{name}.yaml").read_text(encoding="utf-8")
    data, _ = parse_yaml(text, name)
    assert text.isascii()
    assert data["name"] == name
    assert data["format"] == 1
    assert len(data["citation"]) > 40
    assert len(data["assumed"]) > 20
    assert data["title"]


@pytest.mark.parametrize("name", WHOLE)
def test_sheet_is_an_arm_and_every_joint_that_is_not_free_is_driven(name):
    data, _ = parse_yaml((FOLDER / f"{name}.yaml").read_text(encoding="utf-8"), name)
    arm = Robot.model_validate(copy.deepcopy(data))
    assert len(arm.chain().nodes) == len(data["joints"])
    driven = [joint["name"] for joint in data["joints"] if joint.get("state") != "free"]
    assert [drive["joint"] for drive in data["drives"]] == driven


def deluca_links():
    """Both links of De Luca and Siciliano, from the numbers of the sheet."""
    upper, forearm = sheet("deluca_siciliano1991")["links"]
    hub, payload = forearm["bodies"]

    def beam(link, mass, inertia):
        section = link["beam"]["section"]
        stiffness, per_length = section["bending_stiffness"], section["mass_per_length"]
        return UniformBeam(stiffness, per_length, link["beam"]["length"], mass, inertia)

    length, weight = (
        forearm["beam"]["length"],
        forearm["beam"]["length"] * forearm["beam"]["section"]["mass_per_length"],
    )
    carried = hub["mass"] + weight + payload["mass"]
    about_elbow = hub["inertia"]["zz"] + weight * length**2 / 3 + payload["mass"] * length**2 + payload["inertia"]["zz"]
    return beam(upper, carried, about_elbow), beam(forearm, payload["mass"], payload["inertia"]["zz"])


def test_deluca_siciliano_rings_as_printed():
    """0.48 and 1.80 Hz, 2.18 and 15.91 Hz: to every printed digit."""
    upper, forearm = deluca_links()
    assert [f"{value:.2f}" for value in upper.frequencies(2)] == ["0.48", "1.80"]
    assert [f"{value:.2f}" for value in forearm.frequencies(2)] == ["2.18", "15.91"]


def test_deluca_siciliano_as_an_arm_rings_the_same():
    """The forearm on a rigid, held upper arm; and the upper arm with a rigid forearm held square to it.

    Square, the forearm's center of mass does not move across: its first moment is left out, as in the paper.
    """
    upper, forearm = deluca_links()
    data = held(sheet("deluca_siciliano1991"))
    data["links"][0]["beam"]["model"] = "rigid"
    assert ringing(data)[:2] == pytest.approx(forearm.frequencies(2), rel=5e-4)
    data = held(sheet("deluca_siciliano1991"))
    data["joints"][1]["locked_at"] = math.pi / 2
    data["links"][1]["beam"]["model"] = "rigid"
    assert ringing(data)[:2] == pytest.approx(upper.frequencies(2), rel=5e-4)


def test_flexarm_has_its_printed_inertias_and_first_frequency():
    data = sheet("flexarm1990")
    beam, hub = data["links"][1]["beam"], data["links"][1]["bodies"][0]["inertia"]["zz"]
    stiffness, per_length = beam["section"]["bending_stiffness"], beam["section"]["mass_per_length"]
    length, upper = beam["length"], data["joints"][1]["origin"]["position"][0]
    assert hub + per_length * length**3 / 3 == pytest.approx(0.303, abs=1e-6)
    assert upper * per_length * length**2 / 2 == pytest.approx(0.195, abs=1e-3)
    at_elbow = (per_length * length + 0.1) * upper**2
    assert data["links"][0]["bodies"][0]["inertia"]["zz"] + at_elbow == pytest.approx(0.447, abs=1e-5)
    exact = UniformBeam(stiffness, per_length, length, hub=hub).frequencies(2)
    assert exact[0] == pytest.approx(4.716, abs=5e-4)
    assert exact[1] == pytest.approx(14.395, rel=0.035)
    assert math.pi * 4.716 * beam["damping_time"] == pytest.approx(0.07, abs=1e-4)
    found = ringing(held(data, "shoulder"))
    assert found[0] == pytest.approx(0, abs=1e-3)
    assert found[1] == pytest.approx(exact[0], rel=1e-4)
    assert found[2] == pytest.approx(exact[1], rel=0.02)


def test_spongs_joint_rings_as_its_two_equations():
    data = sheet("spong1987")
    link, motor, spring, weight = 1.0, 0.3, 100.0, 9.8
    squares = np.linalg.eigvals([[(weight + spring) / link, -spring / link], [-spring / motor, spring / motor]])
    assert ringing(data) == pytest.approx(np.sqrt(np.sort(squares)) / (2 * np.pi), rel=1e-9)
    assert ringing(data) * 2 * np.pi == pytest.approx([2.73836401898, 20.8718637364], rel=1e-9)
    data["gravity"] = 0
    assert ringing(data)[1] * 2 * np.pi == pytest.approx(20.8166599947, rel=1e-9)


def test_quanser_link_has_its_nominal_stiffness_and_frequency():
    data = sheet("quanser_2dsfl")
    beam, carried = data["links"][0]["beam"], data["links"][0]["bodies"][0]["mass"]
    stiff, soft = beam["section"]["bending_stiffness"]
    length, per_length = beam["length"], beam["section"]["mass_per_length"]
    assert 3 * soft / length == pytest.approx(39.96, rel=1e-6)
    assert stiff / soft == pytest.approx((76.2 / 1.27) ** 2, rel=1e-5)
    assert per_length == pytest.approx(7850 * 0.0762 * 0.00127, rel=1e-5)
    assert carried * length**2 == pytest.approx(0.1704, rel=1e-6)
    exact = UniformBeam(soft, per_length, length, carried).frequencies(1)[0]
    assert exact == pytest.approx(math.sqrt(39.96 / 0.1704) / (2 * math.pi), rel=5e-3)
    assert ringing(held(data))[0] == pytest.approx(exact, rel=1e-6)


def manutec_mass(data, count):
    """Mass matrix of the first joints at the zero pose, all frames parallel: sum of m Jv' Jv + Jw' I Jw."""
    joints, origin = data["joints"], np.zeros(3)
    places, axes, mass = [], [], np.zeros((count, count))
    for index, (joint, link) in enumerate(zip(joints, data["links"], strict=True)):
        origin = origin + np.array(joint["origin"]["position"], float)
        places.append(origin)
        axes.append(np.array(joint["axis"], float))
        moving = min(index + 1, count)
        for body in link["bodies"]:
            center = origin + np.array(body.get("center", [0, 0, 0]), float)
            given = {"xx": 0.0, "yy": 0.0, "zz": 0.0, "xy": 0.0} | body.get("inertia", {})
            inertia = np.diag([given["xx"], given["yy"], given["zz"]])
            inertia[0, 1] = inertia[1, 0] = given["xy"]
            turns = np.zeros((3, count))
            travels = np.zeros((3, count))
            for k in range(moving):
                turns[:, k], travels[:, k] = axes[k], np.cross(axes[k], center - places[k])
            mass += body["mass"] * travels.T @ travels + turns.T @ inertia @ turns
    return mass


def test_manutec_gears_are_the_printed_ones_after_the_reducer():
    printed = {"joint1": (43, 0.005, 105), "joint2": (8, 0.01, 210), "joint3": (58, 0.04, 60)}
    for joint in sheet("manutec_r3")["joints"][:3]:
        spring, damper, ratio = printed[joint["name"]]
        assert joint["motor"]["ratio"] == ratio
        assert joint["gear"]["stiffness"] == spring * ratio**2
        assert joint["gear"]["damping"] == pytest.approx(damper * ratio**2)


def test_manutec_rings_on_its_three_gears():
    """Motors and the last three joints held, no gravity: 8.1, 28.9 and 36.4 Hz."""
    data = held(sheet("manutec_r3"))
    data["gravity"] = 0
    stiffness = np.diag([joint["gear"]["stiffness"] for joint in data["joints"][:3]])
    exact = np.sqrt(eigh(stiffness, manutec_mass(data, 3), eigvals_only=True)) / (2 * np.pi)
    assert ringing(data) == pytest.approx(exact, rel=1e-9)
    assert exact == pytest.approx([8.10, 28.94, 36.43], abs=5e-3)


@pytest.mark.parametrize("name", OVER_URDF)
def test_elasticity_over_a_urdf_holds_no_urdf(name):
    data = sheet(name)
    assert data["urdf"].startswith("package://example-robot-data/robots/")
    keys = {key for group in (*data["joints"].values(), *data.get("links", {}).values()) for key in group}
    assert keys <= {"motor", "gear", "state", "locked_at", "beam"}


@pytest.mark.peer
@pytest.mark.parametrize(
    ("name", "beams", "gears", "mass"), [("ur5_elastic", 2, 6, 22.0), ("panda_elastic", 0, 7, 18.2)]
)
def test_elasticity_over_the_urdf_is_an_arm(name, beams, gears, mass):
    """Where example-robot-data is installed: what bends, and the mass on the joints is the URDF's."""
    from tmodes.io.elasticity import read_elasticity
    from tmodes.kinds.drives.registry import drive_kind
    from tmodes.kinds.links.rigid import RigidLink
    from tmodes.kinds.links.strain import Beam

    with resources.as_file(FOLDER / f"{name}.yaml") as path:
        nodes = Robot.model_validate(read_elasticity(path, [robots_folder()]).data).chain().nodes
    assert sum(isinstance(node.link, Beam) for node in nodes) == beams
    assert sum(node.joint.drive is drive_kind("elastic") for node in nodes) == gears
    bodies = sum(body.mass for node in nodes if isinstance(node.link, RigidLink) for body in node.link.bodies)
    lines = sum(
        piece.mass[0] * node.link.length for node in nodes if isinstance(node.link, Beam) for piece in node.link.pieces
    )
    assert bodies + lines == pytest.approx(mass, rel=0.05)


@pytest.mark.peer
def test_panda_rings_on_its_gears_as_another_engine_says():
    """Motors held, no gravity, zero pose: the mass matrix of Pinocchio and the stiffnesses of the sheet."""
    pin = pytest.importorskip("pinocchio")
    from tmodes.io.elasticity import read_elasticity

    folder = robots_folder()
    with resources.as_file(FOLDER / "panda_elastic.yaml") as path:
        data = read_elasticity(path, [folder]).data
    data.pop("drives")
    data["gravity"] = 0
    gears = [joint["gear"]["stiffness"] for joint in data["joints"] if "gear" in joint]
    model = pin.buildModelFromUrdf(
        str(folder / "example-robot-data" / "robots" / "panda_description" / "urdf" / "panda.urdf")
    )
    pose = pin.neutral(model)
    pose[7:9] = 0.02
    mass = pin.crba(model, model.createData(), pose)[:7, :7]
    mass = np.triu(mass) + np.triu(mass, 1).T
    exact = np.sqrt(eigh(np.diag(gears), mass, eigvals_only=True)) / (2 * np.pi)
    assert ringing(held(data)) == pytest.approx(exact, rel=1e-8)
    assert exact[:2] == pytest.approx([10.25, 40.36], abs=5e-3)


def robots_folder():
    """The folder that holds ``example-robot-data``; the test is skipped where it is not installed."""
    from importlib import metadata
    from pathlib import Path

    try:
        files = metadata.files("example-robot-data") or []
    except metadata.PackageNotFoundError:
        files = []
    found = [Path(str(file.locate())) for file in files if file.name == "ur5_robot.urdf"]
    if not found:
        pytest.skip("needs the robots of the package example-robot-data")
    return next(parent.parent for parent in found[0].parents if parent.name == "example-robot-data")


def test_the_first_robot_is_off_by_millimetres_for_one_reason_and_settles():
    """Its forearm, clamped at the elbow, rings as a beam with a tip mass; it is the largest cause of its error."""
    data = held(sheet("two_link_arm"))
    tube, payload = data["links"][1]["beam"]["section"], data["links"][1]["bodies"][1]
    for joint in data["joints"]:
        del joint["gear"]
    outer, inner = tube["outer_diameter"], tube["outer_diameter"] - 2 * tube["thickness"]
    stiffness, area = 68.9e9 * math.pi / 64 * (outer**4 - inner**4), math.pi / 4 * (outer**2 - inner**2)
    beam = UniformBeam(stiffness, 2700 * area, 0.5, payload["mass"], payload["inertia"])
    assert ringing(data)[0] == pytest.approx(beam.frequencies(1)[0], rel=1e-3)
    summary = tmodes.load("two_link_arm").run().summary()
    worst = summary["tip_error"]["commanded"]
    causes = worst["elements_m"]["gears"] | worst["elements_m"]["links"]
    assert 2e-3 < worst["max_m"] < 1e-2
    assert max(causes, key=lambda name: causes[name]) == "forearm"
    assert causes["forearm"] > worst["max_m"] / 3
    assert 0.1 < summary["settling"]["time_s"] < 1
    assert summary["settling"]["reason"] == ""
    assert 1e-4 < summary["vibration"]["actual"]["amplitude_m"] < 2e-3
    for joint, limit in (("shoulder", 82.0), ("elbow", 54.0)):
        assert summary["joints"][joint]["largest_effort"] < limit
