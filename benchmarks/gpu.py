"""The code of cases on a GPU: its size, what an assembler makes of it, and, where there is a GPU, its speed.

    python -m benchmarks.gpu [--cases 1000000] [--target sm_90]

First a table of robots and methods: kilobytes of PTX; of a thread the registers, bytes of stack (its own arrays and
what functions keep there) and bytes that were spilled. It needs ``ptxas`` (on PATH, named by TMODES_PTXAS, or of the
package nvidia-cuda-nvcc-cu12). Then the 2010 robot over 2 s, its gear, payload and link varied: runs a second on the
GPU, the same on all cores of the processor for a thousandth of the cases, and how far their ends are apart.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from benchmarks.assembler import NONE, assembled

from tmodes.compile.gpu.cuda import first_gpu, unavailable
from tmodes.equations.loop.outputs import OWN, Output, Outputs
from tmodes.robots.load import load
from tmodes.simulation.batch.executor import PROCESSOR, thread_count
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.gpu.run import run_on_gpu
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import sample_times
from tmodes.simulation.problem import Problem
from tmodes.simulation.vary.simulate import prepared

ROBOTS = ("filipovic2010", "spong1987", "flexarm1990", "deluca_siciliano1991")
METHODS = ("dormand_prince", "dop853", "rk4", "reduced")
"""The last one: dormand_prince with four series that are reduced in place of samples that are kept."""

VARIED = {"gear.stiffness": 0.2, "payload.mass": 0.1, "link.modes.1.bending_stiffness": 0.05}
"""Paths, and by which share they differ at most."""


def shown(model: LoopModel) -> tuple[Output, ...]:
    """Outputs of which a kernel is made: a place, a speed, an effort, and a distance of the tip."""
    outputs = Outputs(model.loop, (OWN,))
    names = ("tip.x", "tip.speed", f"{model.plan.drives[0].joint}.effort", OWN)
    return tuple(outputs[name] for name in names)


def table(target: str) -> None:
    """What an assembler makes of each robot and method."""
    print(f"{'robot':22}{'method':16}{'PTX kB':>8}{'registers':>11}{'stack B':>9}{'spilled B':>11}")
    with tempfile.TemporaryDirectory() as folder:
        for robot in ROBOTS:
            model = run_setup(load(robot)).model
            for method in METHODS:
                reduced = method == "reduced"
                if reduced:
                    loop = model.lean_case_loop(METHODS[0], shown(model), 3, folds=True)
                else:
                    loop = model.case_loop(method)
                ptx = loop.ptx()
                found = assembled(ptx, target, Path(folder))
                if found is None:
                    print(NONE.format(target))
                    return
                sizes = f"{found.registers:11}{found.stack:9}{found.spilled:11}"
                print(f"{robot:22}{method:16}{len(ptx) / 1000:8.0f}{sizes}", flush=True)


def works(count: int) -> list[Problem]:
    """Cases of the 2010 robot, of which the start and the end are kept."""
    robot, rng = load("filipovic2010"), np.random.default_rng(1)
    kept = robot.integration.model_copy(update={"output_step": robot.integration.duration})
    robot = robot.model_copy(update={"integration": kept})
    vary = {f"real.{path}": 1 + share * rng.uniform(-1, 1, count) for path, share in VARIED.items()}
    groups, times = prepared(robot, vary).groups, sample_times(kept)
    room = np.empty((count, len(times), groups[0].starts.shape[1]))
    return [group.work(room) for group in groups]


def timed(what: Callable[[], object]) -> float:
    """Seconds that something takes."""
    began = time.perf_counter()
    what()
    return time.perf_counter() - began


def speed(count: int) -> None:
    """Runs a second here and there."""
    few = max(count // 1000, 1000)
    given, same, some, device = works(count), works(few), works(few), first_gpu()
    run_on_gpu(
        same, CaseResults.of_all(few), device=device
    )  # its code is made here, that of the processor in the next line
    PROCESSOR.run(works(1), CaseResults.of_all(1), 1, lambda share: None)
    there = timed(lambda: run_on_gpu(given, CaseResults.of_all(count), device=device))
    ends = CaseResults.of_all(few)
    here = timed(lambda: PROCESSOR.run(some, ends, thread_count(None), lambda share: None))
    print(f"GPU: {count} cases in {there:.3g} s, {count / there:.3g} a second")
    print(f"processor: {few} cases in {here:.3g} s, {few / here:.3g} a second; ratio {count / there * here / few:.3g}")
    one, other = (np.concatenate([work.states[work.places, -1] for work in each]) for each in (same, some))
    print(
        f"largest difference at the end over the largest state: {np.abs(one - other).max() / np.abs(other).max():.2g}"
    )


def main() -> None:
    """Print both."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.gpu", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--cases", type=int, default=1_000_000)
    parser.add_argument("--target", default="sm_90")
    given = parser.parse_args()
    table(given.target)
    reason = unavailable()
    print(f"no speed: {reason}") if reason else speed(given.cases)


if __name__ == "__main__":
    main()
