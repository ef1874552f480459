"""What a user waits for: whole commands, of this version and of another one, in turn.

    python -m benchmarks.wait [--against FOLDER] [--rounds 5] [--robots filipovic2010,...] [--json FILE]

``--against``: the sources of the other version, ``src`` of a checkout (``git worktree add ../before REV``); the same
interpreter and packages run both. Each round makes every command once with each version, with an empty cache of
compiled code and with a full one; medians of wall and processor time [s], the ratio of processor times, and the ratio
to a Python that imports NumPy and CasADi, which no command that computes can do without.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .page_robots import long_arm

ROBOTS = ("filipovic2010", "spong1987", "flexarm1990", "ur5_elastic", "60 coordinates")
READING = ("check", "modes", "describe", "show")
IMPORTS = "import numpy, casadi"
NEWER = "error_estimate:", "model_error:"
"""Keys at their defaults that an earlier version does not know."""

HERE = Path(__file__).resolve().parents[1] / "src"


def spent(command: Sequence[str], source: Path, cache: Path) -> tuple[float, float]:
    """Wall and processor time [s] of a command, with its children; it must end with 0."""
    path = os.pathsep.join(filter(None, (str(source), os.environ.get("PYTHONPATH"))))
    environment = os.environ | {"PYTHONPATH": path, "TMODES_CACHE": str(cache)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed package has its bytecode
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        raise SystemExit(f"{' '.join(command)}: exit {done.returncode}\n{done.stderr}")
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Race:
    """Both versions, their caches, and what each command took."""

    def __init__(self, folder: Path, versions: dict[str, Path]) -> None:
        self.folder, self.versions, self.found = folder, versions, {}

    def lap(self, name: str, version: str, cache: str, *command: str) -> None:
        place = self.folder / f"cache of {version}"
        if cache == "empty":
            shutil.rmtree(place, ignore_errors=True)
        place.mkdir(mode=0o700, exist_ok=True)
        times = spent(command, self.versions[version], place)
        self.found.setdefault((name, cache), {}).setdefault(version, []).append(times)

    def round(self, robots: Sequence[str]) -> None:
        """Each command once with each version."""
        tmodes = (sys.executable, "-m", "tmodes")
        for robot in robots:
            sheet = self.sheet(robot)
            for version in self.versions:
                out = str(self.folder / f"{robot} {version}")
                for cache in ("empty", "full"):
                    self.lap(f"run {robot}", version, cache, *tmodes, "run", sheet, "--out", out, "--overwrite")
        for version in self.versions:
            for name in READING:
                what = str(self.folder / f"{robots[0]} {version}") if name == "show" else self.sheet(robots[0])
                self.lap(f"{name} {robots[0]}", version, "full", *tmodes, name, what)
            self.lap("run --help", version, "full", *tmodes, "run", "--help")
            self.lap(IMPORTS, version, "full", sys.executable, "-c", IMPORTS)

    def sheet(self, robot: str) -> str:
        if robot != "60 coordinates":
            return robot
        path = self.folder / "sixty.yaml"
        if not path.exists():
            from tmodes.io.sheet_write import robot_to_yaml

            lines = robot_to_yaml(long_arm().with_({"integration.duration": 2.0})).splitlines()
            known = [line for line in lines if not line.strip().startswith(NEWER)]
            path.write_text("\n".join(known), encoding="utf-8")
        return str(path)

    def _imports(self) -> float:
        """Processor time [s] of importing NumPy and CasADi."""
        return statistics.median(cpu for _, cpu in self.found[IMPORTS, "full"]["this"])

    def rows(self) -> list[dict[str, Any]]:
        """Medians by command and cache."""
        found = []
        for (name, cache), times in self.found.items():
            row: dict[str, Any] = {"command": name, "cache": cache}
            for version, each in times.items():
                row[version] = {
                    "wall": statistics.median(w for w, _ in each),
                    "cpu": statistics.median(c for _, c in each),
                }
            if len(times) == 2:
                row["ratio"] = row["this"]["cpu"] / row["other"]["cpu"]
            row["imports"] = row["this"]["cpu"] / self._imports()
            found.append(row)
        return found


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--against", type=Path, help="`src` of a checkout of another version")
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--robots", default=",".join(ROBOTS))
    options.add_argument("--json", type=Path, help="also write the numbers to this file")
    given = options.parse_args()
    versions = {"this": HERE} | ({"other": given.against.resolve()} if given.against else {})
    with tempfile.TemporaryDirectory(prefix="tmodes-wait-") as folder:
        race = Race(Path(folder), versions)
        for k in range(given.rounds):
            race.round(given.robots.split(","))
            print(f"round {k + 1} of {given.rounds}", file=sys.stderr)
    rows = race.rows()
    print(
        f"{'command':28} {'cache':6} "
        + " ".join(f"{name + ' wall':>11} {name + ' cpu':>10}" for name in versions)
        + "      ratio to imports"
    )
    for row in rows:
        times = " ".join(f"{row[name]['wall']:11.2f} {row[name]['cpu']:10.2f}" for name in versions if name in row)
        ratios = " ".join(f"{row.get(name, float('nan')):10.2f}" for name in ("ratio", "imports"))
        print(f"{row['command']:28} {row['cache']:6} {times} {ratios}")
    if given.json:
        given.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
