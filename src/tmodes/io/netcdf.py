"""NetCDF-4 in memory, by h5py: what xarray writes and reads through h5netcdf, in a tenth of the time.

Dimensions are HDF5 dimension scales; text is of fixed width in UTF-8, its last dimension the letters of a word; an
attribute ``coordinates`` names what labels a variable besides its dimensions (CF conventions, section 5).
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.io.labelled import Labelled, Record

__all__ = ["decoded", "encoded"]

Storage = Callable[[Labelled], Mapping[str, Any]]
"""How a variable is stored: options of ``h5py.Group.create_dataset``."""

Array = NDArray[Any]

_NO_VARIABLE = "This is a netCDF dimension but not a netCDF variable."
_DIMENSION, _DIMENSIONS = "_Netcdf4Dimid", "_Netcdf4Coordinates"
_STORED = ("CLASS", "NAME", "REFERENCE_LIST", "DIMENSION_LIST", "DIMENSION_LABELS", "_Encoding", "coordinates")
"""Attributes by which the format says how a variable is stored; those that begin with ``_N`` do so too."""


def encoded(record: Record, storage: Storage) -> memoryview:
    """The file of a record: nothing in it depends on time or place."""
    import h5py

    buffer = io.BytesIO()
    with h5py.File(buffer, "w", track_order=True) as file:
        version = f"version=2,h5py={h5py.__version__},hdf5={h5py.version.hdf5_version}"
        file.attrs["_NCProperties"] = np.bytes_(version.encode())
        dims = {name: _dimensions(variable) for name, variable in record.variables.items()}
        sizes = {dim: size for own in dims.values() for dim, size in own.items()}
        numbers = {dim: number for number, dim in enumerate(sizes)}
        for name, variable in record.variables.items():
            options = storage(variable) if variable.dims else {}
            data = file.create_dataset(name, data=_plain(variable.values), track_order=True, **options)
            text = {"_Encoding": "utf-8"} if np.issubdtype(variable.dtype, np.str_) else {}
            _describe(data.attrs, variable.attrs | text)
            if dims[name]:
                data.attrs[_DIMENSIONS] = np.array([numbers[dim] for dim in dims[name]], dtype=np.int32)
        _make_scales(file, sizes, numbers)
        _attach(file, {name: own for name, own in dims.items() if name not in sizes})
        _describe(file.attrs, record.attrs)
        _name_labels(file, record)
    return buffer.getbuffer()


def _make_scales(file: Any, sizes: Mapping[str, int], numbers: Mapping[str, int]) -> None:
    """The dimensions: the variables of their names, or what stands for them where there is none."""
    for dim, size in sizes.items():
        if dim in file:
            file[dim].make_scale(dim)
        else:
            file.create_dataset(dim, (size,), ">f4", track_order=True).make_scale(f"{_NO_VARIABLE}{size:10d}")
        file[dim].attrs[_DIMENSION] = np.int32(numbers[dim])


def _attach(file: Any, dims: Mapping[str, Mapping[str, int]]) -> None:
    """Each variable to its dimensions; a dimension itself has none but its own."""
    for name, own in dims.items():
        for place, dim in zip(file[name].dims, own, strict=True):
            place.attach_scale(file[dim])


def _dimensions(variable: Labelled) -> dict[str, int]:
    """Dimensions in the file and their sizes; of text one more."""
    if not np.issubdtype(variable.dtype, np.str_):
        return variable.sizes
    width = _plain(variable.values).shape[-1]
    return variable.sizes | {f"string{width}": width}


def _plain(values: Array) -> Array:
    """Numbers as they are, text as its letters in UTF-8."""
    if not np.issubdtype(values.dtype, np.str_):
        return values
    words = np.char.encode(values, "utf-8")
    return words[..., None].view("S1").reshape(*words.shape, words.dtype.itemsize)


def _describe(place: Any, attributes: Mapping[str, Any]) -> None:
    for name, value in attributes.items():
        place[name] = value if type(value) is str else np.atleast_1d(value)


def _name_labels(file: Any, record: Record) -> None:
    """What labels each series besides its dimensions; at the file itself what labels none."""
    found: dict[str, list[str]] = {}
    for label in sorted(record.coords - record.sizes.keys()):
        dims = set(record[label].dims)
        for name in [name for name, one in record.data_vars.items() if dims <= set(one.dims)] or ["/"]:
            found.setdefault(name, []).append(label)
    for name, labels in found.items():
        file[name].attrs["coordinates"] = " ".join(labels)


def decoded(body: memoryview) -> Record:
    """The record of a file; whatever is wrong in it raises an error of h5py, KeyError, TypeError or ValueError."""
    import h5py

    with h5py.File(io.BytesIO(body), "r") as file:
        every: dict[str, Any] = {str(name): file[name] for name in file}
        ids = {
            int(one.attrs[_DIMENSION]): name for name, one in every.items() if _DIMENSION in one.attrs and one.is_scale
        }
        chosen = {
            name: one for name, one in every.items() if not _text(one.attrs.get("NAME", "")).startswith(_NO_VARIABLE)
        }
        labels = [word for one in (file, *chosen.values()) for word in _text(one.attrs.get("coordinates", "")).split()]
        variables = {name: _read(name, one, ids) for name, one in chosen.items()}
        return Record(variables, labels, _attributes(file.attrs))


def _read(name: str, data: Any, ids: Mapping[int, str]) -> tuple[tuple[str, ...], Array, dict[str, Any]]:
    """Dimensions, values and attributes of one variable."""
    dims, values = _dims(name, data, ids), np.asarray(data[()])
    if len(dims) != values.ndim:
        raise ValueError(f"{name} has {len(dims)} names of dimensions and {values.ndim} dimensions")
    if np.issubdtype(values.dtype, np.bytes_):
        letters = values.dtype.itemsize == 1 and values.ndim > 0
        words = np.ascontiguousarray(values).view(f"S{values.shape[-1]}")[..., 0] if letters else values
        dims, values = dims[: words.ndim], np.char.decode(words, "utf-8")
    elif values.dtype.byteorder == ">":
        values = values.astype(values.dtype.newbyteorder("="))
    return dims, values, _attributes(data.attrs)


def _dims(name: str, data: Any, ids: Mapping[int, str]) -> tuple[str, ...]:
    if _DIMENSIONS in data.attrs:
        return tuple(ids[int(number)] for number in data.attrs[_DIMENSIONS])
    if data.is_scale or not data.ndim:
        return (name,)[: data.ndim]
    return tuple(scale[0].name.lstrip("/") for scale in data.dims)


def _attributes(place: Any) -> dict[str, Any]:
    """Text and Python numbers, as they were written, without those that say how the file is stored."""
    return {name: _value(place[name]) for name in place if name not in _STORED and not name.startswith("_N")}


def _value(value: Any) -> Any:
    if type(value) in (str, bytes, np.bytes_):
        return _text(value)
    one = np.asarray(value)
    return one.reshape(()).item() if one.size == 1 else one


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
