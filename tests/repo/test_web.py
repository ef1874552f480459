"""The pages' programs: built from these very sources, with the licenses of what they hold, nothing from outside."""

from __future__ import annotations

import re

import pytest

from web import BUILT, built_from, digest

PROGRAMS = ("viewer.js", "studio.js", "model.js")


@pytest.mark.parametrize("name", PROGRAMS)
def test_it_is_built_from_these_sources(name: str) -> None:
    assert built_from(BUILT / name) == digest(), "python tools/web.py builds it anew"


@pytest.mark.parametrize("name", ["viewer.js", "studio.js"])
def test_it_holds_the_licenses_of_its_libraries(name: str) -> None:
    start = (BUILT / name).read_text(encoding="utf-8")[:4000]
    assert start.count("Permission is hereby granted") == 2
    assert "three.js authors" in start
    assert "Leon Sorokin" in start


@pytest.mark.parametrize("name", PROGRAMS)
def test_it_runs_no_text_and_loads_nothing(name: str) -> None:
    program = (BUILT / name).read_text(encoding="utf-8")
    assert re.findall(r"\beval\(|new Function\(|importScripts\(", program) == []
    assert re.findall(r"<script[^>]+src=|@import", program) == []


def test_no_address_of_a_package_is_kept() -> None:
    lock = (BUILT.parents[3] / "web" / "package-lock.json").read_text(encoding="utf-8")
    assert '"resolved"' not in lock
    assert "http" not in lock
