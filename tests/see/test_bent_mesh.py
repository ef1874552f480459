"""The surface of a link that bends: laid about its line, in the page, from a URDF and an STL of the test's own."""

from __future__ import annotations

import io
import json
import shutil
import struct
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from patience import LONG
from see.looking import look
from tmodes import load, run
from tmodes.io.mesh_file import box
from tmodes.report import write_report
from tmodes.report.meshes import read_shapes, with_shapes
from tmodes.report.scene import scene_of
from tmodes.result import Result

WEB = Path(__file__).resolve().parents[2] / "web"
URDF = """<robot name="rod"><link name="base"/>
<link name="arm"><inertial><origin xyz="0 0 0.5"/><mass value="1"/>
<inertia ixx="0.08" iyy="0.08" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
<visual><geometry><mesh filename="arm.stl"/></geometry></visual></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="10" velocity="9"/></joint></robot>"""
ELASTICITY = """urdf: rod.urdf
name: rod
links:
  arm: {beam: {model: strain, functions: 3, damping_time: 0.001, section: {bending_stiffness: 2.0}, to: [0, 0, 1.0]}}
drives:
  - {joint: hinge, command: prescribed, signal: {type: quintic, start: 0.0, end: 1.0, duration: 0.4}}
gravity: [0, 0, 0]
tip: {link: arm}
integration: {duration: 0.4, output_step: 0.02}
"""


def stl() -> bytes:
    """A bar of 1 m along z from the origin: twelve triangles, of which none could bend by itself."""
    surface = box([0.06, 0.06, 1.0])
    corners = (surface.vertices + np.array([0, 0, 0.5]))[surface.faces].astype("<f4")
    records = b"".join(bytes(12) + one.tobytes() + bytes(2) for one in corners)
    return bytes(80) + struct.pack("<I", len(corners)) + records


@pytest.fixture(scope="module")
def bent(tmp_path_factory: pytest.TempPathFactory) -> Result:
    folder = tmp_path_factory.mktemp("rod")
    (folder / "arm.stl").write_bytes(stl())
    (folder / "rod.urdf").write_text(URDF, encoding="utf-8")
    (folder / "rod.yaml").write_text(ELASTICITY, encoding="utf-8")
    shapes, unseen = read_shapes(folder / "rod.urdf")
    assert unseen == []
    return with_shapes(run(load(folder / "rod.yaml")), shapes)


def test_the_surface_lies_along_the_beam_in_the_frame_of_its_root(bent: Result) -> None:
    [mesh] = scene_of(bent)["meshes"]
    assert mesh["along"] == [0]
    low, high = mesh["vertices"].min(axis=0), mesh["vertices"].max(axis=0)
    assert low == pytest.approx([0, -0.03, -0.03], abs=1e-6)
    assert high == pytest.approx([1, 0.03, 0.03], abs=1e-6)


@pytest.mark.nightly
def test_the_surface_bends_with_the_line(browser: Any, bent: Result, tmp_path: Path) -> None:
    """The bar is seen as an arc at the moment of the largest deflection, and as a straight bar at the start."""
    window = look(browser, write_report(bent, tmp_path / "bent.html"), (1280, 800))
    window.page.wait_for_selector(".scene canvas")
    assert bow(window) > 0.06
    window.page.locator(".scrub").fill("0")
    assert bow(window) < 0.03
    assert window.said == []
    window.page.context.close()


def bow(window: Any) -> float:
    """How far the middle of what is seen of the bar is from its ends' chord, over its height in pixels."""
    window.page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))")
    shot = window.page.locator(".scene canvas[tabindex]").screenshot()
    picture = np.asarray(Image.open(io.BytesIO(shot)).convert("RGB")).astype(int)
    seen = np.ptp(picture, axis=-1) > 40
    seen[: len(seen) // 3] = False  # the legend, and the path of the tip
    seen[:, : seen.shape[1] // 5] = False  # the axes
    rows = np.flatnonzero(seen.any(axis=1))
    middles = np.array([np.flatnonzero(seen[row]).mean() for row in rows])[4:-4]
    chord = np.linspace(middles[:5].mean(), middles[-5:].mean(), len(middles))
    return float(np.abs(middles - chord).max() / len(middles))


BUILD = """
import { build } from "esbuild";
const { outputFiles } = await build({ entryPoints: [process.argv.at(-1)], write: false, bundle: true, format: "esm" });
const program = Buffer.from(outputFiles[0].text).toString("base64");
const { Bent, distances } = await import(`data:text/javascript;base64,${program}`);
const { line, roots, stations, links, vertices, faces } = JSON.parse(await new Promise((done) => {
  let text = "";
  process.stdin.on("data", (part) => { text += part; }).on("end", () => done(text));
}));
const lines = Float32Array.from(line);
const surface = { vertices: Float32Array.from(vertices), faces: Uint32Array.from(faces) };
const along = (k) => (Math.floor(k / stations) + (k % stations) / (stations - 1)) / links.length;
const straight = lines.map((_, k) => (k % 3 ? 0 : along(k / 3)));
const bent = new Bent(surface, links, stations, distances(straight, stations, links), 0.6);
const rest = Array.from(bent.geometry.attributes.position.array);
bent.shape(lines, Float32Array.from(roots));
const { position, normal } = bent.geometry.attributes;
console.log(JSON.stringify([rest, Array.from(position.array), Array.from(normal.array)]));
"""
"""Lays a surface about lines of 1 m in all, as the page does."""


@pytest.mark.parametrize("count", [1, 2])
def test_each_vertex_keeps_its_place_in_its_section(count: int) -> None:
    """On a quarter of a circle, of one link or of the two elements of one: to the accuracy of its chords."""
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules" / "esbuild").is_dir():
        pytest.skip("needs Node and the packages of web/ (npm ci)")
    stations, radius = 41, 2 / np.pi
    angles = np.concatenate([np.linspace(k, k + 1, stations) / count for k in range(count)]) * np.pi / 2
    line = radius * np.column_stack([np.sin(angles), 1 - np.cos(angles), 0 * angles])
    starts = angles[::stations] / 2
    roots = np.column_stack([0 * starts, 0 * starts, np.sin(starts), np.cos(starts)])
    bar = box([1.0, 0.06, 0.04])
    given = {
        "line": line.ravel().tolist(), "roots": roots.ravel().tolist(), "stations": stations, "links": [*range(count)],
        "vertices": (bar.vertices + np.array([0.5, 0, 0])).ravel().tolist(), "faces": bar.faces.ravel().tolist(),
    }  # fmt: skip
    command = [node, "--input-type=module", "-e", BUILD, "--", str(WEB / "src" / "scene" / "bent.ts")]
    made = subprocess.run(
        command, cwd=WEB, input=json.dumps(given), check=True, timeout=LONG, capture_output=True, text=True
    )
    rest, place, normal = (np.reshape(part, (-1, 3)) for part in json.loads(made.stdout))
    assert len(rest) > 12 * 3 * 8  # triangles that could not bend are halved
    turn = rest[:, 0] * np.pi / 2
    right = np.column_stack(
        [(radius - rest[:, 1]) * np.sin(turn), radius - (radius - rest[:, 1]) * np.cos(turn), rest[:, 2]]
    )
    assert np.abs(place - right).max() < 2e-3
    assert np.linalg.norm(normal, axis=1) == pytest.approx(1.0, abs=0.01)
