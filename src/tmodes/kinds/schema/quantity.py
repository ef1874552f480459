"""Physical quantities as fields: a number that knows its unit, its symbol in the paper and its range.

The field itself is the single source of the schema, of the error messages, of the vector of parameters, of the data
sheet in a report and of the notation page. No physical quantity has a default (gravity is the one exception, and it is
printed).
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple, Self

from pydantic import BaseModel, ConfigDict, Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from tmodes.errors import InputError
from tmodes.kinds.noted.functions import isinf
from tmodes.kinds.noted.number import Noted

__all__ = [
    "LARGEST", "SMALLEST", "DataSheet", "Issue", "any_sign", "dissipation", "not_negative", "plain_texts",
    "positive", "quantity", "refuse", "span_info", "too_late",
]  # fmt: skip

LARGEST = 1e12
"""The largest finite magnitude a quantity may have [its unit]: beyond it products of quantities overflow a double."""

SMALLEST = 1e-12
"""The smallest value of a quantity that must be greater than zero [its unit]: below it quotients overflow a double."""


LEAST = 1e-100
"""The smallest magnitude of any other quantity that is not zero [its unit]: quotients of squares overflow below it."""


class Issue(NamedTuple):
    """A value that is right by itself and wrong with the others of its group."""

    field: str
    got: str
    expected: str
    hint: str


def too_late(delay: float, period: float | None, most: int = 500) -> Iterator[Issue]:
    """A ``delay`` [s] of more samples than may wait: each of them is a state."""
    if period is not None and delay > most * period:
        yield Issue(
            "delay", f"{delay:g} s, {delay / period:.0f} samples", f"at most {most * period:g} s: {most} samples",
            "shorten it, or sample less often",
        )  # fmt: skip


_STEERING = ("Cc", "Cf", "Cs", "Co", "Zl", "Zp")
"""Unicode categories of letters that are not shown but steer what is: control, direction, surrogates, private, ends."""


def plain_texts(texts: Mapping[str, str]) -> list[Issue]:
    """Texts by path go to terminals and pages: those with letters that steer them are refused, and names of lines."""
    return [
        Issue(path, ascii(text[:60]), "text without control characters", "write it in plain letters")
        for path, text in texts.items()
        for allowed in ["" if path.endswith(("name", "child")) else "\n"]
        if any(unicodedata.category(letter) in _STEERING and letter != allowed for letter in text)
    ]


def refuse(issues: Sequence[Issue]) -> None:
    """Raise what a data sheet's validator must raise when values do not fit together; nothing when all fit."""
    if issues:
        raise PydanticCustomError("issues", "values that do not fit together", {"issues": list(issues)})


class DataSheet(BaseModel):
    """A frozen group of quantities; unknown keys are refused, text and booleans are not numbers."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", strict=True, allow_inf_nan=False, ser_json_inf_nan="strings",
        defer_build=True,  # what checks a group is built with the robot that holds it, once, not for each by itself
    )  # fmt: skip

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        refuse(list(self._issues()))
        return self

    def _issues(self) -> Iterator[Issue]:
        """Values that do not fit together."""
        yield from ()

    def __setattr__(self, name: str, value: Any) -> None:
        """Refused: what is checked once stays as it is. Raises :class:`tmodes.errors.InputError`."""
        raise _unchanging(self, name, value)

    def __delattr__(self, name: str) -> None:
        """Refused, as an assignment."""
        raise _unchanging(self, name, None)

    def __dir__(self) -> list[str]:
        """Its fields and what is defined for users, without what it has of the library that checks it."""
        hidden = {*vars(BaseModel), *vars(DataSheet)}
        return sorted(name for name in object.__dir__(self) if not name.startswith("_") and name not in hidden)

    @classmethod
    def members(cls) -> tuple[type[DataSheet], ...]:
        """The sheets that may stand where this one is named: itself, or those of all registered kinds of a family."""
        return (cls,)

    @classmethod
    def kind_named(cls, data: Any) -> type[DataSheet] | None:  # noqa: ARG003
        """The one of ``members`` that data name; None where they name none."""
        return cls

    @classmethod
    def chosen_by(cls) -> tuple[str, tuple[str, ...]]:
        """The key that names its kind, and its words there; empty where that is a field with one value, or none."""
        return "", ()

    @field_validator("*", mode="after")
    @classmethod
    def _in_range_of_arithmetic(cls, value: Any, info: ValidationInfo) -> Any:
        extra = cls.model_fields[info.field_name or ""].json_schema_extra
        if isinstance(value, (float, Noted)) and isinstance(extra, dict) and not isinf(value):
            smallest = float(str(extra["smallest"])) or (LEAST if value and "kg" in str(extra["unit"]) else 0.0)
            if not smallest <= abs(value) <= LARGEST:
                bounds = {"smallest": smallest, "largest": LARGEST}
                raise PydanticCustomError("arithmetic", "from {smallest} to {largest}", bounds)
        return value


def _unchanging(sheet: DataSheet, name: str, value: Any) -> InputError:
    """The error of an assignment to a sheet, with what takes its place."""
    known = name in type(sheet).model_fields
    hint = f'take a changed robot: robot = robot.with_({{"{name}": {value!r:.60}}})'
    if not hasattr(sheet, "with_"):
        hint = f'take a changed robot by the whole path: robot.with_({{"joints.NAME. ... .{name}": {value!r:.60}}})'
    hint = hint if known else f"its fields are {', '.join(type(sheet).model_fields)}"
    return InputError(name, "an assignment", "left as it is: a data sheet does not change", hint)


def quantity(
    unit: str,
    symbol: str,
    meaning: str,
    *,
    default: Any = ...,
    above: float | None = None,
    at_least: float | None = None,
    at_most: float | None = None,
    smallest: float = 0.0,
    rigid: bool = False,
    plausible: tuple[float, float] | None = None,
    span: bool = False,
) -> Any:
    """A numeric field.

    ``above``/``at_least``/``at_most`` bound it by physics; its magnitude must also lie between ``smallest`` and
    :data:`LARGEST`, by arithmetic; ``rigid`` lets it be infinite, which means rigid on purpose; ``plausible`` is
    the range outside of which a wrong unit is likely (a warning, never an error); ``span``: messages state the least
    and the largest value, whatever bounds them.
    """
    return Field(
        default,
        gt=above,
        ge=at_least,
        le=at_most,
        allow_inf_nan=True if rigid else None,
        description=f"{meaning} [{unit}]",
        json_schema_extra={
            "unit": unit,
            "symbol": symbol,
            "rigid_when_infinite": rigid,
            "plausible": list(plausible) if plausible else None,
            "smallest": smallest,
            **({"span": True} if span else {}),
        },
    )


def positive(unit: str, symbol: str, meaning: str, *, smallest: float = SMALLEST, **more: Any) -> Any:
    """A quantity that must be greater than zero (a length, a mass, a stiffness)."""
    return quantity(unit, symbol, meaning, above=0.0, smallest=smallest, **more)


def not_negative(unit: str, symbol: str, meaning: str, **more: Any) -> Any:
    """A quantity for which zero is a right physical limit (a damping, a payload, a friction)."""
    return quantity(unit, symbol, meaning, at_least=0.0, **more)


def dissipation(unit: str, symbol: str, meaning: str, *, most: float = LARGEST, **more: Any) -> Any:
    """A quantity that takes energy from a motion; a negative one feeds it, which is reported and not forbidden."""
    return quantity(unit, symbol, meaning, plausible=(0.0, most), **more)


def any_sign(unit: str, symbol: str, meaning: str, **more: Any) -> Any:
    """A quantity of either sign (an angle, a preload)."""
    return quantity(unit, symbol, meaning, **more)


def span_info(least: float, largest: float | None) -> str:
    """The least and the largest value of a quantity whose messages state both, such as `` from 1e-13 to 0.01``."""
    return f" from {least:g} to {LARGEST if largest is None else largest:g}"
