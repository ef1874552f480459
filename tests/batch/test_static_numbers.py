"""Static numbers of many cases at once: closed forms, and the same cases by themselves."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from tmodes.analysis.describe.describe import describe
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_data
from tmodes.simulation.vary import static_numbers as module
from tmodes.simulation.vary.static_numbers import static_numbers

WEAK = 1e-3
"""Gravity [m/s^2] so weak that the arm is linear."""


def arm(payload=1.5, per_length=1.5e-4, functions=4, gravity=WEAK):
    """A horizontal arm of 1 m on a spring; its motor stands."""
    held = {"type": "constant", "value": 0.0}
    section = {"bending_stiffness": 150.0, "mass_per_length": per_length}
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "arm", "gravity": gravity,
        "joints": [{
            "name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 1, 0],
            "motor": {"side": "joint", "inertia": 1.0}, "gear": {"stiffness": 2000.0, "damping": 0.0},
        }],
        "links": [{
            "name": "link", "bodies": [{"name": "payload", "mass": payload, "at": 1.0}],
            "beam": {
                "model": "strain", "functions": {"bend_y": functions}, "length": 1.0, "damping_time": 0.0,
                "rotary_inertia": "none", "section": section,
            },
        }],
        "drives": [{
            "joint": "joint", "command": "position", "signal": held,
            "controller": {"type": "pd", "position_gain": 1e5, "velocity_gain": 1e3},
        }],
    })  # fmt: skip


SPRING, BENDING = "joints.joint.gear.stiffness", "links.link.beam.section.bending_stiffness"
MASS = "links.link.bodies.payload.mass"
NAMES = ("sag", "sag.x", "sag.y", "sag.z", "frequency.locked.1", "mass", "mass.links", "mass.link")


@pytest.fixture(scope="module")
def drawn():
    generator, count = np.random.default_rng(1), 200
    return {
        SPRING: generator.uniform(1600, 2400, count),
        MASS: generator.uniform(1.2, 1.8, count),
        BENDING: generator.uniform(140, 160, count),
    }


def test_closed_forms_of_the_lumped_arm(drawn):
    """c = L^2/k + L^3/(3 EI), f1 = 1/(2 pi sqrt(m c)), sag = m g c; of a beam with a ten-thousandth of the payload."""
    found = static_numbers(arm(), drawn, NAMES)
    stiffness, mass, bending = drawn.values()
    compliance = 1 / stiffness + 1 / (3 * bending)
    assert tuple(found.status) == ("finished",) * 200
    assert found.values["sag"] == pytest.approx(mass * WEAK * compliance, rel=2e-4)
    assert found.values["sag.z"] == pytest.approx(-mass * WEAK * compliance, rel=2e-4)
    assert found.values["frequency.locked.1"] == pytest.approx(1 / (2 * np.pi * np.sqrt(mass * compliance)), rel=2e-4)
    assert found.values["mass"] == pytest.approx(mass + 1.5e-4, rel=1e-12)
    assert found.values["mass.links"] == pytest.approx(1.5e-4, rel=1e-12)
    assert [found.units[name] for name in NAMES] == ["m", "m", "m", "m", "Hz", "kg", "kg", "kg"]


@pytest.mark.parametrize(
    ("stiffness", "payload", "bending", "frequency", "sag"),
    [
        (1600.0, 1.05, 150.0, 2.7195773844944693, 0.036072187500000005),
        (2400.0, 1.95, 120.0, 1.9440731246073224, 0.068465625),
    ],
)
def test_reference_of_the_beam_with_mass(stiffness, payload, bending, frequency, sag):
    """Exact root of Euler and Bernoulli, and m g c + rhoA g (L^3/2k + L^4/8EI); the least of many cases at once."""
    spread = np.linspace(1.0, 1.2, 40)
    vary = {SPRING: stiffness * spread, MASS: payload * spread, BENDING: bending * spread}
    found = static_numbers(arm(per_length=0.6, functions=6), vary, ("sag", "frequency.locked.1"))
    assert found.values["sag"][0] == pytest.approx(sag * WEAK / 9.81, rel=1e-6)
    assert found.values["frequency.locked.1"][0] == pytest.approx(frequency, rel=1e-6)


def test_as_sheet_by_sheet(drawn, monkeypatch):
    """Under its whole weight, which stiffens or softens it; and two modes."""
    robot, names = arm(gravity=9.81, per_length=0.6), (*NAMES, "frequency.locked.2")
    found = static_numbers(robot, drawn, names)
    monkeypatch.setattr(module, "_FEW", 10**9)
    some = {path: values[:5] for path, values in drawn.items()}
    true = static_numbers(robot, some, names)
    for name in names:
        assert found.values[name][:5] == pytest.approx(true.values[name], rel=1e-9, abs=1e-12), name
    case = robot.with_({path: float(values[2]) for path, values in drawn.items()})
    info = describe(case)
    assert found.values["sag"][2] == pytest.approx(info["sag"]["displacement_size_m"], rel=1e-9)
    assert found.values["mass"][2] == pytest.approx(info["total_mass_kg"], rel=1e-12)
    modes = sheet_frequencies(case)["locked"]
    assert found.values["frequency.locked.2"][2] == pytest.approx(modes[1]["frequency_Hz"], rel=1e-9)


def test_dimensions_of_sections_are_curves(monkeypatch):
    """The wall of a tube over a wide range, with a payload: all cases at once, as sheet by sheet."""
    data = sheet_data(arm(gravity=9.81, functions=3))
    data["links"][0]["beam"] |= {
        "section": {"shape": "tube", "outer_diameter": 0.04, "thickness": 0.002},
        "material": {"young": 70e9, "shear": 26e9, "density": 2700.0},
    }
    robot, generator = tmodes.Robot.from_data(data), np.random.default_rng(3)
    wall = "links.link.beam.section.thickness"
    vary = {wall: generator.uniform(5e-4, 1e-2, 200), MASS: generator.uniform(1.2, 1.8, 200)}
    with monkeypatch.context() as patched:
        patched.delattr(module._Rows, "_one")  # no case goes by itself
        found = static_numbers(robot, vary, NAMES)
    monkeypatch.setattr(module, "_FEW", 10**9)
    true = static_numbers(robot, {path: values[:5] for path, values in vary.items()}, NAMES)
    for name in NAMES:
        assert found.values[name][:5] == pytest.approx(true.values[name], rel=1e-9, abs=1e-12), name


def test_first_frequency_of_a_summary():
    """In contact: sheet by sheet."""
    robot = tmodes.load("filipovic2010").with_({"integration.duration": 0.01, "integration.output_step": 1e-3})
    found = static_numbers(robot, {"payload.mass": [0.4, 0.5]}, ("frequency.locked.1",))
    true = tmodes.run(robot).frequencies["locked"][0]["undamped_frequency_Hz"]
    assert found.values["frequency.locked.1"][1] == pytest.approx(true, rel=1e-9)


def test_masses_alone_need_no_rest(drawn):
    found = static_numbers(arm(), drawn, ("mass.link",))
    assert found.values["mass.link"] == pytest.approx(drawn[MASS] + 1.5e-4, rel=1e-12)


def test_modes_that_there_are_not(drawn):
    found = static_numbers(arm(functions=2), drawn, ("frequency.locked.3", "frequency.locked.9"))
    assert np.isfinite(found.values["frequency.locked.3"]).all()
    assert np.isnan(found.values["frequency.locked.9"]).all()


def test_wrong_cases(drawn):
    vary = drawn | {MASS: np.where(np.arange(200) == 77, -1.0, drawn[MASS])}
    with pytest.raises(InputErrors, match="case 77"):
        static_numbers(arm(), vary, ("sag",))
    found = static_numbers(arm(), vary, ("sag",), wrong="row")
    assert found.ended("refused").tolist() == [77]
    assert np.flatnonzero(np.isnan(found.values["sag"])).tolist() == [77]


def test_unknown_names():
    with pytest.raises(InputError, match=r"Did you mean `sag\.z`"):
        static_numbers(arm(), {MASS: [1.0]}, ("sag.zz",))
    with pytest.raises(InputError, match="at least one"):
        static_numbers(arm(), {MASS: [1.0]}, ())
