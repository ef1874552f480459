"""States to evaluate at are read from JSON, strictly."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from patience import bounded
from tmodes.errors import InputError
from tmodes.io.states import read_phi_states

RECORD = {"phi": [0.1, -0.2, 0.3, 0, 1e-3, 2], "phid": [1.0] * 6, "u": 24.0}
TEXT = json.dumps(RECORD)
ORACLE = Path(__file__).parents[1] / "oracle" / "reference_states.json"


def written(folder: Path, text: str) -> Path:
    file = folder / "states.json"
    file.write_text(text, encoding="utf-8")
    return file


def test_records_are_read_as_floats(tmp_path: Path) -> None:
    states = read_phi_states(written(tmp_path, f"[{TEXT}, {TEXT}]"))
    assert states == [RECORD, RECORD]
    assert all(type(value) is float for value in states[0]["phi"])


def test_they_may_stand_under_the_key_states_and_after_a_byte_order_mark(tmp_path: Path) -> None:
    assert read_phi_states(written(tmp_path, '\ufeff{"states": [' + TEXT + "]}")) == [RECORD]


def test_answers_of_another_program_may_stand_next_to_ours(tmp_path: Path) -> None:
    readings = json.loads(ORACLE.read_text(encoding="utf-8"))["readings"]
    samples = [sample for reading in readings.values() for sample in [*reading["free"], *reading["contact"]]]
    states = read_phi_states(written(tmp_path, json.dumps(samples)))
    assert states == [{key: sample[key] for key in ("phi", "phid", "u")} for sample in samples]
    assert len(states) >= 20


def test_the_number_of_coordinates_is_asked_for(tmp_path: Path) -> None:
    file = written(tmp_path, '[{"phi": [1, 2], "phid": [3, 4], "u": 5}]')
    assert read_phi_states(file, coordinates=("a", "b")) == [{"phi": [1.0, 2.0], "phid": [3.0, 4.0], "u": 5.0}]
    with pytest.raises(InputError, match="record 0: phi must be a list of 6 numbers"):
        read_phi_states(file)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"u": 24.0', '"u": NaN', "record 1: u must be"),
        ('"u": 24.0', '"u": Infinity', "record 1: u must be"),
        ('"u": 24.0', '"u": 1e999', "record 1: u must be"),
        ('"u": 24.0', '"u": 1e13', "record 1: u must be a number of magnitude at most 1e+12"),
        ('"u": 24.0', f'"u": {"9" * 400}', "record 1: u must be"),
        ('"u": 24.0', f'"u": {"9" * 5000}', "a number of thousands of digits"),
        ('"u": 24.0', '"u": true', "record 1: u must be"),
        ('"u": 24.0', '"u": "24"', "record 1: u must be"),
        ('"u": 24.0', '"u": null', "record 1: u is missing"),
        ('"u": 24.0', '"u": [24.0]', "record 1: u must be"),
        (', "u": 24.0', "", "record 1: u is missing, expected the key `u`"),
        ('"u": 24.0', '"u": 24.0, "u": 24.0', "record 1: 'u' must be given once, got a key that stands twice"),
        ('"u": 24.0', '"u": 24.0, "phii": 1', "unknown key `record 1: 'phii'"),
        ('"u": 24.0', '"u": 24.0, "phii": 1', "Did you mean `phi`?"),
        ('"u": 24.0', '"u": 24.0, "H": [[1, NaN]]', "record 1: H must be"),
        ("-0.2, ", "", "record 1: phi must be a list of 6 numbers"),
        ("-0.2", "false", "record 1: phi: delta must be"),
        ("-0.2", "1e999", "record 1: phi: delta must be"),
        ("-0.2", "[]", "record 1: phi: delta must be"),
        (TEXT, "3.5", "record 1 must be a record with the keys phi, phid, u, got 3.5"),
        (TEXT, "[]", "record 1 must be a record with the keys phi, phid, u, got a list of 0"),
        (TEXT, "{", "broken JSON"),
    ],
)
def test_a_wrong_value_is_reported_with_record_and_field(old: str, new: str, words: str, tmp_path: Path) -> None:
    assert old in TEXT
    file = written(tmp_path, f"[{TEXT}, {TEXT.replace(old, new, 1)}]")
    with pytest.raises(InputError) as caught:
        read_phi_states(file)
    assert words in str(caught.value)
    assert str(file) in str(caught.value)


HOSTILE = {
    "empty": "",
    "null": "null",
    "no records": "[]",
    "other group": '{"state": []}',
    "two keys": '{"states": [], "also": 1}',
    "deep lists": "[" * 1_000_000,
    "deep objects": '{"a":' * 1_000_000,
    "flood of lists": "[" + "[]," * 5_000_000 + "[]]",
    "truncated": f"[{TEXT}, {TEXT}"[:-9],
    "two values": f"[{TEXT}] [{TEXT}]",
    "control characters": '["\x00"]',
    "word": "states",
    "blanks": " " * 1_000_000,
}


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_a_hostile_file_is_refused_in_time(text: str, tmp_path: Path) -> None:
    file = written(tmp_path, text)
    with bounded(2.0), pytest.raises(InputError, match=r"states\.json"):
        read_phi_states(file)


def test_bytes_that_are_no_text_and_places_that_are_no_files_are_refused(tmp_path: Path) -> None:
    (tmp_path / "junk.json").write_bytes(b"\xff\xfe\x00")
    with (tmp_path / "large.json").open("wb") as file:
        file.truncate(50_000_001)
    for path in (tmp_path, tmp_path / "absent.json", tmp_path / "junk.json", tmp_path / "large.json"):
        with pytest.raises(InputError, match=r"record|file"):
            read_phi_states(path)


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5) | st.just([0.0] * 6),
    lambda inner: st.lists(inner, max_size=7) | st.dictionaries(st.sampled_from(["phi", "phid", "u", "H", "x"]), inner),
    max_leaves=12,
)


@settings(max_examples=200)
@given(data=values)
def test_any_json_is_read_or_refused(data: Any, tmp_path_factory: pytest.TempPathFactory) -> None:
    file = written(tmp_path_factory.getbasetemp(), json.dumps(data))
    try:
        states = read_phi_states(file)
    except InputError:
        return
    assert all(math.isfinite(value) for state in states for value in [*state["phi"], *state["phid"], state["u"]])
