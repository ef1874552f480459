"""The oracle against reference values computed independently, and against the laws that energies must obey."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest

from . import energies
from .oracle import STEP, Reading, oracle, second_along
from .parameters import random_parameters, random_state, with_equivalents

DATA = json.loads((Path(__file__).parent / "reference_states.json").read_text(encoding="utf-8"))
READINGS: tuple[Reading, ...] = get_args(Reading)
CASES = [
    pytest.param(reading, kind, record, id=f"{reading}-{kind}-{number}")
    for reading in READINGS
    for kind in ("free", "contact")
    for number, record in enumerate(DATA["readings"][reading][kind])
]


@pytest.mark.parametrize(("reading", "kind", "record"), CASES)
def test_reference_states(reading: Reading, kind: str, record: dict[str, Any]) -> None:
    found = oracle(record["phi"], record["phid"], record["u"], DATA["parameters"], reading, kind == "contact")
    assert set(found) == set(record) - {"phi", "phid", "u"}
    for field, value in found.items():
        scale = np.max(np.abs(record[field]))
        assert np.max(np.abs(np.asarray(record[field]) - value)) <= 1e-12 * scale, field


def test_equivalents_of_the_example() -> None:
    known = DATA["parameters"]
    links = {name: known[name] for name in ("l1", "l2", "EI1", "EI2", "w1", "w2")}
    found = with_equivalents({**links, "eta1": 2e-4, "eta2": 2e-4})
    for j in "12":
        assert [found[f"{n}{j}"] for n in ("mel", "Jel", "Cs", "Bs")] == pytest.approx(
            [known[n] for n in (f"mel{j}", f"Jel{j}", f"Cs{j}o", f"Bs{j}o")], rel=1e-13
        )


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("seed", range(20))
def test_power_balance_of_random_robots(reading: Reading, seed: int) -> None:
    """d(energy)/dt = power of the motor less the losses: it fails for errors in h and f_el that do work."""
    rng = np.random.default_rng(seed)
    p, (phi, v, u) = random_parameters(rng), random_state(rng)
    full = reading == "consistent"
    found = oracle(phi, v, u, p, reading, contact=full)
    x, w = phi + 1j * STEP * v, v + 1j * STEP * found["phidd"]
    energy = energies.kinetic(x, w, p, full) + energies.gravity(x, p) + energies.elastic(x, p, full)
    power = v @ (found["Q"] - found["f_di"]) - (found["F_tip_on_environment"] @ found["J"] @ v if full else 0.0)
    scale = np.abs(v) @ np.abs(found["f_el"]) + np.abs(found["kinetic"])
    assert np.imag(energy) / STEP == pytest.approx(power, abs=1e-9 * scale)
    assert 2.0 * found["rayleigh"] == pytest.approx(v @ found["f_di"], rel=1e-11)


@pytest.mark.parametrize("seed", range(10))
def test_mass_matrix_is_symmetric_positive(seed: int) -> None:
    rng = np.random.default_rng(seed)
    p, (phi, v, u) = random_parameters(rng), random_state(rng)
    for reading in READINGS:
        mass = oracle(phi, v, u, p, reading, contact=False)["H"]
        assert mass == pytest.approx(mass.T, abs=1e-14 * np.max(mass))
        assert np.min(np.linalg.eigvalsh(mass)) > 0.0


def test_readings_agree_without_elevation() -> None:
    """As long as the arm moves in the plane z = 0 the printed reading drops nothing."""
    rng = np.random.default_rng(3)
    p, (phi, v, _) = random_parameters(rng), random_state(rng)
    phi[3:5], v[3:5] = 0.0, 0.0
    one, two = (oracle(phi, v, 5.0, p, reading, contact=False) for reading in READINGS)
    for field in ("H", "h", "f_el", "f_di", "phidd", "kinetic"):
        assert one[field] == pytest.approx(two[field], rel=1e-12, abs=1e-11), field


@pytest.mark.parametrize("seed", range(10))
def test_tip_force_is_the_stated_formula(seed: int) -> None:
    rng = np.random.default_rng(seed)
    p, (phi, v, u) = random_parameters(rng) | {"me": 0.05, "mu": 0.2}, random_state(rng)
    for friction in ("signed", "magnitude"):
        found = oracle(phi, v, u, p, "consistent", True, friction)
        force, normal = found["F_tip_on_environment"], found["tip"] / np.linalg.norm(found["tip"])
        velocity = found["J"] @ v
        slide = velocity / np.sqrt(velocity @ velocity + p["veps"] ** 2)
        acceleration = found["J"] @ found["phidd"] + second_along(lambda x: energies.tip(x, p), phi, v)
        kappa, rate = np.linalg.norm(found["tip"]), normal @ velocity
        bend = normal @ acceleration + (velocity @ velocity - rate**2) / kappa
        radial = p["me"] * bend + p["be"] * rate + p["Fc0"] + p["ka1"] * (kappa - p["l1"] - p["l2"])
        weight = radial if friction == "signed" else abs(radial)
        assert force == pytest.approx(radial * normal + p["mu"] * weight * slide, rel=1e-9, abs=1e-9)
        taken = (force - radial * normal) @ velocity
        assert np.sign(taken) == np.sign(weight)


def test_second_derivative_along_a_line() -> None:
    found = second_along(lambda x: np.array([np.cos(x[0]), x[1] ** 3]), np.full(6, 0.7), np.arange(6.0) + 2.0)
    assert found == pytest.approx([-4.0 * np.cos(0.7), 9.0 * 6.0 * 0.7], rel=1e-13)
