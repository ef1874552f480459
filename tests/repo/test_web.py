"""The pages' programs: built from these very sources, with the licenses of what they hold, nothing from outside."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from patience import LONG
from web import BUILT, WEB, built_from, digest

PROGRAMS = ("viewer.js", "studio.js", "study.js", "plots.js", "model.js")


@pytest.mark.parametrize("name", PROGRAMS)
def test_it_is_built_from_these_sources(name: str) -> None:
    assert built_from(BUILT / name) == digest(), "python tools/web.py builds it again"


@pytest.mark.parametrize("name", ["viewer.js", "studio.js"])
def test_it_holds_the_licenses_of_its_libraries(name: str) -> None:
    start = (BUILT / name).read_text(encoding="utf-8")[:12000]
    assert start.count("Permission is hereby granted") == 7
    assert "three.js authors" in start
    assert "Leon Sorokin" in start
    assert "/* ml-matrix" in start


@pytest.mark.parametrize("name", PROGRAMS)
def test_it_runs_no_text_and_loads_nothing(name: str) -> None:
    program = (BUILT / name).read_text(encoding="utf-8")
    assert re.findall(r"\beval\(|new Function\(|importScripts\(", program) == []
    assert re.findall(r"<script[^>]+src=|@import", program) == []


def test_no_address_of_a_package_is_kept() -> None:
    lock = (WEB / "package-lock.json").read_text(encoding="utf-8")
    assert '"resolved"' not in lock
    assert "http" not in lock


@pytest.mark.skipif(not shutil.which("node"), reason="needs Node to build")
def test_the_sources_build_what_is_kept(tmp_path: Path) -> None:
    if not (WEB / "node_modules" / "esbuild").is_dir():
        pytest.skip("needs the packages of web/: npm ci")
    subprocess.run(["node", "build.mjs", tmp_path, digest()], cwd=WEB, check=True, timeout=LONG)
    assert sorted(path.name for path in tmp_path.glob("*.js")) == sorted(PROGRAMS)
    for name in PROGRAMS:
        assert (tmp_path / name).read_bytes() == (BUILT / name).read_bytes(), name
