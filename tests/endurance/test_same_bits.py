"""The same numbers to the last bit: in every process, whatever its surroundings, and on every thread."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from benchmarks.engines.ours import Ours
from benchmarks.engines.rigid import RigidChain

from tmodes.compile import cache
from tmodes.compile.ir.arithmetic import Wide

from .scale import often

SURROUNDINGS: tuple[dict[str, str], ...] = (
    {"PYTHONHASHSEED": "0", "TZ": "UTC", "LC_ALL": "C", "OPENBLAS_NUM_THREADS": "1"},
    {"PYTHONHASHSEED": "1", "TZ": "Asia/Tokyo", "LC_ALL": "C.UTF-8", "OPENBLAS_NUM_THREADS": "2"},
    {"PYTHONHASHSEED": "77", "TZ": "America/St_Johns", "LC_ALL": "de_DE.UTF-8", "OPENBLAS_NUM_THREADS": "2"},
)

RUN = """
import hashlib, sys
import numpy as np
from benchmarks.engines.runs import ChainRun
from benchmarks.engines.rigid import RigidChain
run = ChainRun(RigidChain(2))
runs = {"method": "dormand_prince", "relative_tolerance": 1e-13}, {"method": "rk4", "step": run.duration / 100}
states = b"".join(run.ours(**settings)[1].tobytes() for settings in runs)
print(hashlib.sha256(states).hexdigest())
"""


def digest_of(surroundings: dict[str, str], place: Path) -> tuple[str, dict[str, str]]:
    """Digests of two runs of a chain, and of all that was compiled for them."""
    environment = os.environ | surroundings | {"TMODES_CACHE": str(place)}
    done = subprocess.run([sys.executable, "-c", RUN], env=environment, capture_output=True, text=True, check=True)
    codes = {
        file.name: file.read_bytes()[cache._START :] for file in place.glob("*.o")
    }  # behind each folder's own seal
    return done.stdout, {name: hashlib.sha256(code).hexdigest() for name, code in codes.items()}


def test_surroundings_change_no_bit(tmp_path: Path) -> None:
    """Seed of hashes, time zone, language, threads of libraries; code just compiled, or from the cache."""
    first = digest_of(SURROUNDINGS[0], tmp_path / "0")
    assert first[1]
    assert digest_of(SURROUNDINGS[1], tmp_path / "0") == first
    for number, surroundings in enumerate(SURROUNDINGS[1:], 1):
        assert digest_of(surroundings, tmp_path / str(number)) == first


def test_threads_change_no_bit() -> None:
    """The same batch on one thread, and on eight at once."""
    ours = Ours(RigidChain(3))
    once, alone = ours.batch(Wide.name)
    once()
    batches = [ours.batch(Wide.name) for _ in range(8)]
    with ThreadPoolExecutor(8) as pool:
        for _ in range(often(3, 1000)):
            for _, out in batches:
                out.fill(np.nan)
            list(pool.map(lambda batch: batch[0](), batches))
            assert all(np.array_equal(out, alone) for _, out in batches)
