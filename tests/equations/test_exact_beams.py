"""The exact frequencies that tests measure by: equal to reference values of an independent solver (14 digits)."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from equations.exact_beams import bending, rotating, torsion

BENDING: list[tuple[dict[str, Any], list[float]]] = [
    ({}, [3.5160152685002, 22.034491564667, 61.697214413549, 120.90191605231, 199.8595301168]),
    ({"mu": 0.1}, [2.967838346776, 19.355801009877, 55.518245548787, 110.70795445059, 185.3461056449]),
    ({"mu": 1, "j": 0.01}, [1.5436768034059, 13.239588559535, 32.069580810081, 66.828676229093, 124.41595128614]),
    ({"hub": 0.1}, [6.9639235527241, 22.980238966699, 62.025909275084, 121.06830119403, 199.95989214258]),
    ({"hub": 0}, [15.41820571698, 49.9648620318, 104.24769645886, 178.26972949461, 272.03097130503]),
]

TORSION = [
    (0.0, [1.5707963267949, 4.7123889803847, 7.8539816339745, 10.995574287564, 14.137166941154]),
    (1.0, [0.86033358901938, 3.4256184594817, 6.4372981791719, 9.529334405362, 12.645287223857]),
]

ROTATING: list[tuple[float, bool, float, list[float]]] = [
    (1, False, 0, [3.681646813958, 22.181011150583, 61.84176258716]),
    (2, False, 0, [4.1373195730254, 22.614921956504, 62.273184105672]),
    (12, False, 0, [13.170150487506, 37.603112331192, 79.614478489457]),
    (4, False, 1, [4.5429056631759, 23.02286722982, 59.293591480582]),
    (1, True, 0, [3.5432362696731, 22.15845788096, 61.833676907383]),
    (2, True, 0, [3.6217969641241, 22.526311173798, 62.241059266845]),
    (4, True, 1, [2.153599745662, 22.672724041939, 59.15851579161]),
]


@pytest.mark.parametrize(("ends", "expected"), BENDING)
def test_bending(ends: dict[str, Any], expected: list[float]) -> None:
    np.testing.assert_allclose([float(w) for w in bending(5, **ends)], expected, rtol=1e-12)


@pytest.mark.parametrize(("r", "expected"), TORSION)
def test_torsion(r: float, expected: list[float]) -> None:
    np.testing.assert_allclose([float(w) for w in torsion(5, r)], expected, rtol=1e-12)


@pytest.mark.parametrize(("speed", "lag", "mu", "expected"), ROTATING)
def test_rotating(speed: float, lag: bool, mu: float, expected: list[float]) -> None:
    """Series solutions of the rotating beam's equation; here 13 polynomials and Galerkin's method."""
    np.testing.assert_allclose(rotating(3, speed, lag=lag, mu=mu), expected, rtol=1e-8)
