"""Long lists of numbers of a YAML file do not go through the parser: same data, same lines, bounded."""

from __future__ import annotations

import pytest

from tmodes.errors import InputError
from tmodes.io.yaml_file import parse_yaml


def test_long_lists_of_numbers_are_read_as_the_parser_reads_them() -> None:
    """Values, lines, anchors, neighbours, and lines of a text that only look like such a list."""
    numbers = [f"{k / 7!r}" for k in range(40)]
    rows = "\n".join(f"    - {number}" for number in numbers)
    text = f"a:\n  first: &kept\n{rows}\n    - -1.5e-3\n  again: *kept\n  mixed:\n{rows}\n    - word\n  last: 1\n"
    data, lines = parse_yaml(text, "sheet")
    values = [*map(float, numbers)]
    assert data == {
        "a": {"first": [*values, -1.5e-3], "again": [*values, -1.5e-3], "mixed": [*values, "word"], "last": 1}
    }
    assert lines["a.first.0"] == 3
    assert lines["a.first.40"] == 43
    assert lines["a.mixed.39"] == 85
    assert lines["a.last"] == 87
    block = "\n".join(f"  - {number}" for number in numbers)
    assert (
        parse_yaml(f"title: |\n{block}\n", "sheet")[0]["title"] == "\n".join(f"- {number}" for number in numbers) + "\n"
    )
    assert parse_yaml(f"title: \ue0000\nb:\n{block}\n", "sheet")[0] == {"title": "\ue0000", "b": values}


def test_long_lists_are_bounded() -> None:
    rows = "\n".join("  - 0.5" for _ in range(2000))
    aliases = "\n".join(f"b{k}: *a" for k in range(250))
    with pytest.raises(InputError, match="more than 400000 items"):
        parse_yaml(f"kind: arm\na: &a\n{rows}\n{aliases}\n", "sheet")
