"""Programs of lowering: every number of a sheet of every kind noted at once; checks of the sheet as guards."""

from __future__ import annotations

import ast
import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import tmodes
from command import called
from noted.sheets import KINDS
from random_sheets import random_sheet
from tmodes.errors import InputErrors
from tmodes.io.sheet_check import sheet_data
from tmodes.kinds.contacts.registry import CONTACTS, SURFACES
from tmodes.kinds.controllers.registry import CONTROLLERS
from tmodes.kinds.joints.registry import JOINTS
from tmodes.kinds.links.sheet import LINKS
from tmodes.kinds.noted import functions
from tmodes.kinds.noted.number import Lost, NotedTape
from tmodes.kinds.noted.program import program_of
from tmodes.kinds.sensors.registry import SENSORS
from tmodes.kinds.shapers.registry import SHAPERS
from tmodes.kinds.signals.registry import SIGNALS
from tmodes.kinds.signals.schedule import SignalPieces, merge, merge_cases
from tmodes.model.parameters import Structural
from tmodes.model.passes import derivatives, evaluate_program
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.plan import Follow
from tmodes.simulation.vary import programs
from tmodes.simulation.vary.cases import run_blocks
from tmodes.simulation.vary.parameters import parameters_of
from tmodes.simulation.vary.programs import case_program, refused_cases
from tmodes.simulation.vary.values import changes_of

ROBOTS = ("filipovic2010", "deluca_siciliano1991", "flexarm1990", "manutec_r3", "quanser_2dsfl", "spong1987")
COUNT = int(os.environ.get("TMODES_PROPERTIES", "1"))

NEAR = 20
"""Neighbours of a number whose size is that of its rounding."""

HELD = ("integration", "real", "format")
APART = (".at", "sample_time", "pieces.1.end")
"""Numbers that stand in a place of their own: a station at an end, samples on the output's instants, the last end."""


DESIGNED = ("controller lqr", "controller lqg", "controller pole_placement", "controller loop_shaping")


def numbers_of(robot, held=APART):
    """Every finite number of a sheet that is not zero, by its path."""
    found = {}

    def walk(value, steps):
        if isinstance(value, dict):
            for key, inner in value.items():
                walk(inner, (*steps, key))
        elif isinstance(value, list):
            for key, inner in enumerate(value):
                walk(inner, (*steps, key))
        elif isinstance(value, float) and np.isfinite(value) and value:
            found[".".join(map(str, steps))] = value

    walk({key: value for key, value in sheet_data(robot).items() if key not in HELD}, ())
    if "links.0.beam.pieces.0.end" in found:
        held = (*held, "links.0.beam.length")
    return {path: value for path, value in found.items() if not path.endswith(held)}


def noted(robot, values):
    return case_program(robot, values, lambda pair: pair.real, lambda one: run_blocks(one, Follow.SHEET))


def compare(program, robot, values):
    """The blocks of a case with those of its own sheet, to 1e-12 of the neighbours' size."""
    true = run_blocks(robot.with_(values).pair().real, Follow.SHEET)
    row = {path: np.array([value]) for path, value in values.items()}
    found = {name: block[0] for name, block in zip(program.places, program.blocks([*program.places], row), strict=True)}
    assert found.keys() == true.keys()
    for name, block in true.items():
        if name.startswith(("knots", "powers")) or not block.size:
            continue
        assert found[name].shape == block.shape
        finite = np.isfinite(block).ravel()
        assert np.array_equal(np.isfinite(found[name]).ravel(), finite), name
        size = np.lib.stride_tricks.sliding_window_view(
            np.pad(np.where(finite, np.abs(block.ravel()), 0.0), NEAR), 2 * NEAR + 1
        ).max(axis=1, initial=0.0)
        apart = np.abs(found[name] - block).ravel()
        assert (apart <= 1e-12 * size)[finite].all(), name
    for k in range(sum(name.startswith("knots") for name in true)):
        own, other = (SignalPieces(blocks[f"knots {k}"], blocks[f"powers {k}"]) for blocks in (found, true))
        times = np.linspace(0.01, 0.99, 23) * robot.integration.duration
        values = other.at(times)
        assert own.at(times) == pytest.approx(values, rel=1e-11, abs=1e-12 * max(np.abs(values).max(), 1.0))


def check_changes(robot, held=APART, seed=0, draws=COUNT):
    values, generator = numbers_of(robot, held), np.random.default_rng(seed)
    program, held = noted(robot, values), 0
    assert not program.fixed
    compare(program, robot, values)
    for _ in range(draws):
        for share in (0.2, 0.05, 0.01, 2e-4):
            changed = {path: value * (1 + share * generator.uniform(-1, 1)) for path, value in values.items()}
            if program.holds({path: np.array([value]) for path, value in changed.items()})[0]:
                compare(program, robot, changed)
                held += 1
                break
    assert held == draws


@pytest.mark.parametrize("name", [name for name in KINDS if name not in DESIGNED])
def test_all_numbers_of_a_kind_at_once(name):
    check_changes(Robot.from_data(KINDS[name]), (*APART, *("delay" for _ in SENSORS if name == "sensors")))


@pytest.mark.parametrize("name", DESIGNED)
def test_gains_that_are_designed_have_no_program(name):
    """Each case is lowered by itself, with gains of its own; a real robot that differs has those of the known one."""
    robot = Robot.from_data(KINDS[name])
    with pytest.raises(Structural):
        noted(robot, numbers_of(robot))
    program = noted(robot, {"real.joints.second.friction.viscous": 1.1})
    assert not program.fixed


@pytest.mark.parametrize("seed", range(6 * COUNT))
def test_all_numbers_of_a_random_robot_at_once(seed):
    check_changes(Robot.from_data(random_sheet(seed, seed)), seed=seed)


@pytest.mark.parametrize("name", ROBOTS)
def test_all_numbers_of_a_published_robot_at_once(name):
    own = (*APART, "duration", "inertia.xx", "inertia.yy", "inertia.zz")  # a move as long as the run; a lump
    check_changes(load(name), own if name == "filipovic2010" else APART)


def test_the_place_of_a_body_inside_a_beam():
    """By a short program: integrals of polynomials need few points, and intervals beyond a piece none."""
    robot = Robot.from_data(KINDS["body inside"])
    values = {"links.0.bodies.0.at": 0.4, "links.0.beam.length": 0.7, "links.0.beam.section.outer_diameter": 0.03}
    program = noted(robot, values)
    assert len(program.program.operations) < 5000
    held = 0
    for share in np.random.default_rng(0).uniform(0.8, 1.2, 5 * COUNT):
        changed = {path: share * value for path, value in values.items()}
        if program.holds({path: np.array([value]) for path, value in changed.items()})[0]:
            compare(program, robot, changed)
            held += 1
    assert held > 0


@pytest.mark.parametrize("name", ["beam tube", "beam curved", "beam rigid"])
def test_guards_hold_what_decides_alone(name):
    """No rounding noise, no order of numbers of which the largest is taken: one program for changes by a tenth."""
    robot = Robot.from_data(KINDS[name])
    values, generator = numbers_of(robot), np.random.default_rng(0)
    rows = {path: value * (1 + 0.1 * generator.uniform(-1, 1, 50)) for path, value in values.items()}
    assert noted(robot, values).holds(rows).all()


def test_every_registered_kind_has_a_sheet():
    words = {value for one in KINDS.values() for value in str(one).replace("'", " ").replace('"', " ").split() if value}
    families = (SIGNALS, SHAPERS, CONTROLLERS, SENSORS, CONTACTS, SURFACES, LINKS, JOINTS)
    known = {name for family in families for name in family.names if family[name].__module__.startswith("tmodes.")
             or type(family[name]).__module__.startswith("tmodes.")}  # fmt: skip
    assert known - words - {"expression", "fixed"} == set()


@pytest.mark.parametrize(
    "name", ["beam tube", "beam i_beam", "joint elastic", "signal trapezoid", "contact unilateral"]
)
def test_no_wild_case_is_accepted_that_the_sheet_refuses(name):
    robot, generator = Robot.from_data(KINDS[name]), np.random.default_rng(7)
    values = numbers_of(robot)
    wild = {path: np.full(20 * COUNT, value) for path, value in values.items()}
    for k in range(20 * COUNT):
        for path in generator.choice(list(values), 2):
            wild[path][k] *= generator.choice([-1.0, 0.0, 1e-14, 0.1, 10.0, 1e7, 1e16])
    true = dict[int, str]()
    for k in range(20 * COUNT):
        try:
            robot.with_(changes_of(wild, k)).pair()
        except InputErrors as error:
            true[k] = str(error)
    assert 0 < len(true) < 20 * COUNT
    assert not noted(robot, values).holds(wild)[list(true)].any()
    assert refused_cases(robot, wild) == true


def test_structure_has_its_value():
    """Samples on instants of the output, and seeds, are structure; other numbers of the same cases are not."""
    robot = Robot.from_data(KINDS["controller sampled_pid"])
    path, gain = "drives.first.controller.sample_time", "drives.first.controller.position_gain"
    program = noted(robot, {path: 0.01, gain: 80.0})
    assert program.fixed == {path: 0.01}
    assert program.paths == (gain,)
    holds = program.holds({path: np.array([0.01, 0.02]), gain: np.array([70.0, 70.0])})
    assert holds.tolist() == [True, False]


def test_factors_of_the_real_robot():
    robot = load("filipovic2010")
    values = {"real.gear.stiffness": 1.3, "gear.stiffness": 900.0, "link.modes.0.length": 0.4, "gravity": 9.7}
    program = noted(robot.with_(values), values)
    assert not program.fixed
    compare(program, robot, values)
    compare(program, robot, {path: 1.1 * value for path, value in values.items()})


@pytest.mark.parametrize("name", ROBOTS)
def test_every_number_of_a_published_robot_can_be_varied(name):
    """But for settings, counts, seeds, and stiffnesses that are infinite on purpose."""
    found = parameters_of(load(name))
    assert len({one.path for one in found}) == len(found) > len(numbers_of(load(name)))
    structure = {one.path for one in found if one.is_structure and np.isfinite(one.value)}
    assert all(path.startswith("integration.") or ".functions." in path or path.endswith((".points", ".seed"))
               for path in structure), structure  # fmt: skip
    stiff = next(one for one in found if one.path.endswith(("gear.stiffness.0", "bending_stiffness.1", "gain")))
    assert stiff.low in (0.0, -np.inf)
    assert "parameters" in stiff.enters
    for one in found:
        assert one.low <= one.value


def test_numbers_of_a_robot_with_designed_gains_are_structure():
    robot = tmodes.load("spong1987")
    drive = {"joint": "joint", "command": "position", "signal": {"type": "constant", "value": 0.0}}
    block = {"type": "lqr", "state_weights": {"joint": 100.0}, "effort_weight": 1.0}
    law = robot.with_({"drives": [drive], "control": [{"name": "law", "drives": ["joint"], "block": block}]})
    found = {one.path: one for one in tmodes.parameters(law)}
    assert all(one.is_structure for one in found.values())
    assert found["control.law.block.state_weights.joint"].value == 100.0


def test_the_command_lists_all_parameters():
    found = parameters_of(load("spong1987"))
    listed = json.loads(called("parameters", "spong1987", "--json").stdout)
    assert [(row["path"], row["value"], row["unit"]) for row in listed] == [one[:3] for one in found]
    assert listed[0].keys() == {*found[0]._asdict()}
    shown = called("parameters", "spong1987").stdout
    assert all(one.path in shown for one in found)


LOWERING = ("chain", "sheet", *(f"kinds/{name}" for name in (
    "contacts", "controllers", "drives", "joints", "links", "schema", "shapers", "signals")))  # fmt: skip
OF_PLAIN_NUMBERS = {
    "chain/mass.py": {"_general"},
    "kinds/controllers/contract.py": {"command"},
    "kinds/controllers/loop_shaping.py": {"robust"},
    "kinds/joints/joint.py": {"notice"},
    "kinds/links/beam_functions.py": {"_first", "bare_beam"},
    "kinds/links/body.py": {"entries"},
    "kinds/links/contract.py": {"described", "embedding"},
    "kinds/links/modes.py": {"stiffness_at"},
    "kinds/links/modes_beam.py": {"_means", "in_place_of"},
    "kinds/schema/quantity.py": {"_in_range_of_arithmetic"},
    "kinds/signals/fit.py": {"_finite"},
    "kinds/signals/formula.py": {"_value"},
    "kinds/signals/switches.py": {"_changes", "_with_dips"},
}
"""Functions that are asked of numbers that are never noted: what is drawn and said, and formulas given as text."""


def casts(node, function=""):
    """Names of the functions in which ``float(x)`` and functions of :mod:`math` are called."""
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, ast.Call):
            called = inner.func
            of_math = isinstance(called, ast.Attribute) and getattr(called.value, "id", "") == "math"
            if of_math or (getattr(called, "id", "") == "float" and not isinstance(inner.args[0], ast.Constant)):
                yield function
        yield from casts(inner, inner.name if isinstance(inner, ast.FunctionDef) else function)


def test_lowering_has_functions_that_take_noted_numbers():
    """In place of ``float`` and :mod:`math`: those of :mod:`tmodes.kinds.noted.functions`."""
    root, found = Path(tmodes.__file__).parent, {}
    for file in sorted(file for part in LOWERING for file in (root / part).rglob("*.py")):
        name = file.relative_to(root).as_posix()
        found[name] = {*casts(ast.parse(file.read_text()))} - OF_PLAIN_NUMBERS.get(name, set())
    assert {name: new for name, new in found.items() if new} == {}


def test_nothing_is_lost_silently():
    x = NotedTape().input(2.0)
    for lossy in (float, int, hash, complex, round, lambda x: f"{x:g}", lambda x: [1, 2, 3][x], lambda x: {x: 1}):
        with pytest.raises(Lost):
            lossy(x)
    with pytest.raises((TypeError, ValueError)):
        np.zeros(2)[0] = x
    with pytest.raises((TypeError, ValueError)):
        np.isfinite(np.array([x]))


def test_a_branch_is_a_guard_and_a_derivative_is_exact():
    tape = NotedTape()
    x, y = tape.input(2.0), tape.input(3.0)
    z = functions.sqrt(x * y) / (x + 1) if x < y else x
    program = program_of(tape, [x, y], [z, 5.0, functions.sin(x) ** 2, abs(x - y)])
    found, holds = program(np.array([[2.0, 3.0], [1.0, 9.0], [4.0, 1.0]]))
    assert holds.tolist() == [True, True, False]
    assert found[1] == pytest.approx([1.5, 5.0, np.sin(1.0) ** 2, 8.0])
    point, step = np.array([2.0, 3.0]), 1e-6
    for k in range(2):
        ends = [program(point[None] + sign * step * np.eye(2)[k])[0][0] for sign in (1, -1)]
        assert program.derivative(point)[:, k] == pytest.approx((ends[0] - ends[1]) / (2 * step), abs=1e-8)
    assert program.part(np.array([1])).is_constant


def test_a_program_is_compiled_code_too():
    """Every operation and relation, natively as in NumPy, with derivatives; sums and products to the bit."""
    tape = NotedTape()
    x, y = tape.input(0.3), tape.input(0.7)
    exact = [x + y, x - y, x * y, x / y, -x, abs(x - y), functions.sqrt(x), functions.maximum(x, y), x**2, x * y + x]
    near = [x**-3, x**5, y.tan(), x.exp(), x.tanh(), x.arcsin(), y.arccos(), x.arctan(), (x - y).arctan2(y),
            x.hypot(y), functions.sin(x), functions.cos(y), functions.minimum(x, y)]  # fmt: skip
    for holds in (x < 0.6, x <= 0.6, not x > 0.6, not x >= 0.6, y > 0.2, y >= 0.2, not y < 0.2, not y <= 0.2, x != y):
        assert holds
    assert x.finite
    assert not x == y  # noqa: SIM201
    program = program_of(tape, [x, y], [*exact, *near, 2.0])
    values = np.random.default_rng(0).uniform(0.01, 0.99, (501, 2))
    values[:4] = [[0.3, 0.3], [np.nan, 0.5], [0.5, np.inf], [0.3, 0.7]]
    (true, right), (found, holds) = program(values), evaluate_program(program, values)
    assert holds.tolist() == right.tolist()
    assert 50 < holds.sum() < 450
    assert np.array_equal(found[3:, : len(exact)], true[3:, : len(exact)])
    assert found[holds] == pytest.approx(true[holds], rel=4e-15, abs=1e-16)
    blocks, along = {"values": np.tile(values[3], (2, 1))}, {"values": np.eye(2)}
    slopes = derivatives(program.constants, program.schedule, blocks, along, 2)["numbers"]
    true = program.derivative(values[3])
    assert np.allclose(slopes.T, true, rtol=1e-13, atol=1e-14)
    with pytest.raises(ValueError, match="power"):
        _ = program_of(tape, [x, y], [x**1.5]).schedule


def test_a_program_of_very_many_cases_is_compiled(monkeypatch):
    """All blocks at once, with the same numbers; how many go at once decides nothing."""
    robot, called = Robot.from_data(KINDS["joint elastic"]), []
    monkeypatch.setattr(programs, "evaluate_program", lambda *given: (called.append(1), evaluate_program(*given))[1])
    few = noted(robot, values := numbers_of(robot))
    rows = {path: value * np.random.default_rng(0).uniform(0.9, 1.1, 11) for path, value in values.items()}
    true, holds = few.blocks([*few.places], rows), few.holds(rows)
    assert not called
    many = replace(few, cases=10**6)
    assert many.holds(rows).tolist() == holds.tolist()
    for found, right in zip(many.blocks([*many.places], rows), true, strict=True):
        assert found == pytest.approx(right, rel=1e-12, abs=1e-300, nan_ok=True)
    assert len(called) == 2


def test_linear_algebra_of_noted_numbers():
    """As NumPy and SciPy have it."""
    from scipy.interpolate import CubicSpline

    generator, tape = np.random.default_rng(0), NotedTape()

    def of(values):
        return np.vectorize(tape.input, otypes=[object])(values)

    def plain(values):
        return np.vectorize(lambda x: getattr(x, "value", x), otypes=[float])(values)

    rows = generator.normal(size=(5, 5))
    rows[2, :2] = 0.0
    assert plain(functions.triangle(of(rows))) == pytest.approx(np.linalg.qr(rows, mode="r"), abs=1e-13)
    right = generator.normal(size=(5, 2))
    assert plain(functions.solve(of(rows), right)) == pytest.approx(np.linalg.solve(rows, right), rel=1e-11)
    square = rows @ rows.T + np.eye(5)
    assert plain(functions.inverse_cholesky(of(square))) == pytest.approx(
        np.linalg.inv(np.linalg.cholesky(square)), abs=1e-12
    )
    main, upper = generator.uniform(0.4, 0.6, 4), generator.uniform(0.1, 0.3, 3)
    for found, true in zip(functions.golub_welsch(of(main), of(upper)), functions.golub_welsch(main, upper),
                           strict=True):  # fmt: skip
        assert plain(found) == pytest.approx(true, abs=1e-13)
    times, values = np.cumsum(generator.uniform(0.1, 1, 6)), generator.normal(size=6)
    slopes = CubicSpline(times, values, bc_type="clamped")(times, 1)
    assert plain(functions.cubic_slopes(of(times), of(values))) == pytest.approx(slopes, abs=1e-12)


def test_signals_of_all_cases_are_merged_as_those_of_one():
    generator, count = np.random.default_rng(0), 40
    first = generator.uniform(0.3, 1.9, count)
    second = np.where(generator.random(count) < 0.3, first, generator.uniform(0.3, 2.0, count))
    parts = [
        (np.stack([np.zeros(count), ends, np.full(count, 2.0)], axis=1), generator.normal(size=(count, 2, 6)))
        for ends in (first, second)
    ]
    parts.append((np.tile([0.0, 2.0], (count, 1)), generator.normal(size=(count, 1, 1))))
    for k, found in enumerate(merge_cases(parts)):
        true = merge([SignalPieces(knots[k], pieces[k]) for knots, pieces in parts]).schedule
        assert found.knots.tobytes() == true.knots.tobytes()
        assert np.array_equal(found.coefficients, true.coefficients)
