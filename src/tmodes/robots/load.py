"""From a name or a file to a checked robot."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping, Sequence
from contextlib import nullcontext
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.robots import MODELS, installed_models, published, unknown
from tmodes.robots import names as sheet_names
from tmodes.robots import text as sheet_text

if TYPE_CHECKING:
    from tmodes.io.urdf import UrdfRobot
    from tmodes.sheet import Robot

__all__ = ["load", "load_with_urdf", "sheet_names", "sheet_text", "urdf_of"]

Roots = Sequence[str | os.PathLike[str]]


def load(
    name_or_path: str | os.PathLike[str],
    changes: Mapping[str, Any] | None = None,
    *,
    roots: Roots = (),
    trust_paths: bool = False,
    fix_inertia: bool = False,
) -> Robot:
    """A checked robot from the name of a published one, or from a file (a name wins; write ``./name`` for a file).

    A file is a data sheet, a Denavit-Hartenberg table, URDF, xacro, MJCF, an elasticity file of a URDF, or a sheet of
    the 2010 robot. ``changes`` are values by dotted path; ``roots`` and ``trust_paths`` say where the files that a file
    names may lie; ``fix_inertia``: impossible inertias of a URDF are raised to possible ones. Raises
    :class:`tmodes.errors.InputError` when there is no such robot or it cannot be read, and
    :class:`tmodes.errors.InputErrors` with all wrong values and their lines.
    """
    return load_with_urdf(name_or_path, changes, roots=roots, trust_paths=trust_paths, fix_inertia=fix_inertia)[0]


def load_with_urdf(
    name_or_path: str | os.PathLike[str],
    changes: Mapping[str, Any] | None = None,
    *,
    roots: Roots = (),
    trust_paths: bool = False,
    fix_inertia: bool = False,
) -> tuple[Robot, UrdfRobot | None]:
    """The same, with the URDF (or xacro) on which it stands, None for what stands on none; its files are read once."""
    return _loaded(name_or_path, changes, roots=roots, trust_paths=trust_paths, fix_inertia=fix_inertia)


@checked_arguments
def _loaded(
    name_or_path: Any,
    changes: Mapping[str, Any] | None,
    *,
    roots: Roots,
    trust_paths: bool,
    fix_inertia: bool,
) -> tuple[Robot, UrdfRobot | None]:
    """The same, for anything as name or path."""
    from tmodes.io.sheet_files import read_file
    from tmodes.io.words import shown, shown_path

    if not isinstance(name_or_path, (str, os.PathLike)):
        hint = 'write tmodes.load("spong1987"), or the path of a file'
        raise InputError("robot", shown(name_or_path), "the name of a published robot, or the path of a file", hint)
    source = shown_path(name_or_path)
    if file := published().get(str(name_or_path)):
        with resources.as_file(file) as path:
            _refuse_without_model(path, roots)
            read, source = read_file(path, (*roots, *installed_models())), path.name
    elif os.path.lexists(name_or_path):
        read = read_file(name_or_path, (*roots, *installed_models()), trust_paths, fix_inertia=fix_inertia)
    else:
        raise unknown(source, sheet_names())
    return _checked(read.data, read.positions, source, changes or {}), read.urdf


def urdf_of(name_or_path: str | os.PathLike[str], *, roots: Roots = (), trust_paths: bool = False) -> UrdfRobot | None:
    """The URDF (or xacro) on which the robot of this name or file stands; None for what stands on none.

    Raises as :func:`load`.
    """
    from tmodes.io.sheet_files import read_file

    file = published().get(str(name_or_path))
    with resources.as_file(file) if file else nullcontext(Path(name_or_path)) as path:
        return read_file(path, (*roots, *installed_models()), trust_paths, fix_inertia=True).urdf


def _refuse_without_model(path: Path, roots: Roots) -> None:
    """A published sheet that stands on a model of another package says which, where that is not installed."""
    if not roots and not installed_models() and _stands_on_urdf(path):
        got, expected = f"a robot of the package {MODELS}, which is not installed", "a robot whose package is installed"
        raise InputError("robot", got, expected, "install it: pip install 'tmodes[robots]'")


def _stands_on_urdf(path: Path) -> bool:
    """Whether a published sheet, whose keys are plain words, is an elasticity file."""
    return any(line.startswith("urdf:") for line in path.read_text(encoding="utf-8").splitlines())


def _checked(data: dict[str, Any], positions: dict[str, int], source: str, changes: Mapping[str, Any]) -> Robot:
    from tmodes.io.sheet_check import sheet_from_data
    from tmodes.io.sheet_groups import later_changes
    from tmodes.io.sheet_paths import changed_places
    from tmodes.io.words import shown

    if data.get("kind", "arm") != "arm":
        where = f"{source}:{positions.get('kind', 1)}"
        study = "a study is checked and run by `tmodes study FILE`; its robot by `tmodes check`"
        hint = study if data["kind"] == "study" else "write `kind: arm`"
        raise InputError("kind", shown(data["kind"]), "arm", hint, where)
    later = later_changes(data, changes)
    changed, places = changed_places(data, {path: changes[path] for path in changes if path not in later})
    robot = sheet_from_data(changed, _kept_lines(positions, places), source)
    return robot.with_(later) if later else robot


def _kept_lines(positions: Mapping[str, int], changes: Collection[str]) -> dict[str, int]:
    """The lines of what stands in the file; what was changed, given by its dotted paths, has none."""
    inside = tuple(f"{changed}." for changed in changes)
    kept = {path: line for path, line in positions.items() if path not in changes and not path.startswith(inside)}
    return kept | dict.fromkeys(changes, 0)
