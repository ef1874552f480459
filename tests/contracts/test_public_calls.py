"""Every public function with arguments of every wrong kind: an error of tmodes, in time, or an answer; never another.

A function or a class of ``tmodes`` that is missing here, or whose parameter is, is found by the last test.
"""

# ruff: noqa: E501 - a line for each function

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from patience import bounded
from tmodes import plot
from tmodes.analysis.statics.equilibrium import equilibrium
from tmodes.errors import TmodesError
from tmodes.report import write_report
from tmodes.simulation.batch.result import load_batch
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.static_numbers import static_numbers
from tmodes.study.read import study_from_data

LONGEST = 20.0
"""Seconds of processor time of one call."""

STUDY = """\
format: 1
kind: study
name: s
parameters: {k: {distribution: {type: uniform, low: 0.8, high: 1.2}}}
plan: {type: monte_carlo, runs: 2, seed: 0}
quantities: {y: {expression: "2*k"}}
optimize: {objectives: [{minimize: y}]}
"""
FORMULA = {
    "parameters": {"k": {"distribution": {"type": "uniform", "low": 0.8, "high": 1.2}}},
    "quantities": {"y": {"expression": "2*k"}},
    "optimize": {"objectives": [{"minimize": "y"}]},
}
GEAR = "joints.joint.gear.stiffness"
TUNED = "drives.0.controller.position_gain"
UNIFORM = {"relative": True, "distribution": {"type": "uniform", "low": 0.8, "high": 1.2}}


def deep() -> list[Any]:
    found: list[Any] = []
    for _ in range(3000):
        found = [found]
    return found


class Rude:
    """It refuses to be looked at."""

    def __repr__(self) -> str:
        raise ZeroDivisionError

    __str__ = __len__ = __iter__ = __repr__  # pyright: ignore[reportAssignmentType]


WRONG: dict[str, Callable[[], Any]] = {
    "None": lambda: None, "true": lambda: True, "0": lambda: 0, "-1": lambda: -1, "huge": lambda: 10**400,
    "nan": lambda: float("nan"), "inf": lambda: float("inf"), "complex": lambda: 1 + 2j, "empty text": lambda: "",
    "text": lambda: "x", "NUL": lambda: "a\0b", "bytes": lambda: b"x", "empty list": list, "list": lambda: [1],
    "texts": lambda: ["a"], "ragged": lambda: [[1], [2, 3]], "empty group": dict, "group": lambda: {"a": 1},
    "keys": lambda: {1: 2}, "object": object, "rude": Rude, "empty array": lambda: np.zeros(0),
    "matrix": lambda: np.zeros((2, 3)), "not-a-number": lambda: np.full(3, np.nan), "array of texts": lambda: np.array(["x"]),
    "array of objects": lambda: np.array([None]), "function": lambda: lambda: None, "type": lambda: float, "set": lambda: {1},
    "iterator": lambda: iter([1]), "deep": deep, "self": lambda: tmodes,
}  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    before = Path.cwd()
    os.chdir(made := tmp_path_factory.mktemp("calls"))
    yield made
    os.chdir(before)


def measured(times: Any, info: Any, *, answer: Any) -> Any:
    return answer(info)


def functional(answer: Callable[[Any], Any]) -> tmodes.Functional:
    return tmodes.Functional(("tip",), partial(measured, answer=answer))


def system(**more: Any) -> tmodes.System:
    return tmodes.System(
        **{"name": "s", "coordinates": {"x": "m"}, "parameters": {}, "kinetic": lambda q, v, p: v.x**2 / 2, **more}
    )


@pytest.fixture(scope="module")
def calls(folder: Path) -> dict[str, tuple[Callable[..., Any], dict[str, Any]]]:
    """Each public function with the arguments that are replaced one after the other."""
    short = {"integration.duration": 0.02, "integration.output_step": 0.01}
    quick = {"integration.error_estimate": False, "integration.model_error": False}
    robot = tmodes.load("spong1987").with_(short | quick)
    (folder / "s.yaml").write_text(STUDY, encoding="utf-8")
    result, model, study = tmodes.run(robot), tmodes.Model(robot.chain()), tmodes.read_study("s.yaml")
    result.save("r.nc")
    tmodes.run_study(study, "o")
    vary = {GEAR: [90.0, 100.0]}
    tmodes.simulate_batch(robot, vary, out="batch")
    still, squared = [0.0] * model.nq, tmodes.tracking_error("tip", np.zeros(3))
    gradient = partial(tmodes.adjoint_gradient, robot)
    moves = {"q": still, "v": still, "base": None}
    return {
        "load": (tmodes.load, {"name_or_path": "spong1987", "changes": {}, "roots": (), "trust_paths": False, "fix_inertia": False}),
        "run": (tmodes.run, {"robot": robot, "stop": (), "controller": None, "progress": lambda *said: None, **dict.fromkeys(("reading", "contact", "integrator", "rtol", "atol", "duration", "settling_band", "period", "out"), None), "check_error": False, "stop_at_limits": False, "overwrite": True, "report": False, "figures": False}),
        "its command": (lambda command: robot.run(controller=lambda m: command, period=0.01), {"command": 0.0}),
        "modes": (tmodes.modes, {"robot": robot, "contact": False, "angle": None, "at": None, "max_frequency": 9.0, "reading": None}),
        "static": (tmodes.static, {"robot": robot, "load": (), "force": None, "moment": None, "point": "tip", "hold": None, "at": None}),
        "inverse": (tmodes.inverse, {"robot": robot, "tip": ("free", "free", -0.9), "load": (), "point": "tip", "near": None, "starts": 4}),
        "its load": (lambda load: robot.static(load=[load]), {"load": tmodes.Load()}),
        "its force": (lambda force: robot.static(load=[{"force": force}]), {"force": (0, 0, 1)}),
        "describe": (tmodes.describe, {"robot": robot, "at": None}),
        "linearize": (tmodes.linearize, {"robot": robot, "at": None, "contact": True, "uncertain": {"k": {"path": GEAR, **UNIFORM}}, "cases": 2, "seed": 0}),
        "its instant": (tmodes.linearize, {"robot": robot, "time": 0.1}),
        "hierarchy": (tmodes.hierarchy, {"robot": robot, "tolerance": 0.1, "finest": 1}),
        "motion": (tmodes.motion, {"robot": robot, "goal": {"joint": 0.1}, "start": None, "duration": 0.2, "least_time": False, "torque": None, "speed": None, "modes": 1, "tolerance": 1.0, "out": None, "overwrite": False}),
        "batch": (tmodes.batch, {"robot": robot, "vary": {GEAR: (90, 110, 2)}, "draw": (), "runs": 2, "seed": 0, "threads": 1, "duration": None, "out": None}),
        "its range": (lambda ends: robot.batch(vary={GEAR: ends}), {"ends": (90, 110, 2)}),
        "its drawn range": (lambda ends: robot.batch(draw={GEAR: ends}, runs=2), {"ends": (90, 110)}),
        "compare": (tmodes.compare, {"robot": robot, "variants": {"own": {}}, "sheets": None, "uncertain": {"k": {"path": GEAR, **UNIFORM}}, "plan": {"type": "sobol"}, "runs": 2, "tolerance": 0.1, "threads": 1, "out": None, "reports": False, "figure": None, "overwrite": True}),
        "tune": (tmodes.tune, {"robot": robot, "gains": (TUNED,), "minimize": "tip_error", "reduce": "max", "against": None, "against_reduce": "rms", "uncertain": {"k": {"path": GEAR, **UNIFORM}}, "worst_case": 2, "within": 2.0, "method": "cobyqa", "trials": 4, "seed": 0, "out": None, "figure": None, "overwrite": True}),
        "its range of a gain": (lambda ends: robot.tune({TUNED: ends}, method="cobyqa", trials=3), {"ends": (40, 100)}),
        "its variant": (lambda given: robot.compare({"own": given}), {"given": {}}),
        "its shaper": (lambda given: robot.compare({"own": {"shaper": given}}), {"given": {"kind": "zv"}}),
        "its uncertainty": (lambda given: robot.compare({"own": {}}, uncertain={"k": {**UNIFORM, "path": given}}, runs=2), {"given": GEAR}),
        "gradient": (tmodes.gradient, {"robot": robot, "functional": squared, "paths": [GEAR], "most_bytes": None}),
        "check": (tmodes.check, {"robot": robot}),
        "evaluate": (tmodes.evaluate, {"robot": robot, "states": [{"q": still}], "contact": False, "nominal": False, "reading": None}),
        "its state": (lambda q: robot.eval([{"q": q}]), {"q": still}),
        "Robot.study": (robot.study, {"study": FORMULA, "on": "local", "out": None, "runs": None, "threads": 1, "page": False, "resource": None, "functions": None}),
        "Robot.sensitivity": (robot.sensitivity, {"study": FORMULA, "method": "morris", "samples": 4, "seed": 0, "second_order": False, "out": None}),
        "Robot.optimize": (robot.optimize, {"study": FORMULA, "method": "tpe", "trials": 2, "seed": 0, "out": None, "functionals": None}),
        "Robot.of": (tmodes.Robot.of, {"robot": robot}),
        "Result.plot": (result.plot, {"ax": None, "name": "energies"}),
        "simulate_batch": (tmodes.simulate_batch, {"sheet": robot, "vary": vary, "tips": False, "threads": 1, "out": None, "figures": None}),
        "adjoint_gradient": (tmodes.adjoint_gradient, {"sheet": robot, "functional": squared, "paths": [GEAR], "most_bytes": 1e8}),
        "forward_sensitivities": (tmodes.forward_sensitivities, {"sheet": robot, "paths": [GEAR], "quantities": ["tip"], "start": {}, "most_bytes": 1e8}),
        "its start": (lambda way: tmodes.forward_sensitivities(robot, start={"a": way}), {"way": np.zeros(4)}),
        "tracking_error": (lambda quantity, reference: gradient(tmodes.tracking_error(quantity, reference)), {"quantity": "tip", "reference": np.zeros(3)}),
        "Functional": (lambda quantities, measure: gradient(tmodes.Functional(quantities, measure)), {"quantities": ("tip",), "measure": squared.measure}),
        "its answer": (lambda answer: gradient(functional(lambda info: answer)), {"answer": (1.0, {})}),
        "its value": (lambda value: gradient(functional(lambda info: (value, {}))), {"value": 1.0}),
        "its weights": (lambda weights: gradient(functional(lambda info: (1.0, weights))), {"weights": {}}),
        "its weight": (lambda weight: gradient(functional(lambda info: (1.0, {"tip": weight}))), {"weight": np.zeros((3, 3))}),
        "read_study": (tmodes.read_study, {"path": "s.yaml", "roots": (), "trust_paths": False, "functions": None}),
        "run_study": (tmodes.run_study, {"study": "s.yaml", "folder": "o", "on": "local", "threads": 1, "recompute": False, "overwrite": False, "insecure": False, "tls": None, "resources": None, "notice": print, "progress": lambda *said: None}),
        "load_study": (tmodes.load_study, {"folder": "o", "functions": None}),
        "kept": (tmodes.load_study("o").kept, {"case": 0}),
        "optimize": (tmodes.optimize, {"study": "s.yaml", "method": "tpe", "trials": 2, "seed": 0, "out": None, "functionals": None}),
        "sensitivity": (tmodes.sensitivity, {"study": "s.yaml", "method": "morris", "samples": 4, "seed": 0, "second_order": False, "out": None}),
        "follow": (tmodes.follow, {"robot": robot, "path": {"type": "joints", "points": [[0.5]]}, "profile": {"type": "quintic", "duration": 1.0}, "reference": "rigid", "least_time": False, "shaper": None, "fit": 1e-6, "out": None, "figure": None, "overwrite": False}),
        "shaper": (tmodes.shaper, {"robot": robot, "kind": "zv", "modes": (1,), "where": "start", "frequency": (), "damping": (), "tolerated": None, "out": None, "figure": None, "overwrite": False}),
        "learn": (tmodes.learn, {"robot": robot, "iterations": 1, "samples": 20, "caution": 0.03, "out": None, "figure": None, "overwrite": False}),
        "its frequency": (partial(tmodes.shaper, robot), {"frequency": (2.0,), "damping": (0.1,), "kind": "ei", "tolerated": 0.1}),
        "show": (tmodes.show, {"*": robot, "names": None, "height": 100}),
        "use": (tmodes.use, {"*": "no such module"}),
        "Robot.from_data": (tmodes.Robot.from_data, {"data": {}}),
        "Robot.with_": (robot.with_, {"changes": {}}),
        "its number": (lambda value: robot.with_({"gravity": value}), {"value": 9.8}),
        "its group": (lambda value: robot.with_({"integration": value}), {"value": {}}),
        "its list": (lambda value: robot.with_({"joints": value}), {"value": []}),
        "Robot.link": (robot.link, {"name": "link"}),
        "Robot.show": (robot.show, {"height": 100}),
        "Robot.model_copy": (robot.model_copy, {"update": None}),
        "Model.at_rest": (model.at_rest, {"gravity": 1.0}),
        "Model.forward_dynamics": (model.forward_dynamics, {**moves, "effort": 0.0, "given": 0.0, "wrenches": None, "step": 0.0}),
        "Model.inverse_dynamics": (model.inverse_dynamics, {**moves, "a": still, "wrenches": None}),
        "Model.inverse_dynamics_derivatives": (model.inverse_dynamics_derivatives, {**moves, "a": still, "wrenches": None}),
        "Model.bias": (model.bias, moves),
        "Model.points": (model.points, {**moves, "a": still}),
        "Model.linearize": (model.linearize, {**moves, "a": still, "wrenches": None}),
        "Model.stiffness": (model.stiffness, {"q": still, "wrenches": None, "base": None}),
        **{f"Model.{name}": (getattr(model, name), {"q": still}) for name in ("mass_matrix", "gravity", "pose", "jacobian")},
        **{f"Model.{name}": (getattr(model, name), {"q": still, "v": still}) for name in ("elastic_forces", "energies", "losses", "power_lost", "momentum")},
        "reduced_output": (tmodes.reduced_output, {"output": "tip.x", "how": "rms"}),
        "Result.output": (result.output, {"name": "tip.x"}),
        "Result.tables": (lambda everything: [*result.tables(everything)], {"everything": False}),
        "Result.reduce": (result.reduce, {"name": "tip.x", "how": "max"}),
        "outputs": (tmodes.outputs, {"robot": robot}),
        "parameters": (tmodes.parameters, {"robot": robot}),
        "equilibrium": (partial(equilibrium, model), {"loads": (), "held": None, "free": (), "start": None, "spin": None}),
        "Result.summary": (result.summary, {"band": 0.001}),
        "Result.save": (result.save, {"path": "again.nc", "overwrite": True}),
        "Result.load": (tmodes.Result.load, {"path": "r.nc"}),
        "Result.show": (result.show, {"height": 100}),
        "Study.from_data": (tmodes.Study.from_data, {"data": study.data, "functions": None}),
        "study_from_data": (study_from_data, {"data": study.data, "folder": None, "roots": (), "functions": None}),
        "Study.evaluate": (study.evaluate, {"first": 0, "values": np.ones((2, 1)), "threads": 1}),
        "Study.choice_names": (study.choice_names, {"name": "k"}),
        "System": (system, {"name": "s", "coordinates": {"x": "m"}, "parameters": {}}),
        "load_batch": (load_batch, {"folder": "batch"}),
        "static_numbers": (static_numbers, {"sheet": robot, "vary": vary, "names": ("mass",), "wrong": "error"}),
        "reduced": (reduced, {"sheet": robot, "vary": vary, "reductions": [Reduction("tip.z", "max")], "wrong": "error", "kept": ()}),
        "write_report": (write_report, {"result": result, "path": "report.html", "live": False, "spent": None}),
        "save_figures": (plot.save_figures, {"result": result, "folder": "figures", "formats": ("svg",), "names": ("energies",)}),
        **{f"plot.{name}": (one, {"result": result}) for name, one in plot.FIGURES.items()},
    }  # fmt: skip


def tried(function: Callable[..., Any], arguments: dict[str, Any], name: str, value: Any) -> str:
    """What is wrong with a call of which one argument is replaced; empty where nothing is."""
    given = arguments | {name: value}
    try:
        with bounded(LONGEST):
            function(*([given.pop("*")] if "*" in given else []), **given)
    except TmodesError as error:
        if len(str(error)) > 5000:
            return f"a message of {len(str(error))} characters"
    except Exception as error:
        return f"{type(error).__name__}: {error}"[:200]
    return ""


SLOW = {
    "save_figures": ("names", "folder"),
    "write_report": ("live",),
    "Robot.show": ("height",),
    "show": ("height",),
    "Result.show": ("height",),
}
"""Arguments that are tried with a few values: each call that succeeds draws."""


@pytest.mark.nightly
def test_no_argument_makes_another_error(calls, capfd) -> None:
    wrong: list[str] = []
    for name, (function, arguments) in calls.items():
        for argument in arguments:
            few = argument in SLOW.get(name, ())
            for kind, make in [*WRONG.items()][:: 6 if few else 1]:
                if found := tried(function, arguments, argument, make()):
                    wrong.append(f"{name}({argument} = {kind}): {found}")
    assert not wrong, "\n".join(wrong)


def test_every_public_name_is_tried(calls) -> None:
    """All of ``tmodes``, and every public method of its classes that takes arguments."""
    left = {name for name in tmodes.__all__ if inspect.isfunction(getattr(tmodes, name))} - calls.keys()
    for owner in (tmodes.Robot, tmodes.Model, tmodes.Result, tmodes.Study):
        for name, member in vars(owner).items():
            function = getattr(member, "__func__", member)
            public = inspect.isfunction(function) and not name.startswith("_")
            public &= member not in map(tmodes.__getattr__, tmodes.__all__)  # a command, that is a function too
            if public and len(inspect.signature(function).parameters) > 1:
                left |= {f"{owner.__name__}.{name}"} - calls.keys()
    assert left == {"Result.like"}  # of a part that is not public
