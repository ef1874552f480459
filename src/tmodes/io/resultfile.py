"""The result file: NetCDF-4, followed by a seal with its length and its checksum.

HDF5 readers (xarray, h5py, netCDF4) pass over what follows the end of their data, so they all read the file; tmodes
reads the seal first and believes nothing that does not match it. The seal has 64 bytes in every version, little-endian:

    magic (8) | format version (4) | size of the seal (4) | length of the body (8) | SHA-256 of the body (32)
    | reserved (4) | CRC-32 of the 60 bytes before (4)
"""

from __future__ import annotations

import hashlib
import io
import math
import os
import struct
import sys
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import ResultFileError
from tmodes.io.atomic import atomic_write, check_writable, file_error, real_path
from tmodes.io.labelled import Labelled, Record
from tmodes.io.netcdf import decoded, encoded
from tmodes.io.plain_file import regular_file

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["FORMAT_VERSION", "MAX_BYTES", "SEAL_BYTES", "read_record", "read_sealed", "write_sealed"]

FORMAT_VERSION = 1
MAX_BYTES = 8 * 2**30
"""Largest file, and largest content in memory, that is read unless the caller allows more [bytes]."""

MAGIC = b"\x93TMODES\n"
HDF5_MAGIC = b"\x89HDF\r\n\x1a\n"
AGAIN = "use a whole copy of the file, or run the robot again"
SEAL = struct.Struct("<8sIIQ32s4x")
CHECK = struct.Struct("<I")
SEAL_BYTES = SEAL.size + CHECK.size
CHUNK_BYTES = 2**20
PLAIN_BYTES = 2**25
"""Numbers up to so many bytes are not compressed: that takes longer than the run, and saves two fifths of the file."""


def write_sealed(dataset: Dataset | Record, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
    """Write a dataset or a record as a sealed file, atomically; the same one gives the same bytes.

    Numbers and text only: no Python objects. Raises :class:`ResultFileError` when the dataset holds anything else,
    or when the file cannot be written; an old file of that name is then untouched.
    """
    record = dataset if isinstance(dataset, Record) else Record.of(dataset)
    _check_storable(record)
    body = _body(record)
    check_writable(real_path(path).parent, len(body) + SEAL_BYTES)
    with atomic_write(path, overwrite=overwrite) as temporary, temporary.open("wb") as file:
        file.write(body)
        file.write(_seal(body))


def read_sealed(path: str | os.PathLike[str], *, max_bytes: int = MAX_BYTES) -> Dataset:
    """A sealed file as a dataset; see :func:`read_record`."""
    return read_record(path, max_bytes=max_bytes).dataset()


def read_record(path: str | os.PathLike[str], *, max_bytes: int = MAX_BYTES) -> Record:
    """Read a sealed file whole into memory, and close it.

    Raises :class:`ResultFileError` with the reason when the file is not a result, is damaged in a single bit, cut
    short or lengthened, newer than this program, or larger than ``max_bytes``.
    """
    body = _believed(Path(path), max_bytes)
    try:
        _check_plain(path, body, max_bytes)
        return decoded(body)
    except ResultFileError:
        raise
    except Exception as error:  # the libraries raise many kinds; the seal matched, so the content is at fault
        got = f"content that cannot be decoded ({type(error).__name__}: {error})"
        raise file_error(path, got, "a result of tmodes", "run the robot again") from error


def _seal(body: memoryview) -> bytes:
    start = SEAL.pack(MAGIC, FORMAT_VERSION, SEAL_BYTES, len(body), hashlib.sha256(body).digest())
    return start + CHECK.pack(zlib.crc32(start))


def _believed(path: Path, max_bytes: int) -> memoryview:
    """The body of a file whose seal matches it; what its last bytes refuse is not read."""
    try:
        with regular_file(path, sys.maxsize) as (file, size):
            if size == 0:
                raise file_error(path, "an empty file", "a result file", AGAIN)
            if size > max_bytes:
                raise file_error(path, f"{size:,} bytes", f"at most {max_bytes:,}", "allow more with max_bytes")
            start, place = file.read(len(HDF5_MAGIC)), max(0, size - SEAL_BYTES)
            file.seek(place)
            digest = _sealed_digest(path, start, file.read(SEAL_BYTES), place)
            file.seek(0)
            body = memoryview(file.read(place))
    except (OSError, ValueError, MemoryError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise file_error(
            path, f"“{reason}”", "a file that can be read", "check the name and the permissions"
        ) from error
    if hashlib.sha256(body).digest() != digest:
        raise file_error(path, "damaged content", "content that matches its SHA-256", AGAIN)
    return body


def _sealed_digest(path: Path, start: bytes, seal: bytes, length: int) -> bytes:
    """The digest of a body of so many bytes, as its seal says."""
    if not length or seal[: len(MAGIC)] != MAGIC:
        kind = "a file without the seal of tmodes at its end"
        found = f"{kind}: cut short, lengthened, or foreign" if start == HDF5_MAGIC else f"{kind}: foreign"
        raise file_error(path, found, "a result file", AGAIN)
    if zlib.crc32(seal[: SEAL.size]) != CHECK.unpack(seal[SEAL.size :])[0]:
        raise file_error(path, "a damaged seal", "a seal that matches its own checksum", AGAIN)
    _, version, _, stated, digest = SEAL.unpack(seal[: SEAL.size])
    if version != FORMAT_VERSION:
        expected = f"version {FORMAT_VERSION}"
        raise file_error(path, f"format version {version}", expected, "read it with the tmodes that wrote it, or newer")
    if stated != length:
        raise file_error(path, f"{length:,} bytes before the seal", f"{stated:,} bytes, as its seal says", AGAIN)
    return digest


def _check_storable(record: Record) -> None:
    """Refuse what would need pickle, or would come back as something else."""
    hint = "store numbers and text; anything else as JSON text in an attribute"
    for name, variable in record.variables.items():
        if variable.dtype.str[1] not in "fiuU" or variable.size == 0:
            got = f"{variable.dtype} of shape {variable.shape}"
            raise file_error(f"variable {name}", got, "numbers or text, at least one", hint)
    places: dict[str, dict[Any, Any]] = {"the result": record.attrs}
    places |= {f"variable {name}": variable.attrs for name, variable in record.variables.items()}
    for place, attributes in places.items():
        for name, value in attributes.items():
            if type(value) not in (str, int, float) or (type(value) is str and not _is_plain_text(value)):
                got = f"{value!r:.60}"
                raise file_error(f"attribute {name} of {place}", got, "text without NUL, an int or a float", hint)


def _is_plain_text(text: str) -> bool:
    """Text that UTF-8 can hold and that HDF5, which ends text at a NUL, does not cut."""
    return "\0" not in text and not any("\ud800" <= letter <= "\udfff" for letter in text)


def _body(record: Record) -> memoryview:
    """The NetCDF-4 file in memory: nothing in it depends on time, place, or what the record was read from."""
    return encoded(record, _storage(record))


def _storage(record: Record) -> Callable[[Labelled], dict[str, Any]]:
    """Numbers as they are or, where there are many, compressed in chunks of about a megabyte."""
    packed = record.nbytes > PLAIN_BYTES

    def stored(variable: Labelled) -> dict[str, Any]:
        if not packed or variable.dtype.str[1] == "U":
            return {}
        row = variable.dtype.itemsize * math.prod(variable.shape[1:])
        chunks = (max(1, min(variable.shape[0], CHUNK_BYTES // row)), *variable.shape[1:])
        return {"compression": "gzip", "shuffle": True, "compression_opts": 4, "chunks": chunks}

    return stored


def _check_plain(path: object, body: memoryview, max_bytes: int) -> None:
    """Refuse what a result never holds: links out of the file, Python objects, more numbers than the limit.

    A checksum shows damage, not intent: a made-up file may declare any size and name any other file.
    """
    import h5py

    size = 0
    with h5py.File(io.BytesIO(body), "r") as file:
        for name in file:
            data = file[name] if isinstance(file.get(name, getlink=True), h5py.HardLink) else None
            if (
                not isinstance(data, h5py.Dataset)
                or data.external
                or data.is_virtual
                or data.dtype.str[1] not in "fiuSV"
            ):
                raise file_error(path, f"{name!r}, which is no plain variable", "numbers and text", "do not trust it")
            size += data.nbytes
    if size > max_bytes:
        raise file_error(path, f"{size:,} bytes when unpacked", f"at most {max_bytes:,}", "allow more with max_bytes")
