"""Mutation check: deliberate faults in kernels, loops, io and result; for each of them some test must fail.

``python tools/mutants.py [WORD ...]`` runs all, or those whose file or new text has one of the words. The faults are
made in a copy of the tree, one at a time; exit code 1 where one survives or no longer fits its file.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]


class Fault(NamedTuple):
    """A text that stands once in a file of src/tmodes, what is put in its place, and the tests that should fail."""

    file: str
    old: str
    new: str
    tests: str


FAULTS = (
    Fault("kinds/links/modes_line.py", "TANGENT = 1.5", "TANGENT = 1.4", "tests/paper tests/lagrange"),
    Fault(
        "kinds/links/modes_line.py",
        "inward, across = ce * a * a, 2 * se * a * e",
        "inward, across = ce * a * a, se * a * e",
        "tests/contracts/test_links.py tests/paper/test_samples.py tests/lagrange/test_rigid.py",
    ),
    Fault(
        "kinds/contacts/spring_damper.py",
        "return p[1] * rate + p[0] * depth + p[2]",
        "return p[1] * rate + p[0] * depth - p[2]",
        "tests/contracts/test_contacts.py",
    ),
    Fault(
        "kinds/contacts/spring_damper.py",
        "f.sqrt(v.dot(slip, slip) + p[4] * p[4])",
        "f.sqrt(v.dot(slip, slip) + p[4])",
        "tests/paper tests/simulation/test_contact.py",
    ),
    Fault(
        "kinds/drives/contract.py",
        "presses = meets * (push > 0)",
        "presses = meets",
        "tests/equations/test_joints.py tests/analysis/statics/test_elements.py",
    ),
    Fault(
        "kinds/drives/contract.py",
        "energy = energy + (over > 0) * step * over * over / 2",
        "energy = energy + (over > 0) * step * over * over",
        "tests/contracts/test_drives.py",
    ),
    Fault(
        "kinds/drives/contract.py",
        "-2 * extra * share * share * ratio / stribeck",
        "2 * extra * share * share * ratio / stribeck",
        "tests/contracts/test_drives.py",
    ),
    Fault(
        "kinds/controllers/pid.py",
        "f.if_else(command * error > 0, (1 - self._held(command, limit)) * error, error)",
        "error",
        "tests/contracts/test_controllers.py",
    ),
    Fault(
        "kinds/signals/trapezoid.py",
        "half = speed * ramp / 2",
        "half = speed * ramp / 3",
        "tests/contracts/test_reference.py",
    ),
    Fault(
        "integrate/rk4.py",
        "(1 / 6, 1 / 3, 1 / 3, 1 / 6)",
        "(1 / 6, 1 / 6, 1 / 2, 1 / 6)",
        "tests/contracts/test_integrators.py",
    ),
    Fault(
        "integrate/dormand_prince.py",
        "22 / 525, -1 / 40)",
        "22 / 525, -1 / 30)",
        "tests/integrate/test_integrators.py tests/contracts/test_integrators.py",
    ),
    Fault(
        "equations/loop/control_kernels.py",
        "amperes = (command - back * thd) / resistance",
        "amperes = (command + back * thd) / resistance",
        "tests/contracts/test_drives.py tests/simulation tests/paper/test_independent.py",
    ),
    Fault(
        "equations/loop/contact_kernels.py",
        "return against, v.sub(against, v.scale(met.rate, met.direction))",
        "return against, against",
        "tests/contracts/test_contacts.py",
    ),
    Fault(
        "equations/loop/contact_kernels.py",
        "mass = self.mass(p, met, step, mode)\n        direction,",
        "mass = p[SURFACE]\n        direction,",
        "tests/simulation tests/contracts/test_contacts.py",
    ),
    Fault(
        "io/resultfile.py",
        "if hashlib.sha256(body).digest() != digest:",
        "if False:",
        "tests/result/test_resultfile.py",
    ),
    Fault(
        "io/resultfile.py",
        "            if size > max_bytes:\n",
        "            if False:\n",
        "tests/result/test_resultfile.py",
    ),
    Fault("io/atomic.py", "path.unlink(missing_ok=True)\n\n\ndef _create", "pass\n\n\ndef _create", "tests/result"),
    Fault("compile/cache.py", "if status.st_uid != os.getuid():", "if False:", "tests/compile/test_cache.py"),
    Fault("compile/cache.py", "if status.st_mode & _OTHERS:", "if False:", "tests/compile/test_cache.py"),
    Fault(
        "analysis/vibration.py",
        "(times[k + 1] - times[k]) - since)",
        "(times[k + 1] - times[k]))",
        "tests/result/test_settling.py",
    ),
    Fault(
        "result/settling.py",
        "values[plan.noises] = 0.0",
        "pass",
        "tests/result/test_settling.py",
    ),
    Fault(
        "simulation/stops.py",
        "signs = np.array([1.0 if stop.above else -1.0 for stop in self.stops])",
        "signs = np.array([1.0 for _ in self.stops])",
        "tests/simulation/test_stop_conditions.py tests/simulation/test_stops.py",
    ),
    Fault(
        "result/errors.py",
        'tip = np.linalg.norm(values["deflection"][:, k, -1], axis=-1)',
        'tip = values["deflection"][:, k, -1, 0]',
        "tests/result",
    ),
    Fault(
        "equations/lagrange/system.py",
        "inertial=ca.jtimes(momentum, q, v) - ca.gradient(energy.kinetic, q)",
        "inertial=ca.jtimes(momentum, q, v) - ca.gradient(energy.kinetic, q) / 2",
        "tests/paper tests/lagrange",
    ),
    Fault(
        "equations/recursion/hinge.py",
        "return [Force(e, v.zero()) if self.kind.turns else Force(v.zero(), e)] if self.moves else []",
        "return [Force(e, v.zero())] if self.moves else []",
        "tests/contracts/test_joints.py",
    ),
    Fault(
        "compile/loops/step_control.py",
        "return 1.0 / self.order - self.damping * self.beta",
        "return 2.0 / self.order - self.damping * self.beta",
        "tests/integrate/test_integrators.py tests/contracts/test_integrators.py",
    ),
)


_LOADING = 2, 3, 4
"""Exit codes of pytest where the package with the fault cannot even be imported: it checks that constants fit."""


def main(words: list[str]) -> int:
    """Make each fault and run its tests; returns the exit code."""
    wanted = [fault for fault in FAULTS if not words or any(word in fault.file + fault.new for word in words)]
    with tempfile.TemporaryDirectory(prefix="mutants") as folder:
        tree = Path(folder) / "tree"
        shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns(".git", ".venv", "node_modules", "results", "*.pyc"))
        survived = [fault for fault in wanted if not caught(tree, fault)]
    print(f"{len(wanted) - len(survived)} of {len(wanted)} faults are caught")
    return 1 if survived else 0


def caught(tree: Path, fault: Fault) -> bool:
    """Whether a test fails with the fault; says so in one line."""
    path = tree / "src" / "tmodes" / fault.file
    text = path.read_text(encoding="utf-8")
    if text.count(fault.old) != 1:
        print(f"stands {text.count(fault.old)} times, not once: {fault.file}: {fault.old!r}", flush=True)
        return False
    start = time.monotonic()
    path.write_text(text.replace(fault.old, fault.new), encoding="utf-8")
    try:
        command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *fault.tests.split()]
        environment = os.environ | {"PYTHONPATH": str(tree / "src"), "TMODES_CACHE": str(tree / "cache")}
        ran = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, check=False)
    finally:
        path.write_text(text, encoding="utf-8")
    failed = [line for line in ran.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    other = "what loads the package" if ran.returncode in _LOADING else "NO TEST"
    by = failed[0].split(" - ")[0].split()[1] if failed else other
    print(f"{time.monotonic() - start:6.1f} s  {fault.file}: {fault.new!r}: caught by {by}", flush=True)
    return ran.returncode in (1, *_LOADING)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
