"""What a user touches: every command as a method with its arguments, and results that print themselves."""

from __future__ import annotations

import copy
import inspect
import json
import pickle
from importlib import import_module
from typing import Any

import numpy as np
import pytest
import xarray
from pydantic import BaseModel

import tmodes
from command import called
from command import tmodes as command
from tmodes.cli.main import COMMANDS
from tmodes.errors import InputError
from tmodes.interface.hierarchy import Hierarchy
from tmodes.interface.statics import Linearization
from tmodes.io.printed import CommandResult
from tmodes.simulation.hierarchy.hierarchy import Ladder, Rung

LINK = tmodes.load("spong1987")
SHORT = LINK.with_({"integration.duration": 0.1})
PLAN = {
    "parameters": {"k": {"path": "gear.stiffness", "distribution": {"type": "uniform", "low": 80, "high": 120}}},
    "plan": {"type": "grid", "levels": 3},
    "quantities": {"peak": {"series": "deviation", "reduce": "max"}},
}
FORMULA = {"parameters": {"k": {"distribution": {"type": "uniform", "low": 1, "high": 2}}},
           "quantities": {"y": {"expression": "k**2"}}}  # fmt: skip
CHOICE = {
    "parameters": {"k": {"distribution": {"type": "discrete", "values": [1, 2, 3]}}},
    "quantities": {"y": {"expression": "(k - 2)**2"}},
    "optimize": {"objectives": [{"minimize": "y"}], "design": ["k"]},
}
FLEXIBLE = tmodes.load("filipovic2010").with_({"integration.duration": 0.05})

RUNGS = (
    Rung("rigid", 2, (), 0.0, 0.3, None, 1e-3, 0.1, None), Rung("strain", 6, (5.0,), 1e-3, 0.9, 50.0, 0.0, 0.0, 0.0),
)  # fmt: skip
RESULTS = {
    "hierarchy": lambda: Hierarchy(Ladder("link", 1e-2, "a move", 0.01, RUNGS, "strain", converged=False)),
    "run": SHORT.run, "modes": LINK.modes, "static": lambda: FLEXIBLE.static(force=(0, 0, -1)),
    "inverse": lambda: tmodes.load("two_link_arm").inverse(tip=(0.7, 0, 0.3)),
    "describe": FLEXIBLE.describe, "linearize": LINK.linearize, "check": LINK.check,
    "shaper": lambda: FLEXIBLE.shaper(kind="zvd"),
    "follow": lambda: tmodes.load("two_link_arm").follow("{type: line, to: [0.7, 0, 0.2]}"),
    "eval": lambda: LINK.eval([{"q": [0.1, 0.2], "v": {"joint": 1.0}}]),
    "batch": lambda: SHORT.batch(draw={"gear.stiffness": (80, 120)}, runs=3),
    "study": lambda: SHORT.study(PLAN), "sensitivity": lambda: LINK.sensitivity(FORMULA, samples=64),
    "optimize": lambda: LINK.optimize(CHOICE),
    "motion": lambda: LINK.motion(duration=0.5),
    "gradient": lambda: SHORT.gradient(tmodes.tracking_error("tip", [0, 0, -1]), ["gear.stiffness"]),
}  # fmt: skip


def test_points_that_belong_to_no_course_are_not_joined() -> None:
    """Modes are points, each thing that motors may do with a look of its own."""
    drawn = [line for line in FLEXIBLE.modes().plot()[0].get_lines() if line.get_marker() != "None"]
    assert {line.get_linestyle() for line in drawn} == {"None"}
    assert len({(line.get_color(), line.get_marker()) for line in drawn}) == len(drawn)
    sizes = [line.get_markersize() for line in drawn]  # points at one place are rings around each other
    assert sizes == sorted({*sizes}, reverse=True)
    assert [line.get_fillstyle() for line in drawn[:-1]] == ["none"] * (len(drawn) - 1)


def test_the_axis_of_what_is_varied_has_its_unit() -> None:
    found = SHORT.batch(draw={"gear.stiffness": (80, 120)}, runs=2)
    assert found.plot()[0].get_xlabel() == "gear.stiffness [N*m/rad]"


@pytest.mark.parametrize("name", RESULTS)
def test_a_result_prints_itself_has_arrays_and_a_figure(name: str) -> None:
    found = RESULTS[name]()
    assert isinstance(found, CommandResult)
    text = repr(found)
    lines, widest = (30, 80) if name == "run" else (10, 120)
    assert 1 <= len(text.splitlines()) <= lines
    assert max(map(len, text.splitlines())) <= widest
    assert "<table>" in found._repr_html_() or name == "check"
    assert isinstance(found.data, xarray.Dataset)
    assert found.data.sizes
    axes = found.plot()
    assert axes
    assert all(one.has_data() for one in axes)
    assert found.plot(axes if len(axes) > 1 else axes[0])[0] is axes[0]
    json.dumps(found.info(), allow_nan=False)
    names = set(dir(found))
    assert {"data", "plot", "info", "tables", "warnings"} <= names
    assert not [one for one in names if one.startswith("_")]


@pytest.mark.parametrize("name", ["modes", "static", "describe", "check", "shaper"])
def test_it_says_what_the_command_prints(name: str) -> None:
    """The same plain data as ``--json``."""
    printed = json.loads(command(name, "filipovic2010", "--json").stdout)
    assert json.loads(json.dumps(getattr(tmodes.load("filipovic2010"), name)().info())) == printed


FROM_THE_LINE = {
    "robot", "settings", "root", "trust_paths", "fix_inertia", "as_json", "open_page", "timing", "sheet", "insecure",
    "everything",
}  # fmt: skip
"""What names the robot or its file (``tmodes.load``, ``Robot.with_``), or is of the terminal alone."""


@pytest.mark.parametrize(
    "name",
    [
        "run",
        "modes",
        "static",
        "describe",
        "hierarchy",
        "batch",
        "study",
        "sensitivity",
        "optimize",
        "check",
        "eval",
        "shaper",
        "motion",
    ],
)
def test_every_argument_of_a_command_is_one_of_the_method(name: str) -> None:
    module, _, function = COMMANDS[name].partition(".")
    callback = getattr(import_module(f"tmodes.cli.{module}"), function)
    of_command = set(inspect.signature(callback).parameters) - FROM_THE_LINE
    assert of_command <= set(inspect.signature(getattr(tmodes.Robot, name)).parameters)
    if name not in ("study", "sensitivity", "optimize"):  # whose names the functions of whole studies have
        assert getattr(tmodes, "evaluate" if name == "eval" else name) is getattr(tmodes.Robot, name)


def test_what_functions_give_prints_without_its_arrays() -> None:
    measured, paths = tmodes.tracking_error("tip", [0, 0, 0]), ["gear.stiffness"]
    found = [
        measured, tmodes.forward_sensitivities(SHORT, paths), SHORT.gradient(measured, paths).found,
        tmodes.simulate_batch(SHORT, {"gear.stiffness": [80.0, 90.0]}),
    ]  # fmt: skip
    for one in found:
        assert len(repr(one)) <= 120
        assert not set("[<") & set(repr(one))


def test_a_beam_that_is_rigid_is_no_flexible_link() -> None:
    robot = tmodes.load("flexarm1990")
    assert "1 flexible link," in repr(robot.check())
    rigid = robot.with_({"links.forearm.beam.model": "rigid"})
    assert "0 flexible links," in repr(rigid.check())
    assert "flexible links:" not in repr(rigid)


def test_a_robot_stays_one() -> None:
    changed = LINK.with_({"gear.stiffness": 80.0})
    made = [
        changed, LINK.model_copy(update={"title": "x"}), copy.deepcopy(LINK),
        pickle.loads(pickle.dumps(LINK)),  # noqa: S301
        tmodes.Robot.from_data(json.loads(command("robots", "spong1987", "--json").stdout)), SHORT.run().robot,
    ]  # fmt: skip
    assert {type(one) for one in made} == {tmodes.Robot}
    assert made[2] == LINK
    assert made[3] == LINK
    assert changed != LINK
    assert tmodes.Robot.of(LINK.pair().real) == LINK
    assert (LINK == 1) is False
    stored = pickle.loads(pickle.dumps(SHORT.run()))  # noqa: S301
    assert type(stored) is tmodes.Result


def test_a_pair_takes_no_settings() -> None:
    with pytest.raises(tmodes.TmodesError):
        tmodes.run(LINK.pair(), duration=0.1)
    assert tmodes.run(SHORT.pair()).status == "finished"


def test_a_stored_result_is_shown_by_its_path(tmp_path: Any) -> None:
    SHORT.run(out=tmp_path / "run", report=False)
    found = tmodes.show(tmp_path / "run")
    assert isinstance(found, tmodes.Result)
    assert repr(found).startswith(found.verdict["sentence"][:40])
    assert "spong1987: finished" in repr(found)
    done = SHORT.study(PLAN, out=tmp_path / "study")
    assert repr(tmodes.show(tmp_path / "study")) == repr(done)


def test_a_controller_or_a_stop_never_takes_the_result_of_another_run(tmp_path: Any) -> None:
    SHORT.run(out=tmp_path, report=False)
    others: list[dict[str, Any]] = [
        {"controller": lambda m: 0.0, "period": 0.05}, {"stop": "joint.position > 1 rad"}
    ]  # fmt: skip
    for more in others:
        with pytest.raises(tmodes.TmodesError):
            SHORT.run(out=tmp_path, report=False, **more)
    found = SHORT.run(out=tmp_path, report=False, overwrite=True, controller=lambda m: 1.0, period=0.05)
    assert float(found.data["effort"][0, 0]) == 1.0
    assert tmodes.Result.load(tmp_path / "result.nc").data["effort"].equals(found.data["effort"])


def test_names_are_those_for_users() -> None:
    for thing in (LINK, LINK.joints[0], LINK.integration):
        assert not set(dir(thing)) & (set(vars(BaseModel)) | {"members", "chosen_by"})
        assert set(type(thing).model_fields) <= set(dir(thing))
    assert {"run", "modes", "with_", "gradient"} <= set(dir(LINK))
    model = tmodes.Model(LINK)
    assert {"mass_matrix", "bias", "gravity", "jacobian", "forward_dynamics", "energies"} <= set(dir(model))
    assert not {"passes", "trials"} & set(dir(model))
    assert set(dir(tmodes)) == {*tmodes.__all__, "__version__"}


@pytest.mark.parametrize("name", ["spong1987", "filipovic2010", "manutec_r3"])
def test_a_robot_prints_itself(name: str) -> None:
    robot = tmodes.load(name)
    assert repr(robot).startswith(name)
    assert len(repr(robot).splitlines()) <= 10
    assert "<table>" in robot._repr_html_()


def test_the_linearization_is_that_of_the_model() -> None:
    linear = FLEXIBLE.linearize()
    assert isinstance(linear, Linearization)
    model = tmodes.Model(FLEXIBLE)
    assert linear.coordinates == model.coordinates
    free = LINK.linearize()
    mass, damping, stiffness = tmodes.Model(LINK).linearize(free.q)
    for found, known in zip((free.mass, free.damping, free.stiffness), (mass, damping, stiffness), strict=True):
        assert np.allclose(found, known, rtol=1e-12, atol=1e-12)
    angles = np.sort(np.abs(free.poles.imag))[::2] / (2 * np.pi)
    states = LINK.modes().states["free"]
    assert angles == pytest.approx([one["frequency_Hz"] for one in states], rel=1e-9)


def test_the_old_name_of_the_hierarchy_works_with_a_notice() -> None:
    """A robot without beams is refused by both in the same words."""
    old, new = (called(name, "spong1987") for name in ("ladder", "hierarchy"))
    assert (old.returncode, new.returncode) == (2, 2)
    assert old.stderr.splitlines()[1:] == new.stderr.splitlines()
    assert "hierarchy" in old.stderr.splitlines()[0]


def test_a_unique_ending_of_a_path_is_a_path() -> None:
    whole = LINK.with_({"joints.joint.gear.stiffness": 80.0})
    assert LINK.with_({"gear.stiffness": 80.0}) == LINK.with_({"stiffness": 80.0}) == whole
    assert tmodes.load("spong1987", {"gear.stiffness": 80.0}) == whole
    assert LINK.with_({"real.gear.stiffness": 0.8}).pair().real.joints[0].gear == whole.joints[0].gear
    shown = json.loads(command("check", "spong1987", "--set", "gear.stiffness=-1", "--json", code=2).stdout)
    assert shown["errors"][0]["which"].startswith("joints.joint.gear.stiffness")
    left_out = LINK.with_({"gear.damping": 3.0})  # that is 0 in the sheet
    assert left_out.joints[0].gear is not None
    assert left_out.joints[0].gear.damping == 3.0
    unwritten = tmodes.load("spong1987", {"gear.backlash": 1e-3}).joints[0].gear  # no key of the file
    assert unwritten is not None
    assert unwritten.backlash == 1e-3
    limits = tmodes.load("spong1987", {"limits.speed": "170 deg/s"}).joints[0].limits  # no group of the file
    assert limits is not None
    assert limits.speed == pytest.approx(np.deg2rad(170))
    with pytest.raises(InputError, match="the ending of 2 paths"):
        tmodes.load("spong1987", {"friction.viscous": 0.1})


@pytest.mark.parametrize("name", ["signal.end", "duration"])
def test_an_ending_of_several_paths_is_refused_with_all_of_them(name: str) -> None:
    arm = tmodes.load("manutec_r3")
    with pytest.raises(tmodes.TmodesError) as wrong:
        arm.with_({name: 1.0})
    errors: Any = getattr(wrong.value, "errors", (wrong.value,))
    paths = errors[0].expected.removeprefix("one of ").split(", ")
    assert len(paths) == 6 + (name == "duration")
    assert all(path.endswith(name) for path in paths)
    changed = arm.with_(dict.fromkeys(paths, 0.5))
    assert all(drive.signal.model_dump()[name.rpartition(".")[2]] == 0.5 for drive in changed.drives)
