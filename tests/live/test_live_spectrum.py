"""The spectrum that the page makes of a live run is that of the report's, of the run's own span of time."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from tmodes.plot.amplitude import amplitude_spectrum

from .node import ESBUILD, WEB

PROGRAM = """
import {{ spectrumOf }} from "{web}/src/charts/spectrum";
const {{ times, values, chart, span }} = {given};
const found = spectrumOf(Float64Array.from(times), Float64Array.from(values), chart, span);
process.stdout.write(JSON.stringify({{ x: [...found.x], y: [...found.y] }}));
"""


def test_spectrum_is_of_the_run_s_span_without_an_odd_last_sample(tmp_path: Path) -> None:
    """The chart's span is another one; the last sample follows a step of its own."""
    node = shutil.which("node")
    if node is None or not ESBUILD.exists():
        pytest.skip("needs Node and the packages of the pages: npm ci in web/")
    times = np.append(np.arange(400) * 0.005, 1.9973)
    values = np.sin(2 * np.pi * 4.9 * times) + 0.3 * times
    chart = {"span": [0.0, 0.5], "at": {"data": [20.0]}}
    given = json.dumps({"times": times.tolist(), "values": values.tolist(), "chart": chart, "span": [0.72, 2.0]})
    (tmp_path / "entry.ts").write_text(PROGRAM.format(web=WEB.as_posix(), given=given))
    info = [ESBUILD, "entry.ts", "--bundle", "--format=esm", "--outfile=entry.mjs"]
    subprocess.run(info, check=True, capture_output=True, cwd=tmp_path)
    found = json.loads(subprocess.run([node, "entry.mjs"], check=True, capture_output=True, cwd=tmp_path).stdout)
    frequency, amplitude = amplitude_spectrum(values[144:400], 0.005, 4)
    count = len(found["x"])
    assert found["x"][-1] == pytest.approx(20.0, abs=0.5)
    assert found["x"] == pytest.approx(frequency[:count])
    assert found["y"] == pytest.approx(amplitude[:count], abs=1e-12)
