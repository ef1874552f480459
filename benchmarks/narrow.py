"""A benchmark as on a processor with AVX2 only: vectors of four, sixteen of them, whatever this one has.

    python -m benchmarks.narrow benchmarks.batch [OPTIONS]
    python -m benchmarks.narrow tmodes.cli.entry bench [OPTIONS]

Code is made, and kept, for the features that the processor seems to have, so use a cache of its own (TMODES_CACHE).
"""

from __future__ import annotations

import runpy
import sys
from typing import Any

import llvmlite.binding as llvm


def narrow() -> None:
    """From here on LLVM hears of no AVX-512."""
    asked = llvm.get_host_cpu_features

    def features() -> Any:
        found: Any = asked()
        found.update({name: False for name in found if name.startswith(("avx512", "avx10"))})
        return found

    llvm.get_host_cpu_features = features


if __name__ == "__main__":
    del sys.argv[0]
    if not sys.argv or sys.argv[0] in ("-h", "--help"):
        sys.exit(__doc__)
    narrow()
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
