"""How tests start a browser, and what keeps its pages cheap where a test does not look at it."""

from __future__ import annotations

from typing import Any

__all__ = ["OPTIONS", "WITHOUT_WEBGL", "never_idle"]

OPTIONS = (
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--disable-gpu-compositing",  # scenes are WebGL in software all the same; text needs no shaders
)
WITHOUT_WEBGL = ("--no-sandbox", "--disable-gpu", "--disable-software-rasterizer", "--disable-3d-apis")


def never_idle(page: Any) -> None:
    """A page or context in which there is never time for what is out of sight, nor for the order of the sliders."""
    page.add_init_script("window.requestIdleCallback = () => 0")
