"""A study that needs no robot: numbers of its parameters, as fast or as slow as a test wants."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import numpy as np

from tmodes.study.plans import Design
from tmodes.study.quantities.contract import Needs
from tmodes.study.rows import Kept, Rows
from tmodes.study.study import Study

__all__ = ["FakeStudy", "data", "fake"]

FORMULAS = {
    "peak": lambda x: x[:, 0] ** 2 + x[:, 1],
    "sag": lambda x: np.sin(x[:, 0]),
    "bad": lambda x: np.where(x[:, 0] > 0.9, np.nan, x[:, 0]),
}


def data(runs: int = 1000, quantities: tuple[str, ...] = ("peak",), **more: Any) -> dict[str, Any]:
    """The study as plain data."""
    parameters = {name: {"path": name, "distribution": {"type": "uniform"}} for name in ("gear", "payload")}
    asked = {name: {"type": "fake", "formula": name} for name in quantities}
    robot = more.pop("robot", None)
    sheet = {"name": "fake", "parameters": parameters, "quantities": asked, "plan": {"runs": runs}, **more}
    return {"study": sheet, "robot": robot}


@dataclass
class FakeStudy:
    """As :class:`tmodes.study.study.Study`; ``calls``: the cases that were computed, of all that share the list."""

    data: Mapping[str, Any]
    functions: Mapping[str, Callable[[Any], float]] = field(default_factory=dict)
    calls: list[tuple[int, int, tuple[str, ...]]] = field(default_factory=list)
    before: Callable[[int], None] = lambda first: None
    needs: Needs = field(default_factory=lambda: Needs(static=("x",)))
    robot: Any = None
    identified: Any = None

    __class__ = property(lambda self: Study)  # pyright: ignore[reportIncompatibleMethodOverride] - for those that ask

    def fixed(self) -> FakeStudy:
        return self

    def from_data(self, info: Mapping[str, Any], functions: Any = None) -> FakeStudy:
        return FakeStudy(info, functions or {}, self.calls, self.before, self.needs)

    @property
    def _own(self) -> Any:
        return self.data["study"]

    @property
    def quantity_identities(self) -> dict[str, str]:
        return {name: f"digest of {name}" for name in self._own["quantities"]}

    @property
    def parameter_units(self) -> dict[str, str]:
        return dict.fromkeys(self.names, "-")

    @property
    def sheet(self) -> Any:
        entry = SimpleNamespace(choices=(), title="", path="x")
        quantity = SimpleNamespace(title="a number", needs=lambda: Needs(static=("x",)))
        keep = SimpleNamespace(**{"cases": (), "every": None} | self._own.get("keep", {}))
        return SimpleNamespace(
            name=self._own["name"], parameters=dict.fromkeys(self._own["parameters"], entry), keep=keep,
            quantities=dict.fromkeys(self._own["quantities"], quantity), block=self._own.get("block"),
        )  # fmt: skip

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(self._own["parameters"])

    def design(self) -> Design:
        return Design(np.random.default_rng(0).random((self._own["plan"]["runs"], 2)))

    def evaluate(self, first: int, values: Any, progress: Any = lambda stage, share: None, **more: Any) -> Rows:
        self.before(first)
        self.calls.append((first, len(values), tuple(self._own["quantities"])))
        count = len(values)
        found = {name: FORMULAS[name](values) for name in self._own["quantities"]}
        good: Any = np.isfinite(np.column_stack(list(found.values()))).all(axis=1).tolist()
        every, cases = self.sheet.keep.every, self.sheet.keep.cases
        kept = {
            case: Kept(np.arange(3.0), np.full((3, 2), float(case)), np.zeros((3, 3)), ("q", "dq"))
            for case in range(first, first + count)
            if case in cases or (every and case % every == 0)
        }
        return Rows(
            np.arange(first, first + count), dict(zip(self.names, values.T, strict=True)), found,
            dict.fromkeys(found, "m"), ["finished" if one else "failed" for one in good],
            ["" if one else "no number" for one in good], ["fake"] * count, np.full(count, 1e-5), kept,
        )  # fmt: skip


def fake(info: Mapping[str, Any], **more: Any) -> Any:
    """Such a study; of no type, as those that run it want a real one."""
    return FakeStudy(info, **more)
