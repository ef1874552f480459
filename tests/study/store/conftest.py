"""Studies that other processes of the same tests continue."""

from __future__ import annotations

from collections.abc import Iterator

import pytest


@pytest.fixture(autouse=True)
def no_kinds_of_other_tests() -> Iterator[None]:
    """Kinds that other tests have registered in this process are none of the engine that a study is continued with."""
    with pytest.MonkeyPatch.context() as patch:
        for module in ("blocks", "identity"):
            patch.setattr(f"tmodes.study.{module}.outside_digest", lambda: "")
        yield
