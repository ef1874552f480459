"""The architecture in numbers: ``python tools/architecture.py [-v]``. Reads text only, runs nothing.

Entries of the package, paths that name a species of robot, places that ask an object for its kind, layers and their
exceptions, import circles at three levels (module, function, types), quaint words, statements. A test holds each.
"""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

__all__ = ["Architecture", "main"]

ROOT = Path(__file__).resolve().parents[1]
LEVELS = {"top level": {"top"}, "in functions": {"top", "function"}, "for types": {"top", "function", "types"}}
_SPECIES = re.compile(r"(^|_)(arms?|robot|seed)(_|\.|$)")
_ALLOWED = {"robots", "sheet/robot.py"}
_UNCOUNTED = {"__pycache__", "__init__.py", "__main__.py", "py.typed"}
# Written in parts, so that this file holds none of them.
_WORDS = [("to", "ld"), ("te", "lls"), ("tell", "ing"), ("me", "nd(?:s|ed|ing)?"), ("an", "ew"), ("mis", "fits?"),
          ("compl", "aints?"), ("dou", "bts?"), ("bes", "ide")]  # fmt: skip
_PHRASES = [("set", r"s in\b"), ("go", r"es on\b"), ("liv", r"es in\b"), ("of no acc", "ount"), ("no more th", "an to")]
QUAINT = re.compile(
    rf"(?<![a-z])({'|'.join(map(''.join, _WORDS))})(?![a-z])|{'|'.join(map(''.join, _PHRASES))}", re.IGNORECASE
)
PROSE = ("src", "docs", "tests", "tools", "benchmarks", "web/src", "examples")


@dataclass(frozen=True)
class Architecture:
    """What the numbers are of: a checkout of the project."""

    root: Path = field(default=ROOT)

    @property
    def source(self) -> Path:
        """The folder of the package."""
        return self.root / "src" / "tmodes"

    @cached_property
    def modules(self) -> dict[str, Path]:
        """Files by dotted name."""
        found = {}
        for file in sorted(self.source.rglob("*.py")):
            parts = file.relative_to(self.source).with_suffix("").parts
            found[".".join(("tmodes", *parts)).removesuffix(".__init__")] = file
        return found

    @cached_property
    def trees(self) -> dict[str, ast.Module]:
        """Syntax trees by dotted name."""
        return {name: ast.parse(file.read_text(encoding="utf-8")) for name, file in self.modules.items()}

    @property
    def scripts(self) -> list[Path]:
        """TypeScript sources of the pages."""
        return sorted((self.root / "web" / "src").rglob("*.ts"))

    @property
    def entries(self) -> list[str]:
        """What stands in the package's folder, its face aside."""
        return sorted(path.name for path in self.source.iterdir() if path.name not in _UNCOUNTED)

    @property
    def named_for_a_species(self) -> list[str]:
        """Paths of sources that name one sort of robot."""
        bases = [(file, self.source) for file in self.modules.values()]
        bases += [(file, self.root / "web" / "src") for file in self.scripts]
        inside = [file.relative_to(base) for file, base in bases]
        return sorted(
            str(path)
            for path in inside
            if str(path) not in _ALLOWED and any(_SPECIES.search(part) for part in path.parts if part not in _ALLOWED)
        )

    @property
    def asked(self) -> list[str]:
        """Places outside ``kinds/`` that ask of what kind an object is, as ``file:line``."""
        inside = {name: tree for name, tree in self.trees.items() if name.startswith("tmodes.kinds")}
        nodes = [node for tree in inside.values() for node in ast.walk(tree)]
        members = {node.name for node in nodes if isinstance(node, ast.ClassDef)} | {"Robot", "System"}
        return [
            f"{self.modules[name].relative_to(self.root)}:{node.lineno}"
            for name, tree in self.trees.items()
            if name not in inside
            for node in ast.walk(tree)
            if isinstance(node, (ast.Call, ast.MatchClass, ast.Compare)) and _asks(node, members)
            if hasattr(node, "lineno")
        ]

    @cached_property
    def arrows(self) -> set[tuple[str, str, str]]:
        """(importing module, imported module, level)."""
        return {(name, target, level) for name in self.modules for target, level in self._imports(name)}

    def _known(self, name: str) -> str:
        while name and name not in self.modules:
            name = name.rpartition(".")[0]
        return name

    def _imports(self, module: str) -> Iterator[tuple[str, str]]:
        for names, level in _imported(self.trees[module], "top"):
            for name in names:
                if (target := self._known(name)) not in ("", module, "tmodes"):
                    yield target, level

    def circles(self, levels: set[str]) -> list[list[str]]:
        """Groups of modules that import each other in a ring, the largest first."""
        ahead = {name: {b for a, b, level in self.arrows if a == name and level in levels} for name in self.modules}
        rest, kept = dict(ahead), -1
        while len(rest) != kept:  # take away what imports nothing of the rest, or is imported by none of it
            kept = len(rest)
            rest = {name: {other for other in others if other in rest} for name, others in rest.items()}
            used = set().union(*rest.values()) if rest else set()
            rest = {name: others for name, others in rest.items() if others and name in used}
        return [sorted(rest)] if rest else []

    @property
    def layers(self) -> tuple[int, int]:
        """Layers of the import rules, and exceptions from them."""
        rules = tomllib.loads((self.root / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
        layered = [rule for rule in rules["contracts"] if rule.get("layers")]
        return max(len(rule["layers"]) for rule in layered), sum(
            len(rule.get("ignore_imports", [])) for rule in layered
        )

    @property
    def quaint(self) -> list[str]:
        """Lines that hold a word which nobody in the field writes, as ``file:line``."""
        files = [file for folder in PROSE for file in sorted((self.root / folder).rglob("*")) if _is_prose(file)]
        return [
            f"{file.relative_to(self.root)}:{number}"
            for file in [*files, *sorted(self.root.glob("*.md"))]
            for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1)
            if QUAINT.search(line)
        ]

    @property
    def statements(self) -> int:
        """Statements of Python, without imports and text: the form and the length of lines do not count."""
        nodes = (node for tree in self.trees.values() for node in ast.walk(tree) if isinstance(node, ast.stmt))
        return sum(not isinstance(node, (ast.Import, ast.ImportFrom)) and not _is_text(node) for node in nodes)

    @property
    def script_lines(self) -> int:
        """Lines of TypeScript."""
        return sum(file.read_text(encoding="utf-8").count("\n") for file in self.scripts)


def _is_prose(file: Path) -> bool:
    return file.suffix in (".py", ".md", ".ts", ".yaml") and "node_modules" not in file.parts


def _imported(node: ast.AST, level: str) -> Iterator[tuple[list[str], str]]:
    """Dotted names of each import below a node, and at which level it is."""
    for child in ast.iter_child_nodes(node):
        here = level
        if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            here = "function"
        elif isinstance(node, ast.If) and child in node.body and "TYPE_CHECKING" in ast.dump(node.test):
            here = "types"
        if isinstance(child, ast.Import):
            yield [alias.name for alias in child.names], here
        elif isinstance(child, ast.ImportFrom):
            yield [f"{child.module}.{alias.name}" for alias in child.names], here
        yield from _imported(child, here)


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def _names(node: ast.AST) -> set[str]:
    return {part.id for part in ast.walk(node) if isinstance(part, ast.Name)}


def _asks(node: ast.Call | ast.MatchClass | ast.Compare, members: set[str]) -> bool:
    if isinstance(node, ast.Call):
        asking = isinstance(node.func, ast.Name) and node.func.id in ("isinstance", "issubclass")
        return asking and len(node.args) == 2 and bool(members & _names(node.args[1]))
    if isinstance(node, ast.MatchClass):
        return bool(members & _names(node.cls))
    sides = [node.left, *node.comparators]
    of_kind = any(isinstance(side, ast.Attribute) and side.attr in ("kind", "species") for side in sides)
    calls = [side.func for side in sides if isinstance(side, ast.Call)]
    of_type = any(isinstance(func, ast.Name) and func.id == "type" for func in calls)
    return of_kind or (of_type and any(members & _names(side) for side in sides))


def _flat(groups: list[list[str]]) -> list[str]:
    return [name for group in groups for name in group]


def main(arguments: list[str]) -> int:
    """Print the numbers; with ``-v`` also what they count."""
    house = Architecture()
    counted = {
        "entries in src/tmodes": house.entries,
        "paths that name a species": house.named_for_a_species,
        "places that ask for a kind": house.asked,
        "lines with quaint words": house.quaint,
        **{
            f"modules on import circles, {name}": [name for circle in house.circles(levels) for name in circle]
            for name, levels in LEVELS.items()
        },
    }
    for name, found in counted.items():
        print(f"{name:36} {len(found)}")
        if "-v" in arguments:
            print(*(f"    {one}" for one in found), sep="\n")
    print(f"{'layers, exceptions':36} {house.layers[0]}, {house.layers[1]}")
    print(f"{'statements, lines of TypeScript':36} {house.statements}, {house.script_lines}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
