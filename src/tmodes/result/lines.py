"""The series of the links of a run: where they are, what they carry, how they bend, and the parts of deformations."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.line import LinkLine, LinkLines, elastic_line
from tmodes.analysis.quasistatic import split_motion
from tmodes.analysis.validity import run_warnings
from tmodes.result.series import MIXED, Series, Variables, over_time, run_wrenches, straight_shape
from tmodes.simulation.motion_run import RunData

__all__ = ["carried_series", "line_series", "load_series"]

Array = NDArray[np.float64]


def line_series(run: RunData, stations: Array, count: int) -> tuple[Variables, dict[str, list[str]], list[str]]:
    """Lines of the first ``count`` samples, the names of links along their dimensions, and sentences of warning."""
    part = slice(count)
    lines, names, notices = _carried(run, stations, count)
    straight = elastic_line(run.model, straight_shape(run)[part], stations=[*map(float, stations)], base=run.base[part])
    shown = [lines[name] for name in names["link"]]
    motion = (run.model, run.q[part], run.v[part], run.a[part])
    split = split_motion(*motion, wrenches=run_wrenches(run)[part], base=run.base[part])
    found = _shapes(shown, straight) | _loads(lines.loaded()) | _split(split.stationary, split.oscillatory)
    loose = np.flatnonzero(~split.held)
    if len(loose):
        notices.append(
            f"the static part of the deformations is that of the linear arm at {len(loose)} of {count} samples, first "
            f"at t = {run.times[loose[0]]:.4g} s: the arm could not hold its loads there without moving"
        )
    return over_time(found, count), names, notices


def carried_series(run: RunData, stations: Array, count: int) -> tuple[Variables, dict[str, list[str]], list[str]]:
    """The same of what a page shows of the links' loads alone: neither where they are nor parts of deformations."""
    lines, names, notices = _carried(run, stations, count)
    return over_time(_loads(lines.loaded(), shown=True), count), names, notices


def _carried(run: RunData, stations: Array, count: int) -> tuple[LinkLines, dict[str, list[str]], list[str]]:
    part = slice(count)
    motion = (run.model, run.q[part], run.v[part], run.a[part])
    loads = {"wrenches": run_wrenches(run)[part], "base": run.base[part]}
    lines = elastic_line(*motion, stations=[*map(float, stations)], **loads)
    bending = lines.loaded()
    groups = {
        "link": [line for line in lines.links.values() if not line.is_point], "bending_link": bending,
        "stressed_link": [line for line in bending if line.stress is not None],
    }  # fmt: skip
    names = {dim: [line.name for line in group] for dim, group in groups.items()}
    return lines, names, run_warnings(run.robot, run.model, run.times[part], run.q[part], lines)


def load_series(run: RunData, stations: Array, count: int) -> Variables:
    """Deflections, moments and stresses alone, of the first ``count`` samples."""
    part = slice(count)
    motion = (run.model, run.q[part], run.v[part], run.a[part])
    loads = {"wrenches": run_wrenches(run)[part], "base": run.base[part]}
    return over_time(_loads(elastic_line(*motion, stations=[*map(float, stations)], **loads).loaded()), count)


def _shapes(shown: list[LinkLine], straight: LinkLines) -> Series:
    rigid = [straight[line.name] for line in shown]
    return {
        "line": ("link s axis", _stack(line.position for line in shown), "m", "position of the elastic line"),
        "line_rigid": ("link s axis", _stack(line.position for line in rigid), "m",
                       "position of the line without any elasticity, the motors where they are"),
    }  # fmt: skip


def _loads(bending: list[LinkLine], *, shown: bool = False) -> Series:
    """What links carry and how they bend, and the stress of those whose section and material are known.

    ``shown``: those alone that a page shows.
    """
    plane, kinds, text = "bending_link s plane", "bending_link s moment_kind", "of all loads outboard, in section axes"
    straight = [(line, np.zeros((*line.shear.shape[:2], 2))) for line in bending]  # of beams that do not bend
    stresses = [line.stress for line in bending if line.stress]
    further = [] if shown else bending
    return {
        "deflection": (plane, _stack(line.shape.deflection if line.shape else none for line, none in straight), "m",
                       "deflection of the elastic line from the root's tangent, along y and z of the root"),
        "slope": (plane, _stack(line.shape.slope if line.shape else none for line, none in straight), "rad",
                  "slope against the root's tangent"),
        "moment": (kinds, _stack(line.moment for line in bending), "N m", f"moment {text}"),
        "elastic_moment": (kinds, _stack(line.shape.elastic_moment if line.shape else line.moment for line in further),
                           "N m", "moment with which the material answers its curvature and its rate"),
        "shear_force": (plane, _stack(line.shear for line in bending), "N", f"shear force {text}"),
        "axial_force": ("bending_link s", _stack(line.axial for line in further), "N",
                        f"axial force {text}, tension positive"),
        "stress": ("stressed_link s", _stack(one.mises_stress for one in stresses), "Pa", "largest von Mises stress"),
        "strain": ("stressed_link s", _stack(one.strain for one in stresses), "1", "largest strain of the outer fibre"),
    }  # fmt: skip


def _split(stationary: Array, oscillatory: Array) -> Series:
    text = "static part of the elastic coordinates: what the present forces would hold"
    return {
        "deformation_stationary": ("deformation_kind", stationary, MIXED, text),
        "deformation_oscillatory": (
            "deformation_kind",
            oscillatory,
            MIXED,
            "dynamic part of the elastic coordinates: their oscillation about the static part",
        ),
    }


def _stack(parts: Iterable[Array]) -> Array:
    """(n, links, ...) of one array for each link."""
    info = [*parts]
    return np.stack(info, axis=1) if info else np.zeros(0)
