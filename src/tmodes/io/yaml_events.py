"""The events of a YAML text, as the parser gives them; its errors become ours."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmodes.errors import InputError
from tmodes.io.words import shown

__all__ = ["yaml_events"]


def yaml_events(text: str, source: str) -> Iterator[Any]:
    """Events of the YAML parser; each of its errors becomes ours."""
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError
    from ruamel.yaml.reader import ReaderError

    hint = "look there for a missing quote, bracket or colon, a tab, or wrong indentation"
    try:
        yield from YAML(typ="safe", pure=True).parse(text)
    except ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        got = f"the character {shown(text[error.position : error.position + 1])}"
        raise InputError("the file", got, "printable text", "remove it", f"{source}:{line}") from None
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        place = f"{source}:{mark.line + 1}" if mark else source
        problem = " ".join(str(error.problem or error.context or "something else").split())
        raise InputError("the file", f"broken YAML ({problem})", "YAML 1.2", hint, place) from None
    except InputError:
        raise
    except Exception as error:  # the parser lets raw IndexError, AssertionError... through on some junk
        raise InputError("the file", f"junk ({type(error).__name__})", "YAML 1.2", hint, source) from None
