"""What a file can get wrong: keys, kinds of values, units, names, sizes; each reported with its place."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from patience import bounded
from sheet.cases import arm_of, beam, body, changed, joint, one_link, problem, sheet
from tmodes.errors import InputErrors, TmodesError
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_plausible import implausible_numbers
from tmodes.io.yaml_file import parse_yaml

KEYS = [
    (lambda d: d.update(gravty=9.81), "unknown key `gravty`", "Did you mean `gravity`?"),
    (lambda d: d["joints"][0].update(axs=[0, 0, 1]), "joints.shoulder.axs", "Did you mean `joints.shoulder.axis`?"),
    (lambda d: d["joints"][0]["gear"].update(stifness=1), "gear.stifness", "mean `joints.shoulder.gear.stiffness`?"),
    (lambda d: d["links"][0]["beam"].update(lenght=1), "links.upper.beam.lenght", "mean `links.upper.beam.length`?"),
    (
        lambda d: d["links"][0]["beam"]["section"].update(EI=1),
        "beam.section.EI",
        "mean `links.upper.beam.section.bending_stiffness.0`?",
    ),
    (
        lambda d: d["links"][0]["beam"].update(section={"type": "tube", "bending_stiffness": 1, "mass_per_length": 1}),
        "unknown key `links.upper.beam.section.type`",
        "remove it, or name the kind: `shape: round`, `shape: tube`",
    ),
    (
        lambda d: d["links"][0]["beam"].pop("model"),
        "links.upper.beam.model is missing, expected one of strain, segments, rigid, modes",
        "add the line `model: strain` or `model: segments`",
    ),
    (lambda d: d["joints"][0].update(loads=[]), "joints.shoulder.loads", "put `loads` at the outermost level"),
    (lambda d: d.update(loads=[{"point": "tp", "frame": "world"}]), "loads.0.point", "Did you mean `tip`?"),
    (lambda d: d.update(tip={"link": "for"}), "tip.link", "Did you mean `fore`?"),
    (lambda d: d.update(couplings={"elbow": {"elbow": 1}}), "couplings.elbow", "between the gears of active joints"),
    (lambda d: d.update(initial={"coordinates": {"sholder": 1}}), "initial.coordinates.sholder", "`shoulder`"),
    (lambda d: d.update(points=[{"name": "tip", "link": "fore"}]), "points.tip.name", "rename the point"),
    (lambda d: d["links"][1].pop("name"), "links.1.name is missing", "add the line `name: ...`"),
    (lambda d: d.pop("joints"), "joints is missing", "add the line `joints: ...`"),
    (lambda d: d.update(kind="robot"), "kind must be 'arm', got 'robot'", ""),
    (lambda d: d.update(format=2), "format must be at most 1, got 2, newer than this program", "update tmodes"),
    (lambda d: d.update(format=True), "format must be the number 1, got true", "write `format: 1`"),
]


@pytest.mark.parametrize(("change", "which", "hint"), KEYS)
def test_keys_and_names(change, which: str, hint: str) -> None:
    said = problem(changed(change))
    assert which in said
    assert hint in said


VALUES = [
    (lambda d: d.update(gravity="9,81"), "gravity", "decimal point instead of the comma: 9.81"),
    (lambda d: d.update(gravity=[0, 0]), "gravity must be a list of 3 numbers [m/s^2]", "each"),
    (lambda d: d.update(gravity=[0, 0, 1, 2]), "gravity must be a list of 3 numbers", ""),
    (lambda d: d.update(gravity=-9.81), "gravity must be", "write the magnitude"),
    (lambda d: d.update(gravity=True), "gravity must be", "true and false are not numbers"),
    (lambda d: d.update(gravity=math.nan), "gravity must be", "finite"),
    (lambda d: d.update(gravity=[0, 0, math.inf]), "gravity.2 must be", "finite"),
    (lambda d: d.update(gravity="9.81 kg"), "gravity must be", "m/s^2"),
    (lambda d: d["joints"][0].update(axis="z"), "joints.shoulder.axis", ""),
    (lambda d: d["joints"][0].update(axis=[0, None, 1]), "joints.shoulder.axis.1", ""),
    (
        lambda d: d["joints"][0].update(origin={"position": "0,0,0"}),
        "joints.shoulder.origin.position must be a list of 3 numbers [m], got the text '0,0,0'",
        "write it as a list",
    ),
    (
        lambda d: d["joints"][0].update(origin={"position": 3}),
        "joints.shoulder.origin.position must be a list of 3 numbers [m], got 3",
        "write it as a list",
    ),
    (lambda d: d["joints"][0].update(type="hinge"), "joints.shoulder.type must be", "prismatic, revolute"),
    (lambda d: d["joints"][0].update(type=1), "joints.shoulder.type", ""),
    (lambda d: d["joints"][0].update(name=5), "joints.0.name", ""),
    (lambda d: d["joints"][0].update(name="a\x1b[2J"), "control characters", ""),
    (lambda d: d["joints"][0].update(name="a\nb"), "control characters", ""),
    (lambda d: d["links"][1]["bodies"][0].update(name="a\u2028b"), "bodies.0.name", "plain letters"),
    (lambda d: d.update(points=[{"name": "a\nb", "link": "fore"}]), "points.0.name", "plain letters"),
    (
        lambda d: d["joints"][0].update(gear=4700),
        "joints.shoulder.gear must be a group with the keys stiffness, torque_limits, damping, backlash, got 4700",
        "",
    ),
    (
        lambda d: d.update(joints={"shoulder": {}}),
        "joints must be a list of 0 to 500 items, got a group of one key",
        "",
    ),
    (lambda d: d.update(name=""), "name must be", "text of 1 to 100 characters"),
    (lambda d: d["links"][0]["beam"].update(section="tube"), "links.upper.beam.section", ""),
    (lambda d: d["links"][0]["beam"].update(material=[1]), "links.upper.beam.material", ""),
    (lambda d: d["joints"][0]["gear"].update(damping=1e13), "joints.shoulder.gear.damping", "exponent or the unit"),
    (lambda d: d.update(real={"x": -1}), "real.x", ""),
    (lambda d: d.update(couplings={"shoulder": 1}), "couplings.shoulder", ""),
    (lambda d: d.update(initial={"coordinates": {"elbow": "10 m"}}), "initial.coordinates.elbow", "in rad"),
]


@pytest.mark.parametrize(("change", "which", "hint"), VALUES)
def test_values(change, which: str, hint: str) -> None:
    said = problem(changed(change))
    assert which in said
    assert hint in said


@pytest.mark.parametrize("data", [None, 5, "text", [], {}, [[]], {"format": 1}])
def test_what_is_no_sheet(data) -> None:
    assert problem(data) != ""


def test_all_is_reported_in_one_go_in_the_order_of_the_file() -> None:
    text = "\n".join(
        [
            "format: 1",
            "kind: arm",
            "name: rod",
            "gravity: 9,81",
            "joints:",
            "  - {name: pivot, type: revolute, child: rod, axis: [0, 0]}",
            "links:",
            "  - name: rod",
            "    bodies:",
            "      - name: bob",
            "        mass: -1",
            "        centre: [0, 0, 1]",
        ]
    )
    data, positions = parse_yaml(text, "rod.yaml")
    with pytest.raises(InputErrors) as caught:
        sheet_from_data(data, positions, "rod.yaml")
    info = [(error.where, error.which) for error in caught.value.errors]
    assert info == [
        ("rod.yaml:4", "gravity"),
        ("rod.yaml:6", "joints.pivot.axis"),
        ("rod.yaml:11", "links.rod.bodies.bob.mass"),
        ("rod.yaml:12", "links.rod.bodies.bob.centre"),
    ]


def test_units_follow_the_joint() -> None:
    slide = {"type": "prismatic", "limits": {"lower": "-20 cm", "upper": "0.3 m", "speed": "100 mm/s"}}
    slide |= {"state": "locked", "locked_at": "5 mm", "gear": {"stiffness": "3 N/mm", "damping": "2 N*s/m"}}
    found = arm_of(one_link({"bodies": [body()]}, **slide)).joints[0]
    assert found.limits is not None
    assert found.gear is not None
    assert (found.limits.lower, found.limits.upper, found.limits.speed) == (-0.2, 0.3, 0.1)
    assert (found.locked_at, found.gear.stiffness, found.gear.damping) == (0.005, (3000.0,), 2.0)
    slide["locked_at"] = "5 deg"
    assert "joints.pivot.locked_at must be" in problem(one_link({"bodies": [body()]}, **slide))


def test_units_of_drives_follow_the_command() -> None:
    def drive(command: str, value: str, **more):
        one = {"joint": "shoulder", "command": command, "signal": {"type": "constant", "value": value}, **more}
        return sheet(drives=[one])

    gains = {"controller": {"type": "pd", "position_gain": "2 kN*m/rad", "velocity_gain": "20 N*m*s/rad"}}
    found = arm_of(drive("position", "45 deg", **gains)).drives[0]
    assert found.controller is not None
    assert (found.controller.position_gain, found.controller.velocity_gain) == (2000.0, 20.0)
    assert found.signal.value == pytest.approx(math.pi / 4)
    assert arm_of(drive("torque", "30 N*cm")).drives[0].signal.value == pytest.approx(0.3)
    assert "in rad" in problem(drive("prescribed", "3 V"))
    assert "drives.0.command must be a motor with a resistance, got voltage without an electric motor" in problem(
        drive("voltage", "3 V")
    )


DRIVES = [
    ({"joint": "elbo"}, "Did you mean `elbow`?"),
    ({"command": "torque"}, "torque without a motor"),
    ({"command": "position"}, "drives.0.controller is missing"),
    (
        {"controller": {"type": "pd", "position_gain": 1, "velocity_gain": 1}},
        "got a controller with the command `effort`",
    ),
    ({"joint": "shoulder"}, "effort on a joint behind an elastic gear"),
    ({"signal": {"type": "ramp"}}, "drives.0.signal.type must be one of brake, constant, expression, noise"),
    ({"signal": {"value": 1}}, "drives.0.signal.type is missing"),
    (
        {"signal": 5},
        "drives.0.signal must be a group of the kind brake, constant, expression, noise, "
        "polynomial, quintic, s_curve, septic, shaped, sine, sine_squared, step, sum, table, trajectory, trapezoid",
    ),
]


@pytest.mark.parametrize(("more", "words"), DRIVES)
def test_drives_that_are_none(more, words: str) -> None:
    one = {"joint": "elbow", "command": "effort", "signal": {"type": "constant", "value": 1}}
    assert problem(sheet(drives=[one])) == ""
    assert words in problem(sheet(drives=[{**one, **more}]))
    assert "a second time" in problem(sheet(drives=[one, one]))


def test_a_locked_joint_is_not_driven() -> None:
    one = {"joint": "elbow", "command": "effort", "signal": {"type": "constant", "value": 1}}
    data = sheet(drives=[one])
    data["joints"][1]["state"] = "locked"
    assert "drives.0.joint must be an active joint, got `elbow`, which does not move" in problem(data)


HUGE = [
    (lambda d: d.update(joints=d["joints"] * 251), "joints must be a list of 0 to 500 items"),
    (lambda d: d["links"][1].update(bodies=[body()] * 201), "links.fore.bodies"),
    (lambda d: d.update(points=[0] * 300_000), "the data sheet must be at most 200000, got more than 200000 values"),
]


@pytest.mark.parametrize(("change", "words"), HUGE)
def test_huge_sheets_are_refused_with_the_numbers(change, words: str) -> None:
    with bounded(2):
        assert words in problem(changed(change))


def test_too_many_coordinates_are_counted_before_anything_is_made() -> None:
    joints = [joint(f"j{k}", f"l{k}") for k in range(60)]
    links = [{"name": f"l{k}", "beam": beam(functions={"twist": 11, "bend_y": 12, "bend_z": 12})} for k in range(60)]
    said = problem(sheet(joints=joints, links=links))
    assert "must be at most 2000, got 2160 coordinates (60 joints, 0 motors, 2100 of the links)" in said


def test_five_hundred_joints_are_read_in_bounded_time() -> None:
    joints = [joint(f"j{k}", f"l{k}", axis=[0, k % 2, 1]) for k in range(500)]
    links = [{"name": f"l{k}", "bodies": [body(center=[0.1, 0, 0])]} for k in range(500)]
    with bounded(10):
        assert len(arm_of(sheet(joints=joints, links=links)).chain().nodes) == 500


def test_deep_and_endless_data() -> None:
    deep: list = []
    for _ in range(100_000):
        deep = [deep]
    assert "more than 40 levels" in problem({**sheet(), "loads": deep})
    endless: list = []
    endless.append(endless)
    assert "more than 40 levels" in problem({**sheet(), "loads": endless})


JUNK = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8) | st.integers(), inner, max_size=4),
    max_leaves=8,
)


def paths(value, steps=()):
    """Every place of plain data."""
    yield steps
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from paths(item, (*steps, key))


FULL = sheet(
    base={"position": [0, 0, 1], "rpy": [0, 0, 0.1]},
    drives=[{"joint": "elbow", "command": "effort", "signal": {"type": "table", "times": [0, 1], "values": [0, 1]}}],
    loads=[{"force": [0, 0, 1], "frame": "world", "signal": {"type": "expression", "formula": "sin(t)"}}],
    points=[{"name": "p", "link": "upper", "at": 0.5}],
    couplings={"shoulder": {"shoulder": 1.0}},
    base_motion={"x": {"type": "sine", "amplitude": "1 mm", "frequency": 3}},
    contact={"shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}, "law": "bilateral"},
    initial={"coordinates": {"elbow": "10 deg"}},
    real={"joints.shoulder.gear.stiffness": 0.8},
)
FULL["drives"][0]["signal"]["interpolation"] = "linear"
FULL["contact"] |= {"stiffness": 1000, "damping": 1}
PLACES = list(paths(FULL))[1:]


def test_the_full_sheet_is_right() -> None:
    assert problem(FULL) == ""


@settings(max_examples=200)
@given(st.sampled_from(PLACES), JUNK)
def test_junk_anywhere_gives_errors_of_ours(steps, junk) -> None:
    data = sheet(**FULL)
    inner = data
    for step in steps[:-1]:
        inner = inner[step]
    inner[steps[-1]] = junk
    said = ""
    try:
        sheet_from_data(data, source="junk.yaml").pair()
    except TmodesError as error:
        said = str(error)
    assert said == "" or said.startswith("junk.yaml: ")


PLAUSIBLE = [
    (lambda d: d["links"][0]["beam"].update(length=600), "links.upper.beam.length = 600 m", "mm (factor 0.001)"),
    (lambda d: d["joints"][1].update(locked_at=90, state="locked"), "locked_at = 90 rad", "deg (factor 0.01745)"),
    (lambda d: d["links"][1]["bodies"][0].update(mass=2e6), "mass = 2e+06 kg", "g (factor 0.001)"),
    (lambda d: tube(d, {"young": 210e3, "shear": 81e9, "density": 7850}), "of no known material", "E in MPa or GPa"),
    (lambda d: tube(d, {"young": 210e9, "shear": 81e9, "density": 7.85}), "density = 7.85 kg/m^3", "g/cm^3"),
    (lambda d: tube(d, "steel", outer_diameter=0.3), "2 times as long as high", ""),
    (lambda d: tube(d, "steel", outer_diameter=4e-4, thickness=1e-4), "1.5e+03 times as long as high", ""),
]


def tube(data, material, **more) -> None:
    section = {"shape": "tube", "outer_diameter": 0.05, "thickness": 0.002, **more}
    data["links"][0]["beam"].update(material=material, section=section)


@pytest.mark.parametrize(("change", "words", "likely"), PLAUSIBLE)
def test_numbers_of_a_wrong_unit_are_warned_of(change, words: str, likely: str) -> None:
    assert implausible_numbers(arm_of(sheet())) == []
    info = "\n".join(implausible_numbers(arm_of(changed(change))))
    assert words in info
    assert likely in info


def test_a_first_frequency_that_no_robot_has() -> None:
    """A clamped bare beam: f = 1.8751^2/L^2 sqrt(EI/w)/(2 pi)."""

    def thread(data):
        data["links"][0]["beam"].update(length=40, section={"bending_stiffness": 1e-3, "mass_per_length": 2e-3})

    hertz = 1.8751**2 / 1600 * math.sqrt(0.5) / (2 * math.pi)
    (info,) = implausible_numbers(arm_of(changed(thread)))
    assert f"swings at {hertz:.3g} Hz" in info
    assert "length in mm (factor 0.001)" in info
