"""Beams with bodies inside, steps of section and mass, and tip bodies: frequencies, and the estimate of their errors.

Reference: Euler-Bernoulli beams with moments of twelve independent functions between every two steps and bodies.
"""

from __future__ import annotations

import os
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy.linalg import eigh

from tmodes.analysis.modes import of_sheet
from tmodes.analysis.modes.of_sheet import CONVERGED, vibrations
from tmodes.analysis.modes.of_sheet import finer as finer_robot
from tmodes.kinds.links.beam_tables import beam_tables
from tmodes.model.model import Model
from tmodes.sheet import Robot

Array = NDArray[np.float64]

SEEDS = int(os.environ.get("TMODES_RANDOM_BEAMS", "40"))
MODES = 5


class _Case(NamedTuple):
    """``steps``: where each piece ends; ``bodies``: place, mass, inertia about the axis of bending. Length 1 m."""

    functions: int
    steps: tuple[float, ...]
    stiffness: tuple[float, ...]
    mass: tuple[float, ...]
    bodies: tuple[tuple[float, float, float], ...]


def _robot(case: _Case) -> Robot:
    pieces = [
        {"end": end, "section": {"bending_stiffness": stiffness, "mass_per_length": mass}}
        for end, stiffness, mass in zip(case.steps, case.stiffness, case.mass, strict=True)
    ]
    section: dict[str, Any] = {"pieces": pieces} if len(pieces) > 1 else {"section": pieces[0]["section"]}
    bodies = [
        {"name": f"body{k}", "mass": mass, "at": at, "inertia": inertia}
        for k, (at, mass, inertia) in enumerate(case.bodies)
    ]
    beam = {"model": "strain", "functions": {"bend_z": case.functions}, "length": 1.0, "damping_time": 0.0}
    return Robot.from_data(
        {
            "format": 1, "kind": "arm", "name": "beam", "gravity": 0.0,
            "joints": [{"name": "root", "type": "fixed", "child": "rod"}],
            "links": [{"name": "rod", "bodies": bodies, "beam": {**beam, "rotary_inertia": "none", **section}}],
        }
    )  # fmt: skip


def _exact(case: _Case, degree: int = 12) -> Array:
    """The first frequencies [Hz]: moments are polynomials of their own between every two steps and bodies.

    Those of neighbours are independent; deflections follow by integration, so that all boundary conditions hold.
    """
    cuts = np.unique([0.0, *case.steps, *(at for at, *_ in case.bodies), 1.0])
    x, weights = legendre.leggauss(degree + 6)
    number = degree * (len(cuts) - 1)
    slope, deflection, mass = np.zeros(number), np.zeros(number), np.zeros((number, number))
    for k, (start, end) in enumerate(pairwise(cuts)):
        half, piece = (end - start) / 2, int(np.searchsorted(case.steps, (start + end) / 2))
        once, twice = np.zeros((2, number, len(x) + 1))
        for j in range(degree):
            size = np.sqrt((2 * j + 1) / (2 * half) / case.stiffness[piece])  # of unit elastic energy
            own = size * np.eye(degree)[j]
            once[k * degree + j] = half * legendre.legval([*x, 1.0], legendre.legint(own, lbnd=-1))
            twice[k * degree + j] = half**2 * legendre.legval([*x, 1.0], legendre.legint(own, 2, lbnd=-1))
        reached = half * (np.append(x, 1.0) + 1)
        moved = deflection[:, None] + slope[:, None] * reached + twice
        mass += case.mass[piece] * half * (moved[:, :-1] * weights) @ moved[:, :-1].T
        slope, deflection = slope + once[:, -1], moved[:, -1]
        for at, heavy, inertia in case.bodies:
            if at == end:
                mass += heavy * np.outer(deflection, deflection) + inertia * np.outer(slope, slope)
    return 1 / np.sqrt(np.linalg.eigvalsh(mass)[::-1][:MODES]) / (2 * np.pi)


def _random(seed: int) -> _Case:
    rng = np.random.default_rng(seed)
    steps = (*sorted(rng.uniform(0.1, 0.9, rng.integers(0, 3)).round(3).tolist()), 1.0)
    inside = sorted(rng.uniform(0.05, 0.95, rng.integers(1, 4)).round(3).tolist())
    places = [*inside, *([1.0] if rng.random() < 0.7 else [])]
    bodies = tuple((at, 10 ** rng.uniform(-2, 1), 10 ** rng.uniform(-4, -0.5) * (rng.random() < 0.6)) for at in places)
    stiffness, mass = (tuple(10 ** rng.uniform(-size, size, len(steps))) for size in (1, 0.7))
    return _Case(int(rng.integers(2, 11)), steps, stiffness, mass, bodies)


def _by_tables(case: _Case, finer: bool = False) -> Array:
    """All frequencies [Hz] of the unbent beam by the tables of its kernels: what its code computes, not compiled."""
    robot = _robot(case)
    beam: Any = ((finer and finer_robot(robot)) or robot).chain().nodes[-1].link
    tables = beam_tables(beam, beam.stations())
    shape, g = tables.shape, tables.shape.points
    named = {name: tables.packed[shape.table_starts[name] :][:size] for name, size in shape.tables.items()}
    slopes = dict(zip(shape.breaks, np.cumsum(named["alpha"].reshape(-1, shape.size), axis=0), strict=True))
    at_points = np.array([slopes["point", m] for m in range(g)])
    root, entry = np.zeros((g, g)), 0
    if shape.spans:
        for part in shape.parts:
            rows = named["root_mass"][entry:][: len(part) * (len(part) + 1)].reshape(len(part), -1)
            root[part, part.start : part.stop] = rows[:, 1:]
            root[part, : part.start] = rows[:, :1] * named["to_tip"][: part.start]
            entry += rows.size
    else:
        root[np.triu_indices(g)] = named["root_mass"]
    moved = root @ at_points
    mass = moved.T @ moved
    for at, heavy, inertia in case.bodies:
        place = ("tip", 0) if at == 1.0 else ("station", beam.stations().index(at))
        weights = named["to_tip"] if at == 1.0 else named["to_station"].reshape(-1, g)[place[1]]
        mass += heavy * np.outer(weights @ at_points, weights @ at_points)
        mass += inertia * np.outer(slopes[place], slopes[place])
    stiffness = np.zeros_like(mass)
    stiffness[np.tril_indices(shape.size) if shape.full else np.diag_indices(shape.size)] = tables.stiffness
    squares = eigh(mass, stiffness, eigvals_only=True, lower=True)
    return 1 / np.sqrt(squares[::-1]) / (2 * np.pi)


@pytest.mark.parametrize("seed", range(SEEDS))
def test_frequencies_come_from_above_and_their_estimated_errors_hold(seed: int) -> None:
    """At least 0.4 of an error is seen by four more functions; what they change by less than a hundredth is good."""
    case = _random(seed)
    found, fine = _by_tables(case)[:MODES], _by_tables(case, finer=True)
    error, estimated = found / _exact(case)[: len(found)] - 1, found / fine[: len(found)] - 1
    assert error.min() > -1e-4
    seen = error > 1e-4
    assert (estimated[seen] > 0.4 * error[seen]).all()
    assert error[estimated < CONVERGED].max(initial=0.0) < 2 * CONVERGED


def test_body_inside_a_beam() -> None:
    """Ten functions: the fifth was 4.5 % high, and the third and fourth 9 and 10 %; three are enough for three."""
    case = _Case(10, (1.0,), (1.0,), (1.0,), ((0.4, 0.8, 0.02), (1.0, 0.5, 0.0)))
    found = _by_tables(case)[:MODES]
    np.testing.assert_allclose(found, [0.309174, 1.756135, 4.296339, 8.330696, 22.905559], rtol=3e-4)
    np.testing.assert_allclose(_by_tables(case._replace(functions=3))[:3], found[:3], rtol=4e-3)


def test_modes_of_a_robot_with_a_body_inside() -> None:
    """The same of compiled code, by the command's way; its estimate knows which modes are the same motions."""
    case = _Case(3, (1.0,), (1.0,), (1.0,), ((0.4, 0.8, 0.02), (1.0, 0.5, 0.0)))
    rows = next(iter(vibrations(_robot(case)).states.values()))
    found = np.array([row["frequency_Hz"] for row in rows])
    np.testing.assert_allclose(found, _by_tables(case), rtol=1e-9)
    expected = found / _by_tables(case, finer=True)[: len(found)] - 1
    np.testing.assert_allclose([row["frequency_error"] for row in rows[:4]], expected[:4], atol=1e-9)


def test_code_of_sections_in_any_span() -> None:
    """Bodies at breaks, close to them, before the first point and after the last: code and tables agree."""
    bodies = (
        (0.0005, 0.3, 0.0),
        (0.2, 1.0, 0.01),
        (0.2004, 0.5, 0.0),
        (0.5, 0.7, 0.0),
        (0.51, 0.1, 0.0),
        (0.9995, 0.2, 0.0),
    )
    case = _Case(1, (1.0,), (1.0,), (1.0,), bodies)
    model = Model(_robot(case).chain())
    rest = np.zeros(model.nq)
    found = eigh(model.mass_matrix(rest), model.stiffness(rest), eigvals_only=True)[::-1] ** -0.5 / (2 * np.pi)
    assert len(found) > 4
    np.testing.assert_allclose(found, _by_tables(case), rtol=1e-9)


def test_a_comparison_that_is_too_long_to_compile_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """And a notice says so; that of twenty bodies in a plane is short enough."""
    case = _Case(1, (1.0,), (1.0,), (1.0,), ((0.4, 0.8, 0.02), (1.0, 0.5, 0.0)))
    many = case._replace(functions=5, bodies=tuple((round(k / 21, 6), 0.05, 0.0) for k in range(1, 21)))
    finer = finer_robot(_robot(many))
    assert finer
    assert of_sheet._work(finer) < of_sheet.MOST_WORK
    monkeypatch.setattr(of_sheet, "MOST_WORK", 0)
    found = vibrations(_robot(case))
    assert len(found.warnings) == 1
    assert [row["converged"] for row in found.states["locked"]] == [None] * 3


def test_functions_of_bodies_inside() -> None:
    """A point mass has a kink of the moment, a body that resists turning a jump too; no others change the beam."""
    bodies = (
        (0.0, 1.0, 0.1),
        (0.3, 1.0, 0.0),
        (0.6, 1.0, 0.1),
        (0.6004, 1.0, 0.0),
        (0.9995, 1.0, 0.1),
        (1.0, 1.0, 0.1),
    )
    beam: Any = _robot(_Case(2, (1.0,), (1.0,), (1.0,), bodies)).chain().nodes[-1].link
    assert beam.coordinates == ("bend_z1", "bend_z2", "bend_z101", "bend_z102", "bend_z103")
    assert not _robot(_Case(2, (1.0,), (1.0,), (1.0,), bodies[:1] + bodies[-1:])).chain().nodes[-1].link.stations()[1:]
