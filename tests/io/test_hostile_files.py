"""Files that are no data sheets, or that were made to hurt: one error of ours, in bounded time and memory."""

from __future__ import annotations

import os
import tracemalloc
from pathlib import Path

import pytest

from io_cases import SHEET
from patience import bounded
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_from_data as robot_from_data
from tmodes.io.yaml_file import parse_yaml, read_yaml
from tmodes.robots.load import load

LIMIT = 256 * 1024
SECONDS = 4.0


def filled(line: str, head: str = "", tail: str = "") -> str:
    """A file just below the limit of size."""
    return head + line * ((LIMIT - len((head + tail).encode())) // len(line.encode())) + tail


HOSTILE = {
    "long comment": filled("#"),
    "comments": filled("# x\n"),
    "long word": filled("x", "a: "),
    "words": filled(" x\n", "a:"),
    "folded": filled(" x\n\n", "a: >\n"),
    "literal": filled(" x\n", "a: |\n"),
    "quoted": filled("x\n", 'a: "', '"'),
    "escapes": filled("\\\n", 'a: "', '"'),
    "open quote": filled("x\n", 'a: "'),
    "blanks": filled(" "),
    "new lines": filled("\n"),
    "returns": filled("\r"),
    "brackets": filled("["),
    "brackets on lines": filled("[" * 9_000 + "\n"),
    "braces": filled("{"),
    "braces with keys": filled("{a: "),
    "deep indentation": "".join(" " * depth + "a:\n" for depth in range(700)),
    "dashes": filled("- "),
    "question marks": filled("? "),
    "exclamation marks": filled("!"),
    "exclamation marks on lines": filled("!" * 9_000 + "\n"),
    "ampersands": filled("&a "),
    "percents": filled("%A b\n"),
    "colons": filled(":"),
    "documents": filled("---\n"),
    "many keys": "".join(f"k{i}: 1\n" for i in range(20_000)),
    "2000 unknown keys": "".join(f"stiffnes{i}: 1\n" for i in range(2_000)),
    "long keys": "".join(f"{'k' * 500}{i}: 1\n" for i in range(500)),
    "many factors": "real:\n" + "".join(f"  gear.stif{i}: 1\n" for i in range(2_000)),
    "alias of nothing": "gravity: *g",
    "tag": "a: !!python/object/apply:os.system [echo]",
    "tagged number": "gravity: !!float 9.81",
    "directive": "%YAML 1.1\n---\ncontact: on",
    "two documents": f"{SHEET}\n---\n{SHEET}",
    "list": "- a\n- b",
    "word": "hello",
    "number": "3.0",
    "null": "~",
    "list as a key": "? [a]\n: b",
    "tab": "gear:\n\tstiffness: 1.0",
    "control character": "gear: \x01",
    "merge key": "<<: {gravity: 9.81}",
}


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_hostile_text_is_refused_in_time(text: str, tmp_path: Path) -> None:
    file = tmp_path / "hostile.yaml"
    file.write_text(text, encoding="utf-8", newline="")
    with bounded(SECONDS):
        with pytest.raises((InputError, InputErrors)) as caught:
            load(file)
        assert str(file) in str(caught.value)


JUNK = {
    "empty": b"",
    "blank": b" \n\n",
    "binary": bytes(range(256)) * 20,
    "zeros": bytes(5_000),
    "utf-16": SHEET.encode("utf-16"),
    "latin-1": "name: é".encode("latin-1"),
    "program": b"\x7fELF\x02\x01\x01" + bytes(100),
    "too large": b"#" * (LIMIT + 1),
}


@pytest.mark.parametrize("content", JUNK.values(), ids=JUNK)
def test_junk_is_refused(content: bytes, tmp_path: Path) -> None:
    file = tmp_path / "junk.yaml"
    file.write_bytes(content)
    with pytest.raises(InputError, match=r"junk\.yaml.*(must be|expected) "):
        load(file)


def test_a_byte_order_mark_is_no_harm(tmp_path: Path) -> None:
    file = tmp_path / "bom.yaml"
    file.write_bytes(b"\xef\xbb\xbf" + SHEET.encode())
    assert load(file) == load("filipovic2010")


def test_line_ends_of_windows_are_no_harm(tmp_path: Path) -> None:
    file = tmp_path / "windows.yaml"
    file.write_bytes(SHEET.replace("\n", "\r\n").encode())
    assert load(file) == load("filipovic2010")


def test_names_of_files_may_hold_spaces_and_letters_of_all_kinds(tmp_path: Path) -> None:
    file = tmp_path / "mein Röböter ☃.yaml"
    file.write_text(SHEET, encoding="utf-8")
    assert load(str(file)) == load("filipovic2010")


@pytest.mark.parametrize("cut", range(1, SHEET.index("ramp_fraction:"), 61))
def test_a_truncated_file_is_reported(cut: int) -> None:
    """Something is missing wherever the cut is."""
    with pytest.raises((InputError, InputErrors), match=r"^cut\.yaml:\d"):
        robot_from_data(*parse_yaml(SHEET[:cut], "cut.yaml"), source="cut.yaml")


@pytest.mark.parametrize("text", ["a: 1\nb: 2\na: 3", "a: {b: 1, b: 2}", "x:\n  - a: 1\n    a: 1"])
def test_a_key_that_stands_twice_is_reported_with_both_lines(text: str) -> None:
    with pytest.raises(InputError, match=r"sheet:\d: .*got a second one \(the first in line \d\)"):
        parse_yaml(text, "sheet")


def test_scalars_are_those_of_yaml_1_2() -> None:
    data, lines = parse_yaml(
        "a: 1e5\nb: on\nc: 010\nd: .inf\ne: 'x: 1'\nf: 1e400\ng: yes\nh: ~\ni: 2001-01-01\nj: -.5\nk:\n  - [1]", "sheet"
    )
    assert data == {
        "a": 1e5,
        "b": "on",
        "c": 10,
        "d": float("inf"),
        "e": "x: 1",
        "f": "1e400",
        "g": "yes",
        "h": None,
        "i": "2001-01-01",
        "j": -0.5,
        "k": [[1]],
    }
    assert lines["k.0.0"] == 12


def test_a_place_that_is_no_file_is_refused(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "absent.yaml", tmp_path / ("x" * 400), tmp_path / "\0"):
        with pytest.raises(InputError, match=r"must be|expected|unknown"):
            read_yaml(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_a_pipe_is_refused_and_does_not_block(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.yaml")
    with pytest.raises(InputError, match="a device, pipe or socket"):
        load(tmp_path / "pipe.yaml")


def test_a_gigabyte_costs_neither_time_nor_memory(tmp_path: Path) -> None:
    file = tmp_path / "large.yaml"
    with file.open("wb") as handle:
        handle.truncate(2**30)
    tracemalloc.start()
    with bounded(SECONDS):
        with pytest.raises(InputError, match="1,073,741,824 bytes"):
            load(file)
        assert tracemalloc.get_traced_memory()[1] < 20e6
        tracemalloc.stop()


def test_an_arm_of_five_hundred_joints_is_read_in_time() -> None:
    """The largest arm, written out in full: 33,500 keys, values and brackets."""
    joint = ("  - {{name: j{0}, type: revolute, child: l{0}, origin: {{position: [0.1, 0.2, 0.3], rpy: [0, 0, 0]}}, "
             "axis: [0, 0, 1], limits: {{lower: -1, upper: 1}}, friction: {{viscous: 0.1}}}}\n")  # fmt: skip
    link = "  - {{name: l{0}, bodies: [{{mass: 1.0, center: [0, 0, 0.1], inertia: {{xx: 0.1, yy: 0.1, zz: 0.1}}}}]}}\n"
    parts = [part for one, key in ((joint, "joints"), (link, "links"))
             for part in (f"{key}:\n", *(one.format(i) for i in range(500)))]  # fmt: skip
    with bounded(SECONDS):
        data, _ = parse_yaml("kind: arm\n" + "".join(parts), "large.yaml")
    assert len(data["joints"]) == len(data["links"]) == 500


HEAD = "kind: arm\nformat: 1\nname: x\njoints: [{name: a, type: revolute, child: l, axis: [0, 0, 1]}]\n"
HOSTILE_ARMS = {
    "unknown keys": HEAD + "".join(f"stif{i}: 1\n" for i in range(19_000)),
    "empty bodies": HEAD + "links: [{name: l, bodies: [" + "{m: 1},\n" * 9_000 + "]}]\n",
    "wrong units": HEAD + "initial: {coordinates: {" + "".join(f"a{i}: 1 mm,\n" for i in range(12_000)) + "}}\n",
    "many factors": HEAD + "real:\n" + "".join(f"  joints.a.gr{i}: 1\n" for i in range(12_000)),
}


@pytest.mark.parametrize("text", HOSTILE_ARMS.values(), ids=HOSTILE_ARMS)
def test_hostile_arms_are_refused_in_time(text: str, tmp_path: Path) -> None:
    file = tmp_path / "hostile.yaml"
    file.write_text(text, encoding="utf-8")
    with bounded(SECONDS):
        with pytest.raises((InputError, InputErrors)) as caught:
            load(file)
        assert str(file) in str(caught.value)


def test_a_sheet_without_a_kind_keeps_the_smaller_bound() -> None:
    with pytest.raises(InputError, match="more than 5000 items"):
        parse_yaml("".join(f"k{i}: 1\n" for i in range(3_000)), "robot.yaml")
