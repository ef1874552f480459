"""Which cases a study runs: one file for each plan; importing the package registers them."""

from tmodes.study.plans import monte_carlo
from tmodes.study.plans.contract import PLANS, Design, Plan

__all__ = ["PLANS", "Design", "Plan", "monte_carlo"]
