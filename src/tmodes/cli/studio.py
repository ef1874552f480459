"""``tmodes studio``: a page on this machine to change a robot and see it move at once."""

from __future__ import annotations

import sys
from contextlib import ExitStack, suppress
from importlib.util import find_spec
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Annotated

import typer

from tmodes.errors import InputError
from tmodes.io.words import shown_path
from tmodes.robots import FIRST
from tmodes.robots.load import load, sheet_names

if TYPE_CHECKING:
    from tmodes.studio.folders import WorkingFolder

__all__ = ["studio"]


def studio(
    robot: Annotated[
        str,
        typer.Argument(metavar="[ROBOT|FILE]", help="What is shown first: a published robot, or a file of the folder."),
    ] = FIRST[0],
    folder: Annotated[Path, typer.Option(help="Where studies are kept; nothing outside is read or written.")] = Path(),
    port: Annotated[int, typer.Option(min=0, max=65535, help="0: any that is free.")] = 0,
    host: Annotated[
        str, typer.Option(help="Address to listen at; another than this machine's own opens it to others.")
    ] = "127.0.0.1",
    browser: Annotated[bool, typer.Option("--open/--no-open", help="Open the page in the browser.")] = True,
) -> None:
    """A local web application: choose a robot, change its parameters, see it move and vibrate, save it as YAML.

    Only this machine can reach it, and only with the address that is printed. Ctrl-C stops it.
    """
    for package in ("fastapi", "uvicorn"):
        if find_spec(package) is None:
            got, hint = f"no package {package}", "install it: pip install 'tmodes[studio]'"
            raise InputError("tmodes studio", got, "run with the extra `studio`", hint)
    from tmodes.studio.folders import WorkingFolder
    from tmodes.studio.serve import serve

    working = WorkingFolder(folder)
    first = _first(robot, working)
    with ExitStack() as until_stopped:
        opened = until_stopped if browser else None
        serve(working, first, host=host, port=port, ready=lambda address: _ready(address, working.path, opened))
    with suppress(OSError):  # the terminal may be what was closed
        print("tmodes studio: stopped", file=sys.stderr)


def _first(robot: str, folder: WorkingFolder) -> str:
    """What is shown first, checked: a published robot, or the name of a file of the working folder."""
    if robot in sheet_names():
        return robot
    _refuse_what_is_no_robot(Path(robot))
    load(robot)
    path = Path(robot).absolute()
    if path.parent.resolve() != folder.path:
        hint = f"add --folder {path.parent}"
        raise InputError("FILE", repr(robot), "a file of the working folder", hint)
    return f"./{folder.existing(path.name).name}"


def _refuse_what_is_no_robot(path: Path) -> None:
    expected = "a published robot, or a data sheet or URDF"
    if path.suffix == ".nc" or (path / "result.nc").is_file():
        hint = f"look at it with: tmodes view {path}"
        raise InputError("ROBOT|FILE", f"a result ({shown_path(path)})", expected, hint)
    if path.is_dir():
        hint = f"to work in this folder: tmodes studio --folder {path}"
        raise InputError("ROBOT|FILE", f"a folder ({shown_path(path)})", expected, hint)


def _ready(address: str, folder: Path, until_stopped: ExitStack | None) -> None:
    """Tell the address; with ``until_stopped`` also open it, by way of a page that goes when the studio stops."""
    with suppress(OSError):  # who started it may have stopped to listen
        print(f"open    {address}\nfolder  {folder}\nstop    Ctrl-C", flush=True)
    if until_stopped is None:
        return
    import webbrowser

    from tmodes.studio.folders import door

    if page := until_stopped.enter_context(door(address)):
        # A browser in the terminal ends only when it is closed, and the page needs the server meanwhile.
        Thread(target=webbrowser.open, args=(page.as_uri(),), daemon=True).start()
