"""Hostile and broken XML: refused with file and line, in bounded time and memory."""

from __future__ import annotations

import tracemalloc

import pytest

from patience import bounded
from tmodes.errors import InputError
from tmodes.io.xml_file import MOST_BYTES, parse_xml, read_xml

BOMB = b"""<?xml version="1.0"?>
<!DOCTYPE lolz [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;">]>
<robot name="&c;"/>"""

EXTERNAL = b"""<?xml version="1.0"?>
<!DOCTYPE robot [<!ENTITY file SYSTEM "file:///etc/passwd">]>
<robot name="r">&file;</robot>"""


def said(content: bytes) -> str:
    with pytest.raises(InputError) as caught:
        parse_xml(content, "bad.urdf")
    return str(caught.value)


def test_elements_know_their_lines_and_children() -> None:
    root = parse_xml(
        b'<robot name="r">\n  <link name="a"/>\n  <!-- no -->\n  <xacro:if value="1"><b/></xacro:if></robot>', "f"
    )
    assert [(child.tag, child.line) for child in root.children] == [("link", 2), ("xacro:if", 4)]
    assert root.children[0].attributes == {"name": "a"}
    assert [element.tag for element in root.within()] == ["robot", "link", "xacro:if", "b"]
    assert root.children[1].place == "f:4"


@pytest.mark.parametrize("content", [BOMB, EXTERNAL], ids=["entity bomb", "external entity"])
def test_no_document_type(content: bytes) -> None:
    assert said(content).startswith("bad.urdf:2: the file must be plain elements, got a document type (<!DOCTYPE)")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "an empty file"),
        (b" \n ", "an empty file"),
        (
            b'<robot>\n<link name="a">\n',
            "bad.urdf:3: the file must be well-formed XML, got broken XML (no element found inside <link> of line 2)",
        ),
        (
            b'<robot>\n<link name="a',
            "bad.urdf:2: the file must be well-formed XML, got broken XML (unclosed token inside <robot> of line 1)",
        ),
        (
            b"<robot>\n</link>",
            "bad.urdf:2: the file must be well-formed XML, got broken XML (mismatched tag inside <robot> of line 1)",
        ),
        (b"<robot/><robot/>", "junk after document element"),
        (b'<robot name="a" name="b"/>', "duplicate attribute"),
        (b"<robot>&unknown;</robot>", "undefined entity"),
        (bytes(range(256)), "broken XML"),
        (b'<?xml version="1.0" encoding="klingon"?><robot/>', "bad.urdf"),
        (b"<a>" * 5_000, "must be at most 100, got 101 levels of elements"),
        (b"<r>" + b"<a/>" * 200_001 + b"</r>", "must be at most 200000, got 200001 elements"),
        (b'<r a="' + b"x" * 20_001 + b'"/>', "20001 characters in one attribute"),
        (b"<r " + b" ".join(b'a%d="1"' % i for i in range(101)) + b"/>", "101 attributes of one element"),
    ],
)
def test_broken_files_are_reported_with_their_line(content: bytes, words: str) -> None:
    assert words in said(content)


def test_a_byte_order_mark_and_other_encodings_are_read() -> None:
    assert parse_xml(b"\xef\xbb\xbf<robot/>", "f").tag == "robot"
    assert parse_xml(
        '<?xml version="1.0" encoding="utf-16"?><robot name="\u00e9"/>'.encode("utf-16"), "f"
    ).attributes == {"name": "\u00e9"}


def test_a_file_that_is_too_large_is_not_read(tmp_path) -> None:
    path = tmp_path / "big.urdf"
    path.write_bytes(b"<robot>" + b" " * MOST_BYTES)
    with pytest.raises(InputError, match=f"at most {MOST_BYTES:,} bytes"):
        read_xml(path)
    with pytest.raises(InputError, match="a directory"):
        read_xml(tmp_path)


@pytest.mark.nightly("content1")
@pytest.mark.parametrize("content", [b"<a>" * 2_700_000, b"<r>" + b"<a/>" * 2_000_000, b"<a " + b"b" * 8_000_000])
def test_eight_megabytes_of_junk_cost_bounded_time_and_memory(content: bytes) -> None:
    with bounded(4.0):
        said(content)
    tracemalloc.start()
    said(content)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 300e6
