"""Tables on terminals of any width: a word or a number is never cut."""

from __future__ import annotations

import io
import re
import sys

import pytest

from tmodes.cli.terminal import print_table

COLUMNS = ["link", "mass [kg]", "EI y, z [N*m^2]", "GJ [N*m^2]", "bare y, z [Hz]", "what gives way"]
ROWS = [
    ["strip", "4.33", "9686, 2.691", "1234567", "1549, 25.81", "strip.bend_z 87.1%, elbow.gear 12.9%"],
    ["a_long_name", "0.123456", "-", "rigid", "-", "-"],
]
WORDS = [word for row in (*ROWS, COLUMNS) for cell in row for word in cell.split()]


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def printed(monkeypatch: pytest.MonkeyPatch, width: int) -> list[str]:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stdout", terminal)
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setenv("TERM", "dumb")
    print_table("Links", COLUMNS, ROWS)
    return re.sub("\x1b\\[[0-9;]*m", "", terminal.getvalue()).splitlines()


@pytest.mark.parametrize("width", [40, 60, 80, 100, 120, 200])
def test_nothing_is_cut(monkeypatch: pytest.MonkeyPatch, width: int) -> None:
    lines = printed(monkeypatch, width)
    assert max(map(len, lines)) <= width
    words = " ".join(lines).split()
    assert all(words.count(word) >= WORDS.count(word) for word in set(WORDS) - {"-"})


def test_wide_ones_are_whole_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    assert any(all(cell in line for cell in ROWS[0]) for line in printed(monkeypatch, 120))


def test_a_pipe_has_no_width(capsys: pytest.CaptureFixture[str]) -> None:
    print_table("t", ["a", "b"], [["x" * 150, "y" * 150]])
    assert f"{'x' * 150}   {'y' * 150}" in capsys.readouterr().out
