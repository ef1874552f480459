"""Checks that every relative link and picture in the Markdown pages leads to a file: ``python tools/links.py``."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import generated

__all__ = ["broken_links", "pages"]

_LINK = re.compile(r"\]\(([^)\s]+)\)")
_FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)


def pages(root: Path) -> list[Path]:
    """The Markdown pages of the project."""
    return [*sorted(root.glob("*.md")), *sorted((root / "docs").rglob("*.md"))]


def broken_links(page: Path) -> Iterator[str]:
    """Relative links of a page that lead nowhere."""
    for link in _LINK.findall(_FENCE.sub("", page.read_text(encoding="utf-8"))):
        target = link.split("#")[0]
        if target and "://" not in link and not link.startswith("mailto:") and not (page.parent / target).exists():
            yield link


def _main() -> int:
    root = generated.ROOT
    broken = [f"{page.relative_to(root)}: {link}" for page in pages(root) for link in broken_links(page)]
    for line in broken:
        print(f"broken link in {line}", file=sys.stderr)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(_main())
