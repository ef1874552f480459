"""Bodies, motors, gears and beams by themselves: closed forms, and each fault with its words."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad

from sheet.cases import SECTION, arm_of, at, beam, body, changed, one_link, problem, sheet
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.strain import Beam

INERTIAS = [
    ({"xx": 1, "yy": 1, "zz": 3}, "triangle inequality"),
    ({"xx": 1, "yy": 1, "zz": 1, "xy": 2}, "not negative"),
    ({"xx": 0, "yy": 0, "zz": 1}, "triangle inequality"),
    ({"xx": 1, "yy": 1, "zz": 2.001}, "triangle inequality"),
]


@pytest.mark.parametrize(("inertia", "rule"), INERTIAS)
def test_an_inertia_that_no_mass_can_have(inertia, rule: str) -> None:
    said = problem(one_link({"bodies": [{"name": "box", "mass": 1, "inertia": inertia}]}))
    assert said.startswith("links.rod.bodies.box.inertia must be one whose ")
    assert ", got an inertia with the principal moments " in said
    assert rule in said


def test_the_principal_moments_are_reported() -> None:
    said = problem(one_link({"bodies": [{"mass": 1, "inertia": {"xx": 1, "yy": 1, "zz": 1, "xy": 2}}]}))
    assert "principal moments -1, 1, 3;" in said


@pytest.mark.parametrize(
    "inertia", [{"xx": 0, "yy": 1, "zz": 1}, {"xx": 1, "yy": 1, "zz": 2}, {"xx": 1, "yy": 1, "zz": 2.00001}]
)
def test_rods_and_discs_are_right(inertia) -> None:
    assert problem(one_link({"bodies": [{"mass": 1, "center": [0.1, 0, 0], "inertia": inertia}]})) == ""


@pytest.mark.parametrize("mass", [-1, "nan", "1e400", "heavy", ".inf", True, None, [1], {}, 1e300, 1e-300])
def test_a_mass_that_is_none(mass) -> None:
    assert "links.rod.bodies.0.mass" in problem(one_link({"bodies": [{"mass": mass}]}))


@pytest.mark.parametrize("mass", [0, 1e-60])
def test_a_joint_that_moves_no_mass(mass) -> None:
    """A body may be without mass, like a tip that carries no payload; what a joint moves may not."""
    assert "joints.pivot must be a joint that moves mass, got `rod`, a link that has no" in problem(
        one_link({"bodies": [{"mass": mass}]})
    )


def test_the_axes_of_an_inertia_are_turned() -> None:
    turned = body(rpy=[0, 0, math.pi / 2], center=[0.1, 0.2, 0.3])
    (found,) = arm_of(one_link({"bodies": [turned]})).chain().nodes[0].link.bodies
    np.testing.assert_allclose(found.inertia, np.diag([0.03, 0.02, 0.025]), atol=1e-17)
    (oblique,) = arm_of(one_link({"bodies": [body(rpy=[0.3, -0.5, 0.9])]})).chain().nodes[0].link.bodies
    turn = at(rpy=[0.3, -0.5, 0.9])[:3, :3]
    np.testing.assert_allclose(oblique.inertia, turn @ np.diag([0.02, 0.03, 0.025]) @ turn.T, atol=1e-16)
    np.testing.assert_allclose(found.center, [0.1, 0.2, 0.3])


def motor(**more):
    def put(data):
        data["joints"][0]["motor"] = {"inertia": 1e-4, "side": "motor", **more}

    return changed(put)


def test_a_motor_is_reflected_by_its_ratio() -> None:
    friction = {"viscous": 2e-4, "coulomb": 0.01, "static_extra": 0.02, "stribeck_rate": 5.0, "smoothing": 0.1}
    electric = {"resistance": 0.3, "back_emf_constant": 0.03, "torque_constant": 0.04, "inductance": 1e-3}
    found = arm_of(motor(ratio=-100, friction=friction, **electric)).chain().nodes[0].joint.motor
    assert found.inertia == pytest.approx(1.0)
    assert found.friction.viscous == pytest.approx(2.0)
    assert (found.friction.coulomb, found.friction.static_extra) == pytest.approx((1.0, 2.0))
    assert (found.friction.stribeck_rate, found.friction.smoothing) == pytest.approx((0.05, 1e-3))
    assert (found.resistance, found.inductance) == (0.3, 1e-3)
    assert (found.back_emf, found.torque_constant) == pytest.approx((-3.0, -4.0))


def test_power_is_the_same_on_both_sides_of_the_reducer() -> None:
    """Friction power of a motor at a speed is that of the joint-side numbers at the joint's speed."""
    friction = {"viscous": 2e-4, "coulomb": 0.01, "static_extra": 0.02, "stribeck_rate": 5.0, "smoothing": 0.1}
    found = arm_of(motor(ratio=37.5, friction=friction)).chain().nodes[0].joint.motor.friction

    def power(viscous, coulomb, extra, stribeck, smoothing, rate):
        dry = coulomb + extra / (1 + (rate / stribeck) ** 2)
        return (viscous * rate + dry * rate / math.hypot(rate, smoothing)) * rate

    own = power(found.viscous, found.coulomb, found.static_extra, found.stribeck_rate, found.smoothing, 0.2)
    assert own == pytest.approx(power(2e-4, 0.01, 0.02, 5.0, 0.1, 0.2 * 37.5), rel=1e-14)


def test_a_joint_side_motor_is_taken_as_it_is() -> None:
    found = arm_of(motor(side="joint", ratio=100)).chain().nodes[0].joint.motor
    assert (found.inertia, found.torque_constant) == (1e-4, 1.0)


@pytest.mark.parametrize(
    ("given", "which"),
    [
        ({}, "motor.ratio"),
        ({"ratio": 0}, "motor.ratio"),
        ({"ratio": 9, "resistance": 1}, "motor.back_emf_constant"),
        ({"ratio": 9, "inductance": 1}, "motor.inductance"),
        (
            {"ratio": 9, "friction": {"viscous": 0, "static_extra": 1, "smoothing": 1e-3}},
            "motor.friction.stribeck_rate",
        ),
        ({"ratio": 9, "friction": {"viscous": 0, "coulomb": -1}}, "motor.friction.coulomb"),
        ({"ratio": 9, "inertia": -1e-4}, "motor.inertia"),
        ({"ratio": 9, "side": "Motor "}, "Did you mean `motor`?"),
    ],
)
def test_motors_that_are_none(given, which: str) -> None:
    assert which in problem(motor(**given))


def gear(**given):
    return changed(lambda data: data["joints"][0].update(gear={"damping": 1.0, **given}))


def test_a_gear_of_ranges() -> None:
    found = arm_of(gear(stiffness=["1 kN*m/rad", 2000, 3000], torque_limits=[14, "48 N*m"], backlash=1e-3))
    info = found.chain().nodes[0].joint.gear
    assert (info.stiffness, info.limits) == ((1000.0, 2000.0, 3000.0), (14.0, 48.0))
    assert (info.damping, info.backlash) == (1.0, 1e-3)


@pytest.mark.parametrize(
    ("given", "which"),
    [
        ({"stiffness": 0}, "gear.stiffness"),
        ({"stiffness": -5}, "gear.stiffness"),
        ({"stiffness": "-.inf"}, "gear.stiffness"),
        ({"stiffness": 1e-20}, "gear.stiffness"),
        ({"stiffness": []}, "gear.stiffness"),
        ({"stiffness": [1, 2]}, "gear.torque_limits"),
        ({"stiffness": [1, 2, 3], "torque_limits": [5, 5]}, "limits that rise"),
        ({"stiffness": [1, math.inf], "torque_limits": [5]}, "one .inf alone"),
        ({"stiffness": 5, "damping": math.inf}, "gear.damping"),
        ({"stiffness": [1, True], "torque_limits": [5]}, "gear.stiffness.1"),
    ],
)
def test_gears_that_are_none(given, which: str) -> None:
    assert which in problem(gear(**given))


def lowered(**more) -> Beam:
    link = arm_of(one_link({"beam": beam(**more)})).chain().nodes[0].link
    assert isinstance(link, Beam)
    return link


def test_a_beam_of_a_drawn_section() -> None:
    """Round bar: EI = E pi d^4/64, GJ = G pi d^4/32, w = rho pi d^2/4."""
    steel = {"young": 210e9, "shear": 81e9, "density": 7850.0}
    section = {"shape": "round", "diameter": "20 mm"}
    (piece,) = lowered(section=section, material=steel, rotary_inertia="full").pieces
    moment, area = math.pi * 0.02**4 / 64, math.pi * 0.02**2 / 4
    assert piece.bend_y == pytest.approx((210e9 * moment,) * 2)
    assert piece.torsion == pytest.approx((162e9 * moment,) * 2)
    assert piece.axial == pytest.approx((210e9 * area,) * 2)
    assert piece.mass == pytest.approx((7850 * area,) * 2)
    expected = np.array([[2, 2], [1, 1], [1, 1]]) * 7850 * moment
    np.testing.assert_allclose(piece.inertia, expected, rtol=1e-14)


@pytest.mark.parametrize(("choice", "counted"), [("none", [0, 0, 0]), ("twist", [1, 0, 0]), ("full", [1, 1, 1])])
def test_the_rotary_inertia_that_counts(choice: str, counted) -> None:
    (piece,) = lowered(rotary_inertia=choice).pieces
    np.testing.assert_allclose(np.array(piece.inertia)[:, 0], np.array([2e-4, 1.2e-4, 0.8e-4]) * counted, rtol=1e-14)


def test_stepped_pieces_end_at_shares_of_the_length() -> None:
    thin = {**SECTION, "bending_stiffness": 5.0}
    found = lowered(section=None, pieces=[{"end": 0.15, "section": SECTION}, {"end": "60 cm", "section": thin}])
    assert [(piece.end, piece.bend_y) for piece in found.pieces] == [(0.25, (120.0, 120.0)), (1.0, (5.0, 5.0))]


def test_a_taper_keeps_the_integrals_of_its_stiffness() -> None:
    """A cone: mass = rho pi L (D^2 + D d + d^2)/12; moments of EI by quadrature of pi E D^4/64."""
    sections = {
        "section": {"shape": "round", "diameter": 0.03},
        "taper": {"section": {"shape": "round", "diameter": 0.02}},
    }
    pieces = lowered(**sections, material="steel").pieces

    def linear(piece, start, x, name):
        first, last = getattr(piece, name)
        return first + (last - first) * (x - start) / (piece.end - start)

    def integral(name, weight):
        ends = [0.0, *(piece.end for piece in pieces)]
        parts = zip(ends, ends[1:], pieces, strict=False)
        return sum(quad(lambda x, s=s, p=p: weight(x) * linear(p, s, x, name), s, e)[0] for s, e, p in parts)

    def stiffness(x):
        return 210e9 * math.pi * (0.03 - 0.01 * x) ** 4 / 64

    assert integral("mass", lambda x: 1) == pytest.approx(7850 * math.pi * (9 + 6 + 4) * 1e-4 / 12, rel=1e-12)
    for power in range(4):
        exact = quad(lambda x, power=power: x**power * stiffness(x), 0, 1)[0]
        assert integral("bend_y", lambda x, power=power: x**power) == pytest.approx(exact, rel=2e-4)
    assert 1 < len(pieces) <= 8


def test_a_taper_of_given_stiffnesses_is_one_exact_piece() -> None:
    tip = {**SECTION, "bending_stiffness": [60.0, 20.0], "axial_stiffness": math.inf}
    (piece,) = lowered(taper={"section": tip}).pieces
    assert piece.bend_y == pytest.approx((120.0, 60.0), rel=1e-14)
    assert piece.bend_z == pytest.approx((80.0, 20.0), rel=1e-14)
    assert piece.axial == (math.inf, math.inf)


def test_a_rigid_direction_has_no_functions() -> None:
    rigid = {**SECTION, "bending_stiffness": [math.inf, 80.0]}
    found = lowered(section=rigid, functions={"twist": 1, "bend_y": 3, "bend_z": 3})
    assert (found.twist, found.bend_y, found.bend_z) == (1, 0, 3)


def test_a_beam_that_bends_nowhere_is_a_rigid_link() -> None:
    rigid = {"bending_stiffness": math.inf, "mass_per_length": 2.0}
    (node,) = arm_of(one_link({"beam": beam(section=rigid)})).chain().nodes
    assert isinstance(node.link, RigidLink)
    (found,) = node.link.bodies
    assert found.mass == pytest.approx(1.2)
    np.testing.assert_allclose(found.center, [0.3, 0, 0], atol=1e-15)
    np.testing.assert_allclose(found.inertia, np.diag([0, 1, 1]) * 1.2 * 0.36 / 12, atol=1e-15)


BEAMS = [
    ({"length": 0}, "beam.length"),
    ({"length": -0.6}, "beam.length"),
    ({"section": {**SECTION, "bending_stiffness": 0}}, "bending_stiffness"),
    ({"section": {**SECTION, "mass_per_length": 0}}, "mass_per_length"),
    ({"section": {"shape": "tube", "outer_diameter": 0.05, "thickness": 0.03}, "material": "steel"}, "thickness"),
    ({"section": {"shape": "tub", "outer_diameter": 0.05}}, "Did you mean `tube`?"),
    ({"section": {"shape": "round", "diameter": 0.05}}, "beam.material"),
    ({"section": {"shape": "round", "diameter": 0.05}, "material": "stel"}, "Did you mean `steel`?"),
    ({"material": "steel"}, "next to given stiffnesses"),
    ({"section": None}, "beam.section"),
    ({"pieces": [{"end": 0.6, "section": SECTION}]}, "next to `pieces`"),
    (
        {"section": None, "pieces": [{"end": 0.5, "section": SECTION}]},
        "pieces.0.end must be the length 0.6 [m], got 0.5",
    ),
    ({"section": None, "pieces": [{"end": 0.6, "section": SECTION}] * 2}, "pieces.1.end"),
    ({"taper": {"section": {"shape": "round", "diameter": 0.1}}}, "the same shape at both ends, got round"),
    ({"taper": {"section": {"bending_stiffness": math.inf, "mass_per_length": 1}}}, "infinite at one end"),
    ({"functions": None}, "beam.functions"),
    ({"functions": 13}, "beam.functions.bend_y"),
    ({"functions": 10**6}, "beam.functions.bend_y"),
    ({"functions": -1}, "beam.functions.bend_y"),
    ({"functions": 2.5}, "beam.functions"),
    ({"functions": {"stretch": 1}}, "0 where axial_stiffness is infinite"),
    ({"functions": {"twist": 1}, "section": {"bending_stiffness": 1, "mass_per_length": 1}}, "torsional_stiffness"),
    ({"functions": {"twist": 1}, "rotary_inertia": "none"}, "without rotary inertia"),
    ({"functions": {"twist": 1}, "section": {**SECTION, "polar_inertia_per_length": 0}}, "polar_inertia_per_length"),
    ({"model": "segments"}, "beam.segments"),
    ({"model": "segments", "segments": 201}, "beam.segments must be a whole number not less than 1"),
    ({"model": "segments", "segments": 2, "rest_curvature": [0, 0, 1]}, "rest_curvature"),
    ({"model": "stran"}, "Did you mean `strain`?"),
    ({"damping_time": None}, "beam.damping_time"),
    ({"damping_time": math.nan}, "beam.damping_time"),
    ({"points": 25}, "beam.points"),
]


@pytest.mark.parametrize(("more", "words"), BEAMS)
def test_beams_that_are_none(more, words: str) -> None:
    assert words in problem(one_link({"beam": beam(**more)}))


def test_a_beam_rigid_in_some_pieces_only() -> None:
    stiff = {**SECTION, "bending_stiffness": [math.inf, 80.0]}
    pieces = [{"end": 0.3, "section": stiff}, {"end": 0.6, "section": SECTION}]
    assert "bend_y rigid in some pieces only" in problem(one_link({"beam": beam(section=None, pieces=pieces)}))


def test_a_body_between_the_ends_of_segments() -> None:
    link = {"beam": beam(model="segments", segments=4), "bodies": [body(at=0.3)]}
    assert "links.rod.bodies.0.at must be an end of one of the 4 segments: a multiple of 1/4, got 0.3" in problem(
        one_link(link)
    )
    link["bodies"] = [body(at=0.75), body(at=0)]
    assert problem(one_link(link)) == ""


def test_a_station_on_a_link_without_a_beam() -> None:
    assert "links.rod.bodies.0.at" in problem(one_link({"bodies": [body(at=0.5)]}))
    assert "tip.at" in problem(sheet(tip={"link": "fore", "at": 0.5}))
