"""``tmodes cache``: where compiled code is kept, how much, and how to remove it."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from tmodes.cli.options import AsJson
from tmodes.cli.terminal import print_json
from tmodes.errors import ResultFileError

__all__ = ["Action", "cache"]


class Action(StrEnum):
    """What can be done to the cache."""

    CLEAR = "clear"


def cache(
    action: Annotated[Action | None, typer.Argument(help="clear: remove all entries.")] = None, as_json: AsJson = False
) -> None:
    """Show where compiled code is kept, or remove it: tmodes cache clear.

    Each robot's equations become native code once; the code is kept so that the next run starts at once. Nothing is
    lost by clearing it but that time. The environment variable TMODES_CACHE names another folder; empty: nothing is
    kept. A damaged entry is made again, and a folder that others can write is not used.
    """
    from tmodes.compile.cache import MAX_BYTES, clear, entries, judged

    place, refusal = judged()
    if action is Action.CLEAR:
        if place is None or refusal:
            hint = "name a folder of your own: TMODES_CACHE=FOLDER"
            raise ResultFileError(f"no cache is used ({place or 'no folder'}): {refusal}; {hint}")
        count, size = clear(place)
        words = f"removed {count} entries, {size / 1e6:.1f} MB, from {place}"
        print_json({"folder": str(place), "removed": count, "bytes": size}) if as_json else print(words)
        return
    found = [] if place is None or refusal else list(entries(place))
    size = sum(entry.size for entry in found)
    if as_json:
        info = {"folder": place and str(place), "used": not refusal, "entries": len(found), "bytes": size}
        print_json(info | {"limit": MAX_BYTES, "why_not": refusal})
        return
    print(f"compiled code  {place or 'no folder'}")
    if refusal:
        print(f"not used       {refusal}")
    print(f"entries        {len(found)}, {size / 1e6:.1f} MB of at most {MAX_BYTES / 1e6:.0f} MB")
    print("what for       a robot's equations are compiled once and cached; a second run of it compiles nothing")
    print("elsewhere      TMODES_CACHE=FOLDER names another folder, by its absolute path; empty: nothing is kept")
    print("remove         tmodes cache clear")
