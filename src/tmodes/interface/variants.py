"""The task of a comparison, as a file or its arguments state it: variants of one robot, and what is uncertain of it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_data
from tmodes.io.units import finite_number
from tmodes.io.words import meant, shown, shown_path
from tmodes.io.yaml_file import nearest_line, read_yaml

if TYPE_CHECKING:
    from tmodes import Robot as UsersRobot
    from tmodes.sheet import Robot
    from tmodes.study.study import Study

__all__ = [
    "Task", "differences", "effort_limits", "effort_quantities", "read_task", "uncertain_of", "uncertain_parameters",
    "uncertain_robots", "uncertain_study", "varied",
]  # fmt: skip

KEYS = ("variants", "uncertain", "plan", "tolerance")
_SHAPER, _CONTROL = "shaper", "control"
_OF_SHAPER = ("kind", "modes", "where", "frequency", "damping", "tolerated")
MOST_VARIANTS = 50

_OF_COMMANDS = ("drives", "sensors", "control", "integration", "initial", "task", "base_motion", "real")
"""Parts of a sheet that do not say what the robot itself is, from which a law may be designed."""

FINAL, LARGEST = "final_error", "largest_error"
"""Quantities of uncertain cases: error of the tip from its commanded path [m], at the end and the largest."""


@dataclass(frozen=True)
class Task:
    """``variants`` and ``uncertain`` parameters by name, the ``plan`` of the cases, the ``tolerance`` [m] or None."""

    variants: Mapping[str, Any]
    uncertain: Mapping[str, Any]
    plan: Mapping[str, Any]
    tolerance: float | None
    source: str = ""
    positions: Mapping[str, int] = field(default_factory=dict)

    def located(self, error: InputError, which: str) -> InputError:
        """The error of a value that stands at the path ``which`` of the file."""
        line = nearest_line(which, self.positions)
        return replace(error, which=which, where=f"{self.source}:{line}" if self.source and line else self.source)


def read_task(
    variants: Mapping[str, Any] | str | os.PathLike[str], uncertain: Mapping[str, Any] | None,
    plan: Mapping[str, Any] | None, tolerance: float | str | None, robot: Robot, sheets: Mapping[str, Robot],
) -> Task:  # fmt: skip
    """The task of a file, or of arguments, which go before what a file says.

    Raises :class:`tmodes.errors.InputError` for a file that cannot be read, unknown keys, and no variant.
    """
    found = Task(variants if isinstance(variants, Mapping) else {}, {}, {}, None)
    if not isinstance(variants, Mapping):
        data, positions = read_yaml(variants)
        found = Task({}, {}, {}, None, shown_path(variants), positions)
        for key in data:
            if key not in KEYS:
                error = InputError(key, "an unknown key", f"one of {', '.join(KEYS)}", meant(key, KEYS, ""))
                raise found.located(error, key)
            if key != "tolerance" and not isinstance(data[key], Mapping):
                raise found.located(InputError(key, shown(data[key]), "names and values", "write `name: {...}`"), key)
        found = replace(found, **data)
    found = replace(found, variants={**sheets, **found.variants})
    if not 1 <= len(found.variants) <= MOST_VARIANTS:
        got, hint = f"{len(found.variants)} variants", "write `variants: {as it is: {}, NAME: {PATH: VALUE}}`"
        raise found.located(InputError("variants", got, f"1 to {MOST_VARIANTS} of them", hint), "variants")
    accepted = tolerance if tolerance is not None else found.tolerance
    if accepted is None:
        accepted = robot.task.tolerance if robot.task else None
    else:
        accepted = finite_number("tolerance", accepted, "m", "a length > 0")
        if accepted <= 0:
            raise InputError("tolerance", f"{accepted:g}", "a length > 0 [m]", "leave it out where there is none")
    return replace(found, uncertain=uncertain or found.uncertain, plan=plan or found.plan, tolerance=accepted)


def varied(
    robot: Robot, name: str, given: Any, task: Task, progress: Callable[[str, float], None] = lambda stage, share: None
) -> UsersRobot:
    """The robot of one variant, its drives on the path of its task.

    Raises :class:`tmodes.errors.InputErrors` with the path of each wrong value.
    """
    from tmodes import Robot as Whole
    from tmodes.sheet import Robot as Sheet

    here = f"variants.{name}"
    if isinstance(given, Sheet):
        return Whole.of(given.commanded(progress))
    if not isinstance(given, Mapping):
        hint = "write `{}` for the robot as it is, or values by their paths"
        raise task.located(InputError(here, shown(given), "values by path, or a robot", hint), here)
    changes = {str(path): value for path, value in given.items() if path != _SHAPER}
    for drive in _commanded(changes.get(_CONTROL)):
        changes.setdefault(f"drives.{drive}.controller", None)  # the block commands it
    try:
        found = Whole.of(robot).with_(changes) if changes else Whole.of(robot)
        found = Whole.of(found.commanded(progress))
        return Whole.of(found.shaper(**_of_shaper(given[_SHAPER])).robot) if _SHAPER in given else found
    except InputError as error:
        raise task.located(error, f"{here}.{error.which}") from None
    except InputErrors as errors:
        raise InputErrors([task.located(one, f"{here}.{one.which}") for one in errors.errors]) from None


def _of_shaper(given: Any) -> dict[str, Any]:
    """Arguments of a shaper; raises :class:`tmodes.errors.InputError` for what is none."""
    if not isinstance(given, Mapping):
        raise InputError(_SHAPER, shown(given), "arguments by name", "write `shaper: {kind: zvd}`")
    for key in given:
        if key not in _OF_SHAPER:
            expected = f"one of {', '.join(_OF_SHAPER)}"
            raise InputError(f"{_SHAPER}.{key}", "an unknown key", expected, meant(str(key), _OF_SHAPER, ""))
    return dict(given)


def _commanded(control: Any) -> Iterator[str]:
    """Joints whose drives the blocks of a `control` section command, as far as it is one."""
    for block in control if isinstance(control, (list, tuple)) else ():
        drives = block.get("drives") if isinstance(block, Mapping) else None
        yield from (str(one) for one in drives if isinstance(one, str)) if isinstance(drives, (list, tuple)) else ()


def effort_limits(robot: Robot) -> dict[str, float]:
    """The largest effort of each drive [N*m, N] by its joint: the joint's limit, or what the drive can give if less."""
    own = {joint.name: joint.limits.effort for joint in robot.joints if joint.limits}
    given = {one.joint: (own.get(one.joint), one.saturation and one.saturation.torque) for one in robot.drives}
    return {name: min(known) for name, both in given.items() if (known := [one for one in both if one])}


def effort_quantities(robot: Robot) -> dict[str, tuple[str, float]]:
    """Names of quantities for the largest effort of each drive with a limit: its joint, and the limit."""
    return {f"effort_{k}": one for k, one in enumerate(effort_limits(robot).items())}


def uncertain_study(robot: Robot, task: Task, cases: int, runs: int | None) -> Study | None:
    """The uncertain cases of a variant as a study; None where nothing is uncertain.

    Raises :class:`tmodes.errors.InputErrors` for what is wrong in it.
    """
    from tmodes.interface.studies import changed_study
    from tmodes.study.plans.contract import PLANS
    from tmodes.study.read import study_of_robot

    if not task.uncertain:
        return None
    data = sheet_data(robot)
    quantities = {LARGEST: {"series": "tip_error", "reduce": "max"}, FINAL: {"series": "tip_error", "reduce": "end"}}
    efforts = effort_quantities(robot).items()
    quantities |= {name: {"series": f"{joint}.effort", "reduce": "max_abs"} for name, (joint, _) in efforts}
    try:
        parameters = uncertain_parameters(task.uncertain, data)
        plan = {"type": "monte_carlo", **task.plan}
        if (kind := str(plan["type"])) in PLANS and "runs" in PLANS[kind].model_fields:
            plan = {"runs": cases} | plan
        asked = {"parameters": parameters, "plan": plan, "quantities": quantities}
        found = study_of_robot(robot, asked)
        drawn = {path.removeprefix("real.") for target in found.targets.values() for path in target.paths}
        kept = {path: factor for path, factor in robot.real.items() if path not in drawn}
        if kept.keys() != robot.real.keys():  # a number that is not drawn in a case is as known
            found = study_of_robot(robot.with_({"real": kept}), asked)
        return changed_study(found, {}, runs)
    except InputError as error:
        raise task.located(error, _written(error.which)) from None
    except InputErrors as errors:
        raise InputErrors([task.located(one, _written(one.which)) for one in errors.errors]) from None


def uncertain_robots(robot: Robot, uncertain: Mapping[str, Any], cases: int, seed: int) -> Iterator[Robot]:
    """Actual robots, drawn; their laws are designed for the one that is known."""
    from tmodes.study.mapping import groups_of

    study = uncertain_study(robot, Task({}, uncertain, {"seed": seed}, None), cases, None)
    if study is None or study.robot is None:
        return
    for group in groups_of(study.robot, study.names, study.targets, study.choices, study.design().values):
        if group.robot is None:
            raise InputError("uncertain", group.wrong, "numbers that a robot can have", "narrow the distributions")
        for k in range(len(group.places)):
            yield group.robot.with_({path: float(values[k]) for path, values in group.vary.items()}).pair().real


def uncertain_of(given: Mapping[str, Any] | str | os.PathLike[str] | None) -> Mapping[str, Any]:
    """Uncertain parameters by name: as they are given, or of a file with a comparison."""
    if given is None or isinstance(given, Mapping):
        return given or {}
    found = read_yaml(given)[0].get("uncertain")
    if not isinstance(found, Mapping) or not found:
        raise InputError("uncertain", f"{shown_path(given)} without it", "a file with `uncertain`", _AS_UNCERTAIN)
    return found


_AS_UNCERTAIN = "write `uncertain: {k: {path: gear.stiffness, relative: true, distribution: {...}}}`"


def uncertain_parameters(uncertain: Mapping[str, Any], data: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters of a study for them: what is relative to a number of the robot varies the actual robot alone."""
    return {str(name): _of_actual(str(name), one, data) for name, one in uncertain.items()}


def _written(which: str) -> str:
    """A path of a study as it stands in the file."""
    return f"uncertain{which.removeprefix('parameters')}" if which.startswith("parameters") else which


def _of_actual(name: str, given: Any, data: Mapping[str, Any]) -> Any:
    """A parameter of a study: relative to a number of the robot, it is a factor on the actual one alone."""
    from tmodes.study.mapping import target_of
    from tmodes.study.resolve import words_of_path

    path = given.get("path") if isinstance(given, Mapping) else None
    if not isinstance(path, str) or path.startswith("real"):
        return given
    try:
        target = target_of(path, data, relative=False)
    except InputError as error:
        raise InputError(f"uncertain.{name}.path", *words_of_path(error)) from None
    if target.paths[0].partition(".")[0] in _OF_COMMANDS:
        return given
    if given.get("relative") is not True:
        hint = "write `relative: true`, and factors on the known number"
        expected = "relative: a controller would know a number that is set for the robot as known, too"
        raise InputError(f"uncertain.{name}", f"numbers of {path}", expected, hint)
    return {**{key: value for key, value in given.items() if key != "relative"}, "path": f"real:{path}"}


def differences(robots: Mapping[str, Robot]) -> Iterator[str]:
    """In what variants differ besides their laws and the way between the same ends of their motion."""
    (first, own), *others = robots.items()
    base, ends = _besides(own), _ends(own)
    for name, robot in others:
        data = _besides(robot)
        apart = [key for key in data.keys() | base.keys() if data.get(key) != base.get(key)]
        if apart:
            yield f"`{name}` and `{first}` differ in more than their laws and signals: {', '.join(sorted(apart))}"
        if ends.keys() == _ends(robot).keys() and (far := [k for k, end in _ends(robot).items() if _off(end, ends[k])]):
            yield f"`{name}` and `{first}` do not move between the same ends: {', '.join(far)}"


_NAMES = ("name", "title", "citation", "assumed", "notices", "imported", "drives", "sensors", "control")


def _besides(robot: Robot) -> dict[str, Any]:
    """Plain data of a robot without its name, laws and signals."""
    data = dict(sheet_data(robot))
    limits = {one["joint"]: one.get("saturation") for one in data.get("drives", ())}
    return {key: value for key, value in data.items() if key not in _NAMES} | {"saturation": limits}


def _ends(robot: Robot) -> dict[str, tuple[float, float]]:
    """Setpoint of each drive at the start and at the end of the run."""
    end, found = robot.integration.duration, {}
    for drive in robot.drives:
        pieces = drive.signal.schedule(end)
        found[drive.joint] = float(pieces.at(0.0)), float(pieces.at(end))
    return found


def _off(one: tuple[float, float], other: tuple[float, float]) -> bool:
    return any(abs(a - b) > 1e-6 * max(1.0, abs(a)) for a, b in zip(one, other, strict=True))
