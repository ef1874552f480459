"""What is said where the memory is too small: by then hardly anything can be loaded any more."""

from __future__ import annotations

import errno
import re
import sys

__all__ = ["OUT_OF_MEMORY", "lacks_memory", "prepare", "prepare_study", "words"]

OUT_OF_MEMORY = 3
"""Exit code."""

LEAST = 650e6
"""Address space below which nothing is begun [bytes]: libraries and compiler, which may end the process without a word
when they get no memory, take 610e6 in a run of the smallest robot."""

LEAST_OF_STUDY = 780e6
"""The same of a study, whose table has a library with threads of its own."""

ENOUGH = 1e9
"""What a run with its report of a robot of a few links needs [bytes]."""

ROOMY = 4e9
"""Below so much the limit is the likely reason where memory lacks [bytes]."""

_SIGNS = re.compile(
    r"failed to map segment|(cannot|can't|unable to) allocate|can't start new thread|failed to launch worker thread",
    re.IGNORECASE,
)


def limit() -> float:
    """The address space that this process may use (`ulimit -v`) [bytes]; infinite where there is no limit."""
    if sys.platform == "win32":
        return float("inf")
    import resource

    most = resource.getrlimit(resource.RLIMIT_AS)[0]
    return float("inf") if most == resource.RLIM_INFINITY else float(most)


def prepare_study() -> None:
    """Before a study loads what it needs; raises :class:`MemoryError` where it could not be."""
    if limit() < LEAST_OF_STUDY:
        raise MemoryError


def prepare() -> None:
    """Before anything is loaded; raises :class:`MemoryError` where it could not be."""
    if limit() < LEAST:
        raise MemoryError
    if limit() < ENOUGH:  # native code that gets no memory may end the process without a word
        print(f"tmodes: this process may use {limit() / 1e6:.0f} MB of memory (ulimit -v)", file=sys.stderr)


def lacks_memory(error: BaseException | None) -> bool:
    """Whether an error, or what caused it, is that the system gave no memory: libraries that are loaded name it so."""
    while error is not None:
        out = isinstance(error, MemoryError) or getattr(error, "errno", None) == errno.ENOMEM
        out |= isinstance(error, ImportError) and limit() < ENOUGH  # a module may hide why it is not there
        spoken = isinstance(error, (ImportError, OSError, RuntimeError)) or type(error).__module__ == "pyarrow.lib"
        if out or (spoken and _SIGNS.search(str(error))):
            return True
        error = error.__cause__ or error.__context__
    return False


def words() -> str:
    """What is wrong and how to fix it."""
    if limit() < ROOMY:
        return (
            f"out of memory: this process may use {limit() / 1e6:.0f} MB; raise the limit (ulimit -v), 2 GB are enough"
        )
    return "out of memory; raise integration.output_step, shorten integration.duration, or free some memory"
