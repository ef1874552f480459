"""Checks run in processes of their own: a slow one blocks nothing, an outdated one is dropped, an endless one ends."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from patience import LONG
from tmodes.studio import server
from tmodes.studio.jobs import JobBook
from tmodes.studio.pool import Pool

WORKER = """
import json, os, sys, threading
for line in sys.stdin:
    order = json.loads(line)
    sheet = order.get("sheet")
    if sheet == "endless":
        threading.Event().wait()
    if sheet == "crash":
        os._exit(9)
    if "job" in order:
        print(json.dumps({"job": order["job"], "kind": "done", "bytes": len(sheet)}))
        print(sheet, end="", flush=True)
"""

Ask = Callable[[str, str], Coroutine[Any, Any, str]]


@pytest.fixture
def checking(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[[Callable[[Ask], Coroutine[Any, Any, None]]], None]:
    """Runs a program that asks for checks of sheets: the answer, or empty where there is none."""
    monkeypatch.setattr("tmodes.studio.pool.COMMAND", (sys.executable, "-c", WORKER))
    monkeypatch.setattr("tmodes.studio.pool.PATIENCE", 0.0)

    async def whole(program: Callable[[Ask], Coroutine[Any, Any, None]]) -> None:
        pool = Pool(2, tmp_path)
        book = JobBook(pool)

        async def ask(sheet: str, client: str) -> str:
            try:
                return (await server._checked(book, {"sheet": sheet}, "check", client)).decode()
            except server._Refused as error:
                return "" if error.args[0][0]["message"] else "no reason"

        await asyncio.wait_for(program(ask), LONG)
        await pool.stop()

    return lambda program: asyncio.run(whole(program))


def test_a_slow_check_blocks_no_other_and_an_outdated_one_is_dropped(checking) -> None:
    async def program(ask: Ask) -> None:
        slow = asyncio.create_task(ask("endless", "one"))
        assert await ask("quick", "another") == "quick"
        assert not slow.done()
        outdated = [slow, *(asyncio.create_task(ask("endless", "one")) for _ in range(3))]
        await asyncio.wait(outdated, return_when=asyncio.FIRST_COMPLETED)  # more than there are processes
        assert await ask("newest", "one") == "newest"
        assert [await one for one in outdated] == [""] * 4

    checking(program)


def test_a_check_that_crashes_or_never_ends_says_so_and_the_next_works(checking, monkeypatch) -> None:
    async def program(ask: Ask) -> None:
        assert await ask("crash", "one") == ""
        with monkeypatch.context() as patch:
            patch.setattr(server, "LONGEST_CHECK", 0.1)
            assert [await ask("endless", "one") for _ in range(3)] == [""] * 3
        assert await ask("quick", "one") == "quick"

    checking(program)
