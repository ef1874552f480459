"""Studies that other processes of the same tests continue."""

from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def no_kinds_of_other_tests(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kinds that other tests have registered in this process are none of the engine that a study is continued with."""
    for module in ("addresses", "identity"):
        monkeypatch.setattr(f"tmodes.study.{module}.outside_digest", lambda: "")
