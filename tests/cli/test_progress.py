"""Progress is said while nothing is reported, in a pipe as in a terminal; Ctrl-C after the last report is heard."""

from __future__ import annotations

import signal
import subprocess

import pytest

from command import COMMAND, started
from patience import LONG, until, work
from tmodes.cli import terminal
from tmodes.cli.terminal import working


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(terminal, "LINE_EVERY", 0.1)
    monkeypatch.setattr(terminal, "PATIENCE", 0.0)


@pytest.mark.usefixtures("quick")
def test_a_silent_stage_is_said_again_and_again(capfd) -> None:
    lines: list[str] = []

    def twice(word: str) -> bool:
        lines.extend(capfd.readouterr().err.splitlines())
        return sum(line.startswith(word) for line in lines) >= 2

    with working("reading") as tell:
        until(lambda: twice("reading: 0%"))
        tell("report", 0.25, "page 3")
        until(lambda: twice("report: 25%"))
    said = [line.partition(":")[0] for line in lines]
    assert said == sorted(said)  # nothing of the first stage after the second began
    assert all(line.endswith(", page 3") for line in lines if line.startswith("report"))


@pytest.mark.usefixtures("quick")
def test_short_pieces_of_work_are_no_silence(capfd, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(terminal, "LINE_EVERY", 0.4)

    def said() -> bool:
        with working("reading"):
            work(0.15)
        return capfd.readouterr().err.startswith("reading: 0%")

    until(said)


@pytest.mark.usefixtures("quick")
def test_an_interrupt_after_the_last_report_is_not_lost() -> None:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt), working("reading"):
            signal.raise_signal(signal.SIGINT)
        with working("reading", at_once=True), pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_command_that_reports_nothing_says_its_stages_alone() -> None:
    with started([*COMMAND, "check", "spong1987"], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        out, errors = process.communicate(timeout=LONG)
    assert out.startswith("spong1987: valid")
    assert all(line.startswith(("warning", "reading: 0% after", "checking: 0% after")) for line in errors.splitlines())
