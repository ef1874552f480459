"""One whole benchmark: every contender at every size, the cost of a start, the limits, and runs at equal error."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from benchmarks.engines import gcc
from benchmarks.engines.contender import CHECKED, Contender, PeerMissing, Runner, Timed, at_equal_error, in_turns
from benchmarks.engines.limit import limit, machine
from benchmarks.engines.ours import SAMPLES, Ours, cores
from benchmarks.engines.peers import ENGINES
from benchmarks.engines.rigid import RigidChain, accelerations, relative_error
from benchmarks.engines.runs import ChainRun, Run, SeedRun
from benchmarks.engines.start import started
from benchmarks.engines.tables import exponents

__all__ = ["FORMAT", "PEERS", "SIZES", "Plan", "described", "measured"]

_PACKAGES = ("casadi", "llvmlite", "numpy", "scipy", "pin", "mujoco", "exudyn")


def described() -> dict[str, object]:
    """Processor, cores, system, load, versions, and the date (UTC)."""
    import tmodes

    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d"),
        "processor": _processor(),
        "cores": cores(),
        "load": list(os.getloadavg()) if hasattr(os, "getloadavg") else [],
        "system": f"{platform.system()} {platform.machine()}",
        "python": sys.version.split()[0],
        "tmodes": tmodes.__version__,
        **{name: found for name in _PACKAGES if (found := _version(name))},
    }


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _processor() -> str:
    """The name that the system gives it, with the name that LLVM gives its architecture."""
    from tmodes.compile.native import processor

    info = ""
    if sys.platform == "linux":
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
        info = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    return f"{info or platform.processor() or platform.machine()} ({processor()})"


FORMAT = 1
"""Version of what :func:`measured` returns."""

SIZES = (6, 12, 36, 102, 200)
"""Joints of the rigid chains that are measured by default."""

PEERS = ("gcc", "pinocchio", "mujoco", "exudyn", "scipy")
"""Others that can be compared with this engine."""

LARGEST = 200
"""Joints above which no straight list is written and no whole runs are raced: that would take minutes."""

Tell = Callable[[str, float], None]


@dataclass(frozen=True)
class Plan:
    """What is measured: joints of the chains, rounds of each, which peers, and whether whole runs are raced too.

    ``patience``: seconds after which the C compiler is given up.
    """

    sizes: Sequence[int] = SIZES
    rounds: int = 9
    peers: Sequence[str] = PEERS
    runs: bool = True
    patience: float = gcc.PATIENCE


def measured(plan: Plan, tell: Tell = lambda stage, share: None) -> dict[str, Any]:
    """All figures, as JSON knows them: times in seconds, errors next to them. ``tell`` hears stage and share done."""
    here = machine()
    info: dict[str, Any] = {"format": FORMAT, "machine": described(), "rounds": plan.rounds, "samples": SAMPLES}
    info["operations"] = {"cycle": here.cycle, "latency": here.latency, "cost": here.cost}
    info["sizes"] = [_size(plan, n, tell) for n in plan.sizes]
    info["scaling"] = exponents(info["sizes"])
    if plan.runs:
        info["seed"] = _raced(plan, SeedRun(), (), lambda share: tell("the 2010 robot", share))
    return info


def _size(plan: Plan, joints: int, tell: Tell) -> dict[str, Any]:
    """One length of the chain."""
    stage = f"{joints} joints"
    robot, left_out = RigidChain(joints), {}
    ours = Ours(robot)
    contenders = [*ours.contenders()]
    for name in plan.peers:
        try:
            contenders += _peers(name, ours, plan.patience)
        except PeerMissing as missing:
            left_out[name] = str(missing)
    times = in_turns(contenders, plan.rounds, lambda share: tell(stage, 0.8 * share))
    found = {
        "n": joints, "contenders": _judged(robot, contenders, times), "left_out": left_out,
        "start": started(joints), "limit": asdict(limit(ours.schedule)) if joints <= LARGEST else None,
    }  # fmt: skip
    tell(stage, 1.0)
    if plan.runs and joints <= LARGEST:
        found["runs"] = _chain_runs(plan, robot, lambda share: tell(f"{joints} joints, runs", share))
    return found


def _peers(name: str, ours: Ours, patience: float) -> list[Contender]:
    if name == "gcc" and ours.robot.joints > LARGEST:
        raise PeerMissing(f"above {LARGEST} joints")
    if name == "gcc":
        return [gcc.contender(ours, way, patience) for way in gcc.FLAGS]
    return [ENGINES[name](ours.robot)] if name in ENGINES else []


def _judged(robot: RigidChain, contenders: list[Contender], times: dict[str, list[float]]) -> list[dict[str, Any]]:
    """Each contender's time with its error against extended precision."""
    q, v = robot.states(SAMPLES)
    exact = accelerations(robot, q[:CHECKED], v[:CHECKED])
    return [
        {
            "name": one.name, "seconds": asdict(Timed.of(times[one.name])), "cores": one.cores,
            "error": relative_error(one.found(), exact), "compile": one.compile_seconds,
        }
        for one in contenders
    ]  # fmt: skip


def _chain_runs(plan: Plan, robot: RigidChain, tell: Callable[[float], None]) -> dict[str, Any]:
    """The falling chain at equal error."""
    run, peers = ChainRun(robot), []
    try:
        peers = [*run.peers()] if "mujoco" in plan.peers else []
    except PeerMissing:
        tell(0.0)  # already named as left out
    return _raced(plan, run, peers, tell)


def _raced(plan: Plan, run: Run, peers: Sequence[Runner], tell: Callable[[float], None]) -> dict[str, Any]:
    own = [one for one in run.runners() if "scipy" in plan.peers or not one.name.startswith("SciPy")]
    races = at_equal_error([*own, *peers], run.error, run.duration, max(3, plan.rounds // 2), tell)
    return {"error": run.error, "unit": run.unit, "duration": run.duration, "races": [asdict(race) for race in races]}
