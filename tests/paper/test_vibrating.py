"""The second sheet of the 2010 robot: both modes vibrate in the vertical plane; its numbers are those of a study."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmodes
from tmodes.analysis.vibration import residual_vibration
from tmodes.io.yaml_file import parse_yaml
from tmodes.robots.load import sheet_text

STUDY = Path(__file__).resolve().parents[2] / "examples" / "studies" / "vibrating.yaml"
BEST = 1919
"""The case of the study whose rounded numbers the sheet has."""


@pytest.fixture(scope="module")
def data():
    return tmodes.load("filipovic2010_vibrating").run(error_estimate=False).data


def leaves(value, path=()):
    """All that stands in a sheet, by its dotted path."""
    if not isinstance(value, (dict, list)):
        return {".".join(map(str, path)): value}
    items = value.items() if isinstance(value, dict) else enumerate(value)
    return {name: leaf for key, inner in items for name, leaf in leaves(inner, (*path, key)).items()}


def test_it_differs_in_what_the_study_varies_alone():
    """T, the ramps and the factors, which are printed, and all others stay."""
    first, own = (
        leaves(parse_yaml(sheet_text(name), name)[0]) for name in ("filipovic2010", "filipovic2010_vibrating")
    )
    study = tmodes.read_study(STUDY)
    best = dict(zip(study.names, study.design().values[BEST], strict=True))
    found = {str(one.path): float(best[name]) for name, one in study.sheet.parameters.items()}
    same = {path for path in first if path not in found and first[path] == own[path]}
    assert {*first} - same - {*found} == {"name", "title", "citation"}
    assert {*own} == {*first}
    assert [own[path] for path in found] == pytest.approx([*found.values()], rel=0.02)


@pytest.mark.parametrize("part", ["elevation1", "elevation2"])
def test_both_modes_vibrate_in_the_vertical_plane(data, part):
    """Two frequencies in each bending angle, well apart, both large enough to be seen."""
    time = data["time"].values
    own = time >= 0.4  # after the first ramp
    angle = data["deformation"].sel(deformation_kind=f"link.{part}").values
    modes = residual_vibration(time[own] - 0.4, angle[own, None]).modes
    slow, fast = (
        max((one for one in modes if low < one.frequency_Hz < high), key=lambda one: one.amplitude)
        for low, high in ((1.0, 4.0), (5.0, 6.5))
    )
    assert fast.frequency_Hz > 1.5 * slow.frequency_Hz
    assert slow.amplitude > fast.amplitude
    assert slow.amplitude > 0.05 * abs(angle.mean())
    assert fast.amplitude > 0.04 * np.ptp(angle)


def test_it_keeps_the_limits_of_the_study(data):
    """The ratios that the paper names: rigidity of the parts, and their bending angles, about ten each."""
    lower, upper = (data["deformation"].sel(deformation_kind=f"link.elevation{k}").values for k in (1, 2))
    own = leaves(parse_yaml(sheet_text("filipovic2010_vibrating"), "")[0])
    rigidity = [own[f"link.modes.{k}.bending_stiffness"] / own[f"link.modes.{k}.length"] ** 3 for k in (0, 1)]
    assert 8 < upper.mean() / lower.mean() < 12
    assert 5 < rigidity[0] / rigidity[1] < 15
    assert np.abs(upper).max() < 0.25
    assert data["deviation"].values.max() < 0.06
