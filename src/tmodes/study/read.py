"""Read a study: its file, the robot and the tables that it names; all that is wrong is reported together."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from tmodes.errors import InputError, InputErrors
from tmodes.io.arguments import checked_arguments, copied
from tmodes.io.checked_sheet import checked_sheet, located
from tmodes.io.files import FilePath, Folders, Roots, folders_of
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_problems import Problem
from tmodes.io.words import shown, shown_path
from tmodes.io.yaml_file import nearest_line, read_yaml
from tmodes.robots import names as published_names
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.study.plain_data import Shorthands, expanded, filled_places
from tmodes.study.resolve import resolved_parameters, resolved_plan, words_of_path
from tmodes.study.sheet import StudySheet
from tmodes.study.study import Study, study_problems, unknown_names

__all__ = ["as_study", "read_study", "study_from_data", "study_of_robot"]

Functions = Mapping[str, Callable[[Any], float]]

MOST_VALUES = 3_000_000
"""Largest number of values in the plain data of a study, tables included."""


@checked_arguments
def read_study(
    path: FilePath, *, roots: Roots = (), trust_paths: bool = False, functions: Functions | None = None
) -> Study:
    """The checked study of a YAML file.

    Files that it names (robot, catalogues, samples) must lie in its folder or in ``roots``, unless ``trust_paths``.
    ``functions``: Python functions of a :class:`tmodes.Result`, which quantities of the type ``function`` name. Raises
    :class:`tmodes.errors.InputError` where it cannot be read, and :class:`tmodes.errors.InputErrors` with all wrong
    values and their lines.

    >>> tmodes.read_study("study.yaml").cases
    4
    """
    data, positions = read_yaml(path)
    source = shown_path(path)
    folder = Path(path).absolute().parent
    return _study(data, positions, source, folders_of(path, roots, trust_paths), functions or {}, folder)


def as_study(study: Study | FilePath) -> Study:
    """A study, also from its file; raises as :func:`read_study`."""
    return study if isinstance(study, Study) else read_study(study)


@checked_arguments
def study_from_data(
    data: Mapping[str, Any], *, folder: FilePath | None = None, roots: Roots = (), functions: Functions | None = None
) -> Study:
    """The study of plain data: :attr:`Study.data` of another one, or the content of a file.

    Files that the latter names lie in ``folder``; without one it can name none. Raises as :func:`read_study`.
    """
    if isinstance(data, Mapping) and set(data) == {"study", "robot"}:
        robot = None if data["robot"] is None else Robot.from_data(data["robot"]).commanded()
        return _checked(data["study"], robot, {}, "", [], (), functions or {}, None)
    folders = Folders(Path(folder).resolve(), tuple(Path(root).resolve() for root in roots)) if folder else None
    return _study(copied(data, "study"), {}, "", folders, functions or {}, Path(folder) if folder else None)


def study_of_robot(
    robot: Robot,
    study: Study | Mapping[str, Any] | FilePath,
    *,
    roots: Roots = (),
    trust_paths: bool = False,
    functions: Functions | None = None,
) -> Study:
    """The study of a robot that is loaded already: plain data as in a file, a file or a study, whose robot it takes.

    Raises as :func:`read_study`.
    """
    if isinstance(study, Study):
        data = {"study": dict(study.data["study"]), "robot": sheet_data(robot)}
        return study_from_data(data, functions=functions or study.functions)
    if isinstance(study, Mapping):
        head = {"format": 1, "kind": "study", "name": robot.name}
        return _of_robot(robot, {**head, **copied(study, "study")}, Shorthands({}, "", None), functions or {}, None)
    data, positions = read_yaml(study)
    found = Shorthands(positions, shown_path(study), folders_of(study, roots, trust_paths))
    return _of_robot(robot, dict(data), found, functions or {}, Path(study).absolute().parent)


def _study(
    data: Any,
    positions: dict[str, int],
    source: str,
    folders: Folders | None,
    functions: Functions,
    folder: Path | None,
) -> Study:
    where = f"{source}:{positions.get('kind', 1)}" if source else ""
    if not isinstance(data, Mapping) or data.get("kind") != "study":
        got = shown(data.get("kind") if isinstance(data, Mapping) else data)
        raise InputErrors([InputError("kind", got, "study", "write `kind: study`, and `format: 1`", where)])
    robot = _robot(data, positions, source, folders)
    return _of_robot(robot, dict(data), Shorthands(positions, source, folders), functions, folder)


def _of_robot(
    robot: Robot | None, data: dict[str, Any], found: Shorthands, functions: Functions, folder: Path | None
) -> Study:
    plain = expanded(data, found)
    changed, problems = _changed(robot, plain)
    problems += resolved_parameters(plain, changed, found) + resolved_plan(plain, found)
    try:
        places = filled_places(plain, found.filled)
        study = _checked(plain, changed, found.positions, found.source, problems, places, functions, folder)
        if wrong := list(unknown_names(study)):
            raise located(wrong, plain, found.positions, found.source)
    except InputErrors as errors:
        raise InputErrors([*map(found.as_written, errors.errors), *found.errors]) from None
    if found.errors:
        raise InputErrors(found.errors)
    return study


def _checked(
    plain: Any, robot: Robot | None, positions: Mapping[str, int], source: str, problems: list[Problem],
    filled: tuple[str, ...], functions: Functions, folder: Path | None,
) -> Study:  # fmt: skip
    """The study of complete plain data, in which text stands for numbers at the places ``filled`` alone."""
    sheet: StudySheet = checked_sheet(plain, positions, source, filled, most=MOST_VALUES, further=lambda _: problems)
    if problems:
        raise located(problems, plain, positions, source)
    data = {"study": sheet.model_dump(mode="json", exclude_defaults=True), "robot": robot and sheet_data(robot)}
    places = {name: f"{source}:{nearest_line(f'quantities.{name}', positions)}" for name in sheet.quantities if source}
    study = Study(sheet, robot, data, folder, functions, places)
    if wrong := list(study_problems(study, functions_known=bool(source))):
        raise located(wrong, plain, positions, source)
    return study


def _robot(data: Mapping[str, Any], positions: Mapping[str, int], source: str, folders: Folders | None) -> Robot | None:
    """The robot that a study names, as its own sheet states it."""
    name = data.get("robot")
    if not isinstance(name, str) or not name:
        return None
    if name in published_names():
        return load(name)
    place = f"{source}:{nearest_line('robot', positions)}" if source else ""
    path = folders.find(name, "robot", place) if folders else None
    if path is None or not path.exists():
        known = ", ".join(published_names())
        got, hint = f"{shown(name)}, neither published nor a file there", f"published are {known}"
        raise InputErrors([InputError("robot", got, "a published robot, or a file in the study's folder", hint, place)])
    return load(path, roots=folders.roots if folders else (), trust_paths=bool(folders and folders.trust))


def _changed(robot: Robot | None, plain: Mapping[str, Any]) -> tuple[Robot | None, list[Problem]]:
    """The robot with the changes for all cases, its drives on the path of its task; what is wrong with the changes."""
    changes = plain.get("set")
    if not isinstance(changes, Mapping) or not changes:
        return robot and robot.commanded(), []
    if robot is None:
        return None, [
            (("set",), InputError("", "changes without a robot", "left out without a robot", "name the robot"))
        ]
    try:
        return robot.with_(changes).commanded(), []
    except InputError as error:
        wrong = [error]
    except InputErrors as errors:
        wrong = [*errors.errors]
    places = [("set", error.which) if error.which in changes else ("set",) for error in wrong]
    own = [InputError("", *words_of_path(error)) for error in wrong]
    return robot, [*zip(places, own, strict=True)]
