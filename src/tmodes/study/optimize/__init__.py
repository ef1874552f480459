"""The best design within limits: every one tried, searched for, or along gradients."""

from tmodes.study.optimize.result import Candidate, Held, Optimum
from tmodes.study.optimize.run import optimize

__all__ = ["Candidate", "Held", "Optimum", "optimize"]
