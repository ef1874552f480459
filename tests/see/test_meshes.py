"""Meshes: read only where they are whole, placed as the URDF says, kept in the result, shown on the right link."""

from __future__ import annotations

import re
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from see.scenes import arm_result
from see.test_scene import plain
from tmodes.errors import InputError
from tmodes.io.mesh_file import Triangles, box, cylinder, read_mesh, sphere
from tmodes.io.urdf_shapes import MOST_SHAPES, LinkShape
from tmodes.report.data import modes_of
from tmodes.report.folder import RunFolder
from tmodes.report.meshes import MOST_TRIANGLES, kept_meshes, read_shapes, thinned, with_shapes
from tmodes.report.scene import scene_of
from tmodes.result import Result


def area(surface: Triangles) -> float:
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def volume(surface: Triangles) -> float:
    """By the divergence theorem: positive where all faces look outwards."""
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    return float(np.einsum("fk,fk->", a, np.cross(b, c)) / 6)


def binary(surface: Triangles, count: int | None = None) -> bytes:
    faces = surface.vertices[surface.faces].astype("<f4")
    info = len(faces) if count is None else count
    return bytes(80) + struct.pack("<I", info) + b"".join(bytes(12) + face.tobytes() + bytes(2) for face in faces)


def ascii_stl(surface: Triangles) -> bytes:
    lines = ["solid it"]
    for face in surface.vertices[surface.faces]:
        lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x!r} {y!r} {z!r}" for x, y, z in face.tolist())]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid"]).encode()


def obj(surface: Triangles) -> bytes:
    lines = ["# a mesh", *("v {} {} {}".format(*vertex) for vertex in surface.vertices.tolist())]
    return "\n".join([*lines, *(f"f {a + 1}/1/1 {b + 1}// {c + 1}" for a, b, c in surface.faces)]).encode()


@pytest.mark.parametrize("surface", [box([0.1, 0.2, 0.3]), cylinder(0.1, 0.5), sphere(0.2)])
@pytest.mark.parametrize(("ending", "write"), [(".stl", binary), (".STL", ascii_stl), (".obj", obj)])
def test_a_mesh_is_read_back_as_it_was_written(tmp_path: Path, surface: Triangles, ending: str, write: Any) -> None:
    path = tmp_path / f"mesh{ending}"
    path.write_bytes(write(surface))
    found = read_mesh(path)
    assert area(found) == pytest.approx(area(surface), rel=1e-6)
    assert volume(found) == pytest.approx(volume(surface), rel=1e-6)
    assert len(found.vertices) <= len(surface.vertices)


def test_primitives_have_their_volumes_and_look_outwards() -> None:
    assert volume(box([0.1, 0.2, 0.3])) == pytest.approx(0.006)
    assert volume(cylinder(0.1, 0.5)) == pytest.approx(np.pi * 0.005, rel=0.01)
    assert volume(sphere(0.2)) == pytest.approx(4 / 3 * np.pi * 0.008, rel=0.02)


def test_faces_with_more_corners_and_counted_from_the_end(tmp_path: Path) -> None:
    path = tmp_path / "square.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n", encoding="utf-8")
    assert area(read_mesh(path)) == pytest.approx(1.0)


BROKEN = {
    "cut.stl": binary(box([1, 1, 1]))[:-30],
    "more.stl": binary(box([1, 1, 1]), 4_000_000_000),
    "empty.stl": b"",
    "none.stl": bytes(84),
    "text.stl": b"solid x\nvertex 1 2\nendsolid",
    "two.stl": b"solid x\nvertex 1 2 3\nvertex 1 2 3\nendsolid",
    "nan.stl": b"solid x\n" + 3 * b"vertex nan 0 0\n",
    "huge.obj": b"v 1e300 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3",
    "beyond.obj": b"v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 99999999999999999999",
    "fan.obj": b"v 0 0 0\nf 1 2" + b" 3" * 600_000,
    "index.obj": b"v 0 0 0\nf 1 2 3",
    "zero.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 5",
    "words.obj": b"v a b c\nf 1 1 1",
    "page.dae": b"<COLLADA/>",
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_mesh_is_reported_and_harms_nothing(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(BROKEN[name])
    with pytest.raises(InputError, match="must be a mesh as STL or OBJ"):
        read_mesh(path)


def test_thinning_keeps_the_shape_and_the_bound() -> None:
    fine = _sphere(120)
    few = thinned(fine, 2000)
    assert 500 < len(few.faces) <= 2000
    assert volume(few) == pytest.approx(volume(fine), rel=0.05)
    assert len(thinned(box([1, 2, 3]), 100).faces) == 12


def _sphere(count: int) -> Triangles:
    """A sphere of about 4 count^2 triangles."""
    up, around = np.meshgrid(np.linspace(0, np.pi, count), np.linspace(0, 2 * np.pi, 2 * count), indexing="ij")
    places = np.stack([np.sin(up) * np.cos(around), np.sin(up) * np.sin(around), np.cos(up)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(count - 1), np.arange(2 * count - 1), indexing="ij")
    a = (i * 2 * count + j).ravel()
    faces = [np.column_stack([a, a + 2 * count, a + 1]), np.column_stack([a + 1, a + 2 * count, a + 2 * count + 1])]
    return Triangles(places, np.concatenate(faces))


URDF = """<robot name="r"><material name="red"><color rgba="1 0 0 1"/></material>
<link name="base_link"><visual><geometry><box size="0.2 0.2 0.1"/></geometry><material name="red"/></visual></link>
<link name="arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
<visual><origin xyz="0.5 0 0" rpy="0 1.5707963267948966 0"/><geometry><cylinder radius="0.05" length="1"/></geometry>
</visual><visual><origin xyz="1 0 0"/><geometry><mesh filename="{file}" scale="0.001 0.001 0.001"/></geometry></visual>
</link><joint name="j" type="revolute"><parent link="base_link"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""


def test_shapes_are_placed_as_the_urdf_says(tmp_path: Path) -> None:
    (tmp_path / "ball.stl").write_bytes(binary(sphere(100.0)))
    (tmp_path / "r.urdf").write_text(URDF.format(file="ball.stl"), encoding="utf-8")
    shapes, notices = read_shapes(tmp_path / "r.urdf")
    assert notices == []
    assert [(shape.link, shape.colour) for shape in shapes] == [
        ("base_link", "#ff0000"), ("arm", "#b4bec8"), ("arm", "#b4bec8")]  # fmt: skip
    rod, ball = shapes[1].surface.vertices, shapes[2].surface.vertices
    assert np.allclose([rod.min(axis=0), rod.max(axis=0)], [[0, -0.05, -0.05], [1, 0.05, 0.05]])
    assert np.allclose([ball.min(axis=0), ball.max(axis=0)], [[0.9, -0.1, -0.1], [1.1, 0.1, 0.1]])


@pytest.mark.parametrize(
    "file", ["missing.stl", "../outside.stl", "/etc/passwd", "http://x/y.stl", "bad.stl", "package://a/../../x.stl"]
)
def test_a_mesh_that_may_not_be_read_costs_no_run(tmp_path: Path, file: str) -> None:
    (tmp_path / "outside.stl").write_bytes(binary(box([1, 1, 1])))
    home = tmp_path / "home"
    home.mkdir()
    (home / "bad.stl").write_bytes(b"nothing")
    (home / "r.urdf").write_text(URDF.format(file=file), encoding="utf-8")
    shapes, notices = read_shapes(home / "r.urdf")
    assert all(shape.link == "base_link" or len(shape.surface.faces) > 12 for shape in shapes)
    assert len(shapes) < 3
    assert len(notices) == 1
    assert "not shown" in notices[0]


def shapes_of(tmp_path: Path, *geometries: str) -> tuple[list[LinkShape], list[str]]:
    visuals = "".join(f"<visual><geometry>{one}</geometry></visual>" for one in geometries)
    arm = re.search(r'<link name="arm">.*?</inertial>', URDF, re.DOTALL)
    joint = re.search(r"<joint.*</joint>", URDF, re.DOTALL)
    assert arm
    assert joint
    text = f'<robot name="r"><link name="base_link">{visuals}</link>{arm[0]}</link>{joint[0]}</robot>'
    (tmp_path / "r.urdf").write_text(text, encoding="utf-8")
    return read_shapes(tmp_path / "r.urdf")


def test_a_mesh_of_many_shapes_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where it is damaged; each of its shapes is reported."""
    (tmp_path / "good.stl").write_bytes(binary(box([1.0, 2.0, 3.0])))
    (tmp_path / "bad.obj").write_text("v 0 0 0\nf 1 2 9\n", encoding="utf-8")
    read = []
    monkeypatch.setattr("tmodes.io.urdf_shapes.read_mesh", lambda path: read.append(path.name) or read_mesh(path))
    good, bad = '<mesh filename="good.stl" scale="1 1 -2"/>', '<mesh filename="bad.obj"/>'
    shapes, notices = shapes_of(tmp_path, *[good, bad] * 20)
    assert sorted(read) == ["bad.obj", "good.stl"]
    assert [len(shapes), len(notices)] == [20, 20]
    assert np.ptp(shapes[-1].surface.vertices, axis=0) == pytest.approx([1.0, 2.0, 6.0])


@pytest.mark.parametrize("geometry", ['<box size="1 1 1"/>', '<mesh filename="none.stl"/>'])
def test_more_shapes_than_may_be_are_reported(tmp_path: Path, geometry: str) -> None:
    shapes, notices = shapes_of(tmp_path, *[geometry] * (MOST_SHAPES + 50))
    assert len(shapes) + len(notices) == MOST_SHAPES + 1
    assert f"at most {MOST_SHAPES} shapes" in notices[-1]
    assert f"at most {MOST_SHAPES}" not in "".join(shapes_of(tmp_path, *[geometry] * MOST_SHAPES)[1])


@pytest.mark.parametrize(("geometry", "info"), [
    ('<mesh filename="good.stl" scale="0 0 0"/>', "without area"), ('<box size="-1 0 1"/>', "negative"),
    ('<box size="0 0 1"/>', "without area"), ('<sphere radius="0"/>', "without area"),
    ('<sphere radius="-1"/>', "negative"), ('<cylinder radius="1" length="-1"/>', "negative"),
])  # fmt: skip
def test_what_has_no_size_is_reported(tmp_path: Path, geometry: str, info: str) -> None:
    (tmp_path / "good.stl").write_bytes(binary(box([1.0, 2.0, 3.0])))
    shapes, [notice] = shapes_of(tmp_path, geometry)
    assert shapes == []
    assert info in notice
    [plate] = shapes_of(tmp_path, '<box size="1 1 0"/>')[0]  # which can be seen
    assert area(plate.surface) == pytest.approx(2.0)


def test_what_is_no_urdf_has_no_shapes() -> None:
    assert read_shapes("spong1987") == ([], [])


def shaped_result() -> Result:
    """The arm with a ball on its rigid hand, a bar on its rod and a plate below."""
    ball = Triangles(sphere(0.05).vertices + np.array([0.25, 0, 0]), sphere(0.05).faces)
    surfaces = {"hand": ball, "rod": box([0.8, 0.1, 0.1]), "base": box([0.4, 0.4, 0.1])}
    return with_shapes(arm_result(), [LinkShape(name, "#102030", shape) for name, shape in surfaces.items()])


def middle(mesh: dict[str, Any]) -> Any:
    return (mesh["vertices"].min(axis=0) + mesh["vertices"].max(axis=0)) / 2


def test_shapes_go_with_the_result_into_its_file_and_its_scene(tmp_path: Path) -> None:
    result = shaped_result()
    path = result.save(tmp_path / "result.nc")
    meshes = scene_of(Result.load(path))["meshes"]
    assert [(mesh["link"], mesh.get("along"), mesh["colour"]) for mesh in meshes] == [
        (1, None, "#102030"), (0, [0], "#102030"), (-1, None, "#102030")]  # fmt: skip
    assert middle(meshes[0]) == pytest.approx([0.25, 0, 0], abs=1e-6)
    assert middle(meshes[1]) == pytest.approx([0, 0, 0], abs=1e-6)
    assert middle(meshes[2]) == pytest.approx([0.1, 0.2, 0.3], abs=1e-6)
    assert "mesh_vertices" not in arm_result().data


def test_a_robot_of_too_many_triangles_is_simplified() -> None:
    result = with_shapes(
        arm_result(), [LinkShape("hand", "#102030", _sphere(100)), LinkShape("base", "#0", _sphere(60))]
    )
    kept = kept_meshes(result.data)
    assert sum(len(mesh.faces) for mesh in kept) <= MOST_TRIANGLES
    assert [len(mesh.vertices) > 100 for mesh in kept] == [True, True]


def test_a_link_without_length_is_there_for_its_mesh() -> None:
    data = arm_result().data
    hidden = data.isel(link=[0]).copy()
    hidden.attrs = data.attrs
    result = with_shapes(Result(hidden), [LinkShape("hand", "#102030", sphere(0.05))])
    scene = scene_of(result)
    whole = scene_of(arm_result())
    assert [(link["name"], link["parent"]) for link in scene["links"]] == [("rod", -1), ("hand", 0)]
    for part in ("line", "rigid", "reference"):
        assert np.abs(plain(scene[part])[:, 1, 0] - plain(whole[part])[:, 1, 0]).max() < 1e-5, part
    assert modes_of(result)[0]["rest"].shape == (2, 21, 3)


def test_a_run_keeps_how_its_links_look(tmp_path: Path) -> None:
    arm = arm_result().robot.with_({"integration.duration": 0.02})
    with RunFolder(tmp_path / "run", arm, shapes=[LinkShape("hand", "#102030", sphere(0.05))]) as folder:
        folder.simulate(lambda stage, share: None)
    assert [mesh.link for mesh in kept_meshes(Result.load(folder.result_file).data)] == ["hand"]
