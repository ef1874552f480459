"""What every robot of these elements must keep, whatever its numbers and wherever it stands."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from oracle.parameters import random_parameters, random_state
from tmodes.paper.environment import FrictionLaw
from tmodes.paper.mechanism import Drive, Mechanism, Parameters, Reading
from tmodes.paper.model import PaperModel
from tmodes.robots import load_robot

READINGS = list(Reading)
seeds = st.integers(0, 10**6)


def terms(seed, reading, contact=None, **override):
    """All terms of a random robot at a random state, and the state."""
    rng = np.random.default_rng(seed)
    symbols, (phi, phid, u) = random_parameters(rng), random_state(rng)
    phi, phid = override.get("phi", phi), override.get("phid", phid)
    numbers = dict(load_robot("filipovic2010").numbers())
    for k in (1, 2):
        numbers[f"link.modes.{k - 1}.length"] = symbols[f"l{k}"]
        numbers[f"link.modes.{k - 1}.bending_stiffness"] = symbols[f"EI{k}"]
        numbers[f"link.modes.{k - 1}.mass_per_length"] = symbols[f"w{k}"]
    numbers |= {"payload.mass": symbols["m"], "payload.inertia": symbols["Jzz"], "gear.stiffness": symbols["Cxi"]}
    parameters = Parameters(tuple(numbers), np.array(list(numbers.values())))
    found = PaperModel(Mechanism(reading, contact, Drive.VOLTAGE)).evaluate(phi, phid, [u], parameters)
    return {name: value[0] for name, value in found.items()}, phi, phid


@pytest.mark.parametrize("reading", READINGS)
@given(seed=seeds)
def test_mass_matrix_is_symmetric_and_positive(reading, seed):
    """H = H^T > 0, and the kinetic energy is its quadratic form."""
    found, _, phid = terms(seed, reading)
    mass = found["H"]
    assert np.abs(mass - mass.T).max() <= 1e-14 * np.abs(mass).max()
    assert np.linalg.eigvalsh(mass)[0] > 0
    assert phid @ mass @ phid / 2 == pytest.approx(found["kinetic"], rel=1e-12)


@pytest.mark.parametrize("reading", READINGS)
@given(seed=seeds)
def test_springs_store_and_dampers_lose(reading, seed):
    """Stored energy and Rayleigh function are never negative, and zero in the undeformed, unmoved arm."""
    found, _, phid = terms(seed, reading)
    assert found["potential_elastic"] >= 0
    assert found["rayleigh"] >= 0
    assert found["f_di"] @ phid == pytest.approx(2 * found["rayleigh"], rel=1e-10)
    rest, _, _ = terms(seed, reading, phi=np.array([0.3, 0, 0.3, 0, 0, 0.3]), phid=np.zeros(6))
    assert rest["potential_elastic"] <= 1e-20
    assert rest["rayleigh"] == 0
    assert np.abs(rest["f_el"]).max() <= 1e-10


@pytest.mark.parametrize("reading", READINGS)
@given(seed=seeds)
def test_free_motion_keeps_the_balance(reading, seed):
    """d(energy)/dt = motor's power - losses, at any state: H phi'' + … projected on the rates."""
    found, phi, phid = terms(seed, reading)
    phidd = found["phidd"]

    def slope(step):
        ahead, behind = (
            terms(seed, reading, phi=phi + h * phid + h**2 / 2 * phidd, phid=phid + h * phidd)[0]["energy"]
            for h in (step, -step)
        )
        return (ahead - behind) / (2 * step)

    step = min(1e-5, 0.03 / np.abs(phidd).max())
    rate = (4 * slope(step / 2) - slope(step)) / 3
    power = found["Q"] @ phid - 2 * found["rayleigh"]
    scale = abs(found["f_el"] @ phid) + abs(power) + abs(phid @ found["H"] @ found["phidd"])
    assert rate == pytest.approx(power, abs=2e-6 * scale)


@pytest.mark.parametrize("reading", READINGS)
@given(seed=seeds, turn=st.floats(-3, 3))
def test_the_base_may_turn(reading, seed, turn):
    """Nothing but directions depends on where the base faces: gravity is along z."""
    found, phi, phid = terms(seed, reading, FrictionLaw.SIGNED)
    turned, _, _ = terms(seed, reading, FrictionLaw.SIGNED, phi=phi + turn * np.array([1, 0, 1, 0, 0, 1]), phid=phid)
    for name in ("H", "h", "f_el", "f_di", "kinetic", "energy"):
        assert turned[name] == pytest.approx(found[name], abs=1e-9 * (1 + np.abs(found[name]).max())), name
    if reading is Reading.CONSISTENT:  # the print's map of the contact force counts F_x twice: it sees the direction
        assert turned["phidd"] == pytest.approx(found["phidd"], abs=1e-7 * np.abs(found["phidd"]).max())


@given(seed=seeds)
def test_magnitude_friction_takes_power(seed):
    """mu |Fc| always takes power; the normal part is what it was."""
    found, _, phid = terms(seed, Reading.CONSISTENT, FrictionLaw.MAGNITUDE)
    velocity, force = found["J"] @ phid, found["F_tip_on_environment"]
    normal = found["tip"] / np.linalg.norm(found["tip"])
    radial = force @ normal
    mu, veps = 0.1, 1e-3
    slip = mu * velocity / np.sqrt(velocity @ velocity + veps**2)
    # F = Fc n + |Fc| slip, so F.n = Fc + |Fc| slip.n: solve for Fc with the sign that fits.
    sign = np.sign(radial)
    radial /= 1 + sign * (slip @ normal)
    assert force == pytest.approx(radial * normal + abs(radial) * slip, abs=1e-9 * (1 + np.abs(force).max()))
    taken = (force - radial * normal) @ velocity
    assert taken > 0
