"""Kinds from outside tmodes on the pages: named in the report, and run by the live page's module."""

from __future__ import annotations

import pytest

import tmodes
from contracts.test_contacts import dropped
from contracts.test_controllers import gains, robot
from contracts.test_signals import Cosine
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.report.page import page


def sheets():
    move = {"type": Cosine.name_of_kind(), "amplitude": 0.1, "frequency": 1.0}
    return {"lqr": robot({"type": "lqr", "row": gains()}, drive={"signal": move}), "soil": dropped("soil")}


@pytest.mark.parametrize(("name", "words"), [("lqr", ("lqr", "cosine")), ("soil", ("soil",))])
def test_page(name, words):
    result = tmodes.run(sheets()[name])
    assert why_not_live(result) == ""
    bundle = live_bundle(result)
    assert bundle is not None
    assert len(bundle["module"]) > 0
    text = page(result, {}, live=True)
    for word in words:
        assert word in text
