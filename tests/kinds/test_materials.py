"""Materials: plausible, sourced, and the laminates recomputed ply by ply."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

from tmodes.errors import InputError
from tmodes.kinds.links.material import LIBRARY, Material, find_material

SODEN = {
    "AS4/3501-6": (126e9, 11e9, 6.6e9, 0.28, 1950e6, 48e6, 79e6),
    "E-glass/MY750": (45.6e9, 16.2e9, 5.83e9, 0.278, 1280e6, 40e6, 73e6),
}
"""E1, E2, G12, nu12, strengths along, across and in shear: Soden, Hinton, Kaddour, CST 58 (1998) 1011."""

LAYERS = {
    "carbon_epoxy": ("AS4/3501-6", [0, 45, -45, 90]),
    "carbon_epoxy_axial": ("AS4/3501-6", [0, 0, 0, 0, 45, -45]),
    "glass_epoxy": ("E-glass/MY750", [0, 45, -45, 90]),
}


def turned(degrees):
    """Strains (xx, yy, xy) of a laminate in the axes of a ply."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c * c, s * s, c * s], [s * s, c * c, -c * s], [-2 * c * s, 2 * c * s, c * c - s * s]])


def laminate(ply, angles):
    """Ex, Gxy and the tension at which the first ply reaches a strain limit."""
    along, across, shear, poisson, *strengths = SODEN[ply]
    compliance = np.array([[1 / along, -poisson / along, 0], [-poisson / along, 1 / across, 0], [0, 0, 1 / shear]])
    stiffness = np.linalg.inv(compliance)
    whole = np.linalg.inv(np.mean([turned(a).T @ stiffness @ turned(a) for a in angles], axis=0))
    limits = np.array(strengths) / np.array([along, across, shear])
    strains = np.array([turned(a) @ whole[:, 0] for a in angles])
    strains[:, 2] = np.abs(strains[:, 2])
    pulled = strains > 1e-16
    first = (np.broadcast_to(limits, strains.shape)[pulled] / strains[pulled]).min()
    return 1 / whole[0, 0], 1 / whole[2, 2], first


@pytest.mark.parametrize("name", LAYERS)
def test_laminates_are_lamination_theory(name):
    material = LIBRARY[name]
    found = (material.young, material.shear, material.yield_strength)
    assert found == pytest.approx(laminate(*LAYERS[name]), rel=3e-3)
    assert LAYERS[name][0] in material.source


def test_quasi_isotropic_laminate_is_isotropic():
    """E = 2 G (1 + nu) with the laminate's own nu: invariants of the ply (Tsai and Pagano)."""
    along, across, shear, poisson, *_ = SODEN["AS4/3501-6"]
    back = 1 - poisson**2 * across / along
    q11, q22, q12 = along / back, across / back, poisson * across / back
    u1, u4, u5 = ((3 * q11 + 3 * q22 + 2 * q12 + 4 * shear) / 8, (q11 + q22 + 6 * q12 - 4 * shear) / 8,
                  (q11 + q22 - 2 * q12 + 4 * shear) / 8)  # fmt: skip
    assert LIBRARY["carbon_epoxy"].young == pytest.approx((u1**2 - u4**2) / u1, rel=3e-3)
    assert LIBRARY["carbon_epoxy"].shear == pytest.approx(u5, rel=3e-3)


@pytest.mark.parametrize("name", sorted(set(LIBRARY) - set(LAYERS)))
def test_isotropic_materials_have_a_poisson_ratio(name):
    material = LIBRARY[name]
    assert 0.25 < material.young / (2 * material.shear) - 1 < 0.40


@pytest.mark.parametrize("name", LIBRARY)
def test_every_material_is_whole(name):
    material = LIBRARY[name]
    assert len(material.source) > 20
    assert 1000 < material.density < 9000
    assert material.yield_strength is not None
    assert 1e-3 < material.yield_strength / material.young < 0.02
    assert find_material(name) is material


def test_an_unknown_name_reports_the_nearest():
    with pytest.raises(InputError, match=r"Did you mean `aluminium_6061`\?"):
        find_material("aluminum_6061")
    with pytest.raises(InputError, match="write its young, shear and density"):
        find_material("cheese")


def test_the_library_cannot_be_changed():
    with pytest.raises(TypeError):
        LIBRARY["steel"] = LIBRARY["pla"]  # pyright: ignore[reportIndexIssue]


@pytest.mark.parametrize("field", ["young", "shear", "density", "yield_strength"])
@pytest.mark.parametrize("value", [0.0, -1.0, float("inf"), float("nan"), "210e9", True])
def test_wrong_numbers_are_refused(field, value):
    numbers = {"young": 1e9, "shear": 1e9, "density": 1e3, "yield_strength": 1e6}
    with pytest.raises(ValidationError):
        Material.model_validate(numbers | {field: value})
