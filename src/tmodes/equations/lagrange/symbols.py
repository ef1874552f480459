"""A robot whose numbers are symbols: the equations are written once, on the same data sheet that a person fills in."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, get_args

import casadi as ca

from tmodes.kinds.schema.quantity import DataSheet
from tmodes.paper.sheet import PLANT, PaperRobot

__all__ = ["symbolic_robot"]


def symbolic_robot() -> tuple[PaperRobot, Any]:
    """The robot with a symbol for every number, and the vector of the symbols in the order of ``Robot.numbers``."""
    symbols: list[Any] = []

    def leaf(path: str) -> Any:
        symbols.append(ca.SX.sym(path))
        return symbols[-1]

    fields = PaperRobot.model_fields
    groups = {name: _stand_in(fields[name].annotation, name, leaf) for name in PLANT}
    return PaperRobot.model_construct(**groups), ca.vertcat(*symbols)


def _stand_in(annotation: Any, path: str, leaf: Callable[[str], Any]) -> Any:
    if annotation is float:
        return leaf(path)
    if isinstance(annotation, type) and issubclass(annotation, DataSheet):
        values = {
            name: _stand_in(field.annotation, f"{path}.{name}", leaf) for name, field in annotation.model_fields.items()
        }
        return annotation.model_construct(**values)
    if getattr(annotation, "__origin__", None) is tuple:
        return tuple(_stand_in(item, f"{path}.{index}", leaf) for index, item in enumerate(get_args(annotation)))
    return None  # a name (a friction law, say): structure, not a number
