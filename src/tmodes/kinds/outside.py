"""Kinds of a user's own: loaded from Python files, modules and installed packages, when a person asks for it."""

from __future__ import annotations

import hashlib
import importlib
import importlib.util
import os
import sys
import sysconfig
import traceback
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from importlib.metadata import entry_points
from pathlib import Path

from tmodes.errors import InputError, TmodesError, error_words

__all__ = ["ENTRY_POINTS", "USED", "own_place", "use"]

ENTRY_POINTS = "tmodes.kinds"
"""Group of the entry points by which installed packages offer kinds."""

USED: list[str] = []
"""What :func:`use` has loaded, for other processes of the same program; files by their whole paths."""


def use(*names: str | os.PathLike[str]) -> list[str]:
    """Load kinds from outside, so that data sheets of this process can name them; the names that were loaded.

    ``names``: entry points of the group ``tmodes.kinds`` that installed packages offer, modules, or Python files; none:
    all entry points. This runs their code; only a person asks for it, never a sheet or a result.

    Raises :class:`tmodes.errors.InputError` for a name that is none of these, and for code that cannot be loaded, with
    the line at which it fails.

    >>> tmodes.use("own.py")  # which registers a controller, say
    ['own.py']
    """
    offered = {point.name: point for point in entry_points(group=ENTRY_POINTS)}
    asked = [os.fspath(name) if isinstance(name, str | os.PathLike) else _refused(name) for name in names or offered]
    for name in asked:
        known = name
        with _mistakes_located(name):
            if name in offered:
                offered[name].load()
            elif name.endswith(".py") and Path(name).is_file():
                known = str(Path(name).resolve())
                _run(Path(known))
            else:
                _import(name, offered)
        USED.append(known)
    return asked


def _refused(name: object) -> str:
    raise InputError("kinds", f"a {type(name).__name__}", "the name of an entry point, a module, or a Python file", "")


def _run(file: Path) -> None:
    """Import a file as a module, once: under its own name, or where another module has that, under one of its path."""
    name = file.stem if _is_free(file.stem, file) else f"{file.stem}_{hashlib.sha256(bytes(file)).hexdigest()[:8]}"
    if name in sys.modules:
        return
    spec = importlib.util.spec_from_file_location(name, file)
    assert spec is not None  # noqa: S101
    assert spec.loader is not None  # noqa: S101
    sys.modules[name] = module = importlib.util.module_from_spec(spec)
    sys.path.append(str(file.parent))  # last: no file there takes the place of an installed module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        sys.modules.pop(name, None)
        raise
    finally:
        sys.path.remove(str(file.parent))


def _is_free(name: str, file: Path) -> bool:
    """Whether no other module than this file is or could be imported under a name."""
    if not name.isidentifier():
        return False
    if name in sys.modules:
        found = getattr(sys.modules[name], "__file__", None)
        return found is not None and Path(found).resolve() == file
    spec = importlib.util.find_spec(name)
    return spec is None or (spec.origin is not None and Path(spec.origin).resolve() == file)


def _import(name: str, offered: Iterable[str]) -> None:
    try:
        importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name and not name.startswith(error.name):
            raise
        known = ", ".join(offered) or "none is installed"
        expected = f"an entry point of the group {ENTRY_POINTS} ({known}), a module, or a Python file"
        raise InputError("kinds", ascii(name)[:80], expected, "check the spelling and the path") from error


@contextmanager
def _mistakes_located(name: str) -> Iterator[None]:
    """What a user's code raises while it is loaded is a mistake there, and not a fault of tmodes."""
    try:
        yield
    except (TmodesError, KeyboardInterrupt):
        raise
    except BaseException as error:  # sys.exit there ends no command of ours
        expected = f"code that can be loaded from {name}"
        raise InputError("kinds", error_words(error), expected, "correct it there", own_place(error)) from error


def own_place(error: BaseException) -> str:
    """File and line of the user's code at which it failed: the last of the traceback outside of tmodes and Python."""
    if isinstance(error, SyntaxError) and error.filename:
        return f"{Path(error.filename).name}:{error.lineno}"
    ours = (str(Path(__file__).parents[1]), "<frozen", sysconfig.get_path("stdlib"))
    own = [frame for frame in traceback.extract_tb(error.__traceback__) if not frame.filename.startswith(ours)]
    return f"{Path(own[-1].filename).name}:{own[-1].lineno}" if own else ""
