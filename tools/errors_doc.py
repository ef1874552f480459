"""Writes docs/errors.md from docs/errors.json: ``errors_doc.py [--check] [--measure FIRST LAST]``.

``--measure`` first makes the random runs of these seeds, each of every kind of robot by every method, and adds them to
build/errors.jsonl: an interrupted measurement continues there. The safety was chosen on seeds below 1000, and is
verified on those from 1000 on; both sets are on the page. ``--measure-models FIRST LAST`` makes those of the link
models alone, in build/model_errors.jsonl, and leaves what is known of the integration.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

import generated
from error_runs import FUNCTIONS, LINK_MODEL, LUMPED, LUMPS, METHODS, Case, cases, kept, measured, model_cases
from random_robots import KINDS
from tmodes.result.errors import SAFETY

__all__ = ["page", "summarised"]

RUNS, MODEL_RUNS = (generated.ROOT / "build" / name for name in ("errors.jsonl", "model_errors.jsonl"))
FIGURES = generated.ROOT / "docs" / "errors.json"
PAGE = generated.ROOT / "docs" / "errors.md"

FRESH = 1000
"""Seeds from here on verify the safety."""

LEAST = 1e-12
"""Share of a number's size below which its error is left out: rounding."""

QUANTILES = (0.01, 0.1, 0.5, 0.9)

Run = dict[str, Any]


def measure(asked: Iterator[list[Case]], file: Path) -> None:
    """Make the runs that the file does not have yet, one robot after the other."""
    file.parent.mkdir(exist_ok=True)
    known = {(run["kind"], run["seed"], run["method"]) for run in kept(file)}
    groups = [group for group in asked if group[0][:3] not in known]
    for k, group in enumerate(groups):
        lines = "".join(json.dumps(run) + "\n" for run in measured(group))
        with file.open("a", encoding="utf-8") as target:
            target.write(lines)
        print(f"{k + 1} of {len(groups)}: {group[0].kind} {group[0].seed}", file=sys.stderr, flush=True)


def summarised(runs: Sequence[Run]) -> dict[str, Any]:
    """What the page shows of both sets of runs."""
    parts = {"chosen": [r for r in runs if r["seed"] < FRESH], "verified": [r for r in runs if r["seed"] >= FRESH]}
    return {"safety": SAFETY} | {name: _of_set(part) for name, part in parts.items()}


def _of_set(runs: Sequence[Run]) -> dict[str, Any]:
    models = [run for run in runs if run["method"] not in METHODS]
    runs = [run for run in runs if run["method"] in METHODS]
    groups: dict[str, dict[str, Callable[[Run], bool]]] = {
        "all": {"all": lambda run: True, "all defaults": _is_default},
        "methods": {name: lambda run, name=name: run["method"] == name for name in METHODS},
        "kinds": {name: lambda run, name=name: run["kind"] == name for name in KINDS},
    }
    found = {title: {name: _figures([r for r in runs if asked(r)]) for name, asked in group.items()}
             for title, group in groups.items()}  # fmt: skip
    kinds = {"functions": (LINK_MODEL, FUNCTIONS)} | {model: (model, LUMPS) for model in LUMPED}
    of_models = {
        f"{n} {words}": [run for run in models if (run["method"], run["tolerance"]) == (method, n)]
        for words, (method, counts) in kinds.items()
        for n in counts
    }
    return found | {LINK_MODEL: {name: _figures(part) for name, part in ({"all": models} | of_models).items()}}


def _is_default(run: Run) -> bool:
    return run["method"] == "auto"


def _figures(runs: Sequence[Run]) -> dict[str, Any]:
    """How many printed errors are bounds, how many of these hold, and how large they are over the true errors."""
    rows = [row for run in runs for row in run.get("rows", ())]
    seen = [row for row in rows if row[4] <= 0.1 * row[3] and row[3] > LEAST * row[5]]
    bounds, others = ([row for row in seen if row[1] is sign] for sign in (True, False))
    return {
        "runs": sum("rows" in run for run in runs),
        "printed": len(rows),
        "bounds": _share(row[1] for row in rows),
        "hold": _share(row[3] <= row[2] for row in bounds),
        "over_true": _quantiles([row[2] / row[3] for row in bounds]),
        "estimates_over_true": _quantiles([row[2] / row[3] for row in others]),
    }


def _share(values: Iterator[bool]) -> float | None:
    found = [*values]
    return round(float(np.mean(found)), 5) if found else None


def _quantiles(values: Sequence[float]) -> list[float] | None:
    return [float(f"{value:.3g}") for value in np.quantile(values, QUANTILES)] if len(values) > 2 else None


_HEAD = """# Errors of the integration, and how far they can be believed

Next to each number of a run's summary stands what the integration added to it. The run is made a second time with
finer steps (a tenth of the tolerances, or half the step; with `--check-error` a hundredth, a quarter), and the number's
series are compared over a window of 3 % of the run to each side of its instant.

- `< 2e-9 m` is a bound: {safety:g} times what the second run says. It is meant to hold in 99 % of cases.
- `≈ 2e-5 m` is an estimate: what the second run says. It stands where a bound would be beyond 1 % of the number's size,
  where contact or friction changes more often in one of the two runs or more than ten times, or at a fixed step, and
  where control reads sensors with a `resolution`, whose steps both runs may take otherwise than the true motion.
- `model error` bounds what other models of the flexible links would change ([links.md](links.md)): true values are
  those of runs with two functions more in each direction; of `segments` and `modes`, with four functions of the same
  sections. Every other fresh robot has a bare last link.
- Nothing stands where no second run came to the end, or where a Python function controls the robot.

What follows was measured on random robots (elastic gears, flexible links, contact, friction, sampled control, chaotic
pendulums; `tools/random_robots.py`) with random motions, by every method with tolerances from 1e-2 to 1e-10 and steps
from 5 ms to 53 µs. True values are those of `dop853` at 1e-13 whose own error is below a tenth of what is judged;
errors below 1e-12 of a number's size are left out. The factor was chosen on the first set of seeds; the second set is
fresh. This page is written by `python tools/errors_doc.py`; `--measure 0 5` and `--measure 1000 1014` make the runs,
`--measure-models` those of the link models alone.
"""


def page(info: dict[str, Any]) -> str:
    """The page as Markdown."""
    lines = _HEAD.format(safety=info["safety"]).splitlines()
    for name, title in (("chosen", "Runs on which the factor was chosen"), ("verified", "Fresh runs")):
        groups = info[name]
        lines += ["", f"## {title}", "", *_tables([group for key, group in groups.items() if key != LINK_MODEL])]
        if LINK_MODEL in groups:
            lines += ["", f"### {title}: errors of the link models", "", *_tables([groups[LINK_MODEL]])]
    return "\n".join([*lines, ""])


def _tables(groups: Sequence[dict[str, Any]]) -> Iterator[str]:
    shares = "1 %, 10 %, median, 90 %"
    yield f"| | runs | numbers | bounds | they hold | bound over true error: {shares} | estimate over true error |"
    yield "|---|---|---|---|---|---|---|"
    for group in groups:
        for name, one in group.items():
            cells = [name, one["runs"], one["printed"], _percent(one["bounds"], 1), _percent(one["hold"], 2),
                     _words(one["over_true"]), _words(one["estimates_over_true"])]  # fmt: skip
            yield f"| {' | '.join(map(str, cells))} |"


def _percent(value: float | None, digits: int) -> str:
    return "–" if value is None else f"{100 * value:.{digits}f} %"


def _words(values: Sequence[float] | None) -> str:
    return "–" if values is None else ", ".join(f"{value:.2g}" for value in values)


def main() -> int:
    """Measure where asked, and write the page."""
    asked = [name for name in ("--measure", "--measure-models") if name in sys.argv]
    for name in asked:
        place = sys.argv.index(name)
        seeds, models = range(*map(int, sys.argv[place + 1 : place + 3])), name != "--measure"
        file = MODEL_RUNS if models else RUNS
        measure(chain.from_iterable(map(model_cases, seeds)) if models else cases(seeds), file)
        found = summarised(kept(file))
        if models:
            parts = ("chosen", "verified")
            known = json.loads(FIGURES.read_text(encoding="utf-8"))
            found = known | {part: known[part] | {LINK_MODEL: found[part][LINK_MODEL]} for part in parts}
        FIGURES.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    return generated.main(PAGE, page(json.loads(FIGURES.read_text(encoding="utf-8"))), "errors_doc")


if __name__ == "__main__":
    sys.exit(main())
