"""Blocks: consecutive cases of a study as one record of bytes, checked whole whenever it is read.

    magic (8) | format version (4) | length of the header (4) | length of the payload (8)
    | SHA-256 of the header (32) | SHA-256 of the payload (32) | header, JSON | payload: the arrays, one after another

The header names the arrays with their types and shapes, in order, and what the numbers depend on. It is a file of a
study folder, and what a worker on another machine sends back. Which stored blocks give which cases of a study, and
what is missing, is a :class:`Cover`.
"""

from __future__ import annotations

import hashlib
import io
import json
import math
import struct
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from numpy.typing import NDArray
from pydantic import TypeAdapter

from tmodes.errors import ResultFileError
from tmodes.io.atomic import file_error
from tmodes.io.plain_file import parsed_json
from tmodes.kinds.registry import outside_digest
from tmodes.study.quantities.contract import MOST
from tmodes.study.rows import STATUS, Kept, Rows

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = [
    "BLOCK_FORMAT",
    "MOST_BLOCK",
    "PREFIX",
    "Block",
    "Cover",
    "Gap",
    "Label",
    "Part",
    "base_of",
    "canonical",
    "cases_address",
    "covered",
    "engine_of_blocks",
    "in_order",
    "label_of",
    "pack",
    "refused",
    "restricted",
    "unpack",
    "unpack_from",
]

_NOT_OF_A_CASE = ("distribution", "title")
"""Keys of a parameter that say which values it has, or what it is called: not what a value means."""


def canonical(data: Any) -> bytes:
    """Plain data as bytes, the same for the same data: for digests."""
    return json.dumps(data, sort_keys=True, separators=(",", ":")).encode()


def in_order(data: Any) -> bytes:
    """Plain data as bytes with their order, which is that of a study's parameters, and so of the columns of values."""
    return json.dumps(data, separators=(",", ":")).encode()


def _digest(*parts: bytes) -> str:
    """SHA-256 of parts, each with its length, as hexadecimal text."""
    whole = hashlib.sha256()
    for part in parts:
        whole.update(len(part).to_bytes(8, "little") + part)
    return whole.hexdigest()


def engine_of_blocks() -> str:
    """The version of what computes: that of the engine, and a digest of kinds that a user has registered."""
    from tmodes.study.identity import engine_version

    outside = outside_digest().encode()
    return engine_version() + (f"+{_digest(outside)[:16]}" if outside else "")


def base_of(study: Study) -> str:
    """Digest of what a case is, whatever computes it: the robot with its settings, and what each parameter means.

    Distributions are left out: a value that is the same from another distribution is the same case.
    """
    parameters = [
        [name, {key: value for key, value in entry.items() if key not in _NOT_OF_A_CASE}]
        for name, entry in study.data["study"]["parameters"].items()
    ]
    return _digest(canonical(study.data["robot"]), canonical(parameters))


def cases_address(base: str, names: Sequence[str], values: NDArray[np.float64]) -> str:
    """Address of the cases ``values`` (m, d) of the parameters ``names``: the same wherever in a study they stand."""
    numbers = np.ascontiguousarray(values, dtype="<f8")
    return _digest(base.encode(), canonical(list(names)), canonical(list(numbers.shape)), numbers.tobytes())


def restricted(study: Study, names: Sequence[str]) -> Study:
    """The study with these quantities alone, and those that they are made of."""
    wanted: set[str] = set()
    left = list(names)
    while left:
        name = left.pop()
        if name in study.sheet.quantities and name not in wanted:
            wanted.add(name)
            left += study.sheet.quantities[name].needs().names
    sheet = study.data["study"]
    if wanted == set(sheet["quantities"]):
        return study
    quantities = {name: entry for name, entry in sheet["quantities"].items() if name in wanted}
    own = {
        key: value for key, value in sheet.items() if key != "optimize"
    }  # it may name the quantities that are left out
    found = study.from_data({**study.data, "study": {**own, "quantities": quantities}}, functions=study.functions)
    return found if study.identified is None else replace(found, identified=study.identified)


BLOCK_FORMAT = 1
MAGIC = b"TMBLOCK\n"
PREFIX = struct.Struct("<8sIIQ32s32s")
MOST_HEADER, MOST_PAYLOAD = 1 << 24, 1 << 34
MOST_BLOCK = 1_000_000
"""Cases of one block."""

_TYPES = ("<f8", "<i8", "<u4", "|u1")
_KEPT = ("times", "states", "tip")


@dataclass(frozen=True)
class Label:
    """What a block is of, as its header says: the cases from ``first``, ``count`` of them, at ``address``.

    ``base``: digest of what a case is; ``engine``: version of what has computed it; ``keys``: a digest of each of its
    quantities; ``failed``: cases of which a quantity failed; ``wall``: seconds that it took.
    """

    base: str
    engine: str
    address: str
    first: int
    count: int
    keys: Mapping[str, str]
    failed: int
    wall: float

    @property
    def name(self) -> str:
        """Name of its file: a digest of all that its numbers depend on."""
        content = [self.base, self.engine, self.address, self.first, self.count, dict(self.keys)]
        return hashlib.sha256(canonical(content)).hexdigest()[:40] + ".block"

    @property
    def end(self) -> int:
        """The case after its last."""
        return self.first + self.count


@dataclass(frozen=True, eq=False)
class Block:
    """``rows``, and the ``label`` of what they depend on; ``asked``: the cases that were to keep their motion."""

    label: Label
    rows: Rows
    asked: tuple[int, ...] = ()


def label_of(base: str, engine: str, keys: Mapping[str, str], rows: Rows, wall: float = 0.0) -> Label:
    """The label of rows that were just computed."""
    values = np.column_stack(list(rows.parameters.values()))
    address = cases_address(base, list(rows.parameters), values)
    failed = sum(status == "failed" for status in rows.status)
    return Label(base, engine, address, int(rows.case[0]), len(rows), dict(keys), failed, wall)


def pack(block: Block) -> bytes:
    """The block as bytes."""
    rows = block.rows
    words = list(dict.fromkeys([*rows.reason, *rows.method]))
    place = {word: index for index, word in enumerate(words)}
    arrays: dict[str, NDArray[Any]] = {
        **{f"parameter/{name}": np.asarray(values, "<f8") for name, values in rows.parameters.items()},
        **{f"quantity/{name}": np.asarray(values, "<f8") for name, values in rows.quantities.items()},
        "status": np.array([STATUS.index(status) for status in rows.status], "|u1"),
        "reason": np.array([place[word] for word in rows.reason], "<u4"),
        "method": np.array([place[word] for word in rows.method], "<u4"),
        "seconds": np.asarray(rows.seconds, "<f8"),
        "errors": np.asarray(rows.errors, "<f8"),
        "words": np.frombuffer(canonical(words), "|u1"),
        "asked": np.array(block.asked, "<i8"),
    }
    kept: dict[str, Any] = {}
    for case, motion in rows.kept.items():
        kept[str(case)] = list(motion.names)
        arrays |= {f"kept/{case}/{part}": np.asarray(getattr(motion, part), "<f8") for part in _KEPT}
    header = canonical(
        {
            "label": {**vars(block.label), "keys": dict(block.label.keys)}, "units": dict(rows.units), "kept": kept,
            "arrays": [[name, array.dtype.str, list(array.shape)] for name, array in arrays.items()],
        }
    )  # fmt: skip
    payload = b"".join(array.tobytes() for array in arrays.values())
    digests = hashlib.sha256(header).digest(), hashlib.sha256(payload).digest()
    return PREFIX.pack(MAGIC, BLOCK_FORMAT, len(header), len(payload), *digests) + header + payload


def unpack(data: bytes | memoryview, which: object) -> Block:
    """The block that bytes hold; raises as :func:`unpack_from`."""
    return unpack_from(io.BytesIO(data), len(data), which)


def unpack_from(file: BinaryIO, size: int, which: object) -> Block:
    """The block of an open file of ``size`` bytes; ``which`` names it in messages.

    Raises :class:`tmodes.errors.ResultFileError` for what is no whole block of this version: sizes are compared with
    the length, digests with the content, and the address with the cases; what its first bytes refuse is not read.
    """
    try:
        header, payload = _parts(file, size, which)
        return _block(header, _arrays(header.arrays, payload))
    except ResultFileError:
        raise
    except (ValueError, KeyError, TypeError, IndexError, AttributeError, OverflowError, MemoryError) as error:
        raise refused(which, f"a block whose parts do not fit together ({error})") from error


def refused(which: object, got: str, expected: str = "a whole block of this study") -> ResultFileError:
    """The error of a block that cannot be used."""
    return file_error(which, got, expected, "delete this file to compute its cases again, or name another folder")


def _parts(file: BinaryIO, size: int, which: object) -> tuple[_Header, memoryview]:
    if size < PREFIX.size:
        raise refused(which, f"{size} bytes")
    magic, version, head, body, head_digest, body_digest = PREFIX.unpack(file.read(PREFIX.size))
    if magic != MAGIC:
        raise refused(which, "a file of another kind")
    if version != BLOCK_FORMAT:
        raise file_error(which, f"format version {version}", f"version {BLOCK_FORMAT}", "upgrade tmodes")
    if head > MOST_HEADER or body > MOST_PAYLOAD or PREFIX.size + head + body != size:
        raise refused(which, f"{size:,} bytes, where its start says {PREFIX.size + head + body:,}")
    header = _checked(file.read(head), head_digest, which)
    return _header().validate_json(header, strict=True), memoryview(_checked(file.read(body), body_digest, which))


@dataclass(frozen=True)
class _Header:
    """What the JSON of a header holds: what a block is of, units by quantity, states by kept case, and the arrays."""

    label: Label
    units: dict[str, str]
    kept: dict[str, list[str]]
    arrays: list[tuple[str, str, tuple[int, ...]]]


@cache
def _header() -> TypeAdapter[_Header]:
    return TypeAdapter(_Header)


def _checked(content: bytes, digest: bytes, which: object) -> bytes:
    if hashlib.sha256(content).digest() != digest:
        raise refused(which, "a content that does not match its checksum")
    return content


def _arrays(index: Sequence[tuple[str, str, tuple[int, ...]]], payload: memoryview) -> dict[str, NDArray[Any]]:
    found: dict[str, NDArray[Any]] = {}
    start = 0
    for name, kind, shape in index:
        if kind not in _TYPES or name in found or any(n < 0 for n in shape):
            raise ValueError(f"array {name!r}")
        length = math.prod(shape) * np.dtype(kind).itemsize
        if length > len(payload) - start:
            raise ValueError(f"array {name!r} is longer than the file")
        found[name] = np.frombuffer(payload[start : start + length], dtype=kind).reshape(shape)
        start += length
    if start != len(payload):
        raise ValueError("bytes that belong to no array")
    return found


def _block(header: _Header, arrays: dict[str, NDArray[Any]]) -> Block:
    label, count = header.label, header.label.count
    if not (0 < count <= MOST_BLOCK and label.first >= 0 and math.isfinite(label.wall)):
        raise ValueError(f"{count} cases from {label.first} in {label.wall} s")
    words = [str(word) for word in parsed_json(bytes(arrays["words"]))]
    texts = {of: [words[index] for index in arrays[of].tolist()] for of in ("reason", "method")}
    columns = {of: _columns(arrays, f"{of}/") for of in ("parameter", "quantity")}
    kept = {
        int(case): Kept(*(arrays[f"kept/{case}/{part}"] for part in _KEPT), names=tuple(names))
        for case, names in header.kept.items()
    }
    if any(_not_fitting(motion) for motion in kept.values()):
        raise ValueError("a motion of the wrong shape")
    if any((np.isfinite(column) & (np.abs(column) > MOST)).any() for column in columns["quantity"].values()):
        raise ValueError(f"a number beyond {MOST:g}")
    case = np.arange(label.first, label.end, dtype=np.int64)
    status = [STATUS[code] for code in arrays["status"].tolist()]
    rows = Rows(
        case, columns["parameter"], columns["quantity"], header.units, status, **texts,
        seconds=arrays["seconds"], kept=kept, errors=arrays.get("errors", np.zeros(0)),
    )  # fmt: skip
    lengths = {len(part) for part in (*columns["parameter"].values(), *columns["quantity"].values(), status)}
    if lengths | {len(rows.reason), len(rows.method), len(rows.seconds), len(rows.errors)} != {count}:
        raise ValueError("columns of different lengths")
    again = label_of(label.base, label.engine, label.keys, rows, label.wall)
    if set(label.keys) != set(rows.quantities) or again != label:
        raise ValueError("cases of another address")
    return Block(label, rows, tuple(arrays["asked"].tolist()))


def _not_fitting(motion: Kept) -> bool:
    samples, states = motion.times.shape, motion.states.shape
    fitting = len(samples) == 1 and motion.tip.shape == (*samples, 3) and len(states) == 2 and states[:1] == samples
    return not fitting or states[1] < len(motion.names)


def _columns(arrays: Mapping[str, NDArray[Any]], start: str) -> dict[str, NDArray[np.float64]]:
    """Columns by name, each of one dimension."""
    found = {name.removeprefix(start): array for name, array in arrays.items() if name.startswith(start)}
    if any(array.ndim != 1 or array.dtype != np.float64 for array in found.values()):
        raise ValueError("a column of the wrong shape")
    return found


@dataclass(frozen=True)
class Part:
    """Cases ``first`` to ``end``, whose quantities are in the blocks ``labels``; ``missing``: those in none."""

    first: int
    end: int
    labels: tuple[Label, ...]
    missing: tuple[str, ...]


@dataclass(frozen=True)
class Gap:
    """Cases ``first`` to ``end`` of which nothing is stored."""

    first: int
    end: int


@dataclass(frozen=True)
class Cover:
    """All cases in order: ``parts`` that are stored, ``gaps`` that are not; ``older``: cases of another engine only."""

    parts: tuple[Part, ...]
    gaps: tuple[Gap, ...]
    older: int

    @property
    def complete(self) -> bool:
        """Whether every quantity of every case is stored."""
        return not self.gaps and not any(part.missing for part in self.parts)

    @property
    def done(self) -> int:
        """Cases of which all is stored."""
        return sum(part.end - part.first for part in self.parts if not part.missing)


def covered(
    labels: Iterable[Label], total: int, engine: str, keys: Mapping[str, str], address: Callable[[int, int], str]
) -> Cover:
    """Cover ``total`` cases, whose ``address`` (first, end) is asked for, by blocks of this ``engine``.

    Blocks count by their content: a study with more cases, or another order of blocks, finds those that are there.
    """
    groups: dict[int, dict[int, list[Label]]] = defaultdict(lambda: defaultdict(list))
    for label in labels:
        if label.end <= total and _useful(label, keys):
            groups[label.first][label.end].append(label)
    parts: list[Part] = []
    gaps: list[Gap] = []
    case = older = 0
    starts = sorted(groups)
    while case < total:
        ends = {end: same for end, of in groups.get(case, {}).items() if (same := _same(of, address(case, end)))}
        here = {end: new for end, same in ends.items() if (new := [one for one in same if one.engine == engine])}
        if here:
            parts.append(_part(case, max(here), here[max(here)], keys))
            case = max(here)
            continue
        older += max(ends, default=case) - case
        following = next((start for start in starts if start > case), total)
        gaps.append(Gap(case, following))
        case = following
    return Cover(tuple(parts), _united(gaps), older)


def _same(labels: Sequence[Label], address: str) -> list[Label]:
    return [label for label in labels if label.address == address]


def _useful(label: Label, keys: Mapping[str, str]) -> bool:
    """Whether a block has a quantity that is asked for, and none that is not and may have made a case fail."""
    asked = [name for name, key in label.keys.items() if keys.get(name) == key]
    return bool(asked) and (len(asked) == len(label.keys) or not label.failed)


def _part(first: int, end: int, labels: Sequence[Label], keys: Mapping[str, str]) -> Part:
    """The fewest blocks that give most quantities: those with many first; the order is always the same."""
    left, used = dict(keys), []
    for label in sorted(labels, key=lambda label: (-len(label.keys), label.name)):
        gives = [name for name, key in label.keys.items() if left.get(name) == key]
        if gives:
            used.append(label)
            left = {name: key for name, key in left.items() if name not in gives}
    return Part(first, end, tuple(used), tuple(left))


def _united(gaps: Sequence[Gap]) -> tuple[Gap, ...]:
    """Gaps that touch as one."""
    found: list[Gap] = []
    for gap in gaps:
        if found and found[-1].end == gap.first:
            found[-1] = Gap(found[-1].first, gap.end)
        else:
            found.append(gap)
    return tuple(found)
