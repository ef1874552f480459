"""Time of one evaluation of the 2010 robot under control, by both makers of equations.

Run: python benchmarks/lagrange.py. The closed loop takes 40,000 steps of four evaluations each.
"""

from __future__ import annotations

import time

from tmodes.integrate.settings import Integration
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

STEPS = 40_000
DURATION = 2.0
ROUNDS = 8


def nanoseconds(robot: Robot) -> float:
    """Least time of one evaluation of the rate in a native loop."""
    setup = run_setup(robot)
    settings = Integration(method="rk4", duration=DURATION, output_step=DURATION, step=DURATION / STEPS)
    found = []
    for _ in range(ROUNDS):
        began = time.perf_counter()
        solve(problem_of(setup.model, setup.model.numbers, setup.planned.schedule, setup.start, settings))
        found.append(time.perf_counter() - began)
    return 1e9 * min(found) / (4 * STEPS)


if __name__ == "__main__":
    robot = load("filipovic2010").pair().real
    for equations in ("consistent", "printed", "recursion"):
        for contact in (robot.contact, None):
            case = robot.model_copy(update={"equations": equations, "contact": contact})
            print(f"{equations:10} {'contact' if contact else 'free':7} {nanoseconds(case):7.1f} ns")
