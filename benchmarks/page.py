"""The speed of a page: from a slider to the picture, what its module costs, a long run, and how equal its runs are.

    python -m benchmarks.page [--parts sliders,modules,long,equal] [--changes 12] [--json FILE] [--write]

Reports as ``tmodes run`` leaves them, opened from a file in headless Chromium, which draws in software here: a graphics
processor is faster in all that is drawn. The same model runs in Node. What needs a browser or Node is left out where
there is none, with a sentence. ``--write`` puts the tables into docs/report.md, each between its marks; times by the
wall want a machine that does nothing else. Some five minutes, most of them for the long run.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.live.bundle import live_bundle
from tmodes.report.charts import page_charts

from .page_browser import changes, played
from .page_equal import FINE, equality
from .page_modules import module_of
from .page_node import Missing, in_node, read_page
from .page_robots import ROBOTS, progress, result_of, written

Rows = Iterator[tuple[str, ...]]

PAGE = Path(__file__).resolve().parents[1] / "docs" / "report.md"
END = "<!-- end -->"


class Bench:
    """Results and reports, made once."""

    def __init__(self, folder: Path, count: int) -> None:
        self.folder, self.count = folder, count
        self._results: dict[str, Any] = {}
        self._reports: dict[str, Path] = {}

    def result(self, name: str) -> Any:
        if name not in self._results:
            with progress(f"simulating: {ROBOTS[name][0]}"):
                self._results[name] = result_of(ROBOTS[name][1]())
        return self._results[name]

    def report(self, name: str) -> Path:
        if name not in self._reports:
            result = self.result(name)
            with progress(f"writing its report: {ROBOTS[name][0]}"):
                self._reports[name] = written(result, self.folder / f"{name.replace(' ', '_')}.html")
        return self._reports[name]


def _ms(values: Sequence[float]) -> str:
    """Median and range [ms]."""
    median, least, most = (f"{1e3 * x:,.0f}" if x > 0.1 else f"{1e3 * x:.3g}" for x in _spread(values))
    return f"{median} ({least} – {most})"


def _spread(values: Sequence[float]) -> tuple[float, float, float]:
    return statistics.median(values), min(values), max(values)


def sliders(bench: Bench) -> Rows:
    """From a slider to the picture."""
    yield f"Slider moved {bench.count} times [ms]: median (range)", "seed's robot, 2 s", "54 coordinates, 1 s"
    names = ("seed", "stiff")
    alone = [_in_node(bench, name) for name in names]
    for label, key in (
        ("model in Node, time loops", "loops"),
        ("model in Node, to the curves", "curves"),
        ("model in Node, with what comes later (settling, modes, parts)", "total"),
        ("the same, time of all processors", "processor"),
    ):
        yield label, *(_ms([run[key] for run in runs]) for runs in alone)
    found = [_in_browser(bench, name) for name in names]
    for label, what in (
        ("in the page: time loops, as it reports", lambda change: change.loops),
        ("in the page: the model's answer is there", lambda change: change.answer),
        ("in the page: new curves and numbers", lambda change: change.curves),
        ("in the page: new picture in 3D, its script done", lambda change: change.picture),
        ("of which drawing of charts and numbers", lambda change: change.curves - change.answer),
        ("of which the 3D picture, with the wait for it", lambda change: change.picture - change.curves),
    ):
        yield label, *(_ms([what(change) for change in runs]) for runs in found)
    flat = [_in_browser(bench, name, lines=True) for name in names]
    for label, what in (
        ("without WebGL, drawn in lines: the model's answer is there", lambda change: change.answer),
        ("without WebGL, drawn in lines: new curves and numbers", lambda change: change.curves),
    ):
        yield label, *(_ms([what(change) for change in runs]) for runs in flat)


def _in_node(bench: Bench, name: str) -> list[dict[str, Any]]:
    bundle = live_bundle(bench.result(name))
    assert bundle is not None, name
    first = [slider["value"] for slider in bundle["sliders"]]
    jobs = [[first[0] * (1 + 0.01 * k), *first[1:]] for k in range(bench.count + 2)]
    with progress(f"model in Node: {ROBOTS[name][0]}"):
        return in_node(bundle, jobs, bench.folder)[2:]


def _in_browser(bench: Bench, name: str, *, lines: bool = False) -> list[Any]:
    report = bench.report(name)
    with progress(f"in Chromium{', without WebGL' if lines else ''}: {ROBOTS[name][0]}"):
        return changes(report, bench.count, lines=lines)


def modules(bench: Bench) -> Rows:
    """What the equations cost in a page."""
    yield "Equations as WebAssembly", "module [kB]", "compressed [kB]", "of the page", "made in [s]"
    for name in ("seed", "two links", "stiff"):
        result, page = bench.result(name), bench.report(name).stat().st_size
        with progress(f"module: {ROBOTS[name][0]}"):
            info = module_of(name, result.statistics["real"]["method"])
        share = f"{info.text / page:.0%} of {page / 1e6:.2f} MB"
        yield ROBOTS[name][0], f"{info.raw / 1e3:.1f}", f"{info.packed / 1e3:.1f}", share, f"{info.seconds:.2f}"


def long(bench: Bench) -> Rows:
    """A long run of a large arm."""
    result, report = bench.result("long"), bench.report("long")
    yield f"Report of the {ROBOTS['long'][0]}", ""
    yield "size", f"{report.stat().st_size / 1e6:.1f} MB"
    yield from _extremes(result, read_page(report, bench.folder))
    with progress(f"in Chromium: {ROBOTS['long'][0]}"):
        info = played(report)
    yield "opened, first picture drawn", f"{info.opened:.1f} s"
    yield "plays, drawn in software", f"{info.rate:.0f} frames/s"
    yield "script of a frame", f"{1e3 * info.script:.1f} ms"


def _extremes(result: Any, charts: list[dict[str, Any]]) -> Rows:
    """Of all charts over time: what is drawn, and how far its extremes are from those of all samples."""
    whole = {chart.id: chart for chart in page_charts(result)}
    worst, curves = 0.0, 0
    timed = [chart for chart in charts if chart["abscissa"] == "time"]
    for chart in timed:
        for line, info in zip(whole[chart["id"]].lines, chart["extremes"], strict=True):
            true = np.array([line.values.min(), line.values.max()])
            unit = 10.0 ** np.round(np.log10(np.abs(info).max() / np.abs(true).max())) if true.any() else 1.0
            worst = max(worst, float(np.abs(np.array(info) / unit - true).max() / (np.abs(true).max() or 1.0)))
            curves += 1
    drawn = [chart["drawn"] for chart in timed]
    yield "samples, of them drawn", f"{max(chart['samples'] for chart in timed):,}, {min(drawn):,} – {max(drawn):,}"
    yield f"extremes of {curves} curves, largest difference over the largest value", f"{worst:.0e}"


def equal(bench: Bench) -> Rows:
    """How equal the page's runs are to the native ones."""
    yield (
        "Largest difference of any series, over its largest value",
        "unchanged",
        "of ten others: median",
        "largest",
    )
    seed = ROBOTS["seed"][1]()
    for label, robot in (("at the sheet's tolerance of 1e-9", seed), ("at 1e-12", seed.with_(FINE))):
        with progress(f"page and native runs {label}"):
            first, *others = equality(robot, bench.folder)
        for who, what in (
            ("page and native run", lambda one: one.page),
            ("native run and its last digit", lambda one: one.native),
        ):
            few = [what(one) for one in others]
            yield f"{who}, {label}", f"{what(first):.0e}", f"{statistics.median(few):.0e}", f"{max(few):.0e}"


PARTS: dict[str, Callable[[Bench], Rows]] = {"sliders": sliders, "modules": modules, "long": long, "equal": equal}


def _table(rows: Rows) -> list[list[str]]:
    """As far as what is needed is there."""
    found: list[list[str]] = []
    try:
        found.extend(list(row) for row in rows)
    except Missing as missing:
        found.append([f"left out: {missing}"])
    return found


def _markdown(table: list[list[str]]) -> str:
    head, *rows = table
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(row)} |" for row in lines)


def _machine() -> str:
    """In general words, with what else ran on it."""
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0
    busy = f"; **{load:.1f} other programs were running, so times say little**" if load > 0.5 else ""
    return f"{os.cpu_count()} cores, drawn in software{busy}."


def main() -> None:
    """Measure, print, and write."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--parts", default=",".join(PARTS))
    options.add_argument("--changes", type=int, default=12)
    options.add_argument("--json", help="also write the tables to this file")
    options.add_argument("--write", action="store_true", help="put the tables into docs/report.md")
    chosen = options.parse_args()
    machine = _machine()
    print(machine, flush=True)
    if chosen.write:
        _write("machine", machine)
    tables: dict[str, list[list[str]]] = {}
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder), chosen.changes)
        for name in chosen.parts.split(","):
            tables[name] = _table(PARTS[name](bench))
            print(f"\n{_markdown(tables[name])}", flush=True)
            if chosen.write:
                _write(name, _markdown(tables[name]))
    if chosen.json:
        Path(chosen.json).write_text(json.dumps({"machine": machine, "tables": tables}, indent=1))


def _write(name: str, text: str) -> None:
    """Between ``<!-- figures: NAME -->`` and the next end."""
    before, mark, rest = PAGE.read_text(encoding="utf-8").partition(f"<!-- figures: {name} -->")
    after = rest.partition(END)[2]
    PAGE.write_text(f"{before}{mark}\n\n{text}\n\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
