"""Every term of the equations equals reference values and an oracle that were computed independently."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from oracle.oracle import oracle
from oracle.parameters import random_parameters, random_state
from tmodes.paper.environment import FrictionLaw
from tmodes.paper.mechanism import Drive, Mechanism, Reading
from tmodes.paper.model import PaperModel

STATES = json.loads((Path(__file__).parents[1] / "oracle/reference_states.json").read_text())
CASES = [(reading, kind) for reading in ("printed", "consistent") for kind in ("free", "contact")]


def model_of(reading: str, kind: str, law: FrictionLaw = FrictionLaw.SIGNED) -> PaperModel:
    return PaperModel(Mechanism(Reading(reading), law if kind == "contact" else None, Drive.VOLTAGE))


def assert_equal(found, wanted, names, tolerance=1e-9):
    for name in names:
        value, reference = np.asarray(found[name]), np.asarray(wanted[name])
        assert value.shape == reference.shape, name
        scale = np.abs(reference).max() or 1.0
        assert np.abs(value - reference).max() <= tolerance * scale, name


@pytest.mark.parametrize(("reading", "kind"), CASES)
def test_samples(reading, kind, to_parameters):
    """H, h, forces, tip, Jacobian, energies, accelerations and contact force at every reference state."""
    records = STATES["readings"][reading][kind]
    phi, phid, u = ([record[key] for record in records] for key in ("phi", "phid", "u"))
    found = model_of(reading, kind).evaluate(phi, phid, u, to_parameters(STATES["parameters"]))
    for index, record in enumerate(records):
        names = [name for name in found if name in record]
        assert len(names) >= 13
        assert_equal({name: found[name][index] for name in names}, record, names)


@pytest.mark.parametrize(("reading", "kind"), CASES)
@pytest.mark.parametrize("law", list(FrictionLaw))
def test_random_robots_and_states(reading, kind, law, to_parameters):
    """The same at robots and states drawn at random, both friction laws, either sign of the contact force."""
    rng = np.random.default_rng(20100401)
    model, signs = model_of(reading, kind, law), set()
    for _ in range(40):
        symbols, (phi, phid, u) = random_parameters(rng), random_state(rng)
        wanted = oracle(phi, phid, u, symbols, reading, kind == "contact", friction=law.value)
        found = {name: value[0] for name, value in model.evaluate(phi, phid, [u], to_parameters(symbols)).items()}
        names = [name for name in found if name in wanted]
        assert_equal(found, wanted, names, 2e-9)
        if kind == "contact":
            signs.add(bool(found["F_tip_on_environment"] @ found["tip"] > 0))
    assert signs == ({True, False} if kind == "contact" else set())
