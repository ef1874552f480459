"""Files that a robot's file names lie in its folder or in listed roots; nothing else is looked at, nothing fetched."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmodes.errors import InputError
from tmodes.io.files import folders_of
from tmodes.io.urdf import read_urdf

LINK = '<link name="{0}"><visual><geometry><mesh filename="{1}"/></geometry></visual></link>'
ROBOT = """<robot name="r">{0}
<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>"""


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """A package with a robot's folder and meshes, and a secret next to it."""
    for name in ("arm_pkg/urdf/local.stl", "arm_pkg/meshes/a.stl", "roots/other/b.stl", "secret/c.stl"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("solid")
    (tmp_path / "arm_pkg/package.xml").write_text("<package/>")
    (tmp_path / "arm_pkg/urdf/link.stl").symlink_to(tmp_path / "secret/c.stl")
    (tmp_path / "arm_pkg/meshes/link.stl").symlink_to(tmp_path / "secret/c.stl")
    return tmp_path


def find(home: Path, name: str, *roots: str, trust: bool = False) -> Path | None:
    folders = folders_of(home / "arm_pkg/urdf/arm.urdf", [home / root for root in roots], trust)
    return folders.find(name, "link a: mesh", "arm.urdf:3")


@pytest.mark.parametrize(
    ("name", "roots", "found"),
    [
        ("local.stl", (), "arm_pkg/urdf/local.stl"),
        ("./local.stl", (), "arm_pkg/urdf/local.stl"),
        ("../meshes/a.stl", ("arm_pkg",), "arm_pkg/meshes/a.stl"),
        ("package://arm_pkg/meshes/a.stl", (), "arm_pkg/meshes/a.stl"),
        ("package://other/b.stl", ("roots",), "roots/other/b.stl"),
        ("package://other/b.stl", ("roots/other",), "roots/other/b.stl"),
        ("package://other/b.stl", (), None),
        ("package://unknown/b.stl", ("roots",), None),
        ("absent.stl", (), None),
        ("x" * 300 + ".stl", (), None),
    ],
)
def test_found_inside(home: Path, name: str, roots: tuple[str, ...], found: str | None) -> None:
    assert find(home, name, *roots) == (home / found if found else None)


@pytest.mark.parametrize(
    "name",
    [
        "../meshes/a.stl",
        "../../secret/c.stl",
        "link.stl",
        "/etc/passwd",
        "C:\\secret\\c.stl",
        "..\\..\\secret\\c.stl",
        "file:///etc/passwd",
        "http://example.com/a.stl",
        "https://example.com/a.stl",
        "model://a/b.stl",
        "package://x/../../../../etc/passwd",
        "package://arm_pkg/../secret/c.stl",
        "package://arm_pkg/meshes/link.stl",
        "package://../secret/c.stl",
        "",
        "a\0b",
        "a\nb",
        "y" * 2000,
    ],
)
def test_refused(home: Path, name: str) -> None:
    with pytest.raises(InputError) as caught:
        find(home, name)
    assert str(caught.value).startswith("arm.urdf:3: link a: mesh must be")


def test_trust_opens_paths_but_fetches_nothing(home: Path) -> None:
    assert find(home, "../../secret/c.stl", trust=True) == home / "secret/c.stl"
    assert find(home, f"file://{home}/secret/c.stl", trust=True) == home / "secret/c.stl"
    assert find(home, str(home / "secret/c.stl"), trust=True) == home / "secret/c.stl"
    assert find(home, "http://example.com/a.stl", trust=True) is None


def test_an_absolute_path_inside_is_inside(home: Path) -> None:
    assert find(home, str(home / "arm_pkg/urdf/local.stl")) == home / "arm_pkg/urdf/local.stl"


def test_a_package_is_no_folder_that_happens_to_have_the_name(home: Path) -> None:
    (home / "arm_pkg/package.xml").unlink()
    assert find(home, "package://arm_pkg/meshes/a.stl") is None


def test_a_urdf_keeps_the_checked_paths_by_link(home: Path) -> None:
    path = home / "arm_pkg/urdf/arm.urdf"
    path.write_text(ROBOT.format(LINK.format("a", "package://arm_pkg/meshes/a.stl")))
    assert read_urdf(path).meshes == {"a": [home / "arm_pkg/meshes/a.stl"]}
    path.write_text(ROBOT.format(LINK.format("a", "../../secret/c.stl")))
    outside = read_urdf(path)
    assert outside.meshes == {}
    assert "leads outside" in outside.data["notices"][0]
    assert read_urdf(path, trust_paths=True).meshes == {"a": [home / "secret/c.stl"]}
