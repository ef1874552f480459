"""Every term of the equations equals reference values and an oracle that were computed independently.

Three makers of equations: both readings as Lagrangian systems, and the recursion, which has the consistent one.
"""

from __future__ import annotations

import numpy as np
import pytest

from lagrange.robot2010 import STATES, close, terms
from oracle.oracle import Reading, oracle
from oracle.parameters import random_parameters, random_state

READINGS: dict[str, Reading] = {"printed": "printed", "consistent": "consistent", "recursion": "consistent"}
CASES = [(equations, kind) for equations in READINGS for kind in ("free", "contact")]


@pytest.mark.parametrize(("equations", "kind"), CASES)
def test_samples(equations, kind):
    """H, h, forces, tip, Jacobian, energies, accelerations and contact force at every reference state."""
    for record in STATES["readings"][READINGS[equations]][kind]:
        found = terms(equations, record["phi"], record["phid"], record["u"], contact=kind == "contact")
        assert found.keys() == record.keys() - {"phi", "phid", "u"}
        for name, value in found.items():
            close(value, record[name])


@pytest.mark.parametrize(("equations", "kind"), CASES)
@pytest.mark.parametrize("law", ["signed", "magnitude"])
def test_random_robots_and_states(equations, kind, law):
    """The same at robots and states drawn at random, both friction laws, either sign of the contact force."""
    rng = np.random.default_rng(20100401)
    signs, touched = set(), kind == "contact"
    for _ in range(25 if touched else 10):
        p, (phi, phid, u) = random_parameters(rng), random_state(rng)
        wanted = oracle(phi, phid, u, p, READINGS[equations], touched, friction=law)
        found = terms(equations, phi, phid, u, p, contact=touched, law=law)
        condition = np.linalg.cond(wanted["H"])
        for name, value in found.items():
            if name in ("phidd", "F_tip_on_environment"):  # an acceleration is in both
                close(value, wanted[name], 2e-9 if touched else max(1e-12, 1e-14 * condition))
            else:
                close(value, wanted[name], 1e-11 if name == "f_di" else 1e-12)
        if touched:
            signs.add(bool(found["F_tip_on_environment"] @ found["tip"] > 0))
    assert signs == ({True, False} if touched else set())
