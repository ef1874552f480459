"""Matrices with names of their rows and columns, as files of other tools."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import InputError
from tmodes.io.atomic import atomic_write

__all__ = ["save_matrices"]


def save_matrices(
    file: Path, numbers: Mapping[str, Any], names: Mapping[str, Sequence[str]], plain: Mapping[str, Any]
) -> None:
    """Write ``numbers`` and ``names`` as ``.mat`` (for MATLAB) or ``.npz``, or ``plain`` data as ``.json``.

    Whole or not at all. Raises :class:`tmodes.errors.InputError` for another ending.
    """
    if file.suffix not in (".mat", ".npz", ".json"):
        expected = "a name that ends on .mat, .json or .npz"
        raise InputError("path", f"`{file.suffix}`", expected, "linear.save('a.mat')")
    with atomic_write(file) as temporary, temporary.open("wb") as stream:
        if file.suffix == ".mat":
            from scipy.io import savemat

            savemat(stream, {**numbers, **{key: np.array(value, dtype=object) for key, value in names.items()}})
        elif file.suffix == ".npz":
            np.savez(stream, allow_pickle=False, **numbers, **{key: np.array(value) for key, value in names.items()})
        else:
            stream.write(f"{json.dumps(plain)}\n".encode())
