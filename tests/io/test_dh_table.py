"""Denavit-Hartenberg tables against the textbooks' matrices, multiplied out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy import cos, sin

from io_frames import chain_frames
from tmodes.errors import InputErrors
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_files import read_sheet

ROWS = [(0.1, 0.5, 0.3, 0.2), (0.4, -1.2, -0.1, 0.9), (0.0, 0.7, 0.2, -0.4)]
BODY = "{mass: 1.0, center: [0.1, 0, 0.05], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}"
ANGLES = [0.3, -0.8, 1.9]


def standard(a: float, alpha: float, d: float, theta: float) -> np.ndarray:
    """Spong, Robot Modeling and Control, Eq. (3.10)."""
    return np.array(
        [
            [cos(theta), -sin(theta) * cos(alpha), sin(theta) * sin(alpha), a * cos(theta)],
            [sin(theta), cos(theta) * cos(alpha), -cos(theta) * sin(alpha), a * sin(theta)],
            [0, sin(alpha), cos(alpha), d],
            [0, 0, 0, 1],
        ]
    )


def modified(a: float, alpha: float, d: float, theta: float) -> np.ndarray:
    """Craig, Introduction to Robotics, Eq. (3.6)."""
    return np.array(
        [
            [cos(theta), -sin(theta), 0, a],
            [sin(theta) * cos(alpha), cos(theta) * cos(alpha), -sin(alpha), -sin(alpha) * d],
            [sin(theta) * sin(alpha), cos(theta) * sin(alpha), cos(alpha), cos(alpha) * d],
            [0, 0, 0, 1],
        ]
    )


def table(folder: Path, convention: str, more: str = "") -> Path:
    rows = "".join(
        f"  - {{a: {a}, alpha: {alpha}, d: {d}, theta: {theta}, bodies: [{BODY}]}}\n" for a, alpha, d, theta in ROWS
    )
    path = folder / "table.yaml"
    path.write_text(f"format: 1\nkind: dh\nname: three\nconvention: {convention}\n{more}rows:\n{rows}")
    return path


@pytest.mark.parametrize(("convention", "row"), [("standard", standard), ("modified", modified)])
def test_frames_are_the_textbooks(convention: str, row, tmp_path: Path) -> None:
    """The last body's center, which rides in the last frame of the table."""
    data, positions, source = read_sheet(table(tmp_path, convention))
    arm: Any = sheet_from_data(data, positions, source)
    expected = np.eye(4)
    for (a, alpha, d, theta), angle in zip(ROWS, ANGLES, strict=True):
        expected = expected @ row(a, alpha, d, theta + angle)
    angles = {f"joint_{i}": angle for i, angle in enumerate(ANGLES, start=1)}
    frame, body = chain_frames(data, angles)["joint_3"], arm.chain().nodes[-1].link.bodies[0]
    np.testing.assert_allclose(frame @ [*body.center, 1], expected @ [0.1, 0, 0.05, 1], atol=1e-14)
    assert positions["joints.1.dh.alpha"] == 7


def test_a_row_holds_what_a_joint_and_a_link_hold(tmp_path: Path) -> None:
    path = tmp_path / "table.yaml"
    path.write_text(
        "format: 1\nkind: dh\nname: one\nconvention: modified\ngravity: 1.62\nrows:\n"
        "  - {a: 0, alpha: 90 deg, d: 300 mm, theta: 0, type: prismatic, name: slide, link: rod,\n"
        "     limits: {upper: 1}, bodies: [{mass: 2}]}\n"
    )
    arm: Any = sheet_from_data(*read_sheet(path))
    assert (arm.joints[0].name, arm.joints[0].child, arm.joints[0].type) == ("slide", "rod", "prismatic")
    assert arm.joints[0].dh.alpha == pytest.approx(np.pi / 2)
    assert (arm.joints[0].dh.d, arm.joints[0].limits.upper, arm.gravity) == (0.3, 1.0, (0.0, 0.0, -1.62))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("convention: craig\nrows: [{a: 0, alpha: 0, d: 0, theta: 0}]\n", "table.yaml:2: convention must be"),
        ("convention: standard\n", "rows is missing"),
        ("convention: standard\nrows: []\n", "rows must be"),
        ("convention: standard\nrows:\n  - {a: 0, alpha: 0, d: 0}\n", "table.yaml:4: rows.0.theta is missing"),
        ("convention: standard\nrows:\n  - 5\n", "rows.0 must be a group with a, alpha, d, theta, got 5"),
        ("convention: standard\nrows:\n  - {a: 0, alpha: 0, d: 0, theta: 0, alhpa: 1}\n", "Did you mean `alpha`?"),
        ("convention: standard\njoints: []\nrows: [{a: 0, alpha: 0, d: 0, theta: 0}]\n", "joints next to `rows`"),
    ],
)
def test_tables_that_are_none(text: str, words: str, tmp_path: Path) -> None:
    path = tmp_path / "table.yaml"
    path.write_text(f"kind: dh\n{text}")
    with pytest.raises(InputErrors) as caught:
        read_sheet(path)
    assert words in str(caught.value)


def test_a_wrong_number_is_reported_with_its_line(tmp_path: Path) -> None:
    path = table(tmp_path, "standard")
    path.write_text(path.read_text().replace("alpha: -1.2", "alpha: steep"))
    with pytest.raises(InputErrors, match=r"table\.yaml:7: .*alpha.*'steep'"):
        sheet_from_data(*read_sheet(path))
