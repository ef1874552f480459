"""What a worker computes: a sheet simulated, and of the result a page's data, a report, or the result file."""

from __future__ import annotations

import hashlib
import json
import tempfile
import time as clock
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_from_data
from tmodes.studio.looks import Shapes
from tmodes.studio.sheets import MOST_BYTES, plain_sheet, sheet_record

if TYPE_CHECKING:
    from tmodes.result import Result
    from tmodes.sheet import Robot

__all__ = ["OF_SHEET", "PRODUCTS", "WorkAnswer", "Workshop", "drawn"]

Progress = Callable[[str, float], None]


@dataclass(frozen=True)
class WorkAnswer:
    """What was asked for: its bytes, and what is reported next to them."""

    content: bytes
    info: dict[str, Any]


class Workshop:
    """Simulates sheets; the last result stays, so that its report and its data take no second run."""

    def __init__(self) -> None:
        self._last: tuple[str, Result] | None = None
        self._shapes = Shapes()

    def answer(
        self,
        product: str,
        data: Any,
        progress: Progress,
        looks: Mapping[str, Any] | None = None,
        series: Sequence[str] = (),
    ) -> WorkAnswer:
        """What is asked for of a sheet's plain data, by its name in :data:`PRODUCTS` or :data:`OF_SHEET`.

        ``seconds`` of the former tell what each part took.

        ``looks``: where the shapes of its links are, as :class:`tmodes.studio.looks.Source`; ``unseen`` says which of
        them cannot be shown. A page of a robot that nothing moves shows it at rest; ``offer``: drives that move it.
        ``series``: of a ``change``, those that are wanted. It can be drawn upon a page of the same ``structure``.
        Raises :class:`tmodes.errors.TmodesError` for a sheet that is wrong or cannot run.
        """
        from tmodes.result.early import early_result
        from tmodes.result.run import stands_still

        laps = _Laps()
        sheet = sheet_from_data(data)
        progress("check", 1.0)
        if product in OF_SHEET:
            return WorkAnswer(OF_SHEET[product](sheet).encode(), {})
        light = product in {"curves", "change"}
        still = (light or product == "page") and stands_still(sheet)
        laps.take("check")
        result = self._result(sheet, progress, still=still)
        laps.take("simulate")
        progress("shapes", 0.0)
        self._shapes.look(looks)
        early = early_result(result, lines=still or product != "change") if light else result
        result = self._shapes.on(early)
        laps.take("shapes")
        order = _Order(sheet.name, tuple(series))
        content = _at_rest(result, sheet, laps, light=light) if still else PRODUCTS[product](result, order, laps)
        info = {"status": result.status, "success": result.success, "message": result.message, "name": sheet.name}
        info["structure"] = "at rest" if still else _structure(result) if light else ""
        info["offer"] = _offer(sheet) if still else []
        info["unseen"] = self._shapes.unseen(data)
        info["seconds"] = laps.info | {"loops": _loop_seconds(result)}
        return WorkAnswer(content, info)

    def _result(self, sheet: Robot, progress: Progress, *, still: bool = False) -> Result:
        key = f"{still} {json.dumps(plain_sheet(sheet), sort_keys=True)}"
        if self._last is None or self._last[0] != key:
            self._last = None  # two results at once may be more than the memory holds
            self._last = (key, _standing(sheet) if still else _simulated(sheet, progress))
        return self._last[1]


class _Order(NamedTuple):
    """The name of the robot, and the series that a change is to have."""

    name: str
    series: tuple[str, ...] = ()


class _Laps:
    def __init__(self) -> None:
        self.info: dict[str, float] = {}
        self._since = clock.perf_counter()

    def take(self, part: str) -> None:
        now = clock.perf_counter()
        self.info[part] = now - self._since
        self._since = now


def _simulated(sheet: Robot, progress: Progress) -> Result:
    from tmodes.result.run import ready_to_run, result_bytes, run

    robot = ready_to_run(sheet)
    _refuse_large(result_bytes(robot))
    return run(robot, progress=progress)


def _standing(sheet: Robot) -> Result:
    from tmodes.report.rest import standing

    return standing(sheet)


def _offer(sheet: Robot) -> list[dict[str, Any]]:
    from tmodes.report.rest import first_move

    return first_move(sheet)


def _refuse_large(size: int) -> None:
    if size > MOST_BYTES:
        got, expected = f"a result of {size / 1e6:,.0f} MB", f"at most {MOST_BYTES / 1e6:,.0f} MB in the studio"
        hint = "sample more coarsely, or run it with `tmodes run` and look at it with `tmodes view`"
        raise InputError("integration.output_step", got, expected, hint)


def _loop_seconds(result: Result) -> float:
    """Seconds spent in the loops of the nominal run and the real one."""
    return sum(result.timing.values()) * float(result.record["time"].values[-1])


def _page(result: Result, order: _Order, laps: _Laps, *, light: bool = False) -> bytes:
    from tmodes.report.data import page_data

    return _packed(page_data([result], [order.name], light=light), result, laps)


def _at_rest(result: Result, sheet: Robot, laps: _Laps, *, light: bool) -> bytes:
    from tmodes.report.rest import rest_page

    return _packed(rest_page(sheet, result, light=light), result, laps)


def _packed(page: dict[str, Any], result: Result, laps: _Laps, series: Sequence[str] | None = None) -> bytes:
    from tmodes.report.pack import pack

    record, names = result.record, drawn(page) if series is None else series
    page |= {"times": np.asarray(record["time"].values, dtype="f8")}
    page["series"] = {name: np.asarray(record[name].values, dtype="f8") for name in names if name in record}
    laps.take("page")
    content = pack(page)
    laps.take("pack")
    return content


def _curves(result: Result, order: _Order, laps: _Laps) -> bytes:
    return _page(result, order, laps, light=True)


def _change(result: Result, order: _Order, laps: _Laps) -> bytes:
    """What of a page changes with a number: no charts, whose curves are the series, and of the scene what moves."""
    from tmodes.report.data import early_facts, verdict_of
    from tmodes.report.scene import frames_of, line_of, scene_of

    frames = frames_of(result)
    scene = {name: one for name, one in scene_of(result, frames).items() if name not in ("links", "joints", "meshes")}
    run = {name: getattr(result, name) for name in ("status", "success", "message", "warnings")}
    facts = [asdict(fact) for fact in early_facts(result)]
    run |= {"name": order.name, "verdict": verdict_of(result), "facts": facts, "charts": []}
    run |= {"scene": scene, "line": line_of(result, frames)}
    return _packed({"runs": [run]}, result, laps, order.series)


def drawn(page: Mapping[str, Any]) -> list[str]:
    """The result's own series that the curves of a page are drawn of, so that later runs can be drawn upon them."""
    sources = [curve["source"] for chart in page["runs"][0]["charts"] for curve in chart["curves"]]
    return sorted({part["variable"] for source in sources if source for part in (source, source.get("less")) if part})


_LABELS = (
    "coordinate", "deformation_kind", "drive", "point", "error_part", "link", "link_parent", "bending_link",
    "stressed_link", "energy_kind", "work_kind",
)  # fmt: skip


def _structure(result: Result) -> str:
    """The same text for results whose series and lines have the same names and places."""
    record = result.record
    labels = [[*map(str, record[name].values)] if name in record else [] for name in _LABELS]
    optional = [name in record for name in ("tip_nominal", "contact_force", "voltage", "controller_states")]
    whole = json.dumps([result.name, record.sizes.get("s", 0), labels, optional])
    return hashlib.sha256(whole.encode()).hexdigest()[:16]


def _data(result: Result, order: _Order, laps: _Laps) -> bytes:
    del order
    with tempfile.TemporaryDirectory(prefix="tmodes-data-") as folder:
        content = result.save(Path(folder) / "result.nc").read_bytes()
    laps.take("data")
    return content


def _report(result: Result, order: _Order, laps: _Laps) -> bytes:
    from tmodes.report import write_report

    del order
    with tempfile.TemporaryDirectory(prefix="tmodes-report-") as folder:
        path = Path(folder) / "report.html"
        write_report(result, path)
        content = path.read_bytes()
    laps.take("report")
    return content


def _yaml(sheet: Robot) -> str:
    from tmodes.io.sheet_write import robot_to_yaml

    return robot_to_yaml(sheet)


OF_SHEET: dict[str, Callable[[Robot], str]] = {
    "check": lambda sheet: json.dumps(sheet_record(sheet), allow_nan=False),
    "yaml": _yaml,
}
"""What can be asked for of a sheet without a run: what the page needs to know of a right one; its YAML."""

PRODUCTS: dict[str, Callable[[Result, _Order, _Laps], bytes]] = {
    "page": _page,
    "curves": _curves,
    "change": _change,
    "report": _report,
    "data": _data,
}
"""What can be asked for: the page's data, the same without modes, what of it changes with a number (quickest),
``report.html``, ``result.nc``."""
