"""``tmodes show``: what a stored result says on the terminal, to machines, and of files that are no results."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from command import COMMAND, tmodes
from result.synthetic import synthetic_result
from see.runs import NASTY, result_of
from tmodes.cli.series import ASCII, BLOCKS, series_of_result, sparkline, steps_for
from tmodes.result import Result

SHOW = [*COMMAND, "show"]


@pytest.fixture(scope="module")
def robot_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("a run")
    synthetic_result(samples=401).save(folder / "result.nc")
    return folder


@pytest.fixture(scope="module")
def arm_result() -> Result:
    return result_of("swinging")


def info(*arguments: object, **more):
    return tmodes("show", *arguments, **more)


def test_folder_and_file_tell_the_same(robot_run):
    for options in ([], ["--all"]):
        shown = info(robot_run, *options).stdout
        assert shown.replace("\\", "/") == info(robot_run / "result.nc", *options).stdout.replace("\\", "/")
        assert "\x1b" not in shown
        for word in ("finished", "rror from nominal path", "mm"):
            assert word in shown
        for word in ("locked", "damping ratio", "voltage joint [V]", "█"):
            assert (word in shown) == bool(options)


def test_numbers_for_machines_are_those_of_the_series(robot_run):
    found = json.loads(info(robot_run, "--json").stdout)
    data = Result.load(robot_run / "result.nc").data
    tip = data["tip"].sel(axis="y").values
    own = next(one for one in found["series"] if (one["variable"], one["of"]) == ("tip", "y"))
    assert (own["min"], own["max"], own["end"]) == (tip.min(), tip.max(), tip[-1])
    assert own["unit"] == "m"
    assert found["summary"]["deviation"]["max_m"] == data["deviation"].values.max()


def test_an_arm_with_a_nasty_name(arm_result, tmp_path):
    """Names are text; each series of an arm has the one unit that is its own."""
    arm_result.save(tmp_path / "result.nc")
    shown = info(tmp_path, "--all").stdout
    assert f"effort {NASTY} [" in shown
    assert "along prismatic" not in shown
    units = {one.name: one.unit for one in series_of_result(arm_result.data)}
    assert units["q shoulder"] == "rad"
    assert units["v shoulder"] == "rad s-1"
    assert units["deformation shoulder.gear"] == "rad"


def test_series_along_a_link_are_the_farthest_values(arm_result):
    data = arm_result.data
    values = data["moment"].sel(bending_link="rod", moment_kind="z").values
    own = next(one for one in series_of_result(data) if one.name == "moment rod z")
    assert np.array_equal(np.abs(own.values), np.abs(values).max(axis=-1))


def test_no_blocks_where_the_terminal_has_none(robot_run):
    world = os.environ | {"PYTHONIOENCODING": "ascii"}
    shown = info(robot_run, "--all", env=world).stdout
    assert shown.isascii()
    assert "\\u" not in shown
    assert "energy_balance" in shown


def test_eighty_columns(robot_run):
    """On a terminal of 80 columns no line is longer."""
    pty = pytest.importorskip("pty")
    main, other = pty.openpty()
    import fcntl
    import struct
    import termios

    fcntl.ioctl(other, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 80, 0, 0))
    with subprocess.Popen(
        [*SHOW, "--all", str(robot_run)], stdout=other, stderr=other, env=os.environ | {"TERM": "dumb"}
    ):
        os.close(other)
        content = b""
        while part := _read(main):
            content += part
    os.close(main)
    table = content.decode().partition("frequencies")[2].partition("data    ")[0]
    assert "voltage" in table
    assert max(map(len, table.splitlines())) <= 80


def _read(descriptor: int) -> bytes:
    try:
        return os.read(descriptor, 65536)
    except OSError:  # the other end is closed
        return b""


@pytest.mark.parametrize("hurt", ["cut", "bit", "foreign", "empty"])
def test_damaged_results_are_refused(robot_run, tmp_path, hurt):
    content = bytearray((robot_run / "result.nc").read_bytes())
    content[len(content) // 2] ^= 1
    broken = {"cut": content[:-100], "bit": content, "foreign": b"GIF89a" * 100, "empty": b""}[hurt]
    (tmp_path / "result.nc").write_bytes(broken)
    assert "use a whole copy" in info(tmp_path, code=4).stderr


def test_what_is_no_result(tmp_path):
    assert "a folder without result.nc" in info(tmp_path, code=4).stderr
    assert "none is missing, expected a result file" in info(tmp_path / "none", code=4).stderr


def test_the_reader_goes_away(robot_run):
    """As with `| head -1`: no traceback, no fault."""
    with subprocess.Popen([*SHOW, str(robot_run)], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as going:
        assert going.stdout is not None
        assert going.stderr is not None
        going.stdout.close()
        assert going.stderr.read() == b""
    assert going.returncode == 0


def test_sparkline_keeps_the_peak():
    values = np.zeros(1000)
    values[500] = 1.0
    assert sparkline(values, 10).count("█") == 1
    assert sparkline(np.ones(5), 10) == "▁" * 5
    assert sparkline(np.linspace(0, 1, 8), 8) == BLOCKS
    assert sparkline(np.linspace(0, 1, 8), 8, ASCII) == ASCII
    assert (steps_for("utf-8"), steps_for("latin-1"), steps_for(None)) == (BLOCKS, ASCII, ASCII)


def test_reading_needs_no_model(robot_run):
    """What a stored result says is read: neither equations nor compiled code are loaded for it."""
    code = (
        "import sys; from tmodes.result import Result; result = Result.load(sys.argv[1]); result.summary(); "
        "result.warnings; print([m for m in ('tmodes.model.model', 'tmodes.simulation.simulate', 'llvmlite') "
        "if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code, robot_run / "result.nc"], capture_output=True, check=True)
    assert done.stdout.split() == [b"[]"]
