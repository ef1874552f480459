"""Two dimensions of a section, or more, drawn together: all cases at once, with the numbers of their own sheets."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from tmodes.simulation.vary import arrays, simulate
from tmodes.simulation.vary import static_numbers as statics
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.static_numbers import static_numbers
from tmodes.simulation.vary.values import Whole

TUBE = {"shape": "tube", "outer_diameter": 0.04, "thickness": 0.002}
HOLLOW = {"shape": "box", "width": 0.03, "height": 0.02, "thickness": 0.0015}
I_BEAM = {"shape": "i_beam", "width": 0.03, "height": 0.04, "flange_thickness": 0.003, "web_thickness": 0.002}
NAMES = ("sag", "frequency.locked.1", "mass", "mass.links")
PEAK = Reduction("tip.speed", "max")


def arm(section, links=1):
    """Links of 1 m on springs, each with a payload, that move up from their rest."""
    names = ["upper", "lower"][:links]
    move = {"type": "quintic", "start": 0.0, "end": -0.1, "duration": 0.02}
    beam = {
        "model": "strain", "functions": {"bend_y": 2}, "length": 1.0, "damping_time": 1e-3, "rotary_inertia": "none",
        "section": section, "material": {"young": 70e9, "shear": 26e9, "density": 2700.0},
    }  # fmt: skip
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "arm", "gravity": 9.81,
        "joints": [
            {
                "name": f"joint_{name}", "type": "revolute", "parent": parent, "child": name, "axis": [0, 1, 0],
                "motor": {"side": "joint", "inertia": 1.0}, "gear": {"stiffness": 2e4, "damping": 1.0},
            } for parent, name in zip(["base", *names], names, strict=False)
        ],
        "links": [
            {"name": name, "bodies": [{"name": "payload", "mass": 1.5, "at": 1.0}], "beam": beam} for name in names
        ],
        "drives": [
            {
                "joint": f"joint_{name}", "command": "position", "signal": move,
                "controller": {"type": "pd", "position_gain": 1e4, "velocity_gain": 1e2},
            } for name in names
        ],
        "integration": {"duration": 0.02, "output_step": 2e-3},
    })  # fmt: skip


def drawn(ends, count, link="upper"):
    """Dimensions of a link."""
    generator = np.random.default_rng(4)
    section = f"links.{link}.beam.section"
    return {f"{section}.{name}": generator.uniform(low, high, count) for name, (low, high) in ends.items()}


WIDE = {"outer_diameter": (0.03, 0.05), "thickness": (1e-3, 4e-3)}
PAYLOAD = "links.upper.bodies.payload.mass"
TWO = drawn(WIDE, 100) | drawn({"outer_diameter": (0.02, 0.03), "thickness": (1e-3, 2e-3)}, 100, "lower")
CASES = {
    "pair": (arm(TUBE), drawn(WIDE, 100) | {PAYLOAD: np.linspace(1.0, 2.0, 100)}),
    "two pairs": (arm(TUBE, 2), TWO),
    "three": (arm(HOLLOW), drawn({"width": (0.02, 0.04), "height": (0.01, 0.03), "thickness": (1e-3, 2e-3)}, 200)),
}  # fmt: skip


@pytest.mark.parametrize("name", list(CASES))
def test_static_numbers_of_all_cases_at_once(name, monkeypatch):
    robot, vary = CASES[name]
    with monkeypatch.context() as patched:
        patched.delattr(statics._Rows, "_one")  # no case goes by itself
        found = static_numbers(robot, vary, NAMES)
    some = {path: values[::25] for path, values in vary.items()}
    true = static_numbers(robot, some, NAMES)  # few
    assert set(found.status) == {"finished"}
    for one in NAMES:
        assert found.values[one][::25] == pytest.approx(true.values[one], rel=3e-12, abs=0.0), one


@pytest.mark.parametrize("name", list(CASES))
def test_runs_of_all_cases_at_once(name, monkeypatch):
    """Each starts from its own rest."""
    robot, vary = CASES[name]
    alone, ordinary = [], simulate._lane
    monkeypatch.setattr(simulate, "_lane", lambda *given: (alone.append(given[-1]), ordinary(*given))[1])
    found = tmodes.simulate_batch(robot, vary, tips=True)
    assert len({*alone}) <= 1 + 2 * len(vary)
    some = [k for k in range(len(found.status)) if k not in alone][:3]
    true = tmodes.simulate_batch(robot, {path: values[some] for path, values in vary.items()}, tips=True)
    assert found.status == ("finished",) * len(found.status)
    assert found.statistics["steps"][some].tolist() == true.statistics["steps"].tolist()
    assert np.abs(found.states[some] - true.states).max() < 1e-11 * np.abs(true.states).max()
    assert found.tips is not None
    assert true.tips is not None
    assert np.abs(found.tips[some] - true.tips).max() < 1e-12 * np.abs(true.tips).max()


def test_blocks_of_a_larger_study(monkeypatch):
    """What is found for the whole does not depend on which cases are in a block, nor on how many."""
    robot, vary = CASES["pair"]
    whole = Whole(100, {path: (float(values.min()), float(values.max())) for path, values in vary.items()})
    few = {path: values[:7] for path, values in vary.items()}
    parts = [reduced(robot, few, [PEAK], whole=whole), reduced(robot, vary, [PEAK], whole=whole)]
    assert parts[0].values[PEAK].tobytes() == parts[1].values[PEAK][:7].tobytes()
    monkeypatch.setattr(arrays, "_FEW", 10**9)
    true = reduced(robot, few, [PEAK])
    assert parts[0].values[PEAK] == pytest.approx(true.values[PEAK], rel=1e-10, abs=0.0)


def test_four_dimensions_by_one_program(monkeypatch):
    ends = {
        "width": (0.02, 0.03),
        "height": (0.03, 0.04),
        "flange_thickness": (2e-3, 3e-3),
        "web_thickness": (1e-3, 2e-3),
    }
    robot, vary = arm(I_BEAM), drawn(ends, 61)
    found = tmodes.simulate_batch(robot, vary)
    true = tmodes.simulate_batch(robot, {path: values[5:7] for path, values in vary.items()})
    assert np.abs(found.states[5:7] - true.states).max() < 1e-11 * np.abs(true.states).max()
    one = static_numbers(robot, {path: values[5:6] for path, values in vary.items()}, NAMES)
    monkeypatch.delattr(statics._Rows, "_one")
    numbers = static_numbers(robot, vary, NAMES)
    for name in NAMES:
        assert numbers.values[name][5] == pytest.approx(one.values[name][0], rel=3e-12, abs=0.0)
