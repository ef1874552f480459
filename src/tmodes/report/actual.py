"""The actual robot of a result, rebuilt once for all that a page shows of it."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from tmodes.errors import TmodesError
from tmodes.model.model import Model
from tmodes.report.scene_meshes import carriers
from tmodes.result import Result
from tmodes.sheet import Robot

__all__ = ["Actual", "actual"]


class Actual:
    """The robot that ran, from its stored data sheet, and its model.

    ``missing``: why it cannot be rebuilt in this process, such as a kind that is not registered; empty where it can.
    ``drawn``: the links of which the result has lines; ``names``: these, then links that are nothing but a surface.
    """

    def __init__(self, result: Result) -> None:
        self.missing, data = "", result.data
        self.drawn = [str(name) for name in data["link"].values] if "link" in data.dims else []
        try:
            self.robot: Robot = result.actual
            self.model = Model(self.robot.chain())
            self.names = [*self.drawn, *carriers(data, self.model.chain, self.drawn)]
            _ = self.model.passes  # unknown equations are found here
        except TmodesError as error:
            self.missing, self.names = str(error), self.drawn


_KNOWN: WeakKeyDictionary[Result, Actual] = WeakKeyDictionary()


def actual(result: Result) -> Actual:
    """The same for the same result."""
    if result not in _KNOWN:
        _KNOWN[result] = Actual(result)
    return _KNOWN[result]
