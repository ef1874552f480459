"""A page's data: what is packed in Python is what JavaScript unpacks."""

from __future__ import annotations

import json
import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

from patience import LONG
from tmodes.report.pack import Coarse, embedded, pack

ROOT = Path(__file__).resolve().parents[2]


def test_the_head_names_each_array_and_the_rest_are_their_bytes() -> None:
    values = np.arange(6.0).reshape(2, 3)
    packed = pack({"name": "<b>", "list": [{"values": values}], "small": np.array([1, 2], dtype=np.uint8)})
    (length,) = struct.unpack("<I", packed[4:8])
    head = json.loads(packed[8 : 8 + length])
    start = -(-(8 + length) // 8) * 8
    assert packed[:4] == b"TMPK"
    assert head["page"] == {"name": "<b>", "list": [{"values": {"$array": 0}}], "small": {"$array": 1}}
    assert head["arrays"][0] == {"dtype": "f8", "shape": [2, 3], "offset": 0}
    assert np.array_equal(np.frombuffer(packed, "<f8", 6, start).reshape(2, 3), values)
    assert np.array_equal(np.frombuffer(packed, "u1", 2, start + head["arrays"][1]["offset"]), [1, 2])


def test_a_number_that_is_not_finite_is_refused() -> None:
    with pytest.raises(ValueError, match="JSON"):
        pack({"value": float("nan")})


def test_the_same_pack_gives_the_same_text() -> None:
    packed = pack({"values": np.zeros(100)})
    assert embedded(packed) == embedded(packed)


@pytest.mark.skipif(not shutil.which("node"), reason="needs Node")
def test_javascript_reads_back_what_was_packed(tmp_path: Path) -> None:
    """The reader of the pages, its types stripped, in Node."""
    esbuild = ROOT / "web" / "node_modules" / ".bin" / "esbuild"
    if not esbuild.exists():
        pytest.skip("needs the packages of web/: npm ci")
    subprocess.run([esbuild, ROOT / "web/src/pack.ts", f"--outfile={tmp_path / 'pack.mjs'}"], check=True, timeout=LONG)
    rng = np.random.default_rng(1)
    fine, coarse = rng.normal(size=(3, 4)), rng.normal(size=(500, 2))
    page = {"a": [fine], "b": {"c": Coarse(coarse), "d": np.array([7], dtype=np.int32)}, "word": "π"}
    (tmp_path / "text").write_text(embedded(pack(page)), encoding="utf-8")
    program = """
    import {inflated, unpack} from "./pack.mjs"; import {readFileSync} from "node:fs";
    const page = unpack(await inflated(readFileSync("text", "utf8")));
    const info = (n) => ({data: [...n.data], shape: n.shape});
    console.log(JSON.stringify({a: info(page.a[0]), c: info(page.b.c), d: info(page.b.d), word: page.word}));
    """
    (tmp_path / "t.mjs").write_text(program, encoding="utf-8")
    done = subprocess.run(["node", "t.mjs"], cwd=tmp_path, check=True, capture_output=True, timeout=LONG)
    read = json.loads(done.stdout)
    assert read["a"] == {"data": fine.ravel().tolist(), "shape": [3, 4]}
    assert read["c"]["shape"] == [500, 2]
    assert np.abs(np.array(read["c"]["data"]) - coarse.ravel()).max() < np.ptp(coarse) / 60000
    assert read["d"] == {"data": [7], "shape": [1]}
    assert read["word"] == "π"
