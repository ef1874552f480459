"""Numbers with units, written the same in Python and in the page."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tmodes.io.printed import bound, written
from tmodes.report.markup import tag

WEB = Path(__file__).resolve().parents[2] / "web"
CASES = [
    (4.0351e-3, "m", "4.035 mm"), (0.0, "N m", "0 N·m"), (0.0, "m", "0 mm"),
    (3.2e8, "Pa", "320 MPa"), (5e4, "m", "50000 m"),
    (4.938, "Hz", "4.938 Hz"), (1.7e-11, "-", "1.7 × 10⁻¹¹"), (-2.5e-12, "J", "-2.5 × 10⁻¹² J"),
    (62.31, "%", "62.31 %"),
    (2.02e-4, "m", "0.202 mm"), (1.5e5, "N", "150 kN"), (0.04447, "s", "0.04447 s"), (1.6e-5, "m", "0.016 mm"),
    (2e-8, "m", "20 nm"), (2.69e-7, "m", "0.269 µm"), (7.91e-9, "rad", "7.91 nrad"), (5e-4, "s", "0.5 ms"),
    (1e-12, "m", "1.0 × 10⁻⁹ mm"), (2.39e8, "m", "2.4 × 10⁸ m"), (1e-6, "m", "0.001 mm"),
    (0.35, "rad", "350 mrad"), (12.0, "ohm", "12 Ω"),
]  # fmt: skip


@pytest.mark.parametrize(("value", "unit", "text"), CASES)
def test_written(value: float, unit: str, text: str) -> None:
    assert written(value, unit) == text


def page_function(file: str, name: str, calls: list[tuple[Any, ...]]) -> Any:
    """What a function of the page's sources gives for each of some arguments."""
    node = shutil.which("node")
    if node is None or not (WEB / "node_modules" / "esbuild").exists():
        pytest.skip("needs Node and the packages of web/")
    program = f"""
      import {{ build }} from "esbuild";
      const made = await build({{ entryPoints: ["src/{file}"], bundle: true, format: "esm", write: false }});
      const text = Buffer.from(made.outputFiles[0].text).toString("base64");
      const {{ {name} }} = await import("data:text/javascript;base64," + text);
      console.log(JSON.stringify({json.dumps(calls)}.map((given) => {name}(...given))));
    """
    ran = subprocess.run(
        [node, "--input-type=module", "-e", program], cwd=WEB, capture_output=True, text=True, check=True
    )
    return json.loads(ran.stdout)


def test_the_page_writes_the_same() -> None:
    wanted = [bound(written(value, unit)) for value, unit, _ in CASES]
    assert page_function("format.ts", "info", [case[:2] for case in CASES]) == wanted


def test_a_slider_has_the_unit_in_which_its_numbers_read_well() -> None:
    """The wall of a tube in mm, its length in m, a modulus in GPa."""
    ends = [("m", 0.75e-3, 3e-3), ("m", 0.2, 0.8), ("Pa", 2e10, 3e11), ("kg", 1e-4, 9e-4)]
    calls = [({"unit": unit, "min": low, "max": high},) for unit, low, high in ends]
    found = page_function("panels/slider.ts", "unitOf", calls)
    assert [(one["name"], one["factor"]) for one in found] == [("mm", 1e3), ("m", 1), ("GPa", 1e-9), ("kg", 1)]


def test_no_end_of_a_line_parts_a_number_from_its_unit() -> None:
    assert bound("ends 3.38 mm off (7.16 Hz, 15 % damping) after 2 steps of a joint") == (
        "ends 3.38\u00a0mm off (7.16\u00a0Hz, 15\u00a0% damping) after 2 steps of a joint"
    )
    assert bound("1.7 × 10⁻¹¹ J of 25 kN·m/rad") == "1.7\u00a0×\u00a010⁻¹¹\u00a0J of 25\u00a0kN·m/rad"
    assert tag("code", "mass: 3 kg") == "<code>mass: 3 kg</code>"
    assert tag("p", "3 kg") == "<p>3\u00a0kg</p>"
