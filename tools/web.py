"""Build what the pages run in the browser, from web/ into the package: ``python tools/web.py [--check]``.

Needs Node, as only this tool does: what it builds is kept with the sources, so that nobody else needs it. ``--check``
only says whether what is kept was built from these very sources, which takes no Node.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

__all__ = ["built_from", "digest", "main"]

ROOT = Path(__file__).resolve().parents[1]
WEB, BUILT = ROOT / "web", ROOT / "src" / "tmodes" / "report" / "web"
_MARK = "/* tmodes, built from "


def digest() -> str:
    """What the sources and the versions of all packages are, in sixteen letters."""
    total = hashlib.sha256()
    for path in sorted([*WEB.glob("src/**/*.ts"), *WEB.glob("*.mjs"), *WEB.glob("package*.json")]):
        total.update(path.relative_to(WEB).as_posix().encode())
        total.update(path.read_bytes().replace(b"\r\n", b"\n"))
    return total.hexdigest()[:16]


def built_from(program: Path) -> str:
    """The sources that a built program says it was built from; empty where it does not say."""
    first = program.read_text(encoding="utf-8")[:200]
    return first.partition(_MARK)[2].partition(";")[0]


def main(arguments: list[str]) -> int:
    """Build, or only check; the exit code."""
    if "--check" in arguments:
        old = [path.name for path in sorted(BUILT.glob("*.js")) if built_from(path) != digest()]
        print(f"web: {', '.join(old)} not built from these sources: python tools/web.py" if old else "web: up to date")
        return bool(old)
    npm, node = shutil.which("npm"), shutil.which("node")
    if not npm or not node:
        print("web: npm and node are needed; install Node 20 or newer", file=sys.stderr)
        return 2
    steps = [] if (WEB / "node_modules" / ".package-lock.json").exists() else [[npm, "ci", "--silent"]]
    steps += [[npm, "run", "--silent", "types"], [node, "build.mjs", os.fspath(BUILT), digest()]]
    for step in steps:
        code = subprocess.run(step, cwd=WEB, check=False).returncode
        if code:
            return code
    for path in sorted(BUILT.glob("*.js")):
        print(f"{path.relative_to(ROOT)}: {path.stat().st_size / 1e3:.0f} kB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
