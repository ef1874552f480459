"""As many lanes as a vector of this processor holds: eight doubles where it has AVX-512, else four.

What a lane computes does not depend on how many are next to it.
"""

from __future__ import annotations

from typing import Any

import llvmlite.binding as llvm
from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.emit import F64

__all__ = ["Wide"]


class Wide(Lanes):
    """Doubles side by side, as many as run at once."""

    stride = 8 if dict(llvm.get_host_cpu_features()).get("avx512f") else 4
    name = f"wide{stride}"
    kind: Any = ir.VectorType(F64, stride)
