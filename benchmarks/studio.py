"""From a slider of the studio to a picture: the server's time by its parts, for changed numbers of one robot.

python -m benchmarks.studio [ROBOT] [--runs 15]
"""

from __future__ import annotations

import argparse
import copy
import os
import statistics
import time
from typing import Any

from tmodes.studio.pool import ONE_THREAD

os.environ.update(ONE_THREAD)  # as its workers have it, before anything loads NumPy

from tmodes import load, run
from tmodes.report.data import page_data
from tmodes.result.early import early_result
from tmodes.studio.sheets import plain_sheet, slider_records
from tmodes.studio.work import Workshop, drawn


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robot", nargs="?", default="filipovic2010")
    parser.add_argument("--runs", type=int, default=15)
    info = parser.parse_args()
    sheet = load(info.robot)
    data = plain_sheet(sheet)
    target = slider_records(sheet, data)[0]["targets"][0]
    series = drawn(page_data([early_result(run(sheet))], [sheet.name], light=True))  # what the page asks for
    workshop, laps, processor = Workshop(), [], []
    for k in range(info.runs + 2):
        began = time.process_time()
        answer = workshop.answer("change", moved(data, target, 1 + 0.01 * k), _silent, None, series)
        if k >= 2:  # what is loaded and compiled at the first runs is no part of a dragged slider
            laps.append(answer.info["seconds"])
            processor.append(time.process_time() - began)
    show(laps, processor)


def _silent(stage: str, share: float) -> None:
    del stage, share


def moved(data: dict[str, Any], target: dict[str, Any], factor: float) -> dict[str, Any]:
    """The sheet with the number of the first slider changed."""
    changed = copy.deepcopy(data)
    inner: Any = changed
    for step in target["steps"][:-1]:
        inner = inner[step]
    inner[target["steps"][-1]] = target["base"] * factor
    return changed


def show(laps: list[dict[str, float]], processor: list[float]) -> None:
    totals = [sum(value for name, value in lap.items() if name != "loops") for lap in laps]
    for name in laps[0]:
        values = [1e3 * lap[name] for lap in laps]
        print(f"{name:10} median {statistics.median(values):7.1f} ms, least {min(values):7.1f} ms")
    share = statistics.median(lap["loops"] / total for lap, total in zip(laps, totals, strict=True))
    print(f"{'together':10} median {1e3 * statistics.median(totals):7.1f} ms, least {1e3 * min(totals):7.1f} ms")
    print(f"{'processor':10} median {1e3 * statistics.median(processor):7.1f} ms")
    print(f"the loops are {share:.1%} of it")


if __name__ == "__main__":
    main()
