"""The examples of the guide to batches print what the guide says."""

from __future__ import annotations

import io
import re
from contextlib import redirect_stdout
from pathlib import Path

GUIDE = Path(__file__).parents[2] / "docs" / "batches.md"


def test_the_examples_of_the_guide():
    guide, known = GUIDE.read_text(encoding="utf-8"), {}
    examples = re.findall(r"```python\n(.*?)```\n\n((?:    [^\n]*\n)+)", guide, re.DOTALL)
    assert len(examples) == 4
    for code, info in examples:
        printed = io.StringIO()
        with redirect_stdout(printed):
            exec(compile(code, str(GUIDE), "exec"), known)  # noqa: S102
        assert printed.getvalue().splitlines() == [line.removeprefix("    ") for line in info.splitlines()]
