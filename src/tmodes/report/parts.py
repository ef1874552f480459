"""Parts of a page: head, sections, status, warnings; and the interactive part, program and data."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from tmodes.plot.style import stylesheet
from tmodes.report.facts import Fact, fact_list
from tmodes.report.markup import Markup, tag
from tmodes.report.pack import embedded, pack
from tmodes.result.result import Result

__all__ = [
    "SECTIONS", "application", "document", "policy", "program", "rows_of", "section", "status",
    "styles", "title_of", "viewer_document", "warnings",
]  # fmt: skip


SECTIONS = {"viewer": "View", "numbers": "Numbers", "robot": "Robot", "provenance": "Provenance"}

_STYLES = ("page.css", "app.css")


def styles() -> str:
    """The style sheets of every page, with the colours of its charts."""
    own = (files("tmodes.report").joinpath(name).read_text(encoding="utf-8") for name in _STYLES)
    return "".join([stylesheet(), *own])


def document(title: str, policy: str, sections: Mapping[str, str], *content: str | None) -> str:
    """The whole page as one HTML document; ``sections``: ids and names of what the navigation leads to."""
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("title", f"{title} – tmodes"),
        tag("style", Markup(styles())),
    )
    main = tag("main", *content, id="main")
    skip = tag("a", "Skip to the content", href="#main", class_="skip")
    body = tag("body", skip, _navigation(sections) if sections else None, main)
    return f"<!doctype html>\n{tag('html', head, body, lang='en')}\n"


def title_of(result: Result, name: str) -> str:
    """The title of a run's page; a run that did not finish says so."""
    return name if result.success else f"{result.status.upper()}: {name}"


def section(name: str, *content: str | None) -> Markup:
    """One of SECTIONS, under its title."""
    title = f"{name}-title"
    return tag("section", tag("h2", SECTIONS[name], id=title), *content, id=name, aria_labelledby=title)


def _navigation(sections: Mapping[str, str]) -> Markup:
    links = (tag("li", tag("a", words, href=f"#{name}")) for name, words in sections.items())
    return tag("nav", tag("ul", *links), aria_label="Sections")


def status(result: Result) -> Markup:
    """The result in a sentence; a run that did not finish says so where no one can miss it."""
    message = result.message
    if result.success:
        found = result.verdict
        return tag("p", found["sentence"], class_=f"status {found['level']}")
    data = result.record
    wanted = json.loads(data.attrs["robot"]).get("integration", {}).get("duration")
    of_wanted = f" of {wanted:g} s" if isinstance(wanted, (int, float)) else ""
    end = f"What follows ends at {float(data['time'][-1]):g} s{of_wanted} and is not a complete result."
    heading = tag("strong", f"This run did not finish: {result.status}.")
    return tag("div", heading, tag("p", message), tag("p", end), class_="status bad", role="alert")


def warnings(result: Result) -> Markup | None:
    """What the run has to say about itself; None where that is nothing."""
    if not result.warnings:
        return None
    return tag("div", tag("strong", "Warnings"), _listed(result.warnings), class_="status warning", role="note")


def _listed(sentences: Iterable[str]) -> Markup:
    """Sentences as a list, without marks of code."""
    return tag("ul", *(tag("li", sentence.replace("`", "")) for sentence in sentences))


def rows_of(info: Mapping[str, Any], group: str = "") -> Iterator[list[str]]:
    """Names and values; a group within the group has its name before the names in it."""
    for key, value in info.items():
        name = f"{group}{re.sub('_s$', ' [s]', key)}".replace("_", " ")
        if isinstance(value, Mapping):
            yield from rows_of(value, f"{name}: ")
        else:
            yield [name, f"{value:.6g}" if isinstance(value, float) else "–" if value is None else str(value)]


_NEEDS = (
    "The robot in 3D and the linked charts need JavaScript, which is switched off or failed to start. The numbers "
    "below need none; `tmodes figures` draws the charts for print."
)


def application(page: Mapping[str, Any]) -> Markup:
    """Where the program mounts its parts, the data that it reads, and the program itself, compressed."""
    without = tag("noscript", tag("p", _NEEDS, class_="status warning"))
    place = tag("div", id="tmodes-app")
    data = tag("script", Markup(embedded(pack(page))), type="text/plain", id="tmodes-data")
    heading = tag("h2", SECTIONS["viewer"], class_="offscreen")
    viewer = tag("section", heading, without, place, id="viewer", aria_label="Interactive view")
    return Markup(viewer + data + _packed_program() + tag("script", Markup(_LOADER)))


_LOADER = """\
const inflated = async (id) => {
  const text = atob(document.getElementById(id).textContent);
  const packed = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k += 1) packed[k] = text.charCodeAt(k); // `Uint8Array.from` takes 50 ms
  return new Response(new Response(packed).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
};
void (async () => {
  const program = inflated("tmodes-program");
  window.tmodesData = inflated("tmodes-data"); // at the same time
  const script = document.createElement("script");
  script.textContent = new TextDecoder().decode(await program);
  document.body.append(script);
})();"""


@cache
def _packed_program() -> Markup:
    return tag("script", Markup(embedded(program().encode())), type="text/plain", id="tmodes-program")


@cache
def program() -> str:
    """The viewer's program as ``tools/web.py`` built it."""
    return files("tmodes.report").joinpath("web/viewer.js").read_text(encoding="utf-8")


def policy(*further: str) -> str:
    """Content security policy of a page with the viewer: it asks for nothing, and runs this program and ``further``."""
    texts = (_LOADER, program(), *further)
    digests = " ".join(f"'sha256-{base64.b64encode(hashlib.sha256(one.encode()).digest()).decode()}'" for one in texts)
    return (
        f"default-src 'none'; script-src {digests} 'wasm-unsafe-eval'; style-src 'unsafe-inline'; "
        "img-src data: blob:; worker-src blob:; connect-src 'none'; base-uri 'none'; form-action 'none'"
    )


def viewer_document(page: Mapping[str, Any]) -> str:
    """A self-contained document about a page's runs, from :func:`tmodes.report.data.page_data`, without printed parts.

    What each run has to say stands above the viewer, its numbers also where no program runs.
    """
    heading = tag("header", tag("h1", str(page["title"])), tag("p", str(page["subtitle"]), class_="lead"), class_="top")
    info = [_run_status(run, several=len(page["runs"]) > 1) for run in page["runs"]]
    numbers = [tag("section", tag("h2", run["name"]), _facts(run), class_="unprogrammed") for run in page["runs"]]
    view = application({name: value for name, value in page.items() if name != "differences"})
    return document(str(page["title"]), policy(), {}, heading, *info, view, page.get("differences"), *numbers)


def _run_status(run: Mapping[str, Any], *, several: bool) -> Markup:
    """How a run ended, and what it warns of."""
    name = tag("strong", f"{run['name']}: " if several else "")
    ended = tag("p", name, run["verdict"]["sentence"])
    warnings = _listed(run["warnings"]) if run["warnings"] else None
    kind = "warning" if run["success"] and run["warnings"] else run["verdict"]["level"]
    return tag("div", ended, warnings, class_=f"status {kind}", role=None if run["success"] else "alert")


def _facts(run: Mapping[str, Any]) -> Markup:
    return fact_list(Fact(**fact) for fact in run["facts"])
