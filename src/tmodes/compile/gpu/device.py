"""What runs cases, one per thread: a GPU, or what stands for one."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.gpu.case_loop import CaseLoop
from tmodes.compile.gpu.one_case import ARRAYS, BLOCK, CASE, WHOLE, blocks

__all__ = ["Device", "HostDevice"]


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
