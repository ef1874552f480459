"""Sections: textbook values, and integrals of the drawn figure done numerically."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import TypeAdapter, ValidationError
from scipy.integrate import quad
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

from tmodes.errors import InputError
from tmodes.kinds.links.material import LIBRARY, Material
from tmodes.kinds.links.section import SHAPES, Box, GivenSection, IBeam, Round, Section, Tube, between
from tmodes.kinds.links.section_shapes import box_shear

UNIT = Material(young=1.0, shear=1.0, density=1.0)
SECTION = TypeAdapter(Section)

TIMOSHENKO = [(1.0, 0.1406), (1.2, 0.166), (1.5, 0.196), (2.0, 0.229), (2.5, 0.249), (3.0, 0.263), (4.0, 0.281),
              (5.0, 0.291), (10.0, 0.312)]  # fmt: skip
"""k1 of J = k1 long short^3: Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 109."""


def drawn(**section):
    return SECTION.validate_python(section)


def integrals(inside, width, height, cells=1500):
    """Area and second moments of the figure ``inside(y, z)`` within a rectangle, by the midpoint rule."""
    y = (np.arange(cells) + 0.5) / cells * width - width / 2
    z = (np.arange(cells) + 0.5) / cells * height - height / 2
    grid = np.meshgrid(y, z, indexing="ij")
    full = inside(*grid) * (width / cells) * (height / cells)
    return full.sum(), (full * grid[1] ** 2).sum(), (full * grid[0] ** 2).sum()


FIGURES = {
    "round": (Round(shape="round", diameter=0.03), lambda y, z: y**2 + z**2 < 0.015**2, (0.03, 0.03)),
    "tube": (
        Tube(shape="tube", outer_diameter=0.05, thickness=0.008),
        lambda y, z: (y**2 + z**2 < 0.025**2) & (y**2 + z**2 > 0.017**2),
        (0.05, 0.05),
    ),
    "solid box": (Box(shape="box", width=0.02, height=0.05), lambda y, z: y < 1.0, (0.02, 0.05)),
    "hollow box": (
        Box(shape="box", width=0.04, height=0.06, thickness=0.004),
        lambda y, z: (np.abs(y) > 0.016) | (np.abs(z) > 0.026),
        (0.04, 0.06),
    ),
    "box of flanges and webs": (
        Box(shape="box", width=0.04, height=0.06, flange_thickness=0.006, web_thickness=0.003),
        lambda y, z: (np.abs(y) > 0.017) | (np.abs(z) > 0.024),
        (0.04, 0.06),
    ),
    "i_beam": (
        IBeam(shape="i_beam", width=0.05, height=0.1, flange_thickness=0.008, web_thickness=0.005),
        lambda y, z: (np.abs(z) > 0.042) | (np.abs(y) < 0.0025),
        (0.05, 0.1),
    ),
}


@pytest.mark.parametrize("name", FIGURES)
def test_moments_are_the_integrals_of_the_figure(name):
    section, inside, (width, height) = FIGURES[name]
    area, about_y, about_z = integrals(inside, width, height)
    found = section.properties(UNIT)
    assert found.axial == pytest.approx(area, rel=3e-4)
    assert found.mass == pytest.approx(area, rel=3e-4)
    assert (found.bend_y, found.bend_z) == pytest.approx((about_y, about_z), rel=1e-3)
    assert (found.inertia_y, found.inertia_z) == pytest.approx((about_y, about_z), rel=1e-3)
    assert found.inertia_x == pytest.approx(about_y + about_z, rel=1e-3)
    assert (found.outer_y, found.outer_z) == (width / 2, height / 2)


@pytest.mark.parametrize(("ratio", "factor"), TIMOSHENKO)
def test_rectangle_twists_as_in_timoshenkos_table(ratio, factor):
    flat = Box(shape="box", width=0.01 * ratio, height=0.01).properties(UNIT).torsion
    upright = Box(shape="box", width=0.01, height=0.01 * ratio).properties(UNIT).torsion
    assert flat / (ratio * 1e-8) == pytest.approx(factor, abs=6e-4)
    assert upright == pytest.approx(flat, rel=1e-14)


def test_square_twists_as_the_series_says_to_many_digits():
    """0.140577014955 side^4: the series summed to 30 digits."""
    import mpmath

    with mpmath.workdps(30):
        series = mpmath.nsum(lambda k: mpmath.tanh((2 * k + 1) * mpmath.pi / 2) / (2 * k + 1) ** 5, [0, mpmath.inf])
        exact = float((1 - 192 / mpmath.pi**5 * series) / 3)
    assert Box(shape="box", width=1.0, height=1.0).properties(UNIT).torsion == pytest.approx(exact, rel=1e-15)
    assert exact == pytest.approx(0.140577014955, rel=1e-10)


def prandtl(solid, spacing, hole=None):
    """J of a figure on a grid: Prandtl's stress function, laplace(phi) = -2, five points; J = 2 integral of phi.

    ``solid`` and ``hole``: cells with and without material inside the outer wall. phi is 0 outside and one constant
    over the hole, where the circulation of the stress is that of a rigid turn: the sum of the equations of its cells.
    """
    index = np.full(solid.shape, -1)
    index[solid] = np.arange(solid.sum())
    if hole is not None:
        index[hole] = solid.sum()
    count = index.max() + 1
    rows, columns, values, right = [], [], [], np.zeros(count)
    for step in ((0, 1), (1, 0), (0, -1), (-1, 0)):
        near = np.roll(index, step, (0, 1))
        here = index >= 0
        rows += [index[here], index[here & (near >= 0)]]
        columns += [index[here], near[here & (near >= 0)]]
        values += [np.ones(here.sum()), -np.ones((here & (near >= 0)).sum())]
    np.add.at(right, index[index >= 0], 2 * spacing**2)
    places = (np.concatenate(rows), np.concatenate(columns))
    matrix = coo_matrix((np.concatenate(values), places), (count, count))
    phi = np.asarray(spsolve(matrix.tocsr(), right))
    return 2 * phi[index[index >= 0]].sum() * spacing**2


def grid(width, height, spacing):
    """Nodes inside the rectangle, and a rim outside it where phi is 0."""
    y, z = (np.arange(-side / 2, side / 2 + spacing / 2, spacing) for side in (width, height))
    return np.meshgrid(y, z, indexing="ij")


def test_prandtls_function_gives_the_rectangle():
    """The oracle of the next tests, against the series."""
    y, z = grid(2.0, 1.0, 0.02)
    solid = (np.abs(y) < 0.99) & (np.abs(z) < 0.49)
    exact = Box(shape="box", width=2.0, height=1.0).properties(UNIT).torsion
    assert prandtl(solid, 0.02) == pytest.approx(exact, rel=2e-3)


@pytest.mark.parametrize(("wall", "error"), [(0.05, 0.024), (0.1, 0.054), (0.2, 0.133)])
def test_bredts_box_is_as_good_as_it_says(wall, error):
    """Too soft, by a share that falls with the wall: 2.4 % at a twentieth of the side."""
    spacing = 0.005
    y, z = grid(1.0, 1.0, spacing)
    outside = np.maximum(np.abs(y), np.abs(z))
    solid = (outside < 0.5 - spacing / 2) & (outside > 0.5 - wall + spacing / 2)
    hole = outside <= 0.5 - wall + spacing / 2
    exact = prandtl(solid, spacing, hole)
    bredt = Box(shape="box", width=1.0, height=1.0, thickness=wall).properties(UNIT).torsion
    assert bredt / exact - 1 == pytest.approx(-error, abs=1e-3)


def test_strips_of_an_i_twist_nearly_as_the_whole():
    """The sum of b t^3/3 of a rolled shape is 5 % above Saint-Venant's J: the ends of the flanges take more than the
    junctions add."""
    spacing = 0.025
    section = IBeam(shape="i_beam", width=5.0, height=10.0, flange_thickness=0.8, web_thickness=0.5)
    y, z = grid(5.0, 10.0, spacing)
    edge = spacing / 2
    solid = ((np.abs(z) > 4.2 + edge) & (np.abs(z) < 5 - edge) & (np.abs(y) < 2.5 - edge)) | (
        (np.abs(y) < 0.25 - edge) & (np.abs(z) < 4.2 + 2 * edge)
    )
    assert section.properties(UNIT).torsion / prandtl(solid, spacing) == pytest.approx(1.047, abs=5e-3)


def test_round_and_tube_twist_exactly():
    assert Round(shape="round", diameter=2.0).properties(UNIT).torsion == pytest.approx(math.pi / 2, rel=1e-15)
    tube = Tube(shape="tube", outer_diameter=0.1, thickness=0.01).properties(UNIT).torsion
    assert tube == pytest.approx(math.pi / 32 * (0.1**4 - 0.08**4), rel=1e-14)


def test_thin_tube_keeps_its_digits():
    found = Tube(shape="tube", outer_diameter=1.0, thickness=1e-6).properties(UNIT)
    assert found.bend_y == pytest.approx(math.pi / 8 * 1e-6 * (1 - 1e-6) ** 3 * (1 + 1e-12), rel=1e-13)


def test_steel_rod_of_the_2010_example():
    """The numbers of the published sheet: a round steel rod of 18 mm, E 210 GPa, 7850 kg/m^3."""
    found = Round(shape="round", diameter=0.018).properties(LIBRARY["steel"])
    assert found.bend_y == pytest.approx(1082.1294435106379, rel=1e-14)
    assert found.mass == pytest.approx(1.9975816887850697, rel=1e-14)


def test_given_numbers_are_handed_on():
    one = drawn(bending_stiffness=3.0, mass_per_length=0.2)
    assert isinstance(one, GivenSection)
    assert (one.properties().young, one.properties().shear) == (0.0, 0.0)
    found = one.properties(UNIT)
    assert (found.bend_y, found.bend_z, found.torsion, found.axial) == (3.0, 3.0, math.inf, math.inf)
    assert (found.mass, found.inertia_x, found.young, found.outer_y) == (0.2, 0.0, 1.0, 0.0)
    two = drawn(
        bending_stiffness=[1.0, 3.0], torsional_stiffness=0.5, axial_stiffness=9.0, mass_per_length=1.0,
        polar_inertia_per_length=0.4,
    ).properties(LIBRARY["steel"])  # fmt: skip
    assert (two.bend_y, two.bend_z, two.torsion, two.axial) == (1.0, 3.0, 0.5, 9.0)
    assert (two.inertia_x, two.inertia_y, two.inertia_z) == pytest.approx((0.4, 0.1, 0.3))
    assert (two.young, two.shear) == (210e9, 81e9)


def test_given_stiffnesses_of_a_drawn_section_are_that_section():
    """The polar inertia parts as the stiffnesses: exact for one material."""
    material = LIBRARY["aluminium_6061"]
    whole = IBeam(shape="i_beam", width=0.05, height=0.1, flange_thickness=0.008, web_thickness=0.005)
    numbers = whole.properties(material)
    copied = drawn(
        bending_stiffness=[numbers.bend_y, numbers.bend_z],
        torsional_stiffness=numbers.torsion,
        axial_stiffness=numbers.axial,
        shear_stiffness=[numbers.shear_y, numbers.shear_z],
        mass_per_length=numbers.mass,
        polar_inertia_per_length=numbers.inertia_x,
    ).properties(material)
    unknown = dict.fromkeys(("outer_y", "outer_z", "across_y", "across_z"), 0)
    assert copied._replace(**unknown) == pytest.approx(numbers._replace(**unknown), rel=1e-14)


@pytest.mark.parametrize(("pair", "shares"), [((math.inf, 1.0), (1, 0)), ((1.0, math.inf), (0, 1))])
def test_rigid_planes_part_the_inertia(pair, shares):
    found = drawn(bending_stiffness=pair, mass_per_length=1.0, polar_inertia_per_length=0.4).properties(UNIT)
    assert (found.inertia_y, found.inertia_z) == (0.4 * shares[0], 0.4 * shares[1])


WRONG = [
    ({"shape": "round", "diameter": 0.0}, "greater_than"),
    ({"shape": "round", "diameter": -0.01}, "greater_than"),
    ({"shape": "round", "diameter": math.inf}, "finite_number"),
    ({"shape": "round", "diameter": math.nan}, "finite_number"),
    ({"shape": "round", "diameter": 1e-9}, "arithmetic"),
    ({"shape": "round", "diameter": 1e6}, "less_than_equal"),
    ({"shape": "round", "diameter": "0.01"}, "float_type"),
    ({"shape": "round", "diameter": True}, "float_type"),
    ({"shape": "round"}, "missing"),
    ({"shape": "round", "diameter": 0.01, "radius": 0.005}, "extra_forbidden"),
    ({"shape": "tube", "outer_diameter": 0.02, "thickness": 0.01}, "issues"),
    ({"shape": "tube", "outer_diameter": 0.02, "thickness": 0.03}, "issues"),
    ({"shape": "box", "width": 0.02, "height": 0.05, "thickness": 0.01}, "issues"),
    ({"shape": "box", "width": 0.02, "height": 0.05, "flange_thickness": 0.01}, "issues"),
    ({"shape": "box", "width": 0.02, "height": 0.05, "web_thickness": 0.01}, "issues"),
    ({"shape": "box", "width": 0.02, "height": 0.05, "flange_thickness": 0.01, "web_thickness": 0.01}, "issues"),
    ({"shape": "box", "width": 0.02, "height": 0.05, "flange_thickness": 0.025, "web_thickness": 0.001}, "issues"),
    (
        {
            "shape": "box",
            "width": 0.02,
            "height": 0.05,
            "thickness": 0.001,
            "flange_thickness": 0.001,
            "web_thickness": 0.001,
        },
        "issues",
    ),
    ({"shape": "i_beam", "width": 0.05, "height": 0.1, "flange_thickness": 0.05, "web_thickness": 0.01}, "issues"),
    ({"shape": "i_beam", "width": 0.05, "height": 0.1, "flange_thickness": 0.01, "web_thickness": 0.05}, "issues"),
    ({"shape": "hexagon", "diameter": 0.01}, "union_tag_invalid"),
    ({"shape": ["tube"], "diameter": 0.01}, "union_tag_invalid"),
    ({"bending_stiffness": -1.0, "mass_per_length": 1.0}, "greater_than"),
    ({"bending_stiffness": 0.0, "mass_per_length": 1.0}, "greater_than"),
    ({"bending_stiffness": math.nan, "mass_per_length": 1.0}, "greater_than"),
    ({"bending_stiffness": [1.0], "mass_per_length": 1.0}, "missing"),
    ({"bending_stiffness": [1.0, 1.0, 1.0], "mass_per_length": 1.0}, "too_long"),
    ({"bending_stiffness": "1", "mass_per_length": 1.0}, "tuple_type"),
    ({"bending_stiffness": True, "mass_per_length": 1.0}, "float_type"),
    ({"bending_stiffness": 1e-300, "mass_per_length": 1.0}, "issues"),
    ({"bending_stiffness": 1e300, "mass_per_length": 1.0}, "issues"),
    ({"bending_stiffness": 1.0, "mass_per_length": 0.0}, "greater_than"),
    ({"bending_stiffness": 1.0, "mass_per_length": 1.0, "polar_inertia_per_length": -1.0}, "greater_than_equal"),
    ({"bending_stiffness": 1.0}, "missing"),
    (None, "model_type"),
    (5, "model_type"),
]


@pytest.mark.parametrize(("data", "kind"), WRONG)
def test_a_wrong_section_is_refused(data, kind):
    with pytest.raises(ValidationError) as caught:
        SECTION.validate_python(data)
    assert kind in {error["type"] for error in caught.value.errors()}


def test_a_wall_too_thick_reports_the_bound():
    with pytest.raises(ValidationError) as caught:
        drawn(shape="tube", outer_diameter=0.02, thickness=0.01)
    ((field, got, expected, hint),) = caught.value.errors()[0].get("ctx", {})["issues"]
    assert (field, got) == ("thickness", "0.01")
    assert "0.01 [m]" in expected
    assert "shape: round" in hint


@given(
    st.sampled_from([section for section, *_ in FIGURES.values()]),
    st.floats(1.0, 3.0),
    st.floats(0.0, 1.0),
)
def test_between_is_linear_in_dimensions(section, factor, share):
    larger = type(section)(
        **{name: value * factor if isinstance(value, float) else value for name, value in section.model_dump().items()}
    )
    found = between(section, larger, share).properties(UNIT)
    scale = 1 + share * (factor - 1)
    own = section.properties(UNIT)
    assert found.bend_y == pytest.approx(own.bend_y * scale**4, rel=1e-12)
    assert found.mass == pytest.approx(own.mass * scale**2, rel=1e-12)


def test_between_given_sections():
    ends = [drawn(bending_stiffness=[1.0, 2.0 * k], mass_per_length=float(k)) for k in (1, 3)]
    found = between(ends[0], ends[1], 0.5).properties(UNIT)
    assert (found.bend_y, found.bend_z, found.mass, found.torsion) == (1.0, 4.0, 2.0, math.inf)


@pytest.mark.parametrize(
    "tip",
    [
        Round(shape="round", diameter=0.01),
        Box(shape="box", width=0.02, height=0.02, thickness=0.001),
        drawn(bending_stiffness=1.0, mass_per_length=1.0),
    ],
)
def test_between_different_shapes_is_refused(tip):
    with pytest.raises(InputError, match="the same shape at both ends"):
        between(Box(shape="box", width=0.03, height=0.03), tip, 0.5)


def test_between_rigid_and_elastic_is_refused():
    soft, rigid = (drawn(bending_stiffness=value, mass_per_length=1.0) for value in (1.0, math.inf))
    with pytest.raises(InputError, match=r"\.inf"):
        between(soft, rigid, 0.5)


@pytest.mark.parametrize("name", FIGURES)
def test_round_trip(name):
    section = FIGURES[name][0]
    assert SECTION.validate_python(section.model_dump(mode="json")) == section
    assert SECTION.validate_python(section) is section
    assert SHAPES[section.shape] is type(section)


def test_walls_of_one_thickness_are_those_of_flanges_and_webs():
    same = Box(shape="box", width=0.04, height=0.06, thickness=0.004).geometry()
    apart = Box(shape="box", width=0.04, height=0.06, flange_thickness=0.004, web_thickness=0.004).geometry()
    assert same[:-1] == apart[:-1]
    assert same.shear_coefficients(0.3) == apart.shear_coefficients(0.3)


def test_torsion_of_walls_of_two_thicknesses_is_bredts():
    """4 A^2/(sum of side/thickness) of the middle line, term by term; turned by 90 degrees it is the same."""
    box = Box(shape="box", width=0.1, height=0.2, flange_thickness=0.004, web_thickness=0.002)
    across, up = 0.1 - 0.002, 0.2 - 0.004
    whole = 4 * (across * up) ** 2 / (2 * across / 0.004 + 2 * up / 0.002)
    assert box.geometry().torsion == pytest.approx(whole, rel=1e-13)
    turned = Box(shape="box", width=0.2, height=0.1, flange_thickness=0.002, web_thickness=0.004)
    assert turned.geometry().torsion == pytest.approx(whole, rel=1e-13)


def cowper_of_a_thin_box(nu: float, across: float, along: float, flange: float, web: float) -> float:
    """Cowper's integral, K = 2(1+nu) I/(nu (I' - I)/2 - A/I * int x (chi + x y^2)), by the shear flow of thin walls.

    The force is along x; webs lie along it at y = +-across/2. By symmetry a quarter of the section, chi = 0 at x = 0.
    """
    half = along / 2

    def of_web(x: float) -> float:
        """chi along a web, the integral of its derivative from the middle."""
        flow = flange * along * across / (4 * web) * x + (half**2 * x - x**3 / 3) / 2
        return -(2 * (1 + nu)) * flow - nu * x**3 / 6 - (1 - nu / 2) * across**2 / 4 * x

    def of_flange(y: float) -> float:
        return of_web(half) + nu * along / 4 * (y**2 - across**2 / 4)

    webs = 4 * web * quad(lambda x: x * (of_web(x) + x * across**2 / 4), 0, half)[0]
    flanges = 4 * flange * quad(lambda y: half * (of_flange(y) + half * y**2), 0, across / 2)[0]
    area = 2 * (flange * across + web * along)
    own = 2 * web * along**3 / 12 + 2 * flange * across * half**2
    other = 2 * flange * across**3 / 12 + 2 * web * along * across**2 / 4
    return 2 * (1 + nu) * own / (nu / 2 * (other - own) - area / own * (webs + flanges))


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
@pytest.mark.parametrize(
    ("across", "along", "flange", "web"), [(1, 1, 1, 1), (1, 2, 3, 1), (2, 1, 1, 4), (1, 3, 0.2, 1), (1, 1, 1e-9, 1)]
)
def test_shear_of_a_thin_box_is_cowpers_integral(nu, across, along, flange, web):
    found = box_shear(nu, across, along, flange / web)
    assert found == pytest.approx(cowper_of_a_thin_box(nu, across, along, 1e-3 * flange, 1e-3 * web), rel=1e-9)
