"""A case gives the same numbers by every executor: alone, in lanes, over threads and processes, on a device."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import tmodes
from tmodes.compile.gpu.cuda import HostDevice, first_gpu, unavailable
from tmodes.compile.native import WIDTH
from tmodes.simulation.gpu.run import OnDevice
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.single_case import single_case
from tmodes.study.read import study_from_data

SETTINGS = {"integration.duration": 0.05, "integration.output_step": 0.005, "integration.step": 1e-4,
            "integration.method": "rk4"}  # fmt: skip
CASES = WIDTH + 3
EFFORT = Reduction("joint.effort", "max_abs")
ASKED = [EFFORT, Reduction("deviation", "max"), Reduction("tip.speed", "rms"), Reduction("contact.force", "end")]
VARY = {
    "gear.stiffness": np.linspace(0.18, 0.22, CASES), "payload.mass": np.linspace(0.52, 0.48, CASES)
}  # fmt: skip

Numbers = dict[Reduction, np.ndarray]


def robot() -> tmodes.Robot:
    """The robot of 2010, briefly; its controller, contact and nominal run included."""
    return tmodes.load("filipovic2010").with_(SETTINGS)


def alone(sheet: tmodes.Robot) -> Numbers:
    """The first and the last case as runs by themselves."""
    changes = [{path: float(values[k]) for path, values in VARY.items()} for k in (0, CASES - 1)]
    found = [single_case(sheet, change, ASKED, None).values for change in changes]
    return {one: np.concatenate([each[one] for each in found]) for one in ASKED}


def over_threads(sheet: tmodes.Robot) -> Numbers:
    """Lanes in two spans."""
    return reduced(sheet, VARY, ASKED, threads=2).values


def one_lane(sheet: tmodes.Robot) -> Numbers:
    """The same two, each in vectors whose other lanes are over."""
    some = [reduced(sheet, {path: values[[k]] for path, values in VARY.items()}, ASKED).values for k in (0, CASES - 1)]
    return {one: np.concatenate([each[one] for each in some]) for one in ASKED}


def device_of_the_host(sheet: tmodes.Robot) -> Numbers:
    """The code of a device, run by the processor."""
    return reduced(sheet, VARY, ASKED, threads=1, executor=OnDevice(HostDevice())).values


def processes(sheet: tmodes.Robot) -> Numbers:
    """Whole results of two cases, in processes."""
    del sheet
    entries = [
        {"name": f"case {k}", "set": {path: float(values[k]) for path, values in VARY.items()}} for k in (0, CASES - 1)
    ]
    study = study_from_data({
        "format": 1, "kind": "study", "name": "two", "robot": "filipovic2010", "set": SETTINGS,
        "parameters": {"which": {"choices": entries}},
        "quantities": {"effort": {"type": "summary", "path": "joints.joint.largest_effort"}},
    })  # fmt: skip
    return {EFFORT: study.evaluate(0, study.design().values, threads=2).quantities["effort"]}


def gpu(sheet: tmodes.Robot) -> Numbers:
    """A GPU."""
    if reason := unavailable():
        pytest.skip(f"no GPU: {reason}")
    return reduced(sheet, VARY, ASKED, threads=1, executor=OnDevice(first_gpu())).values


EXECUTORS: tuple[Callable[[tmodes.Robot], Numbers], ...] = (
    alone, over_threads, one_lane, device_of_the_host, processes, gpu,
)  # fmt: skip


@pytest.fixture(scope="module")
def lanes() -> Numbers:
    """The numbers of the cases in lanes of one thread."""
    return reduced(robot(), VARY, ASKED, threads=1).values


@pytest.mark.parametrize("executor", EXECUTORS)
def test_the_same_numbers(lanes: Numbers, executor: Callable[[tmodes.Robot], Numbers]) -> None:
    """By fixed steps: lengths that are chosen differ by their powers alone, which differ by rounding."""
    for one, values in executor(robot()).items():
        right = lanes[one] if len(values) == CASES else lanes[one][[0, -1]]
        assert np.ptp(right) > 1e-6 * np.abs(right).max(), one
        assert values == pytest.approx(right, rel=1e-10), one
