"""What is allowed and yet looks like a slip: a warning that names the place and the numbers."""

from __future__ import annotations

import math

import pytest

from sheet.cases import arm_of, beam, body, changed, joint, problem, sheet
from tmodes.io.sheet_plausible import implausible_numbers, reading_notices

QUINTIC = {"type": "quintic", "start": 0.0, "end": 1.0, "duration": 1.0}
STEEL = {"young": 210e9, "shear": 81e9, "density": 7850.0}
SWING = {"type": "sine", "amplitude": -45.0, "frequency": 1.0}
TUBE = {"shape": "tube", "outer_diameter": 0.03, "thickness": 0.002}


def drive(**signal) -> list:
    return [{"joint": "elbow", "command": "prescribed", "signal": {**QUINTIC, **signal}}]


def rail(**more) -> dict:
    """A prismatic elbow."""
    return {**joint("elbow", "fore"), "type": "prismatic", **more}


def of_tube(**moduli) -> dict:
    return beam(section=TUBE, material={**STEEL, **moduli})


NOTICES = [
    (lambda d: d["joints"][0].update(origin={"rpy": [0, 0, 90]}), "joints.shoulder.origin.rpy.2 = 90 rad", "deg"),
    (lambda d: d["links"][1]["bodies"][0].update(rpy=[-180, 0, 0]), "rpy.0 = -180 rad", "deg"),
    (lambda d: d.update(drives=drive(end=90.0)), "drives.0 (`elbow`).signal goes to 90 rad, 14.3 turns", "deg"),
    (lambda d: d.update(drives=[{**drive()[0], "signal": SWING}]), "signal goes to -45 rad", "deg"),
    (lambda d: d.update(gravity=9810), "gravity = 9810 m/s^2", "unit"),
    (lambda d: d.update(gravity=[20, 20, 20]), "gravity = 34.641 m/s^2", "outside the usual 0 to 30"),
    (lambda d: d["links"][0].update(beam=of_tube(shear=60e9)), "young/(2 shear) - 1 = 0.75", "-1 to 0.5"),
    (lambda d: d["links"][1]["bodies"][0].update(mass=3700.0 * 10), "mass = 37000 kg", "in g (factor 0.001)"),
    (lambda d: d["joints"].__setitem__(1, rail(limits={"upper": 600})), "limits.upper = 600 m", "mm (factor 0.001)"),
    (
        lambda d: (d["joints"].__setitem__(1, rail()), d.update(drives=drive(end=400.0))),
        "drives.0 (`elbow`).signal = 400 m",
        "mm (factor 0.001)",
    ),
    (lambda d: d["links"][0]["beam"].update(damping_time=-1e-4), "links.upper.beam.damping_time = -0.0001 s", "feeds"),
    (
        lambda d: d["joints"][0].update(
            gear={"stiffness": 50.0, "damping": -1.0}, motor={"side": "joint", "inertia": 0.1, "ratio": 1.0}
        ),
        "gear.damping = -1 N*m*s/rad is negative",
        "feeds energy",
    ),
    (lambda d: d["links"][0]["beam"].update(functions=0), "links.upper.beam is rigid", "0 functions"),
    (
        lambda d: d["links"][0].update(beam={**beam(), "model": "segments", "segments": 4, "functions": None}),
        "links.upper.beam has 4 segments",
        "do not converge",
    ),
    (
        lambda d: d["links"][0].update(beam={**beam(), "model": "segments", "segments": 40, "functions": None}),
        "the arm has 83 coordinates, more than 60",
        "takes long",
    ),
]


@pytest.mark.parametrize(("change", "which", "why"), NOTICES)
def test_notice(change, which: str, why: str) -> None:
    info = "\n".join(implausible_numbers(arm_of(changed(change))))
    assert which in info
    assert why in info


USUAL = [
    lambda d: d["joints"][0].update(origin={"rpy": [0, 0, -2 * math.pi]}),
    lambda d: d.update(drives=drive(start=-12.5, end=12.5)),
    lambda d: d.update(drives=[{**drive(end=90.0)[0], "command": "effort"}]),
    lambda d: d.update(gravity=24.8),
    lambda d: d["links"][0].update(beam=of_tube()),
    lambda d: d["joints"].__setitem__(1, rail(limits={"lower": -49, "upper": 49})),
    lambda d: d["links"][0].update(beam={**beam(), "model": "segments", "segments": 3, "functions": None}),
]


@pytest.mark.parametrize("change", USUAL)
def test_what_is_usual_is_not_doubted(change) -> None:
    assert implausible_numbers(arm_of(changed(change))) == []


def quaternion(length: float) -> list[str]:
    return reading_notices(arm_of(sheet(base={"quaternion": [0, 0, 0.6 * length, 0.8 * length]})))


def test_a_quaternion_of_seven_digits_is_worth_no_word() -> None:
    assert quaternion(1 + 9e-7) == []
    assert len(quaternion(1 + 2e-6)) == 1


def three(couplings) -> str:
    motor, gear = {"inertia": 0.1, "side": "joint"}, {"stiffness": 1000.0, "damping": 1.0}
    joints = [joint(name, f"{name}_link", axis=axis, motor=motor, gear=gear)
              for name, axis in (("a", [0, 0, 1]), ("b", [0, 1, 0]), ("c", [1, 0, 0]))]  # fmt: skip
    links = [{"name": f"{name}_link", "bodies": [body()]} for name in "abc"]
    return problem(sheet(joints=joints, links=links, couplings=couplings))


def test_couplings_by_which_motors_move_no_gear_are_refused() -> None:
    """Both gears turn by b + c: the motors b and -c together move none."""
    said = three({"b": {"b": 1.0, "c": 1.0}, "c": {"b": 1.0, "c": 1.0}})
    assert "couplings must be factors by which every motor moves a gear, got a singular matrix" in said
    assert "b 1, c -1" in said or "b -1, c 1" in said
    assert three({"b": {"b": 1.0, "c": 1.0}, "c": {"b": 1.0, "c": -1.0}}) == ""
    assert "singular" in three({"a": {}})


SAID = [
    (lambda d: d["links"][0]["beam"].update(functions=1.5), "functions must be a whole number"),
    (lambda d: d["links"][0]["beam"].update(length="-30 mm"), "length must be"),
    (lambda d: d["joints"][0].update(axis=[0, 1e-10, 0]), "axis of length 1e-10, which has no direction"),
    (lambda d: d["joints"][0].update(axis=[0, 0, 2e12]), "magnitude of at most 1e+12"),
    (lambda d: d["joints"][0]["motor"].pop("side"), "add the line `side: joint` or `side: motor`"),
]


@pytest.mark.parametrize(("change", "words"), SAID)
def test_message(change, words: str) -> None:
    assert words in problem(changed(change))
