"""Every sheet of the guide to arms loads as it stands there."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from tmodes.kinds.links.beam_data import BeamData
from tmodes.robots import installed_models
from tmodes.robots.load import load
from tmodes.sheet import Robot

GUIDE = (Path(__file__).resolve().parents[2] / "docs" / "arms.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```yaml\n(.*?)^```$", GUIDE, re.MULTILINE | re.DOTALL)
URDF = "robots/ur_description/urdf/ur5_robot.urdf"


def loaded(text: str, folder: Path) -> Robot:
    (folder / "sheet.yaml").write_text(text, encoding="utf-8")
    arm = load(folder / "sheet.yaml")
    assert isinstance(arm, Robot)
    return arm


def test_each_kind_of_sheet_is_there() -> None:
    assert [block.splitlines()[0].partition(":")[0] for block in BLOCKS] == ["format", "urdf", "format"]
    assert "kind: dh" in BLOCKS[2]


def test_a_table_of_denavit_and_hartenberg(tmp_path: Path) -> None:
    chain = loaded(BLOCKS[2], tmp_path).chain()
    assert chain.nodes[-1].name == "forearm"
    assert sum(body.mass for node in chain.nodes for body in node.link.all_bodies) == pytest.approx(2.0)


def test_sheet(tmp_path: Path) -> None:
    arm = loaded(BLOCKS[0], tmp_path)
    assert [node.name for node in arm.chain().nodes] == ["arm"]
    assert arm.pair().real.joints[0].gear.stiffness == (400.0,)  # type: ignore[union-attr]


@pytest.mark.skipif(not installed_models(), reason="example-robot-data is not installed")
def test_elasticity_over_a_urdf(tmp_path: Path) -> None:
    """The forearm is its tube: pi (R^2 - r^2) of 2700 kg/m^3, from the elbow to the wrist 0.39225 m on."""
    shutil.copy(installed_models()[0] / URDF, tmp_path)
    arm = loaded(BLOCKS[1], tmp_path)
    beam = arm.link("forearm_link").beam
    assert isinstance(beam, BeamData)
    assert beam.length == pytest.approx(0.39225)
    assert beam.section_pieces()[0].start.mass == pytest.approx(3.14159265 * (0.038**2 - 0.034**2) * 2700, rel=1e-6)
    assert arm.link("forearm_link").bodies == ()
