"""A study that is killed twenty times at random moments: the table that it gives in the end, and what was repeated.

    python -m benchmarks.study_resume [--kills 20] [--seed 0] [--runs 20000]

The command is killed (SIGKILL) after a random time, and started again, until it has been killed so often; then it runs
to its end. Every column but ``seconds`` must equal that of a run that nothing has disturbed, and no block may change.
"""

from __future__ import annotations

import argparse
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

STUDY = """\
format: 1
kind: study
name: resume
robot: filipovic2010
set: {{integration.output_step: 0.01, integration.relative_tolerance: 1e-7}}
parameters:
  gear: {{path: gear.stiffness, relative: true, distribution: {{type: uniform, low: 0.8, high: 1.2}}}}
  payload: {{path: payload.mass, relative: true, distribution: {{type: uniform, low: 0.9, high: 1.1}}}}
plan: {{type: monte_carlo, runs: {runs}, seed: 0}}
quantities:
  peak: {{series: deviation, reduce: max, unit: mm}}
  end: {{series: deviation, reduce: end, unit: mm}}
block: 128
"""


def command(sheet: Path, out: Path) -> list[str]:
    return [sys.executable, "-m", "tmodes.cli.entry", "study", str(sheet), "--out", str(out), "--no-page"]


def stored(out: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in (out / "blocks").glob("*.block")}


def killed(line: list[str], seconds: float) -> bool:
    """Whether the command still ran after so long, and was killed."""
    process = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        return True
    return False


def table(out: Path) -> dict[str, list[object]]:
    import pyarrow.parquet as pq

    return pq.read_table(out / "table.parquet").sort_by("case").drop_columns("seconds").to_pydict()


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--runs", type=int, default=20000)
    asked = parser.parse_args()
    draws = random.Random(asked.seed)  # noqa: S311 - moments, not secrets
    with tempfile.TemporaryDirectory() as folder:
        sheet, whole, cut = (Path(folder) / name for name in ("resume.yaml", "whole", "cut"))
        sheet.write_text(STUDY.format(runs=asked.runs))
        began = time.monotonic()
        subprocess.run(command(sheet, whole), check=True, stdout=subprocess.DEVNULL)
        length = time.monotonic() - began
        print(f"undisturbed: {length:.1f} s, {len(stored(whole))} blocks")
        before: dict[str, bytes] = {}
        kills = lost = 0
        while kills < asked.kills:
            moment = draws.uniform(0.0, 2.0 * length / asked.kills + 2.0)
            if not killed(command(sheet, cut), moment):
                print("it came to its end before it was killed often enough: give more --runs")
                break
            kills += 1
            now = stored(cut)
            lost += any(now.get(name) != content for name, content in before.items())
            before = now
            print(f"kill {kills} after {moment:.2f} s: {len(now)} blocks")
        subprocess.run(command(sheet, cut), check=True, stdout=subprocess.DEVNULL)
        same, names = table(cut) == table(whole), stored(cut).keys() == stored(whole).keys()
        print(f"{kills} kills: blocks that changed: {lost}; same blocks: {names}; same table but for seconds: {same}")
        sys.exit(0 if same and names and not lost else 1)


if __name__ == "__main__":
    main()
