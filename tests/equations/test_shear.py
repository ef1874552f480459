"""Beams that shear against exact solutions that know nothing of the package: Timoshenko's roots, Reissner's rods."""

from __future__ import annotations

from functools import cache
from itertools import islice, pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.linalg import eigh, expm
from scipy.optimize import brentq, root
from scipy.spatial.transform import Rotation

from tmodes.analysis.modes.modes import MotorState, modes_about
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.analysis.statics.equilibrium import Load, equilibrium
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.errors import InputError
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.section_shapes import box_shear, i_beam_shear, rectangle_shear, round_shear, tube_shear
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model
from tmodes.result.run import run
from tmodes.sheet import Robot

Array = NDArray[np.float64]


def beam(
    shear: tuple[float, float], *, inertia: float = 1e-3, tip: float = 0.0, length: float = 1.0, **more: Any
) -> Model:
    """A clamped round beam of EI = GJ = mass per length = 1 but for ``stiffness``; ``shear`` kGA along y and z."""
    scale = more.pop("stiffness", 1.0)
    axial = more.pop("axial", np.inf)
    own, polar, across, along_y, along_z = ((x, x) for x in (scale, 2 * inertia, inertia, *shear))
    turning = (polar, across, across)
    piece = BeamPiece(1.0, own, own, own, (axial, axial), (1.0, 1.0), turning, along_y, along_z)
    hub = more.pop("hub", None)
    bodies = ((1.0, Body(tip, np.zeros(3), np.zeros((3, 3)))),) if tip else ()
    bodies += ((0.0, Body(0.0, np.zeros(3), hub * np.eye(3))),) if hub else ()
    root = Joint("clamp", joint_kind("revolute" if hub else "fixed"))
    link = Beam(length, (piece,), bodies=bodies, **more)
    return Model(Chain("beam", (Node("beam", -1, root, link),), np.zeros(3)))


@cache
def timoshenko(number: int, s2: float, r2: float, tip: float = 0.0, hub: float | None = None) -> list[float]:
    """First frequencies of a beam, L = EI = rhoA = 1, kGA = 1/s2, rhoI = r2, with a mass at its end.

    Clamped, or on a free hinge with the inertia ``hub``.

    State (w, psi, M, Q) along x: w' = psi + s2 Q, psi' = M, M' = -Q - r2 omega^2 psi, Q' = -omega^2 w.
    """

    def left_over(omega: float) -> float:
        square = omega**2
        matrix = np.array([[0, 1, 0, s2], [0, 0, 1, 0], [0, -r2 * square, 0, -1], [-square, 0, 0, 0.0]])
        root = np.eye(4)[:, 2:]  # of a clamped one moment and force are free
        if hub is not None:
            root[:, 0] = [0, 1, -square * hub, 0]  # of a hub its rotation, with the moment that turns it
        end = expm(matrix) @ root
        return float(np.linalg.det([end[2], end[3] - tip * square * end[0]]))

    ends = pairwise((omega, left_over(omega)) for omega in np.arange(0.05, 200.0, 0.25))
    cells = islice(((a, b) for (a, x), (b, y) in ends if x * y < 0), number)
    return [brentq(left_over, *cell, xtol=1e-13) for cell in cells]  # pyright: ignore[reportReturnType]


@pytest.mark.nightly("0.003-0.001-0.0-z", "0.003-0.001-0.0-y")
@pytest.mark.parametrize("plane", ["y", "z"])
@pytest.mark.parametrize(
    ("s2", "r2", "tip"), [(0.003, 0.001, 0.0), (0.03, 0.01, 0.7), (0.12, 0.03, 0.0), (0.02, 1e-9, 0.0)]
)
def test_frequencies_are_timoshenkos(plane: str, s2: float, r2: float, tip: float) -> None:
    """In both planes, thick and thin, with a tip mass, and practically without rotary inertia."""
    bend = {"y": "bend_z", "z": "bend_y"}[plane]
    model = beam((1 / s2, 1 / s2), inertia=r2, tip=tip, **{bend: 10, f"shear_{plane}": 10})
    q = np.zeros(model.parts.size)
    found = eigh(model.mass_matrix(q), model.stiffness(q), eigvals_only=True)[::-1][:4] ** -0.5
    exact = timoshenko(4, s2, r2, tip)
    np.testing.assert_allclose(found, exact, rtol=5e-5)
    np.testing.assert_allclose(found[:2], exact[:2], rtol=1e-9)


@pytest.mark.nightly("0.1")
@pytest.mark.parametrize("hub", [None, 0.1])
@pytest.mark.parametrize("inertia", [0.0, 1e-15, 1e-12])
def test_sections_without_inertia_leave_the_low_frequencies_exact(inertia: float, hub: float | None) -> None:
    """Reference values computed with Legendre-Ritz and exact roots: 3.3623029273358, ... clamped, s2 = 0.02, r2 = 0."""
    model = beam((50.0, 50.0), inertia=inertia, bend_z=9, shear_y=9, tip=0.0, hub=hub)
    modes = modes_about(equilibrium(model), MotorState.FREE)
    free = [mode for mode in modes if mode.element == "whole arm, free"]
    assert len(free) == (hub is not None)
    assert modes[: len(free)] == free
    exact = timoshenko(4, 0.02, 0.0, hub=hub)
    if hub is None:
        assert exact[0] == pytest.approx(3.3623029273358, rel=1e-12)
    found = [2 * np.pi * mode.frequency_Hz for mode in modes[len(free) :][:4]]
    np.testing.assert_allclose(found[:3], exact[:3], rtol=1e-6)
    np.testing.assert_allclose(found[:2], exact[:2], rtol=1e-9)
    assert max(abs(mode.damping_ratio) for mode in modes[: len(free) + 4]) < 1e-8


@pytest.mark.nightly
def test_modes_need_no_rotary_inertia_and_runs_do() -> None:
    """Eight functions of shear on a sheet: the reference's frequencies, and a run that names what it lacks."""
    section = {"bending_stiffness": 1.0, "shear_stiffness": 50.0, "mass_per_length": 1.0}
    rod = {"model": "strain", "functions": {"bend_z": 8, "shear_y": 8}, "length": 1.0, "damping_time": 0.0}
    robot = Robot.from_data(
        {
            "format": 1, "kind": "arm", "name": "rod", "gravity": 0.0,
            "joints": [{"name": "root", "type": "fixed", "child": "rod"}],
            "links": [{"name": "rod", "beam": rod | {"section": section, "rotary_inertia": "none"}}],
        }
    )  # fmt: skip
    rows = vibrations(robot).states["locked"]
    found = [2 * np.pi * row["frequency_Hz"] for row in rows[:3]]
    np.testing.assert_allclose(found, [3.3623029273358, 17.151279433288, 39.127052699798], rtol=1e-5)
    assert [row["converged"] for row in rows[:3]] == [True] * 3
    with pytest.raises(InputError) as error:
        run(robot)
    assert error.value.which == "links.rod.beam.functions.shear_y"


def reissner(load: Array, shear: tuple[float, float], axial: float, moment: Array, curvature: Array) -> Array:
    """Pose (12: place, axes row by row) of the tip of a rod under a dead force and moment, L = EI = GJ = 1.

    r' = R (e_x + (N/EA, Q_y/kGA, Q_z/kGA)), R' = R [kappa]x, kappa = R^T m + its curvature at rest, and the moment
    m = m_root - r x load, whose value at the tip is that applied there: by shooting.
    """
    give = np.array([1 / axial, 1 / shear[0], 1 / shear[1]])

    def pose(held: Array) -> Array:
        def slope(_: float, y: Array) -> Array:
            axes = y[3:].reshape(3, 3)
            bend = axes.T @ (held - np.cross(y[:3], load)) + curvature
            line = axes @ (np.array([1.0, 0, 0]) + give * (axes.T @ load))
            return np.concatenate([line, (axes @ -np.cross(np.eye(3), bend).T).ravel()])

        start = np.concatenate([np.zeros(3), np.eye(3).ravel()])
        return np.asarray(solve_ivp(slope, (0, 1), start, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1])

    guess = moment + np.cross([1.0, 0, 0], load)
    found = root(lambda m: m - np.cross(pose(m)[:3], load) - moment, guess, tol=1e-11)
    assert found.success
    return pose(found.x)


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.nightly)])
def test_rods_are_reissners(seed: int) -> None:
    """Large deflection in space under a force and a moment at the tip; shear along both axes and stretch."""
    rng = np.random.default_rng(seed)
    shear = tuple(rng.uniform(8, 60, 2))
    axial, load, moment = float(rng.uniform(20, 90)), rng.normal(size=3), 0.5 * rng.normal(size=3)
    curvature = 0.5 * rng.normal(size=3) if seed % 2 else np.zeros(3)
    counts = dict.fromkeys(("twist", "bend_y", "bend_z", "stretch", "shear_y", "shear_z"), 4)
    model = beam(shear, axial=axial, rest_curvature=curvature, points=8, **counts)
    rest = equilibrium(model, loads=[Load("tip", load, moment)])
    places, axes = model.pose(rest.q)
    exact = reissner(load, shear, axial, moment, curvature)
    np.testing.assert_allclose(places[0], exact[:3], atol=2e-5)
    np.testing.assert_allclose(axes[0], exact[3:].reshape(3, 3), atol=5e-5)


def test_a_stocky_cantilever_sags_by_its_shear_too() -> None:
    """F L^3/(3 EI) + F L/(kGA), and a moment at the tip shears nothing."""
    model = beam((50.0, 80.0), bend_y=2, bend_z=2, shear_y=1, shear_z=1)
    force, moment = np.array([0, 1e-4, 2e-4]), np.array([0, 3e-4, 0])
    place = model.pose(equilibrium(model, loads=[Load("tip", force)]).q)[0][0]
    np.testing.assert_allclose(place[1:], force[1:] * (1 / 3 + 1 / np.array([50.0, 80.0])), rtol=1e-6)
    turned = equilibrium(model, loads=[Load("tip", moment=moment)])
    assert np.abs(turned.q[-2:]).max() < 1e-12
    assert model.pose(turned.q)[0][0][2] == pytest.approx(-1.5e-4, rel=1e-6)


NU = 0.3


@pytest.mark.parametrize(
    ("found", "printed"),
    [
        (round_shear(NU), 0.886363636363636), (rectangle_shear(NU), 0.849673202614379),
        (tube_shear(NU, 0.0), round_shear(NU)), (tube_shear(NU, 1.0), 2 * (1 + NU) / (4 + 3 * NU)),
        (box_shear(NU, 1.0, 1.0), 20 * (1 + NU) / (48 + 39 * NU)),
        (i_beam_shear(NU, 1e-9, 1.0, 1e-9, 0.1)[1], rectangle_shear(NU)),
    ],
)  # fmt: skip
def test_shear_coefficients_are_cowpers(found: float, printed: float) -> None:
    """His table for nu = 0.3, a thin tube, a thin square box, and an I that is nothing but its web."""
    assert found == pytest.approx(printed, rel=1e-6)


def test_the_rotation_of_a_section_is_not_the_slope_of_the_line() -> None:
    rotation = Rotation.from_matrix(beam((5.0, 5.0), bend_z=1, shear_y=1).pose(np.array([0.0, 0.1]))[1][0])
    assert rotation.magnitude() < 1e-15


@pytest.mark.parametrize("mass", [1e-11, 1e-9, 1e-8])
def test_a_beam_that_hardly_weighs_anything_carries_a_mass(mass: float) -> None:
    """A spring of 3 EI/L^3 under 2 kg: eigenvalues of the damped robot keep the digits, too."""
    section = {"bending_stiffness": 70.0, "mass_per_length": mass}
    beam = {"model": "strain", "functions": {"bend_z": 3}, "length": 0.7, "section": section, "damping_time": 0.0}
    robot = Robot.from_data(
        {
            "format": 1, "kind": "arm", "name": "light", "gravity": 0.0,
            "joints": [{"name": "root", "type": "fixed", "child": "rod"}],
            "links": [{"name": "rod", "beam": beam | {"rotary_inertia": "none"},
                       "bodies": [{"name": "load", "mass": 2.0, "at": 1.0}]}],
        }
    )  # fmt: skip
    first = vibrations(robot).states["locked"][0]
    assert 2 * np.pi * first["frequency_Hz"] == pytest.approx(np.sqrt(3 * 70.0 / 0.7**3 / 2.0), rel=mass + 1e-9)
