"""Read states at which the equations are to be evaluated: JSON records of angles, speeds and a voltage."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator, Mapping
from typing import Any

from tmodes.errors import InputError
from tmodes.io.files import read_bytes
from tmodes.io.words import nearest, shown, shown_path
from tmodes.kinds.schema.quantity import LARGEST

__all__ = ["MOST_BYTES", "check_keys", "holds_phi", "is_number", "parsed_json", "read_states"]

MOST_BYTES = 50_000_000
MOST_RECORDS = 100_000
MOST_BRACKETS = 4_000_000

GIVEN = ("phi", "phid", "u")
"""What a record must hold: angles [rad], angular velocities [rad/s], motor voltage [V]."""
NEEDED = set(GIVEN)

ANSWERS = (
    *("reading", "H", "h", "f_el", "f_di", "Q", "tip", "J", "phidd", "F_tip_on_environment"),
    *("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy"),
)
"""What a record may hold next to it, and what is not read: another program's answers at that state."""


class _Repeated(dict[str, Any]):
    """An object of JSON in which a key stands twice."""

    key = ""


def read_states(path: str | os.PathLike[str], coordinates: int = 6) -> list[dict[str, Any]]:
    """Records ``{phi, phid, u}`` of a JSON file: a list of them, or ``{"states": [...]}``.

    ``phi`` [rad] and ``phid`` [rad/s] are lists of ``coordinates`` floats, ``u`` [V] is a float. Raises
    :class:`tmodes.errors.InputError` that names the record and the field of the first wrong value.
    """
    source = shown_path(path)
    records = _records(parsed_json(read_bytes(path, MOST_BYTES), source), source)
    return [_Record(record, index, source).read(coordinates) for index, record in enumerate(records)]


def holds_phi(path: str | os.PathLike[str]) -> bool:
    """Whether a file holds records in the coordinates of the 2010 robot, not numbers by name in ``q`` or a table."""
    if str(path).lower().endswith(".csv"):
        return False
    data = parsed_json(read_bytes(path, MOST_BYTES), shown_path(path))
    records = data.get("states", data) if isinstance(data, Mapping) else data
    first = records[0] if isinstance(records, list) and records else records
    return not isinstance(first, Mapping) or "q" not in first


def parsed_json(content: bytes, source: str) -> Any:
    """JSON of a file that may be hostile; raises :class:`tmodes.errors.InputError` that says the line."""
    if content.count(b"[") + content.count(b"{") > MOST_BRACKETS:
        most = f"at most {MOST_BRACKETS} lists and objects"
        raise InputError("the file", "a flood of brackets", most, "check that this is the file you mean", source)
    hint = "look there for a missing quote, bracket or comma"
    try:
        return json.loads(content.decode("utf-8-sig"), object_pairs_hook=_object)
    except json.JSONDecodeError as error:
        where = f"{source}:{error.lineno}"
        raise InputError("the file", f"broken JSON ({error.msg})", "JSON", hint, where) from None
    except UnicodeDecodeError:
        got, hint = "bytes that are not UTF-8", "save the file as UTF-8 text"
        raise InputError("the file", got, "text in UTF-8", hint, source) from None
    except RecursionError:
        got, hint = "lists or objects nested too deep", "remove brackets"
        raise InputError("the file", got, "a list of flat records", hint, source) from None
    except ValueError:  # an integer of more digits than Python converts
        got, hint = "a number of thousands of digits", "write sensible numbers"
        raise InputError("the file", got, "numbers that a double can hold", hint, source) from None


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    record = dict(pairs)
    if len(record) == len(pairs):
        return record
    repeated, seen = _Repeated(record), set[str]()
    repeated.key = next(key for key, _ in pairs if key in seen or seen.add(key))
    return repeated


def _records(data: Any, source: str) -> list[Any]:
    if isinstance(data, Mapping) and not {"phi", "phid", "u"} & set(data):
        check_keys(data, ("states",), (), "the file", source)
        data = data["states"]
    if not isinstance(data, list) or not data:
        got = "an empty list" if data == [] else "one record" if isinstance(data, Mapping) else shown(data)
        hint = 'write [{"phi": [...], "phid": [...], "u": 0.0}]'
        raise InputError("the file", got, "a list of records", hint, source)
    if len(data) > MOST_RECORDS:
        raise InputError("the file", f"{len(data)} records", f"at most {MOST_RECORDS}", "split the file", source)
    return data


Names = tuple[str, ...]


def check_keys(record: Mapping[str, Any], must: Names, may: Names, which: str, source: str) -> None:
    """Raise an InputError for a key that stands twice, is not known, or is missing."""
    if isinstance(record, _Repeated):
        name = shown(record.key)
        raise InputError(f"{which}: {name}", "a key that stands twice", "given once", "remove one", source)
    for key in record:
        if key not in (*must, *may):
            close = nearest(key, (*must, *may))
            hint = f"did you mean `{close}`?" if close else "remove it"
            expected = f"one of {', '.join((*must, *may))}"
            raise InputError(f"{which}: {shown(key)}", "an unknown key", expected, hint, source)
    for key in must:
        if key not in record:
            raise InputError(f"{which}: {key}", "nothing", f"the key `{key}`", f"add `{key}`", source)


class _Record:
    """One record and its place in the file."""

    def __init__(self, data: Any, index: int, source: str) -> None:
        self.data, self.index, self.source = data, index, source

    def error(self, field: str, got: str, expected: str, hint: str) -> InputError:
        """An error of ours about a field of this record."""
        which = f"record {self.index}"
        return InputError(f"{which}: {field}" if field else which, got, expected, hint, self.source)

    def read(self, coordinates: int) -> dict[str, Any]:
        """The numbers that are needed, as floats."""
        if not isinstance(self.data, Mapping):
            expected, hint = "a record with the keys phi, phid, u", 'write {"phi": [...], "phid": [...], "u": 0.0}'
            raise self.error("", shown(self.data), expected, hint)
        if isinstance(self.data, _Repeated) or self.data.keys() != NEEDED:
            check_keys(self.data, GIVEN, ANSWERS, f"record {self.index}", self.source)
            self._check_answers()
        phi, phid = self._list("phi", coordinates), self._list("phid", coordinates)
        if not is_number(self.data["u"]):
            raise self._no_number("u", self.data["u"])
        return {"phi": phi, "phid": phid, "u": float(self.data["u"])}

    def _list(self, key: str, length: int) -> list[float]:
        values = self.data[key]
        if not isinstance(values, list) or len(values) != length:
            raise self.error(key, shown(values), f"a list of {length} numbers", "give one number per coordinate")
        for index, value in enumerate(values):
            if not is_number(value):
                raise self._no_number(f"{key}[{index}]", value)
        return [*map(float, values)]

    def _no_number(self, field: str, value: Any) -> InputError:
        return self.error(field, shown(value), f"a number of magnitude at most {LARGEST:g}", "write a finite number")

    def _check_answers(self) -> None:
        """Answers are not read, but a file that holds NaN or infinity is no JSON."""
        for key in self.data.keys() - NEEDED:
            for value in _leaves(self.data[key]):
                if isinstance(value, float) and not math.isfinite(value):
                    raise self.error(key, shown(value), "finite numbers", "write finite ones, or leave the field out")


def is_number(value: Any) -> bool:
    """True for a number that is finite and of a size that a robot may have."""
    return type(value) in (float, int) and -LARGEST <= value <= LARGEST


def _leaves(value: Any) -> Iterator[Any]:
    if isinstance(value, list):
        for item in value:
            yield from _leaves(item)
    else:
        yield value
