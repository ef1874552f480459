"""The parts of cuda-core and of cuda.bindings that are used, on this machine's memory and processor."""

from __future__ import annotations

import ctypes
from enum import IntEnum
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from tmodes.compile.gpu.case_loop import CASE, CaseLoop

__all__ = ["FakeDriver", "fake_core", "install"]


class Result(IntEnum):
    """Statuses of the driver, with its numbers."""

    CUDA_SUCCESS = 0
    CUDA_ERROR_OUT_OF_MEMORY = 2
    CUDA_ERROR_STUB_LIBRARY = 34
    CUDA_ERROR_NO_DEVICE = 100
    CUDA_ERROR_SYSTEM_NOT_READY = 802


class FakeDriver(ModuleType):
    """``cuda.bindings.driver`` with memory from the C library; counts what is taken."""

    CUresult = Result
    CUdeviceptr = int
    CUdevice_attribute = SimpleNamespace(
        CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR=0, CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR=1
    )

    def __init__(self, status: Any = Result.CUDA_SUCCESS, kind: tuple[int, int] = (9, 0), memory: int = 2**29) -> None:
        super().__init__("cuda.bindings.driver")
        self.status, self.kind, self.memory = status, kind, memory
        self.rooms: dict[int, Any] = {}

    def cuInit(self, flags: int) -> tuple[Any]:
        if self.status is None:
            raise RuntimeError('"cuda" is an NVIDIA driver library and can only be found via system search')
        return (self.status,)

    def cuDeviceGetAttribute(self, which: int, device: int) -> tuple[Any, int]:
        return Result.CUDA_SUCCESS, self.kind[which]

    def cuMemGetInfo(self) -> tuple[Any, int, int]:
        return Result.CUDA_SUCCESS, self.memory, self.memory

    def cuMemAlloc(self, size: int) -> tuple[Any, ...]:
        if size > self.memory:
            return (Result.CUDA_ERROR_OUT_OF_MEMORY, 0)
        room = ctypes.create_string_buffer(size)
        self.rooms[ctypes.addressof(room)] = room
        return Result.CUDA_SUCCESS, ctypes.addressof(room)

    def cuMemFree(self, room: int) -> tuple[Any]:
        del self.rooms[room]
        return (Result.CUDA_SUCCESS,)

    def cuMemcpyHtoDAsync(self, room: int, source: int, size: int, stream: Any) -> tuple[Any]:
        ctypes.memmove(room, source, size)
        return (Result.CUDA_SUCCESS,)

    def cuMemcpyDtoHAsync(self, target: int, room: int, size: int, stream: Any) -> tuple[Any]:
        ctypes.memmove(target, room, size)
        return (Result.CUDA_SUCCESS,)


def fake_core(loop: CaseLoop, fails: str = "") -> ModuleType:
    """``cuda.core`` whose kernel is the native code of a loop; ``fails``: what a launch, or loading, says."""
    stream = SimpleNamespace(handle=0, sync=lambda: None)
    core: Any = ModuleType("cuda.core")
    core.launches = []

    class Device:
        name = "pretended GPU"
        properties = SimpleNamespace(multiprocessor_count=4, max_threads_per_multiprocessor=2048)

        def __init__(self, index: int) -> None:
            assert index == 0

        def set_current(self) -> None:
            """Nothing to do."""

        def create_stream(self) -> Any:
            return stream

    def from_ptx(code: bytes) -> Any:
        if fails == "load":
            raise ValueError("no kernel image is available")
        assert b".visible .entry run(" in code
        attributes = SimpleNamespace(local_size_bytes=8240)
        return SimpleNamespace(get_kernel=lambda name: SimpleNamespace(name=name, attributes=attributes))

    def launch(given: Any, config: Any, kernel: Any, *arguments: Any) -> None:
        if fails == "launch":
            raise ValueError("an illegal memory access was encountered")
        assert given is stream
        assert kernel.name == "run"
        core.launches.append(config)
        function = loop.native()[CASE]
        for thread in range(config.grid * config.block):
            function(thread, *(int(one) for one in arguments))

    core.Device, core.ObjectCode, core.launch = Device, SimpleNamespace(from_ptx=from_ptx), launch
    core.LaunchConfig = SimpleNamespace
    return core


def install(patch: pytest.MonkeyPatch, driver: FakeDriver, core: ModuleType | None = None) -> None:
    """Put the modules where they are imported from."""
    bindings: Any = ModuleType("cuda.bindings")
    bindings.driver = driver
    cuda: Any = ModuleType("cuda")
    cuda.core, cuda.bindings = core or ModuleType("cuda.core"), bindings
    modules = {"cuda": cuda, "cuda.core": cuda.core, "cuda.bindings": bindings, "cuda.bindings.driver": driver}
    for name, module in modules.items():
        patch.setitem(__import__("sys").modules, name, module)
