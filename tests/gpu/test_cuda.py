"""What is said where no GPU can be used, and how one is: by a fake of cuda-core, and by cuda-core on a fake driver."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from tmodes.compile.gpu.cuda import HostDevice, first_gpu, unavailable
from tmodes.errors import SimulationError

from .conftest import on_device
from .fake_cuda import FakeDriver, Result, fake_core, install


def test_without_cuda_core(monkeypatch):
    monkeypatch.setitem(sys.modules, "cuda", None)
    reason = unavailable()
    assert reason is not None
    assert reason.startswith("the Python package cuda-core is missing")
    assert reason.endswith("install it: pip install 'tmodes[gpu]'")
    with pytest.raises(SimulationError, match="no GPU can be used: the Python package cuda-core is missing"):
        first_gpu()


@pytest.mark.parametrize(("status", "words"), [
    (None, "this machine has no NVIDIA driver"),
    (Result.CUDA_ERROR_STUB_LIBRARY, "this machine has no NVIDIA driver"),
    (Result.CUDA_ERROR_NO_DEVICE, "the NVIDIA driver finds no GPU; look whether `nvidia-smi` lists one"),
    (Result.CUDA_ERROR_SYSTEM_NOT_READY, r"driver does not start \(CUDA_ERROR_SYSTEM_NOT_READY\); restart"),
])  # fmt: skip
def test_without_a_driver_or_a_gpu(monkeypatch, status, words):
    install(monkeypatch, FakeDriver(status))
    with pytest.raises(SimulationError, match=words):
        first_gpu()


@pytest.mark.parametrize(("kind", "usable"), [((6, 1), False), ((7, 0), True), ((10, 0), True)])
def test_kinds_of_gpus(monkeypatch, kind, usable):
    install(monkeypatch, FakeDriver(kind=kind))
    reason = unavailable()
    assert (reason is None) == usable
    assert usable or reason == "the GPU is of compute capability 6.1; 7.0 or higher is needed (Volta or newer)"


@pytest.fixture
def cases(published):
    return replace(published.by("dormand_prince"), numbers=published.numbers[:70])


def test_a_batch_through_the_driver(monkeypatch, cases):
    """Arguments arrive in their order, blocks of threads cover all cases, and all memory is given back."""
    loop, driver = cases.model.case_loop("dormand_prince"), FakeDriver()
    core = fake_core(loop)
    install(monkeypatch, driver, core)
    work, other = cases.work(), cases.work()
    runs = on_device([work])
    on_device([other], device=HostDevice())
    assert work.states.tobytes() == other.states.tobytes()
    assert set(runs.status) == {"finished"}
    assert (core.launches[0].grid, core.launches[0].block) == (2, 64)
    assert not driver.rooms
    # 4 processors of 2048 threads hold 8,240 bytes each: what is left of 512 MiB
    assert first_gpu().free(loop) == 2**29 - 4 * 2048 * 8240


@pytest.mark.parametrize(("fails", "words"), [
    ("load", "pretended GPU refuses the code of the cases: no kernel image is available; update its driver"),
    ("launch", "pretended GPU stopped: an illegal memory access was encountered; take fewer cases"),
])  # fmt: skip
def test_what_a_gpu_refuses(monkeypatch, cases, fails, words):
    driver = FakeDriver()
    install(monkeypatch, driver, fake_core(cases.model.case_loop("dormand_prince"), fails))
    with pytest.raises(SimulationError, match=words):
        on_device([cases.work()])
    assert not driver.rooms


def test_no_memory(monkeypatch, cases):
    driver = FakeDriver(memory=4 * 2048 * 8240 + 2**20)
    install(monkeypatch, driver, fake_core(cases.model.case_loop("dormand_prince")))
    gpu = first_gpu()
    with pytest.raises(SimulationError, match=r"the GPU refuses 1e[+]03 MB of its memory: CUDA_ERROR_OUT_OF_MEMORY"):
        gpu.empty(10**9)


STAND_IN = """
import ctypes, os
from dataclasses import replace
import numpy as np
from gpu.conftest import published_cases
from tmodes.compile.gpu.case_loop import CASE
cases = published_cases().by("dormand_prince")
cases = replace(cases, numbers=cases.numbers[:70])
native = cases.model.case_loop("dormand_prince").native()
os.environ["STAND_IN_CASE"] = str(native.address(CASE))
work = cases.work()
on_device([work])
driver = ctypes.CDLL("libcuda.so.1")
np.savez("found.npz", states=work.states, launches=driver.stand_in_launches(), taken=driver.stand_in_taken())
"""


@pytest.mark.skipif(not (find_spec("cuda") and find_spec("cuda.core")), reason="needs cuda-core: the extra `gpu`")
@pytest.mark.skipif(sys.platform != "linux", reason="needs a machine where a library stands in by LD_LIBRARY_PATH")
def test_the_real_cuda_core_on_a_driver_that_stands_in(working_gcc, cases, tmp_path):
    """All calls and their arguments pass through NVIDIA's packages; a launch runs the same code on the processor."""
    here = Path(__file__).parent
    flags = ["-shared", "-fPIC", "-Wl,-soname,libcuda.so.1", "-o", str(tmp_path / "libcuda.so.1")]
    subprocess.run(["gcc", *flags, str(here / "stand_in_driver.c"), "-ldl"], check=True)
    paths = os.pathsep.join([str(here.parent), *sys.path])
    surroundings = os.environ | {"LD_LIBRARY_PATH": str(tmp_path), "PYTHONPATH": paths}
    subprocess.run([sys.executable, "-c", STAND_IN], check=True, cwd=tmp_path, env=surroundings)
    other = cases.work()
    on_device([other], device=HostDevice())
    with np.load(tmp_path / "found.npz") as found:
        assert found["states"].tobytes() == other.states.tobytes()
        assert found["launches"] >= 1
        assert found["taken"] == 0
