"""The C compiler of this machine on the same instruction list: the whole recursion as one straight C function."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.bench.contender import Contender
from tmodes.bench.missing import PeerMissing
from tmodes.bench.ours import SAMPLES, Ours, found_in, repeated
from tmodes.compile.inline import c_text, inlined

__all__ = ["FLAGS", "PATIENCE", "build", "contender"]

FLAGS: dict[str, tuple[str, ...]] = {"gcc -O3": ("-O3",), "gcc -O3 -march=native": ("-O3", "-march=native")}
"""Names of ways to compile, and what the compiler is given."""

PATIENCE = 20.0
"""Seconds after which the compiler is given up."""

_LOOP = """
void many(long long n, const double *p, const double *in, double *out)
{
    static const long long at[] = {OFFSETS};
    const double *arg[sizeof(at) / sizeof(at[0]) + 1];
    double *res[1];
    for (long long i = 0; i < n; i++) {
        for (unsigned k = 0; k < sizeof(at) / sizeof(at[0]); k++) arg[k] = in + i * INPUTS + at[k];
        arg[sizeof(at) / sizeof(at[0])] = p;
        res[0] = out + i * OUTPUTS;
        FUNCTION(arg, res, 0, 0, 0);
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
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=patience)
        except subprocess.TimeoutExpired as late:
            raise PeerMissing(f"given up: it compiles longer than {patience:g} s") from late
        if done.returncode:
            raise RuntimeError(f"gcc {' '.join(flags)} refused the C text:\n{done.stderr[:2000]}")
        seconds = time.perf_counter() - began
        return ctypes.CDLL(str(binary)), seconds


def contender(ours: Ours, name: str, patience: float = PATIENCE) -> Contender:
    """``name`` is one of :data:`FLAGS`."""
    many, seconds = _many(ours, FLAGS[name], patience)
    out = np.empty((SAMPLES, ours.robot.joints))
    arrays = ours.model.parameters, ours.rows, out

    def once() -> None:
        many(ctypes.c_longlong(SAMPLES), *(ctypes.c_void_p(array.ctypes.data) for array in arrays))

    return Contender(f"{name}, same list", repeated(once), found_in(once, out), compile_seconds=seconds)


def _many(ours: Ours, flags: Sequence[str], patience: float) -> tuple[Any, float]:
    """The loop over the batch, in C."""
    schedule = ours.schedule
    sizes = [slot.size for slot in schedule.inputs.values()]
    starts = ", ".join(str(start) for start in np.concatenate([[0], np.cumsum(sizes)[:-1]]))
    words = {"OFFSETS": starts, "INPUTS": str(sum(sizes)), "OUTPUTS": str(schedule.output_size), "FUNCTION": "forward"}
    loop = _LOOP
    for word, value in words.items():
        loop = loop.replace(word, value)
    library, seconds = build(c_text(inlined(schedule, "forward")) + loop, flags, patience)
    library.many.restype = None
    return library.many, seconds
