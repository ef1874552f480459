"""The page on laws for elastic joints and contact: its examples print what it says."""

from __future__ import annotations

import io
import re
from contextlib import redirect_stdout
from pathlib import Path

import pytest

PAGE = (Path(__file__).parents[2] / "docs" / "laws.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```python\n(.*?)```\n\n((?:    [^\n]*\n)+)", PAGE, re.DOTALL)


@pytest.mark.parametrize("example", range(len(EXAMPLES)))
def test_an_example(example: int) -> None:
    code, said = EXAMPLES[example]
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(code, {})  # noqa: S102
    assert printed.getvalue().splitlines() == [line.removeprefix("    ") for line in said.splitlines()]


def test_there_are_examples() -> None:
    assert len(EXAMPLES) == PAGE.count("```python") >= 2
