"""What the page finds modes with: eigenvalues of small vibrations, and assignments, against NumPy and SciPy."""

from __future__ import annotations

import json
import shutil
import subprocess
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from .node import ESBUILD, WEB

PROGRAM = """
import {{ damped, undamped }} from "{web}/src/live/eigen";
import {{ inverted }} from "{web}/src/live/linear";
import {{ assigned }} from "{web}/src/live/partners";
const {{ systems, cost, rows, columns }} = {given};
const array = (values) => Float64Array.from(values.flat());
const found = systems.map(({{ mass, damping, stiffness }}) => {{
  const n = mass.length;
  const still = undamped(array(mass), array(stiffness), n);
  const {{ values, shapes }} = damped(array(mass), array(damping), array(stiffness), n, still);
  const info = {{
    squares: still.squares, still: still.shapes, re: values.re, im: values.im, real: shapes.re, imaginary: shapes.im,
    inverse: inverted(array(mass), n),
  }};
  return Object.fromEntries(Object.entries(info).map(([name, one]) => [name, [...one]]));
}});
process.stdout.write(JSON.stringify({{ found, partners: assigned(array(cost), rows, columns) }}));
"""
ROWS, COLUMNS = 17, 30
LOW = 5
"""Motions that a page shows are low ones; the fastest are known to fewer digits, here as natively."""

Array = NDArray[np.float64]


def matrices(kind: str) -> dict[str, Array]:
    """Masses and springs whose squared frequencies are five decades apart.

    ``turned``: with forces that follow, K is not symmetric; ``loose``: one motion has no spring.
    """
    generator = np.random.default_rng(2)
    n = 9
    mixed = np.eye(n) + 0.3 * generator.standard_normal((n, n))
    stiffness = mixed.T @ np.diag(np.logspace(0, 5, n)) @ mixed
    if kind == "turned":
        stiffness = (
            mixed.T @ np.diag(np.logspace(0, 5, n)) @ (np.eye(n) + np.triu(generator.uniform(0, 0.1, (n, n)))) @ mixed
        )
    if kind == "loose":
        stiffness = mixed.T @ np.diag([0.0, *np.logspace(1, 5, n - 1)]) @ mixed
    mass = np.eye(n) + 0.1 * mixed @ mixed.T
    return {"mass": mass, "damping": 1e-3 * stiffness + np.diag(generator.uniform(0, 2, n)), "stiffness": stiffness}


@pytest.fixture(scope="module")
def given() -> dict[str, Any]:
    cost = np.random.default_rng(4).uniform(-10, 10, (ROWS, COLUMNS))
    return {"systems": [matrices(kind) for kind in ("stiff", "turned", "loose")], "cost": cost}


@pytest.fixture(scope="module")
def info(given: dict[str, Any], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    node = shutil.which("node")
    if node is None or not ESBUILD.exists():
        pytest.skip("needs Node and the packages of the pages: npm ci in web/")
    folder = tmp_path_factory.mktemp("eigen")
    whole = json.dumps(given | {"rows": ROWS, "columns": COLUMNS}, default=lambda array: array.tolist())
    (folder / "entry.ts").write_text(PROGRAM.format(web=WEB.as_posix(), given=whole))
    how = [ESBUILD, "entry.ts", "--bundle", "--format=esm", "--outfile=entry.mjs"]
    subprocess.run(how, check=True, capture_output=True, cwd=folder)
    done = subprocess.run([node, "entry.mjs"], check=True, capture_output=True, cwd=folder)
    return json.loads(done.stdout)


def test_squares_of_the_frequencies_are_those_of_numpy(given: dict[str, Any], info: dict[str, Any]) -> None:
    """Where K is positive definite the low ones have all digits; else each is as rounding of the largest leaves it."""
    stiff, *others = zip(given["systems"], info["found"], strict=True)
    inverse = np.linalg.eigvals(np.linalg.solve(stiff[0]["stiffness"], stiff[0]["mass"])).real
    assert stiff[1]["squares"][:LOW] == pytest.approx(np.sort(1 / inverse)[:LOW], rel=1e-9)
    for system, found in others:
        true = np.sort(np.linalg.eigvals(np.linalg.solve(system["mass"], system["stiffness"])).real)
        assert np.abs(np.array(found["squares"]) - true).max() < 1e-13 * true.max()


def test_shapes_have_unit_modal_mass_and_solve_the_equations(given: dict[str, Any], info: dict[str, Any]) -> None:
    for system, found in zip(given["systems"], info["found"], strict=True):
        n = len(system["mass"])
        shapes, squares = np.reshape(found["still"], (n, n))[:, :LOW], np.array(found["squares"])[:LOW]
        left = system["mass"] @ shapes * squares - system["stiffness"] @ shapes
        assert np.abs(left).max() < 1e-13 * np.abs(system["stiffness"]).max()
        assert np.einsum("ik,ij,jk->k", shapes, system["mass"], shapes) == pytest.approx(np.ones(LOW), rel=1e-9)


def test_damped_motions_solve_their_equations(given: dict[str, Any], info: dict[str, Any]) -> None:
    """(M s^2 + D s + K) x = 0 for the slow motions, as rounding of K leaves it; and no eigenvalue is missing."""
    for system, found in zip(given["systems"], info["found"], strict=True):
        n = len(system["mass"])
        values = np.array(found["re"]) + 1j * np.array(found["im"])
        slow = np.argsort(np.abs(values))[:LOW]
        shapes = (np.reshape(found["real"], (n, 2 * n)) + 1j * np.reshape(found["imaginary"], (n, 2 * n)))[:, slow]
        parts = [system[name] @ shapes * values[slow] ** k for k, name in enumerate(("stiffness", "damping", "mass"))]
        left = np.abs(np.sum(parts, axis=0)).max(axis=0) / np.abs(shapes).max(axis=0)
        assert left.max() < 1e-13 * np.abs(system["stiffness"]).max()
        mass, damping, stiffness = (np.asarray(system[name]) for name in ("mass", "damping", "stiffness"))
        blocks = [
            [np.zeros_like(mass), np.eye(len(mass))],
            [-np.linalg.solve(mass, one) for one in (stiffness, damping)],
        ]
        true = np.linalg.eigvals(np.block(blocks))
        assert len(values) == 2 * n
        assert np.abs(values.sum() - true.sum()) < 1e-6 * np.abs(true).max()


def test_inverse_is_that_of_numpy(given: dict[str, Any], info: dict[str, Any]) -> None:
    for system, found in zip(given["systems"], info["found"], strict=True):
        assert found["inverse"] == pytest.approx(np.linalg.inv(system["mass"]).ravel(), rel=1e-10, abs=1e-12)


def test_assignment_costs_the_least(given: dict[str, Any], info: dict[str, Any]) -> None:
    rows, columns = linear_sum_assignment(given["cost"])
    assert len(set(info["partners"])) == ROWS
    assert given["cost"][range(ROWS), info["partners"]].sum() == pytest.approx(given["cost"][rows, columns].sum())
