"""A kernel as a CasADi function."""

from __future__ import annotations

import casadi as ca

from tmodes.kinds.kernel.kernel import Kernel

__all__ = ["kernel_function"]


def kernel_function(kernel: Kernel) -> ca.Function:
    """The kernel as a CasADi function; common subexpressions are found."""
    symbols = [ca.SX.sym(f"i{k}", size) for k, size in enumerate(kernel.inputs)]
    results = [ca.vertcat(*map(ca.SX, entries)) for entries in kernel.build(*symbols)]
    for size, result in zip(kernel.outputs, results, strict=True):
        assert result.numel() == size, f"{kernel.key}: {result.numel()} numbers, expected {size}"  # noqa: S101
    dense = [ca.densify(result) for result in results]
    return ca.Function("kernel", symbols, dense, {"cse": True})
