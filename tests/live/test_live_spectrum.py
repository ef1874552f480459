"""The spectrum that the page makes of a live run is that of the report's, of the run's own span of time."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from tmodes.plot.facts import spectral_part
from tmodes.plot.spectra import amplitude_spectrum

from .node import ESBUILD, WEB

PROGRAM = """
import {{ spectrumOf }} from "{web}/src/charts/spectrum";
const {{ times, values, chart, span }} = {given};
const found = spectrumOf(Float64Array.from(times), Float64Array.from(values), chart, span);
process.stdout.write(JSON.stringify({{ x: [...found.x], y: [...found.y] }}));
"""

SPANS = """
import {{ spanOf }} from "{web}/src/live/span";
const found = {given}.map(({{ times, end, setpoints }}) =>
  spanOf(Float64Array.from(times), end, setpoints.map((one) => Float64Array.from(one))));
process.stdout.write(JSON.stringify(found));
"""


def test_span_of_a_live_run_is_that_of_the_native_figures(tmp_path: Path) -> None:
    """After the move; within the move where every setpoint keeps its rate; else the whole run; an odd last sample."""
    node = shutil.which("node")
    if node is None or not ESBUILD.exists():
        pytest.skip("needs Node and the packages of the pages: npm ci in web/")
    even = np.arange(401) * 0.005
    ramp = np.clip((even - 0.1), 0, None) ** 2 - np.clip((even - 0.5), 0, None) ** 2
    ramp -= np.clip((even - 1.6), 0, None) ** 2 - np.clip((even - 2.0), 0, None) ** 2
    odd = np.append(even[:-1], 1.9973)
    cases = [(even, 1.0, [ramp]), (even, 1.95, [ramp]), (even, None, [ramp, 2 * even]), (even, None, [np.sin(even)]),
             (odd, 1.95, [ramp]), (odd, 1.0, []), (even[:20], None, [even[:20]])]  # fmt: skip
    wanted = [native_span(*case) for case in cases]
    assert len({tuple(one) for one in wanted}) >= 5
    given = [{"times": t.tolist(), "end": end, "setpoints": [s.tolist() for s in all_]} for t, end, all_ in cases]
    (tmp_path / "entry.ts").write_text(SPANS.format(web=WEB.as_posix(), given=json.dumps(given)))
    info = [ESBUILD, "entry.ts", "--bundle", "--format=esm", "--outfile=entry.mjs"]
    subprocess.run(info, check=True, capture_output=True, cwd=tmp_path)
    found = json.loads(subprocess.run([node, "entry.mjs"], check=True, capture_output=True, cwd=tmp_path).stdout)
    assert np.array(found) == pytest.approx(np.array(wanted), abs=0.0051)  # an odd last sample is dropped later


def native_span(times: np.ndarray, end: float | None, setpoints: list[np.ndarray]) -> list[float]:
    """First and last time of what the native figures show."""
    names = [f"j{k}" for k in range(len(setpoints))]
    sheet = {"drives": [{"joint": name, "command": "position"} for name in names]}
    data = xr.Dataset(
        {"wanted": (("time", "drive"), np.reshape(setpoints, (len(names), len(times))).T)},
        coords={"time": times, "drive": names},
        attrs={"robot": json.dumps(sheet), "move_end": json.dumps(end)},
    )
    part = spectral_part(data, 32)["time"].values
    return [float(part[0]), float(part[-1])]


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
