"""The first NVIDIA GPU of this machine, through cuda-core; and what runs cases, one per thread."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.gpu.case_loop import ARRAYS, BLOCK, CASE, KERNEL, LEAST_TARGET, WHOLE, CaseLoop, blocks
from tmodes.errors import SimulationError

__all__ = ["CudaDevice", "Device", "HostDevice", "first_gpu", "unavailable"]


class Device(ABC):
    """Memory of its own, and launches of the code of cases. A room is a handle of memory, valid until it is freed."""

    @property
    @abstractmethod
    def name(self) -> str:
        """What it is called in messages."""

    @abstractmethod
    def free(self, loop: CaseLoop) -> int:
        """Bytes that arrays can take next to what the code of a loop needs for itself."""

    @abstractmethod
    def empty(self, size: int) -> Any:
        """A room of so many bytes. Raises :class:`tmodes.errors.SimulationError` where there is no memory for it."""

    @abstractmethod
    def upload(self, array: NDArray[Any], room: Any) -> None:
        """The bytes of a C-ordered array to the begin of a room."""

    @abstractmethod
    def download(self, room: Any, first: int, array: NDArray[Any]) -> None:
        """Fill a C-ordered array from byte ``first`` of a room on."""

    @abstractmethod
    def launch(self, loop: CaseLoop, rooms: Mapping[str, Any], whole: Mapping[str, int]) -> None:
        """One thread for each case in question; returns when all are done.

        ``rooms``: by ``ARRAYS``, and whole numbers by ``WHOLE``, of the arguments of the code.
        """

    @abstractmethod
    def release(self, rooms: list[Any]) -> None:
        """Give memory back."""

    def uploaded(self, array: NDArray[Any]) -> Any:
        """A new room that holds an array."""
        array = np.ascontiguousarray(array)
        room = self.empty(max(array.nbytes, 8))
        self.upload(array, room)
        return room


class HostDevice(Device):
    """The processor of this machine in place of a GPU, thread after thread: to check the code where there is none."""

    def __init__(self, memory: int = 2**30, *, mathematics: bool = True) -> None:
        """``memory``: bytes of its arrays; ``mathematics``: as of :meth:`CaseLoop.native`."""
        self.memory, self.mathematics = memory, mathematics

    @property
    def name(self) -> str:
        """No GPU."""
        return "this processor"

    def free(self, loop: CaseLoop) -> int:  # noqa: ARG002
        """So many bytes as it was given."""
        return self.memory

    def empty(self, size: int) -> Any:
        """An array of bytes."""
        return np.zeros(size, dtype=np.uint8)

    def upload(self, array: NDArray[Any], room: Any) -> None:
        """A copy."""
        room[: array.nbytes] = np.frombuffer(array.tobytes(), dtype=np.uint8)

    def download(self, room: Any, first: int, array: NDArray[Any]) -> None:
        """A copy."""
        array[...] = room[first : first + array.nbytes].view(array.dtype).reshape(array.shape)

    def launch(self, loop: CaseLoop, rooms: Mapping[str, Any], whole: Mapping[str, int]) -> None:
        """Whole blocks of threads, as a GPU has them: some are beyond the last case."""
        function = loop.native(mathematics=self.mathematics)[CASE]
        given = [rooms[name].ctypes.data for name in ARRAYS] + [whole[name] for name in WHOLE]
        for thread in range(blocks(whole["threads"]) * BLOCK):
            function(thread, *given)

    def release(self, rooms: list[Any]) -> None:
        """Nothing to do."""


_INSTALL = "pip install 'tmodes[gpu]'"
_LEAST = int(LEAST_TARGET.removeprefix("sm_"))


def unavailable() -> str | None:
    """Why cases cannot run on a GPU of this machine, and what to do; None where they can."""
    try:
        driver, _ = _packages()
    except ImportError as problem:
        return f"the Python package cuda-core is missing ({problem}); install it: {_INSTALL}"
    try:
        (status,) = driver.cuInit(0)
    except RuntimeError:
        status = None
    if status is None or status == driver.CUresult.CUDA_ERROR_STUB_LIBRARY:
        return "this machine has no NVIDIA driver; install the driver, until `nvidia-smi` lists the GPU"
    if status == driver.CUresult.CUDA_ERROR_NO_DEVICE:
        return "the NVIDIA driver finds no GPU; look whether `nvidia-smi` lists one and CUDA_VISIBLE_DEVICES names it"
    if status != driver.CUresult.CUDA_SUCCESS:
        return f"the NVIDIA driver does not start ({status.name}); restart the machine, or install the driver again"
    return _too_old(driver)


def _packages() -> tuple[Any, Any]:
    """The driver's functions, and cuda-core; raises ImportError."""
    return import_module("cuda.bindings.driver"), import_module("cuda.core")


def _too_old(driver: Any) -> str | None:
    kind = driver.CUdevice_attribute
    major, minor = (
        _checked(driver.cuDeviceGetAttribute(one, 0), "its kind")
        for one in (
            kind.CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR, kind.CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR,
        )
    )  # fmt: skip
    if 10 * major + minor >= _LEAST:
        return None
    return f"the GPU is of compute capability {major}.{minor}; {_LEAST / 10:.1f} or higher is needed (Volta or newer)"


def first_gpu() -> CudaDevice:
    """The first GPU; raises :class:`tmodes.errors.SimulationError`, with the reason, where there is none to use."""
    if reason := unavailable():
        raise SimulationError(f"no GPU can be used: {reason}; or run without --on gpu")
    return CudaDevice()


class CudaDevice(Device):
    """The first GPU, with one stream."""

    def __init__(self) -> None:
        self._driver, self._core = _packages()
        self._card = self._core.Device(0)
        self._card.set_current()
        self._stream = self._card.create_stream()
        self._kernels: dict[str, Any] = {}

    @property
    def name(self) -> str:
        """Name of the card."""
        return self._card.name

    def free(self, loop: CaseLoop) -> int:
        """Bytes that are free, less the local memory of as many threads as the GPU can hold: so much is set aside."""
        each = self._kernel(loop).attributes.local_size_bytes
        card = self._card.properties
        held = each * card.multiprocessor_count * card.max_threads_per_multiprocessor
        free, _ = _checked(self._driver.cuMemGetInfo(), "its memory")
        return max(0, free - held)

    def _kernel(self, loop: CaseLoop) -> Any:
        if loop.key not in self._kernels:
            try:
                code = self._core.ObjectCode.from_ptx(loop.ptx().encode())
                self._kernels[loop.key] = code.get_kernel(KERNEL)
            except Exception as problem:
                hint = "update its driver"
                raise SimulationError(f"{self.name} refuses the code of the cases: {problem}; {hint}") from None
        return self._kernels[loop.key]

    def empty(self, size: int) -> Any:
        """Memory of the card."""
        return _checked(self._driver.cuMemAlloc(size), f"{size / 1e6:.3g} MB of its memory")

    def upload(self, array: NDArray[Any], room: Any) -> None:
        """A copy over the bus."""
        array = np.ascontiguousarray(array)
        copied = self._driver.cuMemcpyHtoDAsync(room, array.ctypes.data, array.nbytes, self._stream.handle)
        _checked(copied, "a copy to it")
        self._wait()

    def download(self, room: Any, first: int, array: NDArray[Any]) -> None:
        """A copy over the bus."""
        source = self._driver.CUdeviceptr(int(room) + first)
        copied = self._driver.cuMemcpyDtoHAsync(array.ctypes.data, source, array.nbytes, self._stream.handle)
        _checked(copied, "a copy from it")
        self._wait()

    def launch(self, loop: CaseLoop, rooms: Mapping[str, Any], whole: Mapping[str, int]) -> None:
        """Blocks of threads, until all are done."""
        pointers, numbers = [int(rooms[name]) for name in ARRAYS], [np.int64(whole[name]) for name in WHOLE]
        config = self._core.LaunchConfig(grid=blocks(whole["threads"]), block=BLOCK)
        with self._stopping():
            self._core.launch(self._stream, config, self._kernel(loop), *pointers, *numbers)
        self._wait()

    def _wait(self) -> None:
        """Until all is done; what a launch did wrong is heard of here."""
        with self._stopping():
            self._stream.sync()

    @contextmanager
    def _stopping(self) -> Iterator[None]:
        try:
            yield
        except Exception as problem:
            hint = "take fewer cases, or run without --on gpu"
            raise SimulationError(f"{self.name} stopped: {problem}; {hint}") from None

    def release(self, rooms: list[Any]) -> None:
        """Give memory back; of a GPU that stopped, all is gone anyway."""
        for room in rooms:
            self._driver.cuMemFree(room)


def _checked(answer: tuple[Any, ...], what: str) -> Any:
    """What a call of the driver gives, without its status."""
    status, *values = answer
    if int(status):
        raise SimulationError(f"the GPU refuses {what}: {status.name}; look at `nvidia-smi`, or run without --on gpu")
    return values[0] if len(values) == 1 else values
