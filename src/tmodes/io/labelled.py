"""Labelled series in memory: what of an xarray Dataset this package itself uses, without the second that it takes.

:class:`Record` has the same names for the same things, so that whoever reads it may be handed a Dataset as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["Labelled", "Record"]

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class Labelled:
    """One variable: ``values`` along ``dims``; ``record`` has the labels along these."""

    record: Record
    dims: tuple[str, ...]
    values: Array
    attrs: dict[str, Any] = field(default_factory=dict)

    @property
    def dtype(self) -> np.dtype[Any]:
        """Type of the values."""
        return self.values.dtype

    @property
    def shape(self) -> tuple[int, ...]:
        """Places along each dimension."""
        return self.values.shape

    @property
    def size(self) -> int:
        """Number of values."""
        return self.values.size

    @property
    def sizes(self) -> dict[str, int]:
        """Places along each dimension, by its name."""
        return dict(zip(self.dims, self.shape, strict=True))

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, place: Any) -> Any:
        return self.values[place]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self.values, dtype=dtype, copy=copy)

    def isel(self, **places: Any) -> Labelled:
        """The part at some places along dimensions: a number, which drops the dimension, a slice, or several."""
        dims, values = self.dims, self.values
        for dim, place in places.items():
            axis = dims.index(dim)
            values = values[(slice(None),) * axis + (place if isinstance(place, slice) else np.asarray(place),)]
            if not isinstance(place, slice) and np.ndim(place) == 0:
                dims = dims[:axis] + dims[axis + 1 :]
        return replace(self, dims=dims, values=values)

    def sel(self, **labels: Any) -> Labelled:
        """The part with a label, or with several in their order; a KeyError for one that there is not."""
        return self.isel(**{dim: self.record.places(dim, wanted) for dim, wanted in labels.items()})

    def transpose(self, *dims: Any) -> Labelled:
        """With the dimensions in this order; ``...``: all others, as they are."""
        rest = [dim for dim in self.dims if dim not in dims]
        order = [one for dim in dims for one in (rest if dim is ... else [dim])]
        return replace(self, dims=tuple(order), values=self.values.transpose([self.dims.index(dim) for dim in order]))


class Record:
    """Variables by name, some of them coordinates, and attributes of the whole."""

    def __init__(
        self,
        variables: Mapping[str, tuple[Iterable[str], Any, Mapping[str, Any]]],
        coordinates: Iterable[str] = (),
        attrs: Mapping[str, Any] | None = None,
    ) -> None:
        """``variables``: dimensions, values and attributes; those named as a dimension are ``coordinates`` too."""
        self.variables = {
            name: Labelled(self, tuple(dims), np.asarray(values), dict(info))
            for name, (dims, values, info) in variables.items()
        }
        self.sizes: dict[str, int] = {}
        for one in self.variables.values():
            self.sizes |= one.sizes
        self.coords = {*coordinates, *self.sizes} & self.variables.keys()
        self.attrs = dict(attrs or {})

    @classmethod
    def of(cls, dataset: Dataset) -> Self:
        """The record of a Dataset."""
        variables = {str(name): (map(str, v.dims), v.values, v.attrs) for name, v in dataset.variables.items()}
        return cls(variables, map(str, dataset.coords), dataset.attrs)

    def dataset(self) -> Dataset:
        """The same as a Dataset of xarray."""
        import xarray as xr

        parts = [{n: v for n, v in self.variables.items() if (n in self.coords) is own} for own in (False, True)]
        series, coordinates = ({n: (v.dims, v.values, v.attrs) for n, v in part.items()} for part in parts)
        return xr.Dataset(series, coords=coordinates, attrs=self.attrs)

    @property
    def dims(self) -> dict[str, int]:
        """Dimensions and their sizes."""
        return self.sizes

    @property
    def data_vars(self) -> dict[str, Labelled]:
        """The variables that are no coordinates."""
        return {name: one for name, one in self.variables.items() if name not in self.coords}

    @property
    def nbytes(self) -> int:
        """Bytes of all values."""
        return sum(one.values.nbytes for one in self.variables.values())

    def __contains__(self, name: object) -> bool:
        return name in self.variables

    def __getitem__(self, name: str) -> Labelled:
        return self.variables[name]

    def places(self, dim: str, wanted: Any) -> Any:
        """Where a label, or each of several, stands along a dimension."""
        known = {label: k for k, label in enumerate(self.variables[dim].values.tolist())}
        return known[wanted] if isinstance(wanted, (str, int, float)) else [known[one] for one in wanted]

    def isel(self, **places: Any) -> Record:
        """The part at some places along dimensions, of each variable that has these."""
        parts = {
            name: one.isel(**{dim: place for dim, place in places.items() if dim in one.dims})
            for name, one in self.variables.items()
        }
        return self._with({name: (one.dims, one.values, one.attrs) for name, one in parts.items()}, self.attrs)

    def assign(self, **variables: tuple[Iterable[str], Any, Mapping[str, Any]]) -> Record:
        """The same with further variables."""
        return self._with(self._plain() | variables, self.attrs)

    def assign_attrs(self, attributes: Mapping[str, Any] | None = None, **more: Any) -> Record:
        """The same with further attributes."""
        return self._with(self._plain(), {**self.attrs, **(attributes or {}), **more})

    def rename(self, names: Mapping[str, str]) -> Record:
        """The same with other names of some variables."""
        return self._with({names.get(name, name): info for name, info in self._plain().items()}, self.attrs)

    def _plain(self) -> dict[str, Any]:
        return {name: (one.dims, one.values, one.attrs) for name, one in self.variables.items()}

    def _with(self, variables: Mapping[str, Any], attrs: Mapping[str, Any]) -> Record:
        return Record(variables, self.coords, attrs)
