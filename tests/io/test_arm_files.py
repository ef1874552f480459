"""The one way in: each kind of file is known by its ending and first words, and all else is refused plainly."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmodes.errors import InputError, TmodesError
from tmodes.io.sheet_files import read_sheet


def test_a_sheet_is_handed_on_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "arm.yaml"
    path.write_text("format: 1\nkind: arm\nname: a\njoints:\n  - {name: j}\n")
    data, positions, source = read_sheet(path)
    assert data == {"format": 1, "kind": "arm", "name": "a", "joints": [{"name": "j"}]}
    assert (positions["joints.0.name"], source) == (5, str(path))


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("arm.txt", b"x", "a file with the ending '.txt'"),
        ("arm", b"x", "a file with the ending ''"),
        ("arm.urdf", b"", "an empty file"),
        ("arm.xml", b"", "an empty file"),
        ("arm.xml", b"<sdf/>", "the root element must be <robot> of a URDF or xacro, got <sdf>"),
        ("arm.URDF", b"<robot/>", "got no link"),
        ("arm.urdf", b'<robot><link name="a"/></robot>', "got no joint"),
        ("arm.yaml", b"\xff", "not UTF-8"),
        ("arm.yaml", b"urdf: 5", "urdf must be the path of a URDF, got 5"),
        ("arm.xacro", b"<robot", "broken XML"),
    ],
)
def test_others_are_refused(name: str, content: bytes, words: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(TmodesError) as caught:
        read_sheet(path)
    assert words in str(caught.value)
    assert str(path) in str(caught.value)


@pytest.mark.parametrize("name", ["arm.yaml", "arm.urdf", "arm.xacro", "arm.xml"])
def test_files_that_are_none(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_sheet(tmp_path / name)
    (tmp_path / name).mkdir()
    with pytest.raises(InputError, match="a directory"):
        read_sheet(tmp_path / name)
