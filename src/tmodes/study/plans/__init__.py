"""Which cases a study runs: one file for each plan; importing the package registers them."""

from tmodes.study.plans import (
    grid,
    latin_hypercube,
    list_of_cases,
    monte_carlo,
    morris,
    one_at_a_time,
    random,
    saltelli,
    sobol,
    tolerance,
)
from tmodes.study.plans.contract import PLANS, Design, Plan

__all__ = [
    "PLANS", "Design", "Plan", "grid", "latin_hypercube", "list_of_cases", "monte_carlo", "morris",
    "one_at_a_time", "random", "saltelli", "sobol", "tolerance",
]  # fmt: skip
