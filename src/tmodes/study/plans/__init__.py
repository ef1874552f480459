"""Which cases a study runs; importing the package registers all plans."""

from tmodes.study.plans import sampling, sensitivity, systematic
from tmodes.study.plans.contract import PLANS, Design, Plan

__all__ = ["PLANS", "Design", "Plan", "sampling", "sensitivity", "systematic"]
