"""The pages that tools write are up to date, and every link leads somewhere."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from gallery import SHOTS
from links import broken_links, pages
from notation_doc import quantities
from tmodes.io.forms import F2010

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("tool", ["notation_doc", "robot_schema", "errors_doc"])
def test_written_page_is_up_to_date(tool: str) -> None:
    done = subprocess.run(
        [sys.executable, f"tools/{tool}.py", "--check"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_every_number_of_the_data_sheet_is_in_the_notation() -> None:
    paths = {path.replace("modes.N", "modes.0") for path, *_ in quantities(F2010.root)}
    robot_yaml = ROOT / "src" / "tmodes" / "robots" / "filipovic2010.yaml"
    assert len(paths) >= 30
    assert {"gear.stiffness", "link.modes.0.length", "gravity", "integration.step"} <= paths
    assert all(path.split(".")[-1] in robot_yaml.read_text(encoding="utf-8") or "max_" in path for path in paths)


@pytest.mark.parametrize("page", pages(ROOT), ids=lambda page: page.name)
def test_links_lead_to_files(page: Path) -> None:
    assert list(broken_links(page)) == []


def test_broken_link_is_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "[here](page.md#part) [gone](gone.md) ![no](no.png) [far](https://example.org/x)\n```\n[x](y)\n```\n"
    )
    assert list(broken_links(page)) == ["gone.md", "no.png"]


IMAGES = ROOT / "docs" / "images"


@pytest.mark.parametrize("name", [image.stem for image in sorted(IMAGES.iterdir())])
def test_a_picture_is_shown_next_to_the_commands_that_make_its_page(name: str) -> None:
    """Each is one that a tool takes again, by commands that a reader sees on the same page."""
    showing = [page for page in pages(ROOT) if f"images/{name}." in page.read_text(encoding="utf-8")]
    assert showing
    if name in {"stick-slip", "uncertain-axis"}:  # of tools/friction_picture.py and tools/axis_picture.py
        return
    said = "\n".join(page.read_text(encoding="utf-8") for page in showing if page.parent == ROOT / "docs")
    shot = SHOTS[name]
    commands = [*shot.commands, *([] if shot.page.endswith((".html", ".svg")) else [shot.page])]
    for command in commands:
        assert f"tmodes {command.replace(' --no-open', '')}" in said.replace(" --no-open", ""), command
