"""What is told of an arm: masses, exact frequencies of bare beams, sag, stiffness, doubts."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tmodes.analysis.arm_modes_sheet import servos_of, sheet_modes
from tmodes.analysis.describe import describe
from tmodes.analysis.describe_bare import bare_beam
from tmodes.analysis.equilibrium_arm import arm_rest, first_commands
from tmodes.arm_model import ArmModel
from tmodes.chain import Beam, BeamPiece
from tmodes.robots.load import load_sheet


def taper(mass: float) -> Beam:
    """A beam of stepped stiffness (4, 1) and even mass."""
    pieces = [BeamPiece(end, (k, k), (k, k), (k, k), (0.0, 0.0), (mass, mass), ((0.3, 0.3), (0.0, 0.0), (0.0, 0.0)))
              for end, k in ((0.5, 4.0), (1.0, 1.0))]  # fmt: skip
    return Beam(2.0, tuple(pieces), bend_y=3)


def test_bare_beam_of_one_section():
    """beta^2 sqrt(EI/rhoA)/L^2 and (pi/2) sqrt(GJ/rhoIp)/L; tip compliance L^3/3EI."""
    piece = BeamPiece(
        1.0, (6.0, 6.0), (24.0, 24.0), (3.0, 3.0), (0.0, 0.0), (1.5, 1.5), ((0.3, 0.3), (0.0, 0.0), (0.0, 0.0))
    )
    found = bare_beam(Beam(2.0, (piece,), bend_y=3))
    first = 1.8751040687119611**2 * np.sqrt(6.0 / 1.5) / 2.0**2 / (2 * np.pi)
    assert found.bend_y_Hz == pytest.approx(first, rel=1e-10)
    assert found.bend_z_Hz == pytest.approx(2 * first, rel=1e-10)
    assert found.twist_Hz == pytest.approx(np.sqrt(3.0 / 0.3) / 2.0 / 4, rel=1e-10)
    assert found.mass == pytest.approx(3.0)
    assert found.compliance == pytest.approx((8 / 18, 8 / 72))


def test_bare_beam_of_two_sections():
    """Tip compliance by hand: (L^3 - (L/2)^3)/3EI1 + (L/2)^3/3EI2."""
    assert bare_beam(taper(1.0)).compliance[0] == pytest.approx(7 / 12 + 1 / 3)


def test_two_link_arm():
    """Printed lengths and stiffnesses; the tip's compliance 7/8 and 1/8 in the two links."""
    told = describe(load_sheet("deluca_siciliano1991"))  # pyright: ignore
    json.dumps(told, allow_nan=False)
    assert told["total_mass_kg"] == pytest.approx(2.3)
    bare = 1.8751040687119611**2 * np.sqrt(1.0 / 0.2) / 0.5**2 / (2 * np.pi)
    assert [link["bare_bend_z_Hz"] for link in told["links"]] == pytest.approx([bare, bare], rel=1e-9)
    assert [joint["kind"] for joint in told["joints"]] == ["AR", "AR"]
    y = told["stiffness"]["directions"][1]
    assert y["stiffness"] == pytest.approx(3.0)
    assert y["shares"]["upper_arm.bend_z"] == pytest.approx(7 / 8)
    assert told["sag"]["displacement_size_m"] == pytest.approx(0.0, abs=1e-12)
    assert told["warnings"] == []


def test_single_elastic_joint():
    """100 N*m/rad, 1 kg at 1 m that hangs: locked w^2 = 100 + 9.8."""
    arm = load_sheet("spong1987")
    model = ArmModel(arm.chain())  # pyright: ignore
    assert first_commands(arm, model) == {"joint.motor": 0.0}  # pyright: ignore
    told = describe(arm)  # pyright: ignore
    assert told["gears"][0]["stiffness"] == [100.0]
    assert told["joints"][0]["kind"] == "AE"
    assert servos_of(arm, model)["joint.motor"] == (80.0, 12.0)  # pyright: ignore
    modes = sheet_modes(arm)  # pyright: ignore
    assert set(modes) == {"locked", "free", "controlled"}
    assert 2 * np.pi * modes["locked"][0]["frequency_Hz"] == pytest.approx(np.sqrt(109.8), rel=1e-9)


def test_doubts():
    """A gear a thousand times too soft sags far, past its joint's limits."""
    arm = load_sheet("spong1987", {"joints.joint.limits": {"lower": -0.1, "upper": 0.1},
                                   "joints.joint.gear.stiffness": 5.0, "drives.0.signal.start": 0.5})  # fmt: skip
    warnings = describe(arm)["warnings"]  # pyright: ignore
    assert any("joint joint stands at" in told for told in warnings)
    rest = arm_rest(arm)  # pyright: ignore
    gamma = rest.named["joint"]
    assert 5.0 * (0.5 - gamma) == pytest.approx(9.8 * np.sin(gamma), abs=1e-9)
