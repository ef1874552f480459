"""The interactive part of a page: the program and its data inside one document that may ask for nothing else."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from tmodes.report.facts import Fact, fact_list
from tmodes.report.markup import Markup, tag
from tmodes.report.pack import embedded, pack
from tmodes.report.parts import document

__all__ = ["application", "policy", "program", "viewer_document"]

_NEEDS = "The robot in 3D and the linked charts need JavaScript, which is switched off or failed to start."


def application(page: Mapping[str, Any]) -> Markup:
    """Where the program mounts its parts, the data that it reads, and the program itself."""
    without = tag("noscript", tag("p", f"{_NEEDS} The numbers and figures below need none.", class_="status warning"))
    place = tag("div", id="tmodes-app")
    data = tag("script", Markup(embedded(pack(page))), type="text/plain", id="tmodes-data")
    viewer = tag("section", without, place, id="viewer", aria_label="Interactive view")
    return Markup(viewer + data + tag("script", Markup(program())))


@cache
def program() -> str:
    """The viewer's program as ``tools/web.py`` built it."""
    return files("tmodes.report").joinpath("web/viewer.js").read_text(encoding="utf-8")


@cache
def policy() -> str:
    """Content security policy of a page with the viewer: it may run this one program, and ask for nothing at all."""
    digest = base64.b64encode(hashlib.sha256(program().encode()).digest()).decode()
    return (
        f"default-src 'none'; script-src 'sha256-{digest}' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; "
        "img-src data: blob:; worker-src blob:; connect-src 'none'; base-uri 'none'; form-action 'none'"
    )


def viewer_document(page: Mapping[str, Any]) -> str:
    """A self-contained document about a page's runs, from :func:`tmodes.report.data.page_data`, without printed parts.

    What each run has to say stands above the viewer, its numbers also where no program runs.
    """
    heading = tag("header", tag("h1", str(page["title"])), tag("p", str(page["subtitle"]), class_="lead"), class_="top")
    info = [_info(run, several=len(page["runs"]) > 1) for run in page["runs"]]
    numbers = [tag("section", tag("h2", run["name"]), _facts(run), class_="unprogrammed") for run in page["runs"]]
    return document(str(page["title"]), policy(), {}, heading, *info, application(page), *numbers)


def _info(run: Mapping[str, Any], *, several: bool) -> Markup:
    """How a run ended, and what it warns of."""
    name = tag("strong", f"{run['name']}: " if several else "")
    ended = tag("p", name, tag("strong", f"{run['status']}. "), run["message"])
    warnings = tag("ul", *(tag("li", str(sentence)) for sentence in run["warnings"])) if run["warnings"] else None
    kind = "bad" if not run["success"] else "warning" if run["warnings"] else "good"
    return tag("div", ended, warnings, class_=f"status {kind}", role=None if run["success"] else "alert")


def _facts(run: Mapping[str, Any]) -> Markup:
    return fact_list(Fact(**fact) for fact in run["facts"])
