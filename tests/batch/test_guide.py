"""The example of the guide to batches prints what the guide says."""

from __future__ import annotations

import io
import re
from contextlib import redirect_stdout
from pathlib import Path

GUIDE = Path(__file__).parents[2] / "docs" / "batches.md"


def test_the_example_of_the_guide():
    guide = GUIDE.read_text(encoding="utf-8")
    code, info = re.findall(r"```python\n(.*?)```\n\n((?:    [^\n]*\n)+)", guide, re.DOTALL)[0]
    printed = io.StringIO()
    with redirect_stdout(printed):
        exec(compile(code, str(GUIDE), "exec"), {})  # noqa: S102
    assert printed.getvalue().splitlines() == [line.removeprefix("    ") for line in info.splitlines()]
