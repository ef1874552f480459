"""A figure inside the page: as SVG that follows the page's colours, or, where that is too large, as PNG."""

from __future__ import annotations

import base64
import re
from typing import TYPE_CHECKING

from tmodes.report.markup import Markup, tag

if TYPE_CHECKING:
    from tmodes.plot.save import Drawing

__all__ = ["picture"]

LARGEST = 240_000
"""Size above which a figure is embedded as PNG [bytes]; ten figures and the rest stay below 3 MB."""

RESOLUTIONS = (160, 110, 80)
"""Tried in turn until a PNG is small enough [dots per inch]."""

PATH_DATA = re.compile(r' d="([^"]*)"')
LONG_NUMBER = re.compile(r"-?\d+\.\d{3,}")
COLOR = re.compile(r"#([0-9a-f]{6})\b")
STYLE = re.compile(r' style="[^"]*"')
PARTS_TO_DROP = re.compile(r"<!--.*?-->|<metadata>.*?</metadata>|<defs>\s*<style.*?</style>\s*</defs>", re.DOTALL)
ROOT = re.compile(r"<svg\b[^>]*\bviewBox=\"([^\"]*)\"[^>]*>")


def picture(drawing: Drawing, name: str, alternative: str) -> Markup:
    """The figure as an element of the page; ``alternative`` is its text for those who do not see it."""
    svg = _inline(drawing.content("svg").decode(), name, alternative)
    return svg if len(svg) <= LARGEST else _png(drawing, alternative)


def _inline(svg: str, name: str, alternative: str) -> Markup:
    """SVG as part of the page: ids made its own, colours made variables, coordinates to 0.01 pt, nothing outside."""
    svg = PARTS_TO_DROP.sub("", svg[svg.index("<svg") :]).replace("xlink:href", "href")
    svg = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{name}-", svg)
    svg = STYLE.sub(lambda style: COLOR.sub(r"var(--c\1, #\1)", style[0]), svg)
    svg = PATH_DATA.sub(_shorter, svg)
    view = ROOT.search(svg)
    box = view[1] if view else "0 0 1 1"
    label = tag("svg", viewBox=box, role="img", aria_label=alternative).removesuffix("</svg>")
    return Markup(re.sub(r">\s+<", "><", ROOT.sub(lambda _: label, svg, count=1)).strip())


def _shorter(path: re.Match[str]) -> str:
    numbers = LONG_NUMBER.sub(lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), path[1])
    return f' d="{" ".join(numbers.split())}"'


def _png(drawing: Drawing, alternative: str) -> Markup:
    content = ""
    for resolution in RESOLUTIONS:
        content = base64.b64encode(drawing.content("png", resolution)).decode()
        if len(content) <= LARGEST:
            break
    return tag("img", src=f"data:image/png;base64,{content}", alt=alternative)
