"""Whatever is done to the text of a robot's files, nothing but errors of tmodes comes out, soon and in little memory.

300 cases of each kind; TMODES_FUZZ=10000 in the environment asks for as many.
"""

from __future__ import annotations

import os
import random
import tracemalloc
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path

import pytest

from patience import bounded
from tmodes.errors import TmodesError
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_files import read_sheet

from .test_bad_urdf import GOOD
from .test_dh_table import ROWS
from .test_elasticity import BOTH, URDF
from .test_xacro import MACROS

CASES = int(os.environ.get("TMODES_FUZZ", "300"))
LONGEST = 5.0
"""Longest time of one case [s]; one takes about a millisecond."""

PIECES = ["<", ">", "/>", '"', "'", "&", "&lt;", "&#0;", "&#x110000;", "<!--", "-->", "<![CDATA[", "]]>", "<?x ?>", "="]
PIECES += [
    "<!DOCTYPE r [",
    "xmlns:",
    " ",
    "\n",
    "\t",
    "\0",
    "\ufeff",
    "\u00e9",
    "\U0001f916",
    "\u2028",
    "0",
    "-",
    "-1",
    "nan",
]
PIECES += [
    "inf",
    "1e400",
    "1e-400",
    "1,5",
    "9" * 400,
    "1_0",
    "0x1F",
    "e",
    ".",
    "true",
    "mm",
    "${",
    "}",
    "${1/0}",
    "$(find x)",
]
PIECES += [
    "[",
    "]",
    "{",
    "}",
    ": ",
    "- ",
    ",",
    "&a ",
    "*a",
    "!",
    "|",
    "%",
    "---\n",
    "~",
    ".inf",
    ".nan",
    "12 mm",
    "../" * 5,
]

JOINTS = """name: bent
joints:
  pan:
    motor: {inertia: 0.2, side: motor, ratio: 100, friction: {viscous: 0.1}}
    gear: {stiffness: [5e3, 9e3], torque_limits: [10], damping: 1.0}
  lift: {state: locked, locked_at: 0.2, friction: {viscous: 0.3, coulomb: 0.1}, limits: {lower: -2, upper: 2}}
gravity: [0, 0, -9.81]
tip: {link: hand, position: [0, 0, 0.1]}
loads: [{point: tip, force: [0, 0, -10], frame: world}]
"""
TABLE = "format: 1\nkind: dh\nname: t\nconvention: standard\nrows:\n" + "".join(
    f"  - {{a: {a}, alpha: {alpha}, d: {d}, theta: {theta}, bodies: [{{mass: 1.0, center: [0.1, 0, 0]}}]}}\n"
    for a, alpha, d, theta in ROWS
)
TEXTS = {
    "two.urdf": GOOD,
    "bent.urdf": URDF,
    "bent.yaml": f"urdf: bent.urdf\n{JOINTS}{BOTH}",
    "table.yaml": TABLE,
    "bar.xacro": MACROS.replace(
        "</robot>",
        '<link name="ground"/><xacro:arg name="damping" default="1"/>'
        '<xacro:bar name="a"><origin/><n/></xacro:bar></robot>',
    ),
}


def mutated(text: str, dice: random.Random) -> str:
    """The text with some places cut, doubled, moved, or filled with junk; or with a few other digits."""
    if dice.random() < 0.3:
        return "".join(dice.choice("0123456789") if c.isdigit() and dice.random() < 0.1 else c for c in text)
    for _ in range(dice.choice([1, 1, 2, 3, 8])):
        start = dice.randrange(len(text) + 1)
        end = min(len(text), start + dice.choice([0, 1, 1, 5, 40, 200]))
        elsewhere = dice.randrange(len(text) + 1)
        piece = dice.choice([*PIECES, "", "", text[elsewhere : elsewhere + 60], text[start:end] * 2])
        text = text[:start] + piece + text[end:]
    return text


@pytest.mark.parametrize("name", TEXTS)
def test_mutated_files(name: str, tmp_path: Path) -> None:
    (tmp_path / "bent.urdf").write_text(URDF)
    dice = random.Random(name)  # noqa: S311  # a reproducible choice, not a secret
    path, refused = tmp_path / name, 0
    sheet_from_data(*_written(path, TEXTS[name]))
    for case in range(CASES):
        text = mutated(TEXTS[name], dice)
        with little_memory() if case % 10 == 0 else nullcontext(), bounded(LONGEST):
            said = problem(path, text)
            info = f"case {case}: {said}\n{text}"
            assert said == "" or str(path) in said or "bent.urdf" in said, info
        refused += bool(said)
    assert CASES / 4 < refused < CASES


@contextmanager
def little_memory() -> Iterator[None]:
    """What is done in the block takes at most 200 MB; it is slow, so one case in ten is looked at."""
    tracemalloc.start()
    yield
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 200e6


def problem(path: Path, text: str) -> str:
    """What tmodes has to say against a file; empty for an arm. Errors of other families come through."""
    try:
        sheet_from_data(*_written(path, text)).chain()
    except TmodesError as error:
        return str(error)
    return ""


def _written(path: Path, text: str) -> tuple[dict, dict, str]:
    path.write_text(text, encoding="utf-8", errors="surrogatepass", newline="")
    return read_sheet(path)
