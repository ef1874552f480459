"""Results of any length, of a short run whose samples repeat: for tests of files and summaries, not of physics."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import numpy as np

import tmodes
from tmodes.result import Result

MOVE_END = 2.0
"""When the move of these results ends [s]."""


@cache
def _short(contact: bool) -> Any:
    changes = {"contact": contact, "integration.duration": 0.05, "integration.line_points": 5}
    data = tmodes.run(tmodes.load("filipovic2010").with_(changes)).data
    data.attrs |= {"settling": "null", "errors": "null", "move_end": json.dumps(MOVE_END), "warnings": "[]"}
    return data


def synthetic_result(contact: bool = True, *, duration: float = 2.0, samples: int = 2001) -> Result:
    """The shipped robot's first motion over and over; settling is found in the samples alone."""
    data = _short(contact)
    repeated = data.isel(time=np.arange(samples) % data.sizes["time"])
    time = ("time", np.linspace(0.0, duration, samples), dict(data["time"].attrs))
    return Result(repeated.assign_coords(time=time).copy(deep=True))
