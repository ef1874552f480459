"""Arguments of public functions: of the kinds that their annotations say, or an error that names the argument.

Checked are plain types, lists and groups of these, functions by their number of arguments, and classes; arrays are
checked where they are used, which knows their shapes.
"""

from __future__ import annotations

import copy
import inspect
import numbers
import os
import sys
import types
from collections.abc import Callable, Collection, Mapping, Sequence
from functools import cache, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, ParamSpec, TypeVar, Union, get_args, get_origin

import tmodes
from tmodes.errors import InputError
from tmodes.io.words import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["checked_arguments", "copied", "numbers_of", "refuse_fields", "whole_number"]

P = ParamSpec("P")
T = TypeVar("T")

_HINTS = {
    "Robot": "load it first: tmodes.load(NAME or FILE)", "Study": "read it first: tmodes.read_study(FILE)",
    "Result": "run a robot first: tmodes.run(ROBOT)",
}  # fmt: skip


def checked_arguments(function: Callable[P, T]) -> Callable[P, T]:
    """A public function that raises :class:`tmodes.errors.InputError` for an argument of another kind.

    A call with arguments that it does not have is Python's own TypeError, as ever.
    """

    @wraps(function)
    def called(*args: P.args, **kwargs: P.kwargs) -> T:
        signature, hints = _annotated(function)
        try:
            given = signature.bind(*args, **kwargs).arguments
        except TypeError:
            return function(*args, **kwargs)
        for name, value in given.items():
            several = str(signature.parameters[name]).startswith("*")
            for one in value if several else (value,):
                _refuse(name, one, hints.get(name, Any))
        return function(*args, **kwargs)

    return called


def refuse_fields(value: Any) -> None:
    """The same for the fields of a new object of a public dataclass."""
    cls = type(value)
    for name, hint in _annotated(cls)[1].items():
        _refuse(f"{cls.__name__}.{name}", getattr(value, name), hint)


def _refuse(name: str, value: Any, hint: Any) -> None:
    if expected := _wanted(value, hint):
        got = f"a {type(value).__name__}" if isinstance(hint, type) and hint not in _PLAIN else shown(value)
        raise InputError(name, got, expected, _HINTS.get(getattr(hint, "__name__", ""), ""))


@cache
def _annotated(function: Callable[..., Any]) -> tuple[inspect.Signature, dict[str, Any]]:
    """The signature of a function, and what the annotations mean of which the names are known while it runs."""
    signature, known, hints = inspect.signature(function), vars(sys.modules[function.__module__]), dict[str, Any]()
    for name, parameter in signature.parameters.items():
        if str(parameter).startswith("**") or parameter.annotation is inspect.Parameter.empty:
            continue
        try:
            hints[name] = eval(parameter.annotation, {}, _Public(known))  # noqa: S307 - an annotation of ours
        except NameError:  # imported for type checkers alone
            continue
    return signature, hints


class _Public(dict[str, Any]):
    """The public names, for annotations that modules import for type checkers alone."""

    def __missing__(self, name: str) -> Any:
        if name not in tmodes.__all__:
            raise KeyError(name)
        found = getattr(tmodes, name)  # a class of the same name that it extends is taken as well
        return (
            next(one for one in reversed(found.__mro__) if one.__name__ == name) if isinstance(found, type) else found
        )


def _wanted(value: Any, hint: Any) -> str:
    """What is expected in place of a value; nothing where it fits."""
    if hint in _PLAIN:
        fits, words = _PLAIN[hint]
        return "" if fits(value) else words
    if (check := _KINDS.get(get_origin(hint))) is not None:
        return check(value, get_args(hint))
    if isinstance(hint, type) and hint.__module__.startswith("tmodes.") and not getattr(hint, "_is_protocol", False):
        return "" if isinstance(value, hint) else f"a tmodes.{hint.__name__}"
    return ""


def _of_several(value: Any, hints: Sequence[Any]) -> str:
    words = [_wanted(value, one) for one in hints]
    return "" if "" in words else " or ".join(dict.fromkeys(word for word in words if word != "nothing"))


def _of_words(value: Any, words: Sequence[Any]) -> str:
    fits = isinstance(value, str) and value in words
    return "" if fits else f"one of {', '.join(map(str, words))}"


def _of_group(value: Any, inner: Sequence[Any]) -> str:
    if not isinstance(value, Mapping):
        return "a group of values by their names"
    if words := next(filter(None, (_wanted(one, inner[0]) for one in value)), ""):
        return f"a group of which each key is {words}"
    wrong = ((key, words) for key, one in value.items() if (words := _wanted(one, inner[1])))
    return next((f"a group in which `{key}` is {words}" for key, words in wrong), "")


def _of_list(value: Any, inner: Sequence[Any]) -> str:
    if not isinstance(value, Collection) or isinstance(value, str | bytes) or hasattr(value, "dtype"):
        return "a list"
    words = next(filter(None, (_wanted(one, inner[0]) for one in value)), "")
    return f"a list, each of which is {words}" if words else ""


def _of_function(value: Any, inner: Sequence[Any]) -> str:
    count = len(inner[0]) if isinstance(inner[0], list) else None
    words = "a function" if count is None else f"a function of {count} argument{'s' if count != 1 else ''}"
    if not callable(value):
        return words
    try:
        inspect.signature(value).bind(*[None] * (count or 0))
    except ValueError:  # of some that are built in nobody knows
        return ""
    except TypeError:
        return "" if count is None else words
    return ""


_KINDS: dict[Any, Callable[[Any, Sequence[Any]], str]] = {
    Union: _of_several, types.UnionType: _of_several, Literal: _of_words, Callable: _of_function,
    Mapping: _of_group, dict: _of_group, Sequence: _of_list, Collection: _of_list, list: _of_list, tuple: _of_list,
}  # fmt: skip


def _is_number(value: Any) -> bool:
    scalar = value[()] if getattr(value, "shape", None) == () else value
    if isinstance(scalar, bool) or not isinstance(scalar, numbers.Real):
        return False
    try:
        return float(value) == float(value)
    except (OverflowError, ValueError):
        return False


def _is_path(value: Any) -> bool:
    return isinstance(value, os.PathLike) and isinstance(os.fspath(value), str) and "\0" not in os.fspath(value)


_PLAIN: dict[Any, tuple[Callable[[Any], bool], str]] = {
    Any: (lambda value: True, ""),
    type(None): (lambda value: value is None, "nothing"),
    None: (lambda value: value is None, "nothing"),
    bool: (lambda value: isinstance(value, bool) or type(value).__name__ == "bool", "true or false"),
    int: (lambda value: isinstance(value, numbers.Integral) and not isinstance(value, bool), "a whole number"),
    float: (_is_number, "a finite number"),
    str: (lambda value: isinstance(value, str) and "\0" not in value, "a text"),
    os.PathLike[str]: (_is_path, "a path"),
    Path: (_is_path, "a path"),
}


def whole_number(which: str, value: int, least: int, most: int) -> int:
    """The number, if it lies between the two; raises :class:`tmodes.errors.InputError`."""
    if not least <= value <= most:
        raise InputError(which, shown(value), f"a whole number from {least:,} to {most:,}", "correct the number")
    return value


def copied(value: Any, which: str) -> Any:
    """A deep copy of plain data; raises :class:`tmodes.errors.InputError` where it goes too deep, or has no copy."""
    try:
        return copy.deepcopy(value)
    except RecursionError:
        raise InputError(which, "lists or groups that go too deep", "plain data", "remove levels") from None
    except Exception as error:
        raise InputError(which, f"a {type(value).__name__}", "plain data", "give numbers and texts") from error


Shape = tuple[int | None, ...]


def _has(shape: tuple[int, ...], wanted: Shape) -> bool:
    return len(shape) == len(wanted) and all(n in (m, None) for m, n in zip(shape, wanted, strict=True))


def numbers_of(value: Any, which: str, shapes: Sequence[Shape], meaning: str = "") -> NDArray[np.float64]:
    """An array of finite real numbers of one of the ``shapes``, in which None is any length.

    ``meaning`` of these shapes is said, as ``one at each sample``. Raises :class:`tmodes.errors.InputError`.
    """
    import numpy as np

    try:
        given = np.asarray(value)
        found = (
            None
            if np.issubdtype(given.dtype, np.complexfloating) or given.dtype.char in "SUMm"
            else given.astype(float)
        )
    except (TypeError, ValueError, OverflowError, RecursionError):
        given = found = None
    known = " or ".join(str(shape).replace("None", "n") for shape in shapes)
    several = f"an array of finite numbers of shape {known}{meaning and f', {meaning}'}"
    expected = "a finite number" if shapes == ((),) else several
    if found is None:
        got = "complex numbers" if given is not None and np.iscomplexobj(given) else shown(value)
        raise InputError(which, got, expected, "give real numbers")
    if not any(_has(found.shape, shape) for shape in shapes):
        raise InputError(which, f"an array of shape {found.shape}", expected, "reshape it")
    if not np.isfinite(found).all():
        place = tuple(np.argwhere(~np.isfinite(found))[0].tolist())
        at = f" at {list(place)}" if place else ""
        raise InputError(which, f"{found[place]}{at}", expected, "look for gaps in it")
    return found
