"""The report: one file that asks for nothing, escapes everything, and shows a failed run at the top."""

from __future__ import annotations

import base64
import gzip
import json
import re
from collections import Counter
from collections.abc import Iterator
from hashlib import sha256
from html.parser import HTMLParser
from pathlib import Path

import pytest

from see.conftest import NASTY
from tmodes.errors import ResultFileError
from tmodes.report import write_report
from tmodes.report.markup import Markup, power_of_ten, tag, written
from tmodes.report.parts import program
from tmodes.result import Result

VOID = {"meta", "img", "br"}


class Page(HTMLParser):
    """The elements of a page in their order, the text in each, and whether all are closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[tuple[str, str]] = []
        self.open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append((self.open[-1] if self.open else "", data))

    def all(self, *tags: str) -> list[dict[str, str | None]]:
        return [attributes for tag, attributes in self.elements if tag in tags]

    @property
    def text(self) -> str:
        return " ".join(text for tag, text in self.texts if tag not in {"style", "script"}).replace("\u00a0", " ")


@pytest.fixture(scope="module")
def texts(reports: dict[str, Path]) -> dict[str, str]:
    """The report of a finished and of a failed run."""
    return {name: path.read_text(encoding="utf-8") for name, path in reports.items()}


@pytest.fixture(params=["good", "failed"])
def text(request: pytest.FixtureRequest, texts: dict[str, str]) -> str:
    """Each report in turn."""
    return texts[request.param]


def test_it_asks_for_nothing_and_runs_its_program_alone(text: str) -> None:
    page = Page(text)
    *plain, run = page.all("script")
    assert plain == [{"type": "text/plain", "id": f"tmodes-{name}"} for name in ("data", "program")]
    assert run == {}
    written = [text for tag, text in page.texts if tag == "script"]
    assert gzip.decompress(base64.b64decode(written[1])).decode() == program()
    text = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)
    addresses = [a[key] or "" for _, a in page.elements for key in ("src", "href", "xlink:href", "srcset") if key in a]
    assert {address[:1] for address in addresses} == {"#"}
    assert not page.all("link", "iframe", "object", "embed", "base", "form", "audio", "video", "style2")
    assert not [name for _, attributes in page.elements for name in attributes if name.startswith("on")]
    assert {match[1] for match in re.finditer(r"url\((.)", text)} <= {"#"}
    assert "@import" not in text
    assert "http:" not in text
    assert "https:" not in text
    policy = next(a["content"] for a in page.all("meta") if a.get("http-equiv") == "Content-Security-Policy")
    assert policy is not None
    digests = [base64.b64encode(sha256(one.encode()).digest()).decode() for one in (written[2], program())]
    assert "default-src 'none'" in policy
    assert f"script-src 'sha256-{digests[0]}' 'sha256-{digests[1]}' 'wasm-unsafe-eval';" in policy
    assert "connect-src 'none'" in policy
    assert "unsafe-eval" not in policy.replace("'wasm-unsafe-eval'", "")


def test_it_is_a_whole_page(text: str) -> None:
    page = Page(text)
    assert page.open == []
    assert text.startswith('<!doctype html>\n<html lang="en">')
    assert len(page.all("h1")) == len(page.all("main")) == len(page.all("title")) == 1
    ids = Counter(attributes["id"] for _, attributes in page.elements if "id" in attributes)
    assert max(ids.values()) == 1
    targets = {a["href"] for a in page.all("a", "use")} | {f"#{m}" for m in re.findall(r"url\(#([^)]+)\)", text)}
    assert {str(target).removeprefix("#") for target in targets} <= set(ids)
    labels = {a["aria-labelledby"] for a in page.all("section") if "aria-label" not in a}
    assert labels <= set(ids)


def test_whatever_a_text_holds_it_stays_text(texts: dict[str, str]) -> None:
    page = Page(texts["failed"])
    assert page.text.count(NASTY) == 9  # heading, title, lead, message twice, warning, citation, and a version twice
    assert NASTY in next(text for tag, text in page.texts if tag == "title")
    assert len(page.all("script")) == 3
    assert not page.all("img")


def test_a_failed_run_says_so_first(texts: dict[str, str]) -> None:
    text = texts["failed"]
    page = Page(text)
    assert next(text for tag, text in page.texts if tag == "title").startswith("DIVERGED: ")
    assert text.index('role="alert"') < text.index('id="numbers"')
    assert "This run did not finish: diverged." in page.text
    assert "q is not finite at t = 0.003 s." in page.text
    assert "What follows ends at 0.002 s of 2 s and is not a complete result." in page.text
    assert "off its commanded path" not in page.text
    assert "Contact force, mean" not in page.text


def test_a_finished_run_says_so(texts: dict[str, str], good: Result) -> None:
    page = Page(texts["good"])
    assert good.verdict["sentence"] in page.text
    assert "end completed at t = 2 s (dormand_prince chosen: fastest eigenvalue" in page.text
    assert not [a for _, a in page.elements if a.get("role") == "alert"]
    assert "Warnings" not in page.text


def test_the_numbers_are_those_of_the_summary(texts: dict[str, str], good: Result) -> None:
    info, text = good.summary(), Page(texts["good"]).text
    assert f"Error from nominal path {info['deviation']['max_m'] * 1e3:.4g} mm" in text
    assert f"at {info['deviation']['time_of_max_s']:.3g} s" in text
    settling = info["settling"]
    assert f"Settling after the move {settling['time_s']:.4g} s within" in text
    assert f"{1e3 * settling['limit_m']:.4g} mm of its rest, 0.1 % of the move" in text
    assert "First frequency, controlled 4.932 Hz 4.989 Hz with the motors locked" in text
    for name, one in info["deformations"].items():
        assert f"{name} {1e3 * one['max']:.4g} mrad {one['time_of_max_s']:.3g} s" in text
    moment = max(link["bending_moment"]["max_Nm"] for link in info["links"].values())
    assert f"Largest bending moment {moment:.4g} N·m link.1 at s = 0, at 0.118 s" in text
    assert f"Largest gear torque {info['joints']['joint']['largest_gear_torque']:.4g} N·m" in text
    force = info["contact_force"]
    assert f"Contact force, mean {force['mean_N']:.4g} N from {force['min_N']:.4g} to {force['max_N']:.4g} N" in text
    assert "Energy balance 1.2 × 10⁻¹¹" in text
    for case in good.frequencies.values():
        ringing = [mode for mode in case if mode["damped_frequency_Hz"]]
        assert all(f"{100 * mode['damping_ratio']:.3g} {mode['element']}" in text for mode in ringing)
        assert all(f" {mode['frequency_Hz']:.4g} " in text for mode in ringing)
        assert not case[len(ringing) + 1 :] or "– – decays in" in text


def leaves(value: object) -> Iterator[float]:
    """Every number of a data sheet."""
    if isinstance(value, dict | list):
        for item in value.values() if isinstance(value, dict) else value:
            yield from leaves(item)
    elif isinstance(value, float):
        yield value


def test_the_data_sheet_is_reported_with_units_and_symbols(texts: dict[str, str], good: Result) -> None:
    text = Page(texts["good"]).text
    sheet = json.loads(good.data.attrs["robot"])
    del sheet["real"]
    numbers = set(leaves(sheet))
    assert len(numbers) > 30
    assert numbers <= {float(one) for one in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", text)}
    lines = [" ".join(line.split()) for line in text.splitlines()]
    assert (
        "bending_stiffness: 13.359622759390597 # EI [N*m^2] bending stiffness EI of the section, both planes" in lines
    )
    assert "- length: 0.6 # l [m] length of the mode" in lines
    assert "resistance: 0.299 # R [ohm] armature resistance" in lines
    assert any(line.startswith("friction_law: signed") for line in lines)
    assert any(line.startswith("stiffness: [4700.0] # Cxi [N*m/rad]") for line in lines)
    assert "gear.stiffness 0.2" in text
    assert "doi:10.2298/TAM1001049F" in text
    statistics = good.statistics["real"]
    assert all(f"{name} {statistics[name]}" in text for name in ("steps", "evaluations"))
    versions = json.loads(good.data.attrs["versions"])
    assert versions
    assert all(f"{name} {version}" in text for name, version in versions.items())


@pytest.mark.nightly("inf")
@pytest.mark.parametrize("stored", [float("inf"), "Infinity"])
def test_rigid_elements_are_called_rigid(stored: float | str, good: Result, tmp_path: Path) -> None:
    robot = json.loads(good.data.attrs["robot"])
    robot["joints"][0]["gear"]["stiffness"] = [stored]
    data = good.data.assign_attrs(robot=json.dumps(robot))
    page = Page(write_report(Result(data), tmp_path / "r.html").read_text(encoding="utf-8"))
    assert re.search(r"stiffness: \[\.inf\] +# Cxi", page.text)


def test_statistics_of_several_runs(good: Result, tmp_path: Path) -> None:
    info = json.dumps({"reference": {"steps": 12}, "real": {"steps": 34, "dt_omega": 0.51234567, "largest": None}})
    run = Result(good.data.assign_attrs(statistics=info))
    text = Page(write_report(run, tmp_path / "r.html").read_text(encoding="utf-8")).text
    assert "reference: steps 12 real: steps 34 real: dt omega 0.512346 real: largest –" in text


def test_its_size(text: str) -> None:
    """With the program, the data and the live model."""
    assert len(text.encode()) < 1_400_000


def test_the_report_is_written_whole_or_not_at_all(good: Result, tmp_path: Path) -> None:
    old = tmp_path / "report.html"
    old.write_text("old")

    def interrupted(stage: str, share: float) -> None:
        if share > 0.0:
            raise KeyboardInterrupt(stage)

    with pytest.raises(KeyboardInterrupt, match="report"):
        write_report(good, old, progress=interrupted)
    assert [path.read_text() for path in tmp_path.iterdir()] == ["old"]
    with pytest.raises(ResultFileError, match="a place that can be written"):
        write_report(good, tmp_path / "nowhere" / "report.html")


def test_markup_escapes_text_and_keeps_markup() -> None:
    made = tag("p", "<b> & ", tag("i", "x"), None, class_='a"b', hidden=True, title=None, aria_label="<")
    assert made == '<p class="a&quot;b" hidden aria-label="&lt;">&lt;b&gt; &amp; <i>x</i></p>'
    assert tag("br") == "<br>"
    assert isinstance(made, Markup)
    assert not isinstance(made + "<script>", Markup)


def test_numbers_are_written_readably() -> None:
    assert written(4.04e-3, "m") == "4.04 mm"
    assert written(0.0, "N m") == "0 N·m"
    assert power_of_ten(-2.5e-11) == "-2.5 × 10⁻¹¹"
    assert power_of_ten(0.0) == "0"
