"""NVIDIA's assembler, where this machine has one, and what it says about a kernel."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sysconfig
from functools import cache
from pathlib import Path
from typing import NamedTuple

__all__ = ["NONE", "Assembled", "assembled"]

_WHEELS = ("nvidia/cuda_nvcc/bin/ptxas", "nvidia/cu13/bin/ptxas")
"""Where the wheels nvidia-cuda-nvcc-cu12 and nvidia-cuda-nvcc put it."""

NONE = (
    "needs NVIDIA's assembler ptxas, on PATH, named by TMODES_PTXAS, or of "
    "`pip install nvidia-cuda-nvcc-cu12` (40 MB); none that knows {} is here"
)
"""What is said where there is none."""


class Assembled(NamedTuple):
    """Of a kernel: registers of a thread, bytes of its stack, and bytes that were spilled, functions included."""

    registers: int
    stack: int
    spilled: int


@cache
def _assemblers() -> list[str]:
    named = [os.environ.get("TMODES_PTXAS"), shutil.which("ptxas")]
    packages = Path(sysconfig.get_path("purelib"))
    named += [str(packages / place) for place in _WHEELS if (packages / place).exists()]
    return [one for one in named if one]


@cache
def _assembler(target: str, folder: Path) -> str:
    """One that knows a target: newer ones forget the oldest."""
    probe = folder / "probe.ptx"
    probe.write_text(".version 6.0\n.target sm_70\n.address_size 64\n.visible .entry run() { ret; }\n")
    for one in _assemblers():
        line = [one, f"-arch={target}", str(probe), "-o", str(folder / "probe.cubin")]
        if subprocess.run(line, capture_output=True, check=False).returncode == 0:
            return one
    return ""


def assembled(ptx: str, target: str, folder: Path) -> Assembled | None:
    """What the assembler makes of a kernel; None where there is none that knows the target."""
    tool = _assembler(target, folder)
    if not tool:
        return None
    (folder / "run.ptx").write_text(ptx)
    line = [tool, f"-arch={target}", "-v", str(folder / "run.ptx"), "-o", str(folder / "run.cubin")]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    assert "warning" not in said, said  # of a stack whose size is unknown: something calls itself
    (registers,), (stack,) = (
        [int(number) for number in re.findall(pattern, said)]
        for pattern in (r"Used (\d+) registers", r"(\d+) bytes cumulative stack")
    )
    return Assembled(registers, stack, sum(int(number) for number in re.findall(r"(\d+) bytes spill stores", said)))
