"""The live model in a page that is opened from a file, with neither server nor network."""

from __future__ import annotations

import base64
import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from patience import WAIT
from tmodes import load, run
from tmodes.live.bundle import live_bundle
from tmodes.report.pack import embedded, pack

from .node import built_page, worst_difference

ENTRY = """
import { openLive, Superseded } from "{web}/src/live/live";
import { inflated, unpack } from "{web}/src/pack";
const info = (run) => JSON.stringify(run, (key, value) => ArrayBuffer.isView(value) ? Array.from(value) : value);
(globalThis as any).ready = (async () => {
  const bundle = unpack(await inflated(document.getElementById("data")!.textContent!)) as any;
  const live = await openLive(bundle);
  const values = live.sliders.map((slider) => slider.value);
  (globalThis as any).one = async () => info(await live.run(values));
  (globalThis as any).both = async () => {
    const ended = (problem) => problem instanceof Superseded ? "superseded" : String(problem);
    const first = live.run(values).then(() => "done", ended);
    const second = live.run(values).then((run) => run.status);
    return [await first, await second];
  };
  (globalThis as any).timed = async (times: number) => {
    const spent = [];
    for (let k = 0; k < times; k += 1) {
      const began = performance.now();
      await live.run(values.map((value, j) => (j === 0 ? value * (1 + 0.001 * k) : value)));
      spent.push(performance.now() - began);
    }
    return spent;
  };
  (globalThis as any).close = () => live.close();
  return live.sliders.length;
})();
"""

POLICY = (
    "default-src 'none'; script-src 'sha256-{digest}' 'wasm-unsafe-eval'; worker-src blob:; connect-src 'none'; "
    "img-src data: blob:"
)


def page_of(bundle: dict[str, Any], program: str) -> str:
    """As strict as the report's own page."""
    digest = base64.b64encode(hashlib.sha256(program.encode()).digest()).decode()
    return (
        '<!doctype html><meta charset="utf-8"><title>live</title>'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY.format(digest=digest)}">'
        f'<script type="application/octet-stream" id="data">{embedded(pack(bundle))}</script>'
        f"<script>{program}</script>"
    )


def test_page_from_a_file_runs_in_a_worker(chromium: str, tmp_path: Path) -> None:
    """The same numbers as natively, no request, no error of the browser; a newer run ends an older one."""
    playwright = pytest.importorskip("playwright.sync_api", reason="needs playwright to look at the page")
    result = run(load("filipovic2010"))
    bundle = live_bundle(result)
    assert bundle is not None
    (tmp_path / "page.html").write_text(page_of(bundle, built_page(ENTRY, tmp_path)), encoding="utf-8")
    with playwright.sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        page = browser.new_page()
        page.set_default_timeout(WAIT)
        info: list[str] = []
        asked: list[str] = []
        page.on("console", lambda message: info.append(message.text))
        page.on("pageerror", lambda problem: info.append(str(problem)))
        page.on("request", lambda request: asked.append(request.url))
        page.goto((tmp_path / "page.html").as_uri())
        sliders = page.evaluate("ready")
        workers, most = len(page.workers), page.evaluate("Math.min(2, navigator.hardwareConcurrency)")
        given = json.loads(page.evaluate("one()"))
        both = page.evaluate("both()")
        spent = page.evaluate("timed(12)")
        page.evaluate("close()")
        browser.close()
    assert sliders == len(bundle["sliders"])
    assert workers == most  # one of them makes the nominal runs
    assert both == ["superseded", "finished"]
    assert not info
    assert [url for url in asked if not url.startswith(("file:", "blob:"))] == []
    assert len(spent) == 12
    print(f"slider to curves, median: {np.median(spent[2:]):.1f} ms")
    series = {name: np.reshape([*one["data"].values()] if isinstance(one["data"], dict) else one["data"], one["shape"])
              for name, one in given["series"].items()}  # fmt: skip
    tips = {name: series[name] for name in ("tip", "tip_nominal", "q", "deviation", "contact_force_normal")}
    assert worst_difference(tips, result.data, {})[0] < 1e-9
