"""What the validator found wrong, in our words: which, got, expected, mend."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from tmodes.errors import InputError
from tmodes.io.fields import Place, children, place_at, places
from tmodes.io.words import nearest, shown

__all__ = ["problems"]

SHEET = "the data sheet"


def problems(error: ValidationError) -> list[InputError]:
    """One error of ours for each wrong place; ``which`` is its dotted path."""
    info: dict[str, InputError] = {}
    for detail in error.errors(include_url=False):
        for problem in _problems(detail):
            info.setdefault(problem.which, problem)
    return list(info.values())


def _problems(detail: ErrorDetails) -> Iterator[InputError]:
    steps = [step for step in detail["loc"] if step != "[key]"]
    path = ".".join(str(step) for step in steps)
    match detail["type"]:
        case "extra_forbidden" | "invalid_key":
            yield _unknown(path, str(steps[-1]))
        case "missing" if isinstance(steps[-1], int):
            group, place = path.rpartition(".")[0], place_at(path.rpartition(".")[0])
            yield _short(group, place, detail["input"])
        case "missing":
            yield _missing(path)
        case "issues":
            for field, got, expected, hint in detail.get("ctx", {})["issues"]:
                yield InputError(f"{path}.{field}" if path else field, got, expected, hint)
        case kind:
            yield _wrong(path, kind, detail)


def _unknown(path: str, key: str) -> InputError:
    group = path.removesuffix(key).rstrip(".")
    known = children(group)
    return InputError(path, "an unknown key", f"one of {', '.join(known) or 'the known keys'}", _meant(key, known))


def _meant(key: str, known: list[str]) -> str:
    """Which key was probably meant: misspelt, written by its symbol, or put in the wrong group."""
    if key in places():
        group, _, name = key.rpartition(".")
        return f"put the key `{name}` inside the group `{group}`" if group else f"put `{key}` at the outermost level"
    if close := nearest(key, known):
        return f"did you mean `{close}`?"
    for path, place in places().items():
        if key in (path.rpartition(".")[2], place.extra.get("symbol")):
            return f"did you mean `{path}`? Write it there"
    return "remove it"


def _short(path: str, place: Place | None, value: Any) -> InputError:
    expected = place.expected if place else "a longer list"
    return InputError(path, shown(value), expected, "write each of them, starting with `- `")


def _missing(path: str) -> InputError:
    group, _, name = path.rpartition(".")
    place = place_at(path)
    expected = place.expected if place else "a value"
    if place and place.info and place.info.description:
        expected += f": {place.meaning}"
    inside = f" inside `{group}`" if group else ""
    return InputError(path, "nothing", expected, f"add the line `{name}: ...`{inside}")


def _wrong(path: str, kind: str, detail: ErrorDetails) -> InputError:
    value, place = detail["input"], place_at(path)
    if place is None:
        expected = f"a group with the keys {', '.join(children(''))}" if not path else detail["msg"]
        return InputError(path or SHEET, shown(value), expected, "compare it with a published robot")
    if kind == "arithmetic" and not place.extra.get("span"):
        bounds = detail.get("ctx", {})
        expected = f"a magnitude from {bounds['smallest']:g} to {bounds['largest']:g} [{place.unit}]"
        rigid = "; .inf makes it rigid" if place.may_be_infinite else ""
        return InputError(path, shown(value), expected, f"correct the exponent or the unit{rigid}")
    return InputError(path, shown(value), place.expected, _hint(place, value))


def _hint(place: Place, value: Any) -> str:
    """How a value of the right kind or of the wrong one is put right."""
    if place.unit is not None and isinstance(value, (int, float)):
        return "check sign, size and unit"
    if place.unit is not None:
        return f"write a number in {place.unit}"
    if isinstance(value, str) and (close := nearest(value, _choices(place))):
        return f"did you mean `{close}`?"
    if isinstance(value, Mapping) or value is None:
        return f"write the {place.meaning} as {place.expected}"
    return f"write {place.expected}"


def _choices(place: Place) -> list[str]:
    return [str(choice) for choice in getattr(place.annotation, "__members__", {}).values()]
