"""``import tmodes`` is light, and its face shows what it says."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest

import tmodes

HEAVY = ("casadi", "h5netcdf", "h5py", "llvmlite", "matplotlib", "numpy", "pint", "pydantic", "rich", "scipy", "xarray")


def in_fresh_python(code: str) -> str:
    return subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout


def test_import_loads_nothing_heavy() -> None:
    loaded = in_fresh_python(f"import sys, tmodes; print([name for name in {HEAVY} if name in sys.modules])")
    assert loaded.strip() == "[]"


def test_robots_are_loaded_without_plotting_and_compiler() -> None:
    heavy = ("casadi", "llvmlite", "matplotlib", "xarray")
    loaded = in_fresh_python(
        f"import sys, tmodes; tmodes.load('filipovic2010'); print([n for n in {heavy} if n in sys.modules])"
    )
    assert loaded.strip() == "[]"


def test_the_command_line_is_parsed_without_what_computes() -> None:
    """Help and a wrong option are answered before anything heavy is loaded."""
    heavy = ("casadi", "llvmlite", "matplotlib", "numpy", "pydantic", "rich", "scipy", "xarray")
    loaded = in_fresh_python(f"import sys, tmodes.cli.main; print([n for n in {heavy} if n in sys.modules])")
    assert loaded.strip() == "[]"


UNREAD = (
    "cli.study", "io.mjcf", "io.urdf", "io.xacro", "kinds.contacts.ball", "kinds.joints.prismatic",
    "kinds.links.strain", "kinds.signals.noise", "model.derivatives", "plot.figure", "study",
)  # fmt: skip
"""Modules of other commands, of other formats than the sheet's, and of kinds that it does not name."""


@pytest.mark.parametrize("command", ["check", "modes", "describe"])
def test_commands_that_only_read_load_neither_figures_nor_scipy(command: str) -> None:
    """Each would take as long to load as the rest of the command."""
    heavy = ["matplotlib", "pandas", "scipy", "xarray", *(f"tmodes.{name}" for name in UNREAD)]
    code = (
        "import sys; from tmodes.cli.main import main\n"
        f"sys.argv = ['tmodes', '{command}', 'spong1987']\n"
        "try:\n    main()\n"
        f"finally:\n    print([n for n in {heavy} if n in sys.modules])"
    )
    *shown, loaded = in_fresh_python(code).splitlines()
    assert shown
    assert loaded == "[]"


def test_a_report_is_written_without_the_figures_for_print() -> None:
    unwanted = ("tmodes.plot.drawing", "tmodes.plot.figures.energies", "tmodes.io.urdf", "matplotlib", "xarray")
    code = f"import sys, tmodes.report.folder; print([name for name in {unwanted} if name in sys.modules])"
    assert in_fresh_python(code).strip() == "[]"


def test_names_are_sorted_and_shown() -> None:
    assert list(tmodes.__all__) == sorted(tmodes.__all__)
    assert set(tmodes.__all__) <= set(dir(tmodes))


def test_names_stay_themselves_when_all_modules_are_loaded() -> None:
    """A submodule of the same name would hide a function of the face once it is imported."""
    code = (
        "import importlib, pkgutil, tmodes\n"
        "first = {name: getattr(tmodes, name) for name in tmodes.__all__}\n"
        "for one in pkgutil.walk_packages(tmodes.__path__, 'tmodes.'):\n"
        "    if not one.name.endswith('__main__'):\n"
        "        importlib.import_module(one.name)\n"
        "print([name for name, one in first.items() if not callable(one) or getattr(tmodes, name) is not one])"
    )
    assert in_fresh_python(code).strip() == "[]"


def test_unknown_name_is_refused() -> None:
    with pytest.raises(AttributeError, match="no attribute 'robot_of_mine'"):
        tmodes.robot_of_mine  # noqa: B018


def test_import_time(benchmark: Any) -> None:
    """A fresh Python that imports tmodes: `python tools/check.py bench` shows how long; only an absurd time fails."""
    benchmark.pedantic(in_fresh_python, args=("import tmodes",), rounds=3, warmup_rounds=1)
    if benchmark.enabled:
        assert benchmark.stats.stats.min < 3.0
