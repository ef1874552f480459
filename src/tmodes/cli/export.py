"""``tmodes export``: a robot's compiled equations as files for other programs."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli import options
from tmodes.cli.options import chosen_sheet
from tmodes.cli.terminal import print_json, working
from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write, check_writable, file_error

__all__ = ["export"]


def export(
    robot: options.SheetArgument,
    wasm: Annotated[bool, typer.Option("--wasm", help="As WebAssembly, for a page or for Node.")] = False,
    reading: options.ReadingOption = None,
    contact: options.Contact = None,
    settings: options.Settings = None,
    integrator: options.IntegratorOption = None,
    root: options.Roots = None,
    trust_paths: options.TrustPaths = False,
    fix_inertia: options.FixInertia = False,
    out: Annotated[Path, typer.Option(metavar="DIR", help="Folder for the files.")] = Path(),
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace files that are there.")] = False,
    as_json: options.AsJson = False,
) -> None:
    """Write the robot's equations with integrator, reference, control and contact as a module for any web page.

    NAME.wasm (the equations, without other libraries), NAME.js (an ES module that runs them), NAME.d.ts (its types) and
    NAME.html (an example, which opens from disk).

    For example:  tmodes export filipovic2010 --wasm --out page    then, in a page of yours
    import { open } from "./filipovic2010.js"; const run = await (await open()).run();
    """
    from tmodes.cli.run import folder_name
    from tmodes.interface.integration import run_changes
    from tmodes.live.wasm_export import exported

    if not wasm:
        raise InputError("export", "none", "called with a kind of files", f"write: tmodes export {robot} --wasm")
    changes = run_changes(integrator=integrator)
    sheet = chosen_sheet(
        robot, settings, reading, contact, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia, changes=changes
    )
    name = folder_name(sheet.name)
    with working("compiling", at_once=True):
        made = exported(sheet, name)
    paths = {end: out / f"{name}.{end}" for end in made.files}
    _write({paths[end]: content for end, content in made.files.items()}, overwrite)
    _report({end: str(path) for end, path in paths.items()}, made.description["method"], made.files, as_json)


def _write(files: dict[Path, bytes], overwrite: bool) -> None:
    """All of them, or none where one is there already."""
    for path in files:
        if os.path.lexists(path) and not overwrite:
            raise file_error(path, "a file that exists", "a new name", "choose another --out, or give --overwrite")
    check_writable(next(iter(files)).parent, sum(map(len, files.values())))
    for path, content in files.items():
        with atomic_write(path, overwrite=overwrite) as temporary:
            temporary.write_bytes(content)


def _report(paths: dict[str, str], method: str, files: Mapping[str, bytes], as_json: bool) -> None:
    sizes = {end: len(content) for end, content in files.items()}
    if as_json:
        print_json({"files": paths, "bytes": sizes, "method": method})
        return
    for end, path in paths.items():
        print(f"{path}  {sizes[end] / 1e3:.0f} kB")
    print(f"integrated by {method}; open {paths['html']} to see it run")
