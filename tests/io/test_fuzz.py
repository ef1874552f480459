"""Whatever is done to the text of a data sheet, nothing but errors of tmodes comes out."""

from __future__ import annotations

import random
from typing import Any

from hypothesis import example, given, settings
from hypothesis import strategies as st

from io_cases import SHEET
from tmodes.errors import TmodesError
from tmodes.io.sheet_check import sheet_from_data as robot_from_data
from tmodes.io.yaml_file import parse_yaml

PIECES = ["[", "]", "{", "}", ":", " ", "\n", "\t", "'", '"', "#", "&a ", "*a", "!", "|", ">", "%", "@", "`", "-", "? "]
PIECES += ["- ", "0", "9" * 400, ".inf", ".nan", "1e999", "~", "true", "<<: ", "---\n", "...\n", "\0", "\x85", "\u2028"]
PIECES += ["\ufeff", "é", "\U0001f916", "%YAML 1.1\n", "\\", "\r", ",", "1_0", "0x1F", "12:30:45", "mm", " 1 **9**9"]


def mutated(seed: int, count: int) -> str:
    """The sheet with some places cut, doubled, moved or filled with junk."""
    dice = random.Random(seed)  # noqa: S311  # a reproducible choice, not a secret
    text = SHEET
    for _ in range(count):
        start = dice.randrange(len(text) + 1)
        end = min(len(text), start + dice.choice([0, 1, 1, 5, 40]))
        piece = dice.choice([*PIECES, "", text[end : end + 30], text[start:end] * 2])
        text = text[:start] + piece + text[end:]
    return text


def problem(data: Any, lines: dict[str, int] | None = None) -> str:
    """What tmodes has to say against plain data; empty for a right robot."""
    try:
        robot_from_data(data, lines, source="fuzz.yaml").pair()
    except TmodesError as error:
        return str(error)
    return ""


def problem_on_text(text: str) -> str:
    """What tmodes has to say against a text."""
    try:
        data, lines = parse_yaml(text, "fuzz.yaml")
    except TmodesError as error:
        return str(error)
    return problem(data, lines)


@settings(max_examples=200)
@given(seed=st.integers(0, 2**32), count=st.integers(1, 8))
def test_mutated_sheets(seed: int, count: int) -> None:
    said = problem_on_text(mutated(seed, count))
    assert said == "" or said.startswith("fuzz.yaml:")


@settings(max_examples=200)
@given(text=st.text(max_size=200))
@example("\ud800".encode("utf-8", "replace").decode())
@example("? |\n a")
@example("!<tag:yaml.org,2002:float> 1")
@example("a: !!binary x")
@example("- - - -\n -")
def test_any_text(text: str) -> None:
    assert problem_on_text(text).startswith("fuzz.yaml:")


plain = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=10),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=10), inner, max_size=3),
    max_leaves=8,
)


@settings(max_examples=200)
@given(data=st.data())
def test_any_data_in_any_place(data: st.DataObject) -> None:
    sheet, _ = parse_yaml(SHEET, "fuzz.yaml")
    group = data.draw(st.sampled_from(sorted(sheet)))
    where = sheet
    while isinstance(where.get(group), dict) and data.draw(st.booleans()):
        where = where[group]
        group = data.draw(st.sampled_from(sorted(where)))
    where[group] = data.draw(plain)
    said = problem(sheet)
    assert said == "" or said.startswith("fuzz.yaml: ")
