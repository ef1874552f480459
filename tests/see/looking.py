"""A page in a real browser: opened, listened to."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from browsing import never_idle
from patience import WAIT

__all__ = ["SIZES", "Window", "look", "words_of"]

SIZES = ((1280, 800), (400, 800))
SLOW = ("GL Driver Message", "Multiple readback operations")
"""What the browser says of drawing in software, and of tests that look at pixels."""


@dataclass
class Window:
    """An open page, with all that it said and asked for."""

    page: Any
    said: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)


def words_of(locator: Any) -> str:
    """The text of an element, with the spaces of the data: the page keeps numbers with their units."""
    return str(locator.text_content()).replace("\u00a0", " ")


def hear(window: Window, text: str) -> None:
    """Keep what the page said, but for what is of the test itself."""
    if not any(word in text for word in SLOW):
        window.said.append(text)


def look(
    browser: Any,
    report: Path,
    size: tuple[int, int] = SIZES[0],
    scheme: str = "light",
    *,
    unfolded: bool = False,
    idle: bool = False,
    **more: Any,
) -> Window:
    """Open a page, and listen; return when its program has started.

    ``unfolded``: with all its sliders in sight; ``idle``: it has time for what is out of sight and for the order of
    its sliders, which take most of a second.
    """
    viewport = {"width": size[0], "height": size[1]}
    context = browser.new_context(viewport=viewport, color_scheme=scheme, reduced_motion="reduce", **more)
    context.set_default_timeout(WAIT)
    if not idle:
        never_idle(context)
    window = Window(context.new_page())
    window.page.on(
        "console", lambda message: any(word in message.text for word in SLOW) or window.said.append(message.text)
    )
    window.page.on("pageerror", lambda error: window.said.append(str(error)))
    window.page.on("dialog", lambda dialog: (window.said.append(dialog.message), dialog.dismiss()))
    window.page.on("request", lambda request: window.asked.append(request.url))
    window.page.goto(report.as_uri())
    if more.get("java_script_enabled", True):
        window.page.wait_for_selector("html.running")
    if unfolded:
        window.page.evaluate(
            "document.querySelectorAll('.sliders-panel details').forEach((one) => { one.open = true })"
        )
    return window
