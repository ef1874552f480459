"""The elastic line against closed forms and against the model's own points and forces."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from analysis.line.beams import EI, LENGTH, MASS, beam, clamped, piece, turning
from oracle.arms.robots import arms
from random_chains import random_chain, random_state
from tmodes.analysis.line.line import elastic_line, line_places
from tmodes.analysis.quasistatic import held_shape
from tmodes.chain.chain import Chain, Point
from tmodes.errors import InputError, SimulationError
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body, Link
from tmodes.kinds.links.material import find_material
from tmodes.kinds.links.section import Box, Round, Tube
from tmodes.kinds.links.segment import Segment
from tmodes.model.model import Model

S = np.linspace(0, 1, 21)
X = LENGTH * S


def random_samples(model: Model, count: int = 4) -> list[np.ndarray]:
    rows = [random_state(seed, model.coordinates) for seed in range(count)]
    return [np.array([row[k] for row in rows]) for k in range(3)]


def chains() -> dict[str, Chain]:
    return arms() | {f"random{seed}": random_chain(seed) for seed in (11,)}


@pytest.mark.parametrize("name", chains())
def test_line_ends_at_the_points_of_the_model(name: str) -> None:
    model = Model(chains()[name])
    q, v, a = random_samples(model)
    points = model.points(q)
    for k, point in enumerate(model.parts.points):
        line = elastic_line(model, q, v, a, stations=[0.1, point.s])[model.chain.nodes[point.node].name]
        if line.kind == "rigid":
            continue
        place = line.position[:, -1] + line.rotation[:, -1] @ point.offset.position
        assert np.abs(place - points.position[:, k]).max() < 1e-14 * max(1, np.abs(place).max())
        assert np.abs(line.rotation[:, -1] @ point.offset.rotation - points.rotation[:, k]).max() < 2e-14


@pytest.mark.parametrize("name", chains())
def test_balance_of_everything_outboard_is_the_joint_force_of_the_model(name: str) -> None:
    model = Model(chains()[name])
    q, v, a = random_samples(model)
    wrenches = np.random.default_rng(5).normal(size=(len(q), len(model.parts.points), 6))
    base = np.random.default_rng(6).normal(size=24)
    base[9:18] = model.chain.base.rotation.ravel()
    lines = elastic_line(model, q, v, a, wrenches=wrenches, base=base)
    rotors = model.rotor_inertias * a
    wanted = model.inverse_dynamics(q, v, a, wrenches=wrenches, base=base) - model.elastic_forces(q, v) - rotors
    for index, part in enumerate(model.parts.nodes):
        if part.angle >= 0:
            axis = lines[part.node.name].rotation[:, 0] @ part.node.joint.axis
            turns = part.node.joint.kind is joint_kind("revolute")
            load = lines.roots[:, index, 3:] if turns else lines.roots[:, index, :3]
            got = -(load * axis).sum(axis=1)
            assert np.abs(got - wanted[:, part.angle]).max() < 1e-12 * np.abs(wanted).max()


def test_stations_are_the_sections_of_the_model() -> None:
    spots = (Point("tip", 0), Point("third", 0, s=0.3), Point("late", 0, s=0.77))
    bodies = ((0.5, Body(0.3, np.array([0.0, 0.02, 0.01]))),)
    link = beam(twist=1, bodies=bodies, rest_curvature=np.array([0.3, 0.2, -0.4]))
    model = clamped(link, points=spots)
    q, v, a = random_samples(model)
    line = elastic_line(model, q, v, a, stations=[0.3, 0.77, 1.0])["rod"]
    assert np.abs(line.position - model.points(q).position[:, [1, 2, 0]]).max() < 1e-14


def test_static_tip_force() -> None:
    """Force F across, weightless, small: moment F (L - x), shear F, deflection F x^2 (3 L - x)/(6 EI)."""
    model = clamped(gravity=np.zeros(3))
    force = np.array([0.0, 2e-6, -3e-6])
    _, _, stiffness = model.linearize(np.zeros(6))
    push = np.concatenate([force, np.zeros(3)])[None, None]
    q = np.linalg.solve(stiffness, -model.inverse_dynamics(np.zeros(6), np.zeros(6), np.zeros(6), wrenches=push))
    line = elastic_line(model, q, wrenches=push)["rod"]
    assert line.shape is not None
    assert np.abs(line.moment[0, :, 2] - force[1] * (LENGTH - X)).max() < 1e-10 * force[1]
    assert np.abs(line.moment[0, :, 1] + force[2] * (LENGTH - X)).max() < 1e-10 * abs(force[2])
    assert np.abs(line.shear[0] - force[1:]).max() < 1e-10 * abs(force[2])
    assert np.abs(line.shape.elastic_moment[0, :, 1:] - line.moment[0, :, 1:]).max() < 1e-10 * abs(force[2])
    cubic = X**2 * (3 * LENGTH - X) / (6 * EI)
    assert np.abs(line.shape.deflection[0] - cubic[:, None] * force[1:]).max() < 1e-10 * cubic[-1] * abs(force[2])
    slope = X * (2 * LENGTH - X) / (2 * EI)
    assert np.abs(line.shape.slope[0] - slope[:, None] * force[1:]).max() < 1e-10 * slope[-1] * abs(force[2])
    assert np.abs(line.shape.curvature[0, :, 1] - force[1] * (LENGTH - X) / EI).max() < 1e-10 * force[1] / EI


@pytest.mark.parametrize("taper", [1.0, 0.4])
def test_self_weight(taper: float) -> None:
    """An unbent beam: q (L - x)^2/2 and q (L - x), of a tapered one the integrals of its weight."""
    model = clamped(beam(pieces=(piece(taper=taper),)))
    line = elastic_line(model, np.zeros(6), stations=S.tolist())["rod"]
    left, drop, weight = LENGTH - X, (1 - taper) / LENGTH, 9.81 * MASS
    shear = weight * (left - drop * (LENGTH**2 - X**2) / 2)
    moment = weight * (left**2 / 2 - drop * (LENGTH**3 / 3 - LENGTH**2 * X / 2 + X**3 / 6))
    assert np.abs(line.shear[0, :, 1] + shear).max() < 1e-12 * shear[0]
    assert np.abs(line.moment[0, :, 1] - moment).max() < 1e-12 * moment[0]
    assert np.abs(line.axial).max() < 1e-12 * shear[0]


def test_stepped_beam_carries_its_steps_and_a_body_between() -> None:
    steps = (piece(end=0.25, mass=2.0), piece(end=1.0, mass=0.5))
    model = clamped(beam(pieces=steps, bodies=((0.6, Body(1.5)), (1.0, Body(0.4)))))
    line = elastic_line(model, np.zeros(model.nq), stations=S.tolist())["rod"]
    own = 2.0 * np.maximum(0.25 * LENGTH - X, 0) + 0.5 * (LENGTH - np.maximum(X, 0.25 * LENGTH))
    assert np.abs(line.shear[0, :, 1] + 9.81 * (own + 1.5 * (S < 0.6 + 1e-9) + 0.4)).max() < 1e-12 * 9.81 * 4


def test_rotating_beam() -> None:
    """Spun about z at w: rhoA w^2 (L^2 - x^2)/2 in tension; and w^2/2 (...) is what its root carries."""
    model, w = turning(), 7.0
    v = np.zeros(7)
    v[0] = w
    line = elastic_line(model, np.zeros(7), v)["rod"]
    tension = MASS * w**2 * (LENGTH**2 - X**2) / 2
    assert np.abs(line.axial[0] - tension).max() < 1e-12 * tension[0]
    assert np.abs(line.moment).max() < 1e-12 * tension[0] * LENGTH


def test_accelerated_beam() -> None:
    """Turned with w' from rest: moment -rhoA w' (L^3/3 - L^2 x/2 + x^3/6)."""
    model = turning()
    a = np.zeros(7)
    a[0] = 3.0
    line = elastic_line(model, np.zeros(7), 0.0, a)["rod"]
    wanted = -MASS * 3.0 * (LENGTH**3 / 3 - LENGTH**2 * X / 2 + X**3 / 6)
    assert np.abs(line.moment[0, :, 2] - wanted).max() < 1e-12 * abs(wanted[0])


@pytest.mark.parametrize("gravity", [0.0, 9.81])
def test_loads_are_those_in_the_beam_next_to_bodies(gravity: float) -> None:
    """Just beyond a body at the root, on both sides of one inside, just before one at the tip: turned as if rigid.

    N = int m s w^2, Q = -int m (s alpha + g), M = -int m (s - x) (s alpha + g) - J alpha, over all beyond x.
    """
    places, rate, gain = (0.0, 0.4, 1.0), 2.3, -1.7
    masses, inertias = (3.0, 0.5, 0.9), (0.2, 0.03, 0.01)
    bodies = tuple(
        (s, Body(mass, inertia=inertia * np.eye(3))) for s, mass, inertia in zip(places, masses, inertias, strict=True)
    )
    model = turning(beam(bodies=bodies), gravity=(0.0, -gravity, 0.0))
    q, v, a = np.zeros((3, model.nq))
    v[0], a[0] = rate, gain
    s = np.array([0.0, 0.2, 0.4, 0.4, 0.7, 1.0])
    line = elastic_line(model, q, v, a, stations=[*s])["rod"]
    beyond = np.array([[False, True, True]] * 3 + [[False, False, True]] * 3)
    x, at, rest = s * LENGTH, np.array(places) * LENGTH, LENGTH * (1 - s)
    each = beyond * np.array(masses)
    beam_mass, middle = MASS * rest, (LENGTH + x) / 2
    axial = rate**2 * (beam_mass * middle + each @ at)
    shear = -gain * (beam_mass * middle + each @ at) - gravity * (beam_mass + each.sum(axis=1))
    turned = MASS * rest**2 * (2 * LENGTH + x) / 6 + (each * (at - x[:, None])) @ at
    weighed = MASS * rest**2 / 2 + (each * (at - x[:, None])).sum(axis=1)
    moment = -gain * (turned + beyond @ np.array(inertias)) - gravity * weighed
    np.testing.assert_allclose(line.axial[0], axial, rtol=1e-9)
    np.testing.assert_allclose(line.shear[0, :, 0], shear, rtol=1e-9)
    np.testing.assert_allclose(line.moment[0, :, 2], moment, rtol=1e-9)


def test_places_show_both_sides_of_bodies_inside() -> None:
    """Not of those at the ends, and not twice what the grid has already."""
    bodies = tuple((s, Body(0.1)) for s in (0.0, 0.25, 0.3, 1.0))
    places = line_places(turning(beam(bodies=bodies)).chain, 5)
    np.testing.assert_allclose(places, [0.0, 0.25, 0.25, 0.3, 0.3, 0.5, 0.75, 1.0], atol=0)
    np.testing.assert_allclose(line_places(turning().chain, 3), [0.0, 0.5, 1.0], atol=0)


def test_twisted_shaft() -> None:
    """Angular acceleration about its own axis: torsion -rhoIp a (L - x)."""
    model = clamped(beam(twist=2, pieces=(piece(inertia=((1e-3, 1e-3), (0.0, 0.0), (0.0, 0.0))),)), gravity=np.zeros(3))
    base = np.concatenate([[2.0, 0, 0], np.zeros(6), np.eye(3).ravel(), np.zeros(6)])
    line = elastic_line(model, np.zeros(8), base=base)["rod"]
    assert np.abs(line.moment[0, :, 0] + 1e-3 * 2.0 * (LENGTH - X)).max() < 1e-14


@pytest.mark.parametrize(("functions", "tolerance"), [(3, 0.06), (5, 2e-3), (7, 5e-5)])
def test_free_vibration_bends_as_its_inertia_asks(functions: int, tolerance: float) -> None:
    """In its first mode the balance's moment is EI kappa, to the accuracy of the functions."""
    from scipy.linalg import eigh

    model = clamped(beam(bend_y=0, bend_z=functions), gravity=np.zeros(3))
    mass, _, stiffness = model.linearize(np.zeros(functions))
    squares, shapes = eigh(stiffness, mass)
    q = 1e-6 * shapes[:, 0]
    line = elastic_line(model, q, 0.0, -squares[0] * q)["rod"]
    assert line.shape is not None
    moment = line.moment[0, :, 2]
    assert np.abs(line.shape.elastic_moment[0, :, 2] - moment).max() < tolerance * np.abs(moment).max()
    wave = 1.87510406871196 * S
    ratio = (np.cosh(wave[-1]) + np.cos(wave[-1])) / (np.sinh(wave[-1]) + np.sin(wave[-1]))
    exact = np.cosh(wave) + np.cos(wave) - ratio * (np.sinh(wave) + np.sin(wave))
    assert np.abs(moment / moment[0] - exact / 2).max() < tolerance


@pytest.mark.parametrize("taper", [1.0, 0.5])
def test_moment_of_the_material_is_the_projection_of_the_balance(taper: float) -> None:
    """Of any motion that obeys the equations: int (M - EI (kappa + eta kappa')) b_j ds = 0 for every function.

    The functions are polynomials over the relative stiffness, which falls in a straight line here.
    """
    from numpy.polynomial.legendre import leggauss

    link = beam(pieces=(piece(taper=taper),), damping_time=1e-3, points=12, bodies=((1.0, Body(0.4)),))
    model = clamped(link)
    q, v, _ = random_samples(model)
    q, v = 1e-3 * q, 1e-3 * v
    x, w = leggauss(30)
    s = (1 + x) / 2
    line = elastic_line(model, q, v, model.forward_dynamics(q, v), stations=s.tolist())["rod"]
    assert line.shape is not None
    gap = (line.moment - line.shape.elastic_moment)[..., 1:] / (1 - (1 - taper) * s)[:, None]
    for power in range(3):
        weighed = (gap * (w * s**power)[:, None]).sum(axis=1)
        assert np.abs(weighed).max() < 2e-6 * np.abs(line.moment).max()


def test_line_of_a_step_under_a_tip_force() -> None:
    """EI falls to a third at 0.4: the moments are F (L - x) in the material too, the sag is that of the unit load."""
    link = beam(bend_y=0, pieces=(piece(end=0.4), piece(bending=EI / 3, mass=0.4 * MASS)))
    model = clamped(link, gravity=np.zeros(3))
    force, s = 1e-4, np.array([0.0, 0.2, 0.39, 0.4, 0.41, 0.7, 1.0])
    push = np.array([0.0, force, 0.0, 0.0, 0.0, 0.0])[None, None]
    q, _ = held_shape(model, np.zeros(3), wrenches=push)
    moments = force * LENGTH * (1 - s)
    line = elastic_line(model, q, wrenches=push, stations=s.tolist())["rod"]
    assert line.shape is not None
    np.testing.assert_allclose(line.shape.elastic_moment[0, :, 2], moments, atol=1e-9 * moments[0])
    np.testing.assert_allclose(line.moment[0, :, 2], moments, atol=1e-9 * moments[0])
    soft = np.clip(s - 0.4, 0, None)
    sag = s**2 / 2 - s**3 / 6 + 2 * (0.6 * soft**2 / 2 - soft**3 / 6)
    expected = force * LENGTH**3 / EI * sag
    np.testing.assert_allclose(line.position[0, :, 1], expected, rtol=1e-7, atol=1e-16)


def test_stress_of_a_round_rod() -> None:
    """Diameter d: sigma = 32 M/(pi d^3), tau = 16 T/(pi d^3), whatever the direction of M."""
    d, young, shear = 0.02, 210e9, 81e9
    moment, area = np.pi * d**4 / 64, np.pi * d**2 / 4
    numbers: dict[str, Any] = {"torsion": (shear * 2 * moment,) * 2, "axial": (young * area,) * 2}
    rod = beam(pieces=(piece(bending=young * moment, **numbers),), outer=(d / 2, d / 2), young=young, shear=shear)
    model = clamped(rod, gravity=np.zeros(3))
    push = np.array([500.0, 3.0, 4.0, 6.0, 0.0, 0.0])[None, None]
    stress = elastic_line(model, np.zeros(6), wrenches=push)["rod"].stress
    assert stress is not None
    sigma = 32 * 5.0 * LENGTH / (np.pi * d**3) + 500 / area
    tau = 16 * 6.0 / (np.pi * d**3)
    assert stress.normal_stress[0, 0] == pytest.approx(sigma, rel=1e-12)
    assert stress.strain[0, 0] == pytest.approx(sigma / young, rel=1e-12)
    assert stress.shear_stress[0, 0] == pytest.approx(tau, rel=1e-12)
    assert stress.mises_stress[0, 0] == pytest.approx(np.sqrt(sigma**2 + 3 * tau**2), rel=1e-12)


@pytest.mark.parametrize(
    ("section", "peak"),
    [
        (Round(shape="round", diameter=0.04), 4 / 3), (Tube(shape="tube", outer_diameter=0.04, thickness=1e-5), 2.0),
        (Box(shape="box", width=0.02, height=0.05), 1.5),
        (Box(shape="box", width=0.02, height=0.05, thickness=0.0099999), 1.5),
    ],
)  # fmt: skip
def test_shear_stress_of_a_transverse_force(section: Any, peak: float) -> None:
    """tau = 4/3, 2 and 3/2 of Q/A; at the tip, without a moment, it is all the stress there is."""
    numbers = section.properties(find_material("steel"))
    area = numbers.axial / numbers.young
    ends: dict[str, Any] = {
        name: (getattr(numbers, name),) * 2 for name in ("torsion", "axial", "across_y", "across_z")
    }
    outer = (numbers.outer_y, numbers.outer_z)
    one = piece(bending=numbers.bend_y, **ends)
    rod = beam(pieces=(one,), outer=outer, young=numbers.young, shear=numbers.shear)
    push = np.array([0.0, 0.0, 700.0, 0.0, 0.0, 0.0])[None, None]
    stress = elastic_line(clamped(rod, gravity=np.zeros(3)), np.zeros(6), wrenches=push)["rod"].stress
    assert stress is not None
    assert stress.shear_stress[0, -1] == pytest.approx(peak * 700.0 / area, rel=1e-3)
    assert stress.mises_stress[0, -1] == pytest.approx(np.sqrt(3) * peak * 700.0 / area, rel=1e-3)
    assert stress.mises_stress[0, 0] == pytest.approx(stress.normal_stress[0, 0], rel=1e-12)


def test_stress_of_a_box_adds_at_its_corner() -> None:
    rod = beam(pieces=(piece(bending=700.0),), outer=(0.01, 0.01), young=70e9, shear=26e9)
    push = np.array([0.0, 3.0, 4.0, 0.0, 0.0, 0.0])[None, None]
    line = elastic_line(clamped(rod, gravity=np.zeros(3)), np.zeros(6), wrenches=push)["rod"]
    assert line.stress is not None
    assert line.stress.strain[0, 0] == pytest.approx(7.0 * LENGTH * 0.01 / 700.0, rel=1e-12)
    largest = line.largest("mises_stress")
    assert largest is not None
    assert (largest.s, largest.sample) == (0.0, 0)


def test_stress_is_not_reported_where_the_section_is_not_known() -> None:
    line = elastic_line(clamped(), np.zeros(6))["rod"]
    assert line.stress is None
    assert line.largest("mises_stress") is None


def test_largest_says_where_and_when() -> None:
    model = clamped(gravity=np.zeros(3))
    pushes = np.zeros((3, 1, 6))
    pushes[:, 0, 1] = [1.0, -5.0, 2.0]
    line = elastic_line(model, np.zeros((3, 6)), wrenches=pushes)["rod"]
    found = line.largest("moment", 2)
    assert found is not None
    assert found.value == pytest.approx(-5.0 * LENGTH)
    assert (found.s, found.sample) == (0.0, 1)


def test_segment_line() -> None:
    """The paper's mode: deflection l th (3 s^2 - s^3)/2, slope 3/2 th at the tip, moment 3 EI/l^3 l^2 th (1 - s)."""
    model = Model(arms()["segmented"])
    th_y, th_z = 2e-5, 3e-5
    q = np.zeros(model.nq)
    q[[model.coordinates.index("lower.bend_y"), model.coordinates.index("lower.bend_z")]] = th_y, th_z
    line = elastic_line(model, q)["lower"]
    assert line.shape is not None
    shape = (3 * S**2 - S**3) / 2 * 0.6
    assert np.abs(line.shape.deflection[0, :, 0] - th_z * shape).max() < 1e-9 * th_z
    assert np.abs(line.shape.deflection[0, :, 1] + th_y * shape).max() < 1e-9 * th_z
    assert line.shape.slope[0, -1] == pytest.approx([1.5 * th_z, -1.5 * th_y], rel=1e-12)
    assert line.shape.elastic_moment[0, 0] == pytest.approx([0.0, 2e3 * 0.36 * th_y, 1.5e3 * 0.36 * th_z], rel=1e-12)
    assert line.shape.curvature[0, 0] == pytest.approx([3 * th_y / 0.6, 3 * th_z / 0.6], rel=1e-12)


def test_segment_in_balance_carries_what_bends_it() -> None:
    """In equilibrium the moment of a tip force is the mode's own all along."""
    from tmodes.chain.chain import Joint, Node
    from tmodes.kinds.links.segment import Segment

    node = Node("mode", -1, Joint("wall", joint_kind("fixed")), Segment(0.5, 800.0, 800.0, bodies=(Body(0.2),)))
    model = Model(Chain("mode", (node,), np.zeros(3)))
    push = np.array([0.0, 1e-6, 0.0, 0.0, 0.0, 0.0])[None, None]
    q = np.array([0.0, 1e-6 * 0.5 / (800.0 * 0.25)])
    line = elastic_line(model, q, wrenches=push)["mode"]
    assert line.shape is not None
    assert np.abs(line.moment[0, :, 2] - line.shape.elastic_moment[0, :, 2]).max() < 1e-10 * 5e-7


def test_rigid_links_are_straight() -> None:
    model = Model(arms()["branched"])
    q, _, _ = random_samples(model)
    line = elastic_line(model, q)["arm"]
    assert line.kind == "rigid"
    assert line.length == pytest.approx(np.sqrt(0.2**2 + 0.1**2))
    assert np.abs(np.diff(line.position, n=2, axis=1)).max() < 1e-15
    assert line.shape is None
    assert {line.name for line in elastic_line(model, q).bending()} == {"trunk", "blade"}


@pytest.mark.parametrize("stations", [[], [1.2], [float("nan")], [[0.1]]])
def test_places_off_the_link_are_refused(stations: list) -> None:
    with pytest.raises(InputError, match="stations"):
        elastic_line(clamped(), np.zeros(6), stations=stations)


def test_too_much_is_refused_before_it_is_begun() -> None:
    with pytest.raises(SimulationError, match="GB"):
        elastic_line(clamped(), np.broadcast_to(np.zeros(6), (10_000_000, 6)))


def test_infinite_axial_stiffness_gives_no_stretch_and_no_stress_of_it() -> None:
    """What a section of given stiffnesses means by no `axial_stiffness`."""
    rod = beam(pieces=(piece(axial=(np.inf, np.inf)),), outer=(0.01, 0.02), young=70e9, shear=26e9)
    push = np.array([9.0, 3.0, 0.0, 0.0, 0.0, 0.0])[None, None]
    line = elastic_line(clamped(rod, gravity=np.zeros(3)), np.zeros(6), wrenches=push)["rod"]
    assert line.stress is not None
    assert line.stress.strain[0, 0] == pytest.approx(3.0 * LENGTH * 0.01 / EI, rel=1e-12)


class Unlined(Segment):
    """A link kind that has no line of its own."""

    def lines(self, stations: tuple[float, ...], s: np.ndarray) -> Any:
        return Link.lines(self, stations, s)


def test_a_link_without_a_line_of_its_own_has_the_cubic_between_its_ends() -> None:
    """Of small angles that of a segment, which is a cubic; with the same loads at root and tip."""
    own, cubic = (clamped(kind(LENGTH, 40.0, 60.0, bodies=(Body(0.4),))) for kind in (Segment, Unlined))
    q, v, a = 1e-4 * np.array([[3.0, -2.0]]), np.array([[0.3, 0.5]]), np.array([[2.0, -1.0]])
    lines = [elastic_line(model, q, v, a)["rod"] for model in (own, cubic)]
    for name in ("position", "moment", "shear", "axial"):
        first, second = (getattr(line, name) for line in lines)
        assert np.abs(first - second).max() < 1e-6 * np.abs(first).max(), name
        assert np.abs(first - second)[:, [0, -1]].max() < 1e-12 * np.abs(first).max(), name
    for name in ("deflection", "slope", "curvature"):
        first, second = (getattr(line.shape, name) for line in lines)
        assert np.abs(first - second).max() < 1e-6 * np.abs(first).max(), name
