"""Motions that turn stiff during a run: detected, reported, and continued by the implicit method where allowed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from simulation.sheets import landing, ringing, sliding, sunk
from tmodes.integrate.choice import STIFF, TRIAL, chosen_method, worth_keeping, worth_switching
from tmodes.integrate.settings import Integration
from tmodes.simulation.simulate import simulate_motion


@pytest.mark.parametrize("method", ["auto", "dormand_prince", "dop853"])
def test_stiffness_is_seen_and_reported(method: str) -> None:
    run = simulate_motion(landing(method=method))
    assert run.status == "finished"
    assert np.abs(run.q[:, 0] - sunk(run.times)).max() < 2e-8
    assert run.statistics["stiff_from_s"] == pytest.approx(np.sqrt(0.1 / 9.81), abs=2e-3)
    if method == "auto":
        assert "dormand_prince chosen" in run.message
        assert "; from t = 0.10" in run.message
        assert "on by extrapolation" in run.message
        parts = run.statistics["parts"]
        assert [parts[k]["method"] for k in "12"] == ["dormand_prince", "extrapolation"]
        assert sum(parts[k]["steps"] for k in "12") == run.statistics["steps"]
    else:
        assert "the motion is stiff from t = 0.10" in run.message
        assert "parts" not in run.statistics


def test_what_is_not_stiff_is_not_called_so() -> None:
    """A hard bounce: short steps for the sake of the error only."""
    run = simulate_motion(landing(damping=0.0, method="auto", duration=1.0))
    assert run.status == "finished"
    assert "stiff" not in run.message
    assert run.statistics["contact_changes"] > 4


def test_a_vibration_that_hardly_decays_is_seen() -> None:
    """Its eigenvalues are imaginary: steps of dormand_prince stand at 1 over them, and not at 3.3."""
    run = simulate_motion(ringing(method="auto"))
    assert "dormand_prince chosen" in run.message
    assert "on by extrapolation" in run.message
    exact = simulate_motion(ringing(method="dop853", relative_tolerance=1e-10, absolute_tolerance=1e-12))
    assert np.abs(run.q - exact.q).max() < 2e-6
    assert run.statistics["evaluations"] < exact.statistics["evaluations"] / 20


def test_smooth_friction_of_a_contact_is_taken_by_the_method_that_has_it_in_its_jacobian() -> None:
    run, alone = (simulate_motion(sliding(method=method)) for method in ("auto", "dop853"))
    assert "on by rosenbrock" in run.message
    assert run.statistics["evaluations"] < alone.statistics["evaluations"] / 100
    assert np.abs(run.q - alone.q).max() < 1e-6


def _only_extrapolation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Friction of a contact is explicit in it, as in explicit methods."""
    monkeypatch.setattr("tmodes.simulation.initial_state.implicit_method", lambda *_, **__: "extrapolation")


def test_a_change_that_does_not_pay_is_taken_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """After a trial the explicit one continues, and says so."""
    _only_extrapolation(monkeypatch)
    run, alone = (simulate_motion(sliding(method=method)) for method in ("auto", "dormand_prince"))
    assert "extrapolation was tried" in run.message
    assert "by dormand_prince again" in run.message
    parts = run.statistics["parts"]
    assert [parts[k]["method"] for k in "123"] == ["dormand_prince", "extrapolation", "dormand_prince"]
    assert parts["2"]["steps"] + parts["2"]["rejected"] == TRIAL
    assert sum(parts[k]["evaluations"] for k in "123") == run.statistics["evaluations"]
    assert run.statistics["evaluations"] < 1.02 * alone.statistics["evaluations"]
    assert np.abs(run.q - alone.q).max() < 1e-6


@pytest.mark.nightly
def test_trials_are_the_same_whatever_the_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    _only_extrapolation(monkeypatch)
    whole = simulate_motion(sliding(method="auto"))
    monkeypatch.setattr("tmodes.simulation.native_run._FIRST_PIECE", 7)
    monkeypatch.setattr("tmodes.simulation.native_run._PIECE_SECONDS", 1e-4)
    pieces = simulate_motion(sliding(method="auto"))
    assert "by dormand_prince again" in whole.message
    assert pieces.states.tobytes() == whole.states.tobytes()
    assert pieces.statistics == whole.statistics
    assert pieces.message == whole.message


def test_what_pays_is_a_matter_of_passes() -> None:
    """Nine passes of four lanes, 1.1 each, over the six of an explicit step."""
    assert worth_keeping(1e-5, 40 * 1.7e-5)
    assert not worth_keeping(1e-5, 40 * 1.6e-5)


def test_short_runs_keep_their_method() -> None:
    assert not worth_switching(0.1, 0.1 / (STIFF - 1))
    assert worth_switching(0.1, 0.1 / (STIFF + 1))
    assert chosen_method(Integration(duration=1.0), 0.0)[0] == "dormand_prince"
    fine = Integration(duration=1.0, relative_tolerance=1e-12)
    assert chosen_method(Integration(duration=1.0), 1e6)[0] == "extrapolation"
    assert chosen_method(fine, 1e6)[0] == "dormand_prince"  # extrapolation does not get there
    assert "extrapolation" not in simulate_motion(landing(method="auto", duration=0.2)).message


class Journal:
    """Keeps every record; an interruption gives the last."""

    def __init__(self) -> None:
        self.record: Any = None

    def restore(self) -> Any:
        return self.record

    def keep(self, record: Any, *, last: bool = False, now: bool = False) -> None:
        self.record = {name: array.copy() for name, array in record.items()}


@pytest.mark.parametrize("share", [0.1, 0.169, 0.3])
def test_same_bits_after_a_kill_on_either_side(share: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Killed before the method changes, about then, or after: the bytes and counts of a whole run."""
    whole = simulate_motion(landing(method="auto"))
    monkeypatch.setattr("tmodes.simulation.native_run._FIRST_PIECE", 20)
    monkeypatch.setattr("tmodes.simulation.native_run._PIECE_SECONDS", 1e-4)
    journal = Journal()

    def progress(stage: str, done: float) -> None:
        if done > share:
            raise MemoryError

    with pytest.raises(MemoryError):
        simulate_motion(landing(method="auto"), progress=progress, journals=lambda stage: journal)
    again = simulate_motion(landing(method="auto"), journals=lambda stage: journal)
    assert again.states.tobytes() == whole.states.tobytes()
    assert again.statistics == whole.statistics
    assert again.message == whole.message


def test_chattering_ends_a_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """A contact that starts and ends too often within a time: a status of its own, and what was done is kept."""
    monkeypatch.setattr("tmodes.simulation.native_run.MOST_EVENTS", 3)
    monkeypatch.setattr("tmodes.simulation.native_run.EVENT_TIME", 10.0)
    run = simulate_motion(landing(damping=0.0, method="dormand_prince", duration=1.0))
    assert run.status == "chattering"
    assert "more than 3 times" in run.message
    assert 10 < len(run.times) < 101
    assert np.isfinite(run.q).all()
    monkeypatch.setattr("tmodes.simulation.native_run.EVENT_TIME", 1e-3)
    assert simulate_motion(landing(damping=0.0, method="dormand_prince", duration=1.0)).status == "finished"
