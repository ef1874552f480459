"""Two independent derivations, SymPy's and the numeric oracle, at random states of random robots."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from .oracle import Reading, oracle
from .parameters import random_parameters, random_state

sympy = pytest.importorskip("sympy")


@pytest.mark.peer
@pytest.mark.parametrize("contact", [False, True])
@pytest.mark.parametrize("reading", get_args(Reading))
def test_sympy_agrees_with_the_oracle(reading: Reading, contact: bool) -> None:
    from benchmarks.peers import sympy_robot as peer

    derived = peer.derive(reading, contact)
    terms = [derived.H, derived.h, derived.f_el, derived.f_di, derived.Q, *derived.system()]
    names = list(set(peer.NAMES) - {"Klp", "Klv"})
    evaluate = sympy.lambdify([peer.PHI, peer.RATES, peer.VOLTAGE, [peer.P[n] for n in names]], terms, "numpy")
    for seed in range(5):
        rng = np.random.default_rng(seed)
        p, (phi, v, u) = random_parameters(rng), random_state(rng)
        wanted = oracle(phi, v, u, p, reading, contact)
        *found, left, right = evaluate(phi, v, u, [p[n] for n in names])
        values: dict[str, np.ndarray] = dict(zip(("H", "h", "f_el", "f_di", "Q"), found, strict=True))
        values["phidd"] = np.linalg.solve(left, right)
        for field, value in values.items():
            scale = np.max(np.abs(wanted[field]))
            assert np.max(np.abs(np.squeeze(value) - wanted[field])) <= 1e-10 * scale, (field, seed)
