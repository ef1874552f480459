"""From a slider of a page to its curves: the median of 20 changes in headless Chromium, for each robot that is named.

    python -m benchmarks.page_change [--changes 20] [ROBOT ...]

Compare versions by alternating runs on one machine: times by the wall depend on what else runs.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
from pathlib import Path

from tmodes import load, run

from .page_browser import changes
from .page_robots import written


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("robots", nargs="*", default=["filipovic2010", "spong1987"])
    options.add_argument("--changes", type=int, default=20)
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name in chosen.robots:
            moved = changes(written(run(load(name)), Path(folder) / f"{name}.html"), chosen.changes)
            for what in ("loops", "answer", "curves", "picture"):
                values = [1e3 * getattr(change, what) for change in moved]
                print(f"{name:16} {what:8} median {statistics.median(values):6.1f} ms, least {min(values):6.1f} ms")


if __name__ == "__main__":
    main()
