"""The loop over cases of one structure by one method: PTX for a GPU, and native code to check it without one."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib.metadata import version
from typing import Any

import llvmlite.binding as llvm

from tmodes.compile import cache as disk
from tmodes.compile.gpu.case_series import CaseSeries, kernels_of_series
from tmodes.compile.gpu.mathematics import mathematics_module
from tmodes.compile.gpu.one_case import CASE, CASE_ARGUMENTS, KERNEL, LOOP, case_module, write_kernel
from tmodes.compile.ir.kernels import library
from tmodes.compile.native import Library, for_target, free
from tmodes.compile.wasm.wasm_parts import schedule_loop
from tmodes.errors import CompileError

__all__ = ["LEAST_TARGET", "CaseLoop"]

TRIPLE = "nvptx64-nvidia-cuda"

LEAST_TARGET = "sm_70"
"""The oldest kind of GPU for which code is made; the driver turns it into that of any later kind."""

_LEVEL = 3


@cache
def _machine(target: str) -> Any:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    try:
        kind = llvm.Target.from_triple(TRIPLE)
    except RuntimeError as problem:
        raise CompileError(
            f"this llvmlite cannot write code for NVIDIA GPUs: {problem}; install one that can"
        ) from None
    return kind.create_target_machine(cpu=target, opt=_LEVEL)


@dataclass(frozen=True, eq=False)
class CaseLoop:
    """A schedule of rates with the method that integrates it; ``guarded``, ``more``: as of the loops of single runs.

    ``series``: what is wanted of the samples; None: the samples.
    """

    schedule: Any
    guarded: int
    method: str
    more: Mapping[str, Any] = field(default_factory=dict)
    series: CaseSeries | None = None

    @property
    def parameters(self) -> int:
        """Numbers of a case."""
        return self.schedule.parameters

    @property
    def size(self) -> int:
        """Numbers of a state."""
        return self.schedule.output_size

    @cached_property
    def key(self) -> str:
        """What identifies the code."""
        wanted = self.series.key if self.series else ""
        return f"{self.method} {self.guarded} {dict(self.more)} {self.schedule.key} {wanted}"

    def ptx(self, target: str = LEAST_TARGET) -> str:
        """The text of the kernel ``run(*CASE_ARGUMENTS)``, from the cache or made and kept.

        Raises :class:`tmodes.errors.CompileError` when LLVM refuses the code.
        """
        import llvmlite

        key = f"ptx {target} {llvmlite.__version__} {version('casadi')} {disk.source_digest()}\n{self.key}"
        found = disk.load(key)
        if found is None:
            found = self._ptx(target).encode()
            disk.save(key, found)
        return found.decode()

    def _ptx(self, target: str) -> str:
        machine = _machine(target)
        whole = self._linked(machine, kernel=True)
        builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=_LEVEL))
        passes = builder.getModulePassManager()
        passes.run(whole, builder)
        free(passes)
        return re.sub(r"\s*//.*", "", machine.emit_assembly(whole))  # its remarks count calls of the whole process

    def native(self, *, mathematics: bool = True) -> Library:
        """The same for this machine's processor: ``tmodes_case(thread, *CASE_ARGUMENTS)``.

        ``mathematics``: False takes the functions of the C library, as the loops of single runs do.
        """
        functions = {CASE: 1 + len(CASE_ARGUMENTS)}

        def write() -> str:
            return str(self._linked(None, kernel=False, mathematics=mathematics))

        return library("cases", f"cases mathematics={mathematics} {self.key}", write, functions, 1)

    def _linked(self, machine: Any, *, kernel: bool, mathematics: bool = True) -> Any:
        """All code in one module; only what is called from outside is seen there."""
        try:
            module = case_module(self.parameters, self.size, self.series)
            if kernel:
                write_kernel(module)
            texts = [str(module), *self._texts()]
            texts += [str(mathematics_module())] if mathematics else []
            whole, *others = (llvm.parse_assembly(for_target(text, machine) if machine else text) for text in texts)
            for other in others:
                whole.link_in(other)
            whole.verify()
        except RuntimeError as problem:
            raise CompileError(f"the loop of cases by {self.method}: LLVM refuses the code: {problem}") from problem
        for function in whole.functions:
            if not function.is_declaration and function.name != (KERNEL if kernel else CASE):
                function.linkage = llvm.Linkage.internal
        return whole

    def _texts(self) -> list[str]:
        """The loop of single runs and all kernels, each once."""
        parts = schedule_loop(LOOP, self.schedule, self.guarded, self.method, **self.more)
        known = {symbol for part in parts for symbol in part.symbols}
        more = [code for symbol, code in kernels_of_series(self.series).items() if symbol not in known]
        return [str(part.write()) for part in parts] + [str(code) for code in more]
