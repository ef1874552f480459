"""A nominal run by a partner at the other end of a channel: the same numbers, and an end where nobody wants it."""

from __future__ import annotations

from typing import Any

import pytest

from see.scenes import short_robot
from tmodes import run
from tmodes.live.bundle import live_bundle

from .node import in_node

PROGRAM = """
import { readFileSync } from "node:fs";
import { openPlanner, openRunner, unpack } from "./live.mjs";
const read = () => unpack(new Uint8Array(readFileSync("bundle.tmpk")));
const { port1, port2 } = new MessageChannel();
const orders = [];
const post = port1.postMessage.bind(port1);
port1.postMessage = (order) => { orders.push(order.id); post(order); };
const [alone, helped] = [await openRunner(read()), await openRunner(read(), port1)];
const values = read().sliders.map(({ value }) => value);
const first = await helped.run(values, {}); // without help: the partner is not there yet
const there = new Promise((resolve) => port1.addEventListener("message", resolve, { once: true }));
await openPlanner(read(), port2);
await there;
const text = ({ seconds, ...run }) => JSON.stringify(run);
const same = [];
const shares = [];
for (const factor of [1.01, 1.02]) {
  const changed = values.map((value, k) => (k ? value : factor * value));
  const [one, other] = [await alone.run(changed, {}), await helped.run(changed, { progress: (x) => shares.push(x) })];
  same.push(text(one) === text(other));
}
const before = orders.length;
await helped.run(values.map((value, k) => (k ? value : 1.02 * value)), {});
const again = orders.length - before;
const given = await helped.run(values.map((value) => 1.03 * value), { cancelled: () => true, piece: 0 }).then(
  () => "finished", (problem) => problem.name);
console.log(JSON.stringify({ first: first.status, same, orders, again, given, shares }));
port1.close();
port2.close();
"""


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What runs with a partner give, and what it was asked."""
    bundle = live_bundle(run(short_robot()))
    assert bundle is not None
    return in_node(PROGRAM, bundle, tmp_path_factory.mktemp("partner"))


def test_a_partner_changes_no_number(found: dict[str, Any]) -> None:
    assert found["first"] == "finished"
    assert found["same"] == [True, True]
    assert found["orders"][:2] == [1, 2]
    assert all(0 <= share <= 1 for share in found["shares"])


def test_a_nominal_run_that_is_known_is_not_asked_for(found: dict[str, Any]) -> None:
    assert found["again"] == 0


def test_a_run_that_nobody_wants_ends(found: dict[str, Any]) -> None:
    assert found["given"] == "Cancelled"
