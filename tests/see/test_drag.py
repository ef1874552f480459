"""A slider that is being dragged, faster than a run is made, shows runs on the way and the last one at the end."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tmodes.report.data import live_page
from tmodes.report.parts import viewer_document
from tmodes.result import Result

from .looking import look

STATUS = ".sliders-panel [role=status]"
DRAG = """(wanted) => {
  const input = document.querySelector(".sliders-panel input[type=range]");
  const fact = document.querySelector("[data-fact='deviation.max'] strong");
  document.querySelector(".stage").style.display = "none"; // drawing in software would let no input through
  const [low, high] = [Number(input.min), Number(input.max)];
  const drag = (window.drag ??= { moves: 0, seen: new Set() });
  drag.moves += 1;
  drag.seen.add(fact.textContent);
  input.value = String(low + (high - low) * (0.3 + 0.0004 * (drag.moves % 1000)));
  input.dispatchEvent(new Event("input", { bubbles: true }));
  return drag.seen.size >= wanted;
}"""
"""One of many moves of the slider, without waiting for what it shows."""


@pytest.mark.nightly
def test_runs_are_shown_while_a_slider_is_dragged(browser: Any, good: Result, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(viewer_document(live_page(good)), encoding="utf-8")
    window = look(browser, page)
    window.page.wait_for_selector(f"{STATUS}:text('Move a slider')")
    window.page.wait_for_function(DRAG, arg=5, polling=8)
    assert window.said == []
