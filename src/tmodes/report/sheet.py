"""The robot's data sheet as tables: value, unit, symbol and meaning come from the fields of :class:`Robot`."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, get_args

from pydantic import BaseModel

from tmodes.paper.sheet import PaperRobot
from tmodes.plot.units import pretty
from tmodes.report.markup import Markup, tag
from tmodes.report.tables import grouped_table

if TYPE_CHECKING:
    from pydantic.fields import FieldInfo

__all__ = ["data_sheet"]

APART = ("name", "title", "citation", "format", "real")
"""Told elsewhere on the page: in its head, or in the column of the real robot."""

Row = tuple[str, str, str, str, str, str]
"""Meaning, key, symbol, known value, real value where it differs, unit."""


def data_sheet(sheet: Mapping[str, Any], real: Mapping[str, float]) -> Markup:
    """The whole data sheet; ``sheet`` as it was stored, ``real`` the numbers of the real robot by path."""
    groups: dict[str, list[Row]] = {}
    for path, value, field in _leaves(sheet, PaperRobot):
        if path.split(".")[0] not in APART:
            group = path.rpartition(".")[0] or "robot"
            groups.setdefault(group, []).append(_row(path, value, field, real))
    caption = "Data sheet: the robot as it is known, and the real one where it differs"
    head = ("Quantity", "Key", "Symbol", "Known", "Real", "Unit")
    return grouped_table(caption, head, {_title(group): rows for group, rows in groups.items()}, numeric=(3, 4))


def _leaves(value: Any, model: Any, path: str = "", field: FieldInfo | None = None) -> Iterator[tuple[str, Any, Any]]:
    """Path, value and field of every entry; where the sheet and the model part ways, the field is None."""
    if isinstance(value, Mapping):
        fields = model.model_fields if isinstance(model, type) and issubclass(model, BaseModel) else {}
        for key, item in value.items():
            inner = fields.get(key)
            yield from _leaves(item, inner and inner.annotation, f"{path}.{key}".lstrip("."), inner)
    elif isinstance(value, list):
        kinds = get_args(model)
        for index, item in enumerate(value):
            kind = kinds[min(index, len(kinds) - 1)] if kinds else None
            yield from _leaves(item, kind, f"{path}.{index}", field)
    else:
        yield path, value, field


def _row(path: str, value: Any, field: FieldInfo | None, real: Mapping[str, float]) -> Row:
    extra = field.json_schema_extra if field else None
    info = extra if isinstance(extra, dict) else {}
    key = path.rpartition(".")[2]
    unit = str(info.get("unit", ""))
    meaning = (field.description or "") if field else ""
    meaning = meaning.removesuffix(f" [{unit}]") or key.replace("_", " ")
    other = real.get(path)
    differs = isinstance(value, (int, float)) and other is not None and other != value
    symbol = str(info.get("symbol", ""))
    return (
        meaning,
        tag("code", key),
        symbol,
        _shown(value),
        _shown(other) if differs else "",
        pretty(unit) if unit else "",
    )


def _shown(value: Any) -> str:
    match value:
        case bool():
            return "yes" if value else "no"
        case float() if not math.isinf(value):
            return f"{value:.6g}"
        case float() | "Infinity":
            return "∞ (rigid)"
    return str(value)


def _title(group: str) -> str:
    """``link.modes.0`` as ``Link, mode 1``."""
    words = [f"mode {int(word) + 1}" if word.isdigit() else word for word in group.split(".") if word != "modes"]
    return ", ".join(words).capitalize()
