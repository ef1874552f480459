"""The C compiler of this machine on the same instruction list: the whole recursion as one straight C function."""

from __future__ import annotations

import ctypes
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.engines.contender import Contender, PeerMissing
from benchmarks.engines.ours import SAMPLES, Ours, found_in, repeated

from tmodes.compile.ir.unroll import c_text, unrolled

__all__ = ["FLAGS", "PATIENCE", "build", "compiled", "contender"]

FLAGS: dict[str, tuple[str, ...]] = {"gcc -O3": ("-O3",), "gcc -O3 -march=native": ("-O3", "-march=native")}
"""Names of ways to compile, and what the compiler is given."""

PATIENCE = 20.0
"""Seconds after which the compiler is given up."""

_LOOP = """
#include <string.h>
void many(long long n, const double *p, double *w, const double *in, double *out)
{
    static const int at[] = {TAKEN}, size[] = {SIZES}, given[] = {GIVEN};
    memcpy(w, p, PARAMETERS * sizeof(double));
    forward_prepare(w);
    for (long long i = 0; i < n; i++) {
        for (unsigned k = 0; k < sizeof(at) / sizeof(at[0]); in += size[k], k++)
            memcpy(w + at[k], in, size[k] * sizeof(double));
        forward(w);
        for (unsigned k = 0; k < sizeof(given) / sizeof(given[0]); k++) *out++ = w[given[k]];
    }
}
"""


def build(text: str, flags: Sequence[str], patience: float = PATIENCE) -> tuple[ctypes.CDLL, float]:
    """A library from C text, and the compiler's own time [s].

    Raises :class:`PeerMissing` where there is no gcc or it takes longer than ``patience`` [s], RuntimeError where it
    refuses the text.
    """
    gcc = shutil.which("gcc")
    if gcc is None:
        raise PeerMissing("no gcc on this machine (Debian: apt install gcc)")
    with tempfile.TemporaryDirectory() as folder:
        source, binary = Path(folder, "peer.c"), Path(folder, "peer.so")
        source.write_text(text, encoding="utf-8")
        command = [gcc, "-std=gnu11", *flags, "-fPIC", "-shared", str(source), "-o", str(binary), "-lm"]
        began = time.perf_counter()
        code, problem = compiled(command, patience)
        if code:
            raise RuntimeError(f"gcc {' '.join(flags)} refused the C text:\n{problem[:2000]}")
        seconds = time.perf_counter() - began
        return ctypes.CDLL(str(binary)), seconds


def compiled(command: Sequence[str], patience: float) -> tuple[int, str]:
    """Exit status of a compiler and what it reports; given up, the programs that it started end with it.

    Raises :class:`PeerMissing` where it takes longer than ``patience`` [s].
    """
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, start_new_session=True) as process:
        try:
            _, problem = process.communicate(timeout=patience)
        except BaseException as late:
            with suppress(ProcessLookupError):
                process.kill() if sys.platform == "win32" else os.killpg(process.pid, signal.SIGKILL)
            if isinstance(late, subprocess.TimeoutExpired):
                raise PeerMissing(f"given up: it compiles longer than {patience:g} s") from late
            raise
    return process.returncode, problem


def contender(ours: Ours, name: str, patience: float = PATIENCE) -> Contender:
    """``name`` is one of :data:`FLAGS`."""
    library, seconds = build(_text(ours.schedule), FLAGS[name], patience)
    library.many.restype = None
    out, workspace = np.empty((SAMPLES, ours.robot.joints)), np.zeros(ours.schedule.workspace)
    arrays = ours.model.parameters, workspace, ours.rows, out

    def once() -> None:
        library.many(ctypes.c_longlong(SAMPLES), *(ctypes.c_void_p(array.ctypes.data) for array in arrays))

    return Contender(f"{name}, same list", repeated(once), found_in(once, out), compile_seconds=seconds)


def _text(schedule: Any) -> str:
    """The list of a schedule and the loop over the batch, in C."""
    offset = schedule.offset
    given = [slot for slots in schedule.outputs.values() for slot in slots]
    numbers = {
        "TAKEN": [offset(slot) for slot in schedule.inputs.values()],
        "SIZES": [slot.size for slot in schedule.inputs.values()],
        "GIVEN": [place for slot in given for place in range(offset(slot), offset(slot) + slot.size)],
        "PARAMETERS": [schedule.parameters],
    }
    loop = _LOOP
    for word, info in numbers.items():
        loop = loop.replace(word, ", ".join(map(str, info)))
    return c_text(unrolled(schedule), "forward") + loop
