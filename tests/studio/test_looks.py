"""The looks of robots in the studio: meshes of uploads, of files of the working folder, of published robots."""

from __future__ import annotations

import base64
import gzip
import json
import re
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.errors import InputError
from tmodes.io.mesh_file import box
from tmodes.report.meshes import StoredMesh, kept_meshes
from tmodes.result import Result
from tmodes.studio.folders import WorkingFolder
from tmodes.studio.looks import MOST_KEPT, Shelf, source_of
from tmodes.studio.upload import main_file

URDF = """<robot name="two">
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0.25 0 0"/><mass value="2"/>
      <inertia ixx="0.01" iyy="0.05" izz="0.05" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="{mesh}"/></geometry></visual>
  </link>
  <joint name="hinge" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
</robot>
"""
ELASTICITY = """format: 1
urdf: {urdf}
name: mine
drives:
  - joint: hinge
    command: prescribed
    signal: {{type: quintic, start: 0.0, end: 0.5, duration: 0.2}}
integration: {{duration: 0.2, output_step: 0.02}}
"""


def stl(size: float) -> bytes:
    """A box as a binary STL, twelve triangles."""
    surface = box(np.full(3, size))
    corners = surface.vertices[surface.faces].astype("<f4")
    records = b"".join(struct.pack("<12x") + one.tobytes() + b"\0\0" for one in corners)
    return bytes(80) + struct.pack("<I", len(corners)) + records


def sent(studio: Any, files: dict[str, bytes | str], code: int = 200) -> Any:
    info = [
        {"name": name, "content": base64.b64encode(text.encode() if isinstance(text, str) else text).decode()}
        for name, text in files.items()
    ]
    return studio.post("/api/upload", json={"files": info}, code=code)


def simulated(studio: Any, info: Any, product: str = "curves", code: int = 200) -> Any:
    """What is reported of a job with the looks of an answer, and its bytes."""
    order = {"product": product, "sheet": info["sheet"], "looks": info["looks"], "client": "looks"}
    job = studio.post("/api/jobs", json=order, code=code)["job"]
    ended = studio.ended(job)
    assert ended["state"] == "done", ended["errors"]
    return ended["info"], studio.client.get(f"/api/jobs/{job}/content").content


def meshes(content: bytes) -> list[Any]:
    """The surfaces in the scene of a page's data."""
    head = json.loads(content[8 : 8 + int.from_bytes(content[4:8], "little")])
    return head["page"]["runs"][0]["scene"]["meshes"]


def kept(studio: Any, info: Any, path: Path) -> tuple[Any, list[StoredMesh]]:
    """What is reported of a run, and the surfaces that its result keeps."""
    result, content = simulated(studio, info, "data")
    path.write_bytes(content)
    return result, kept_meshes(Result.load(path).data)


LAYOUTS = {
    "side by side": ("two.urdf", "arm.stl", "arm.stl"),
    "chosen together": ("two.urdf", "meshes/visual/arm.stl", "arm.stl"),
    "next to its folder": ("two.urdf", "../meshes/arm.stl", "arm.stl"),
    "of a package": ("two.urdf", "package://two_description/meshes/arm.stl", "arm.stl"),
    "other case": ("two.urdf", "meshes/Arm.STL", "arm.stl"),
    "a folder": ("mine/urdf/two.urdf", "../meshes/arm.stl", "mine/meshes/arm.stl"),
    "a package": ("two_description/urdf/two.urdf", "package://two_description/m/arm.stl", "two_description/m/arm.stl"),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_meshes_of_an_upload_are_found(studio, layout, tmp_path):
    """Wherever the files lay when they were chosen: the result holds the mesh that was sent."""
    main, named, lies = LAYOUTS[layout]
    sheet = str(Path(main).with_suffix(".yaml"))
    files = {lies: stl(0.25), main: URDF.format(mesh=named), sheet: ELASTICITY.format(urdf="two.urdf")}
    info = sent(studio, files)
    assert info["looks"].startswith("upload:")
    result, [mesh] = kept(studio, info, tmp_path / "result.nc")
    assert result["unseen"] == []
    assert (mesh.link, len(mesh.faces)) == ("arm", 12)
    assert np.ptp(mesh.vertices, axis=0) == pytest.approx(np.full(3, 0.25))


def test_scene_and_exported_report_show_them(studio):
    info = sent(studio, {"arm.stl": stl(0.25), "two.urdf": URDF.format(mesh="arm.stl"),
                         "two.yaml": ELASTICITY.format(urdf="two.urdf")})  # fmt: skip
    assert len(meshes(simulated(studio, info)[1])) == 1
    report = simulated(studio, info, "report")[1].decode()
    packed = re.search(r'id="tmodes-data"[^>]*>([^<]*)<', report)
    assert packed
    assert len(meshes(gzip.decompress(base64.b64decode(packed[1])))) == 1


def test_a_missing_mesh_is_a_warning_at_its_link(studio):
    """The run is made; what is missing is reported with file, line, link and hint, and nothing of this machine."""
    info = sent(
        studio, {"two.urdf": URDF.format(mesh="meshes/arm.stl"), "two.yaml": ELASTICITY.format(urdf="two.urdf")}
    )
    result, content = simulated(studio, info)
    assert meshes(content) == []
    [unseen] = result["unseen"]
    assert unseen["where"] == "two.urdf:6"
    assert (unseen["path"], unseen["steps"]) == ("links.arm", ["links", 0])
    assert "not there" in unseen["got"]
    assert "choose that file too" in unseen["hint"]
    assert "tmodes-upload" not in str(unseen)


@pytest.mark.parametrize("content", [b"", b"solid x", bytes(80) + b"\xff" * 4 + bytes(50), b"<COLLADA/>" * 9])
def test_a_broken_mesh_is_a_warning_too(studio, content):
    info = sent(studio, {"arm.stl": content, "two.urdf": URDF.format(mesh="arm.stl"),
                         "two.yaml": ELASTICITY.format(urdf="two.urdf")})  # fmt: skip
    result, _ = simulated(studio, info)
    assert result["unseen"][0]["path"] == "links.arm"
    assert result["unseen"][0]["where"] == "arm.stl"
    assert "tmodes-upload" not in str(result["unseen"])


@pytest.mark.parametrize("mesh", ["../../arm.stl", "/etc/arm.stl", "package://x/../../arm.stl"])
def test_nothing_is_put_outside_of_the_upload(studio, mesh):
    """A file of that name was sent, and still is not laid where it may not lie."""
    info = sent(studio, {"arm.stl": stl(1.0), "two.urdf": URDF.format(mesh=mesh)})
    (notice,) = (text for text in info["sheet"]["notices"] if "may not be read" in text)
    assert "--root" not in notice
    assert meshes(simulated(studio, info)[1]) == []


def test_a_robot_of_the_working_folder_with_its_meshes(studio):
    (studio.folder / "own.urdf").write_text(URDF.format(mesh="own.stl"), encoding="utf-8")
    (studio.folder / "own.stl").write_bytes(stl(0.5))
    (studio.folder / "own.yaml").write_text(ELASTICITY.format(urdf="own.urdf"), encoding="utf-8")
    info = studio.get("/api/studies/own.yaml")
    assert len(meshes(simulated(studio, info)[1])) == 1
    (studio.folder / "own.stl").unlink()
    (studio.folder / "own.stl").symlink_to("/etc/passwd")
    (studio.folder / "own.urdf").touch()
    other = studio.get("/api/studies/own.yaml")
    assert any("outside" in text for text in other["sheet"]["notices"])


def test_a_study_saved_of_an_upload_keeps_its_looks_while_the_studio_runs(studio):
    info = sent(studio, {"arm.stl": stl(0.25), "two.urdf": URDF.format(mesh="arm.stl"),
                         "two.yaml": ELASTICITY.format(urdf="two.urdf")})  # fmt: skip
    studio.put("/api/studies/of upload.yaml", json={"sheet": info["sheet"], "looks": info["looks"], "overwrite": True})
    again = studio.get("/api/studies/of upload.yaml")
    assert again["sheet"] == info["sheet"]
    assert len(meshes(simulated(studio, again)[1])) == 1
    studio.put("/api/studies/of upload.yaml", json={"sheet": info["sheet"], "overwrite": True})
    assert studio.get("/api/studies/of upload.yaml")["looks"] == "study:of upload.yaml"


def test_an_upload_that_is_kept_no_more_says_so(studio):
    info = sent(studio, {"two.urdf": URDF.format(mesh="arm.stl"), "two.yaml": ELASTICITY.format(urdf="two.urdf")})
    result, _ = simulated(studio, info | {"looks": "upload:guessed"})
    assert "not kept any more" in result["unseen"][0]["message"]
    for odd in (None, 3, {}, "robot:nobody", "study:../x.yaml", "study:none.yaml", "file:/etc/passwd"):
        result, content = simulated(studio, info | {"looks": odd})
        assert (result["unseen"], meshes(content)) == ([], [])


def test_only_the_newest_uploads_are_kept(tmp_path):
    shelf = Shelf(tmp_path)
    rooms = [shelf.room() for _ in range(MOST_KEPT + 2)]
    names = [shelf.keep(room, room / "x.urdf", (room,)) for room in rooms]
    assert [room.exists() for room in rooms] == [False] * 2 + [True] * MOST_KEPT
    assert shelf.found(names[0].partition(":")[2]) is None
    assert rooms[-1].stat().st_mode & 0o077 == 0


def test_a_study_that_is_a_link_has_no_looks(tmp_path):
    (tmp_path / "a.yaml").symlink_to(tmp_path / "b.yaml")
    assert source_of("study:a.yaml", WorkingFolder(tmp_path), Shelf(tmp_path)) is None


SHEET = b"urdf: two.urdf\n"


@pytest.mark.parametrize(
    ("contents", "main"),
    [
        ({"a/limits.yaml": b"limits: 1", "a/urdf/two.urdf": b"", "a/package.xml": b""}, "a/urdf/two.urdf"),
        ({"a/two.yaml": SHEET, "a/limits.yaml": b"x: 1", "a/two.urdf": b""}, "a/two.yaml"),
        ({"a/macro.xacro": b"", "a/two.urdf.xacro": b"", "a/more.xacro": b""}, "a/two.urdf.xacro"),
        ({"deep/er/x.urdf": b"", "deep/y.urdf": b""}, "deep/y.urdf"),
        ({"wrong.yaml": b"nothing: here"}, "wrong.yaml"),
        ({"scene.xml": b"", "arm.stl": b""}, "scene.xml"),
    ],
)
def test_the_robots_own_file_among_many(contents, main):
    assert main_file(contents) == main


def test_several_robots_ask_which():
    with pytest.raises(InputError, match=re.escape("a.urdf, b.urdf")):
        main_file({"b.urdf": b"", "a.urdf": b"", "m.stl": b""})
    with pytest.raises(InputError, match=r"ending \.yaml"):
        main_file({"a.stl": b"", "package.xml": b""})
