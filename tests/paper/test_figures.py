"""Figures 6, 7 and 8 of the paper: its symbols and captions, text as text, and a word on what cannot be drawn."""

from __future__ import annotations

import logging
from collections import Counter
from xml.etree import ElementTree as ET

import pytest

import tmodes
from command import tmodes as command
from tmodes import plot
from tmodes.plot import figure

SHORT = {"integration.duration": 0.1}
SHOWN = {
    "figure_6": ("x", "y[m]", "z", "deviation[mm]", "c)coordinatez", "real"),
    "figure_7": ("Fc", "Fc−Fco", "real"),
    "figure_8": ("ϑ1,1m", "ϑ1,2e", "ϑ1,1q", "ϑ1,2δ", "ξ[mrad]", "ξ−ξo[mrad]", "real"),
}
"""The letters of what must be written in each figure; those of a formula stand in the order of their fonts."""


@pytest.fixture(scope="module")
def result():
    return tmodes.load("filipovic2010").with_(SHORT).run(error_estimate=False)


@pytest.fixture(scope="module")
def folder(result, tmp_path_factory):
    folder = tmp_path_factory.mktemp("figures")
    plot.save_figures(result, folder, ("svg", "pdf"), names=[*plot.PAPER_FIGURES])
    return folder


def texts(path):
    """The letters of each text of an SVG: a formula is one."""
    every = ET.parse(path).iter("{http://www.w3.org/2000/svg}text")  # noqa: S314
    return [Counter("".join("".join(one.itertext()).split())) for one in every]


@pytest.mark.parametrize("name", SHOWN)
def test_symbols_are_text(name, folder):
    found = texts(folder / f"{name}.svg")
    assert [word for word in SHOWN[name] if not any(Counter(word) <= one for one in found)] == []
    content = (folder / f"{name}.pdf").read_bytes()
    assert b"/FontFile2" in content or b"/CIDFontType2" in content
    assert b"/Type3" not in content


def test_captions_are_the_papers():
    captions = figure.captions([*plot.PAPER_FIGURES])
    for words in (
        "Figure 6: The tip coordinates and the position deviation from the reference level.",
        "Figure 7: The environment force dynamics.",
        "Figure 8: The elastic deformations.",
    ):
        assert words in captions
    assert captions.count("those of the run that is drawn are assumed.") == len(plot.PAPER_FIGURES)


def test_panels_are_lettered_and_a_missing_font_is_no_warning(result, caplog):
    with caplog.at_level(logging.WARNING):
        letters = {
            name: "".join(panel.get_title(loc="left")[0] for panel in drawn(result))
            for name, drawn in plot.PAPER_FIGURES.items()
        }
    assert letters == {"figure_6": "abcd", "figure_7": "ab", "figure_8": "aabbcc"}
    assert caplog.messages == []


def test_what_is_not_there_is_left_out_with_the_reason(tmp_path):
    free = tmodes.load("filipovic2010").with_(SHORT | {"contact": None}).run(error_estimate=False)
    assert [*plot.left_out(free, paper=True)] == ["figure_7"]
    command(
        "run", "spong1987", "--set", "integration.duration=0.1", "--no-report", "--no-live", "--out", tmp_path / "run"
    )
    refused = command("figures", tmp_path / "run", "--paper", code=2).stderr
    assert "link.elevation1" in refused
    assert "2010 robot" in refused
