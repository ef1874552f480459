"""A function's digest: another for every change of what it depends on, and the same again, in another process too."""

from __future__ import annotations

import collections
import functools
import itertools
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.kinds.code_identity import UnidentifiedError, code_digest

GLOBAL: Any = 1.0


def plain(x: float, result: Any = None, *, factor: float = 1.0) -> float:
    return x * factor


class Callable1:
    kept: Any = 0.0

    def __init__(self, x: Any) -> None:
        self.x = x

    def __call__(self, result: Any) -> Any:
        return self.x

    def method(self, result: Any) -> Any:
        return self.x


class Slotted(Callable1):
    __slots__ = ("y",)

    def __init__(self, x: Any) -> None:
        super().__init__(0.0)
        self.y = x


@dataclass(frozen=True)
class Data:
    x: Any
    more: dict[str, Any] = field(default_factory=dict)

    def __call__(self, result: Any) -> Any:
        return self.x


class Own(list[Any]):
    def __call__(self, result: Any) -> Any:
        return self[0]


class Queue(collections.deque[Any]):
    def __call__(self, result: Any) -> Any:
        return self[0]


class Array(np.ndarray):
    def __call__(self, result: Any) -> Any:
        return self[0]


class Word(Enum):
    one, two = 1, 2


def closed(x: Any) -> Callable[[Any], Any]:
    return lambda result: x


def nested(x: Any) -> Callable[[Any], Any]:
    inner = closed(x)
    return lambda result: -inner(result)


def default(x: Any) -> Callable[[Any], Any]:
    def function(result: Any, x: Any = x) -> Any:
        return x

    return function


def keyword(x: Any) -> Callable[[Any], Any]:
    def function(result: Any, *, x: Any = x) -> Any:
        return x

    return function


def wrapped(x: Any) -> Callable[[Any], Any]:
    function = closed(x)

    @functools.wraps(function)
    def outer(*given: Any) -> Any:
        return function(*given)

    return outer


def with_attribute(x: Any) -> Callable[[Any], Any]:
    def function(result: Any) -> Any:
        return function.x  # pyright: ignore[reportFunctionMemberAccess]

    function.x = x  # pyright: ignore[reportFunctionMemberAccess]
    return function


MADE: dict[str, Callable[[Any], Any]] = {
    "partial": lambda x: functools.partial(plain, x),
    "partial, keyword": lambda x: functools.partial(plain, 1.0, factor=x),
    "partial of a method": lambda x: functools.partial(Callable1(x).method),
    "object": Callable1,
    "slots": Slotted,
    "dataclass": Data,
    "dataclass, deep": lambda x: Data(0, {"a": [x]}),
    "list of one's own": lambda x: Own([x]),
    "deque of one's own": lambda x: Queue([x]),
    "array of one's own": lambda x: np.full(3, x).view(Array),
    "method": lambda x: Callable1(x).method,
    "closure": closed,
    "closure of a function": nested,
    "default": default,
    "keyword default": keyword,
    "wrapped": wrapped,
    "cached": lambda x: functools.lru_cache(closed(x)),
    "vectorized": lambda x: np.vectorize(closed(x)),
    "attribute": with_attribute,
}
"""Functions that hold a value."""

VALUES = {
    "numbers": (1.0, 2.0), "int and float": (1, 1.0), "texts": ("a", "b"), "bytes": (b"a", b"b"),
    "lists": ([1, [2]], [1, [3]]), "order": ({"a": 1, "b": 2}, {"b": 2, "a": 1}), "sets": ({1, 2}, {1, 3}),
    "large": (np.zeros(100_000), np.eye(1, 100_000, 50_000)[0]), "type": (np.zeros(3), np.zeros(3, np.float32)),
    "shape": (np.zeros((2, 3)), np.zeros((3, 2))), "empty": (np.zeros(0), np.zeros((0, 2))),
    "objects": (np.array([1, None]), np.array([2, None])), "words": (Word.one, Word.two),
    "generators": (np.random.default_rng(0), np.random.default_rng(1)),
    "counts": (itertools.count(1), itertools.count(2)),
    "functions": (closed(1), closed(2)), "classes": (Callable1, Slotted), "paths": (Path("a"), Path("b")),
    "slices": (slice(1), slice(2)), "ufuncs": (np.add, np.subtract), "methods": ("ab".upper, "ab".lower),
}  # fmt: skip


@pytest.mark.parametrize("how", MADE)
def test_what_a_function_holds_matters(how: str) -> None:
    make = MADE[how]
    assert code_digest(make(1.0)) == code_digest(make(1.0))
    assert code_digest(make(1.0)) != code_digest(make(2.0))


@pytest.mark.parametrize("which", VALUES)
def test_values_are_compared_by_content(which: str) -> None:
    one, other = VALUES[which]
    assert code_digest(closed(one)) == code_digest(closed(one))
    assert code_digest(closed(one)) != code_digest(closed(other))


def uses_global(result: Any) -> Any:
    return [GLOBAL for _ in range(2)]


def calls(result: Any) -> Any:
    return uses_global(result)


@pytest.mark.parametrize(
    "function", [uses_global, calls, lambda result: Callable1(GLOBAL), functools.partial(calls, 1)]
)
def test_globals_that_the_code_names_matter(function: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """In comprehensions, and in functions that it calls."""
    before = code_digest(function)
    monkeypatch.setattr(sys.modules[__name__], "GLOBAL", 2.0)
    assert code_digest(function) != before


def test_the_class_of_an_object_matters(monkeypatch: pytest.MonkeyPatch) -> None:
    before = code_digest(Slotted(1.0))
    monkeypatch.setattr(Callable1, "kept", 1.0)
    changed = code_digest(Slotted(1.0))
    monkeypatch.setattr(Callable1, "__call__", lambda self, result: 0.0)
    assert len({before, changed, code_digest(Slotted(1.0))}) == 3


@pytest.fixture
def helpers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """A module of the user's own, and what of it is named."""
    (tmp_path / "own_helpers.py").write_text("K = 1.0\ndef twice(x):\n    return 2 * K * x\n", encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    import own_helpers  # pyright: ignore[reportMissingImports]

    yield own_helpers
    del sys.modules["own_helpers"]


def test_modules_of_the_user_matter(helpers: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a function asks them for, and what that names; imported before, or when it is called."""

    def asks(result: Any) -> Any:
        return helpers.twice(result)

    def imports(result: Any) -> Any:
        import own_helpers  # pyright: ignore[reportMissingImports]

        return own_helpers.twice(result)

    before = [code_digest(asks), code_digest(imports)]
    monkeypatch.setattr(helpers, "K", 2.0)
    after = [code_digest(asks), code_digest(imports)]
    assert not set(before) & set(after)


def rounds() -> Any:
    return (_ for _ in ())


def endless() -> list[Any]:
    found: list[Any] = []
    for _ in range(100_000):
        found = [found]
    return found


UNKNOWN = {
    "lock": threading.Lock, "generator": rounds, "depth": endless, "size": lambda: np.zeros(1 << 28),
    "many": lambda: list(range(2_000_000)),
}  # fmt: skip


@pytest.mark.parametrize("which", UNKNOWN)
def test_what_has_no_content_is_refused_with_a_reason(which: str) -> None:
    with pytest.raises(UnidentifiedError):
        code_digest(closed(UNKNOWN[which]()))


def test_names_that_are_looked_up_at_run_time_are_refused() -> None:
    for function in (lambda result: eval("GLOBAL"), lambda result: globals()["GLOBAL"]):  # noqa: S307
        with pytest.raises(UnidentifiedError, match="run time"):
            code_digest(function)


def test_objects_that_hold_each_other() -> None:
    one, other = Callable1(None), Callable1(None)
    one.x, other.x = other, one
    assert code_digest(one) == code_digest(one) == code_digest(other)


THERE = """
import sys
sys.path[:0] = {path!r}
from contracts.test_code_identity import MADE, VALUES, calls, closed, code_digest
print([code_digest(make(1.0)) for make in MADE.values()])
print([code_digest(closed(one)) for one, _ in VALUES.values()])
print(code_digest(calls))
"""


def test_another_process_finds_the_same() -> None:
    def found(seed: str) -> str:
        line = [sys.executable, "-c", THERE.format(path=sys.path)]
        done = subprocess.run(
            line, capture_output=True, text=True, check=True, env={**os.environ, "PYTHONHASHSEED": seed}
        )
        return done.stdout

    assert found("1") == found("2")
