"""The architecture in numbers stays where it is: one package for one thing, imports one way, kinds that answer."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import architecture

HOUSE = architecture.Architecture()
MOST_ENTRIES, MOST_LAYERS, MOST_EXCEPTIONS, MOST_QUAINT, MOST_ASKED, MOST_UPWARD = 22, 14, 0, 40, 5, 12
MOST_STATEMENTS, MOST_SCRIPT_LINES = 49_450, 17_500
"""Where the numbers are today: they may only fall. Fitted forms, which noted programs replace, are still in."""


def test_entries_of_the_package() -> None:
    assert len(HOUSE.entries) <= MOST_ENTRIES


def test_no_path_names_a_species_of_robot() -> None:
    assert HOUSE.named_for_a_species == []


def test_objects_are_not_asked_for_their_kind() -> None:
    assert len(HOUSE.asked) <= MOST_ASKED, "\n".join(HOUSE.asked)


@pytest.mark.parametrize("level", architecture.LEVELS)
def test_no_import_circles(level: str) -> None:
    assert HOUSE.circles(architecture.LEVELS[level]) == []


def test_layers_and_exceptions() -> None:
    layers, exceptions = HOUSE.layers
    assert layers <= MOST_LAYERS
    assert exceptions <= MOST_EXCEPTIONS


def test_plain_words() -> None:
    assert len(HOUSE.quaint) <= MOST_QUAINT, "\n".join(HOUSE.quaint)


def test_size() -> None:
    assert HOUSE.statements <= MOST_STATEMENTS
    assert HOUSE.script_lines <= MOST_SCRIPT_LINES


def test_scripts_name_modules_that_exist() -> None:
    """A script of the page that does as a module of Python does says which: where it was moved, the script follows."""
    root = architecture.ROOT
    named = {
        (file.name, found)
        for file in (root / "web" / "src").rglob("*.ts")
        for found in re.findall(r"\btmodes/[\w/]+\.py", file.read_text(encoding="utf-8"))
    }
    assert len(named) > 15
    assert [one for one in sorted(named) if not (root / "src" / one[1]).is_file()] == []


def test_few_methods_reach_an_upper_package() -> None:
    import tmodes

    assert len(tmodes._UPWARD) <= MOST_UPWARD
    for name in tmodes._UPWARD:
        assert callable(getattr(tmodes, name))


def test_what_a_rule_finds(tmp_path: Path) -> None:
    """Each rule finds what it is for, in a package that breaks it."""
    source = tmp_path / "src" / "tmodes"
    (source / "kinds").mkdir(parents=True)
    (source / "kinds" / "__init__.py").write_text("class Wheel: ...\n")
    (source / "__init__.py").write_text("")
    (source / "arm_a.py").write_text("def f(x):\n    from tmodes.b import g\n    return isinstance(x, Wheel)\n")
    (source / "b.py").write_text("from tmodes.arm_a import f\n# made an" + "ew\n")
    broken = architecture.Architecture(tmp_path)
    assert broken.named_for_a_species == ["arm_a.py"]
    assert broken.asked == ["src/tmodes/arm_a.py:3"]
    assert broken.quaint == ["src/tmodes/b.py:2"]
    assert broken.circles({"top"}) == []
    assert broken.circles({"top", "function"}) == [["tmodes.arm_a", "tmodes.b"]]
