"""The command line as a user meets it: every command, its messages, its exit codes, its files."""

from __future__ import annotations

import json
import os
import signal
import subprocess
from itertools import chain
from pathlib import Path

import numpy as np
import pytest

import patience
from command import COMMAND, tmodes
from disturbed import running
from patience import until
from tmodes.cli.main import COMMANDS

STATES = Path(__file__).parents[1] / "oracle/reference_states.json"
LONG = {
    "integration.duration": "30000",
    "integration.output_step": "1.0",
    "reference.duration": "30000",
    "integration.relative_tolerance": "1e-12",
}


def settings(changes: dict[str, str]) -> list[str]:
    return [part for path, value in changes.items() for part in ("--set", f"{path}={value}")]


def test_run_as_json(tmp_path):
    """Machines get everything that a person sees, and nothing else on standard output."""
    done = tmodes("run", "filipovic2010", "--json", "--no-report", "--no-contact", "--out", tmp_path / "o")
    info = json.loads(done.stdout)
    assert info["status"] == "finished"
    assert info["summary"]["deviation"]["max_m"] == pytest.approx(2.971e-3, abs=5e-6)
    assert [round(line["frequency_Hz"], 3) for line in info["frequencies"]["locked"]] == [
        4.996, 7.315, 20.259, 32.616, 179.859,
    ]  # fmt: skip


def test_help_begins_with_five_commands():
    """And has each of the others, uncut."""
    shown = tmodes("--help").stdout
    sections = [part.splitlines() for part in shown.split("\n\n") if part[:1] != " "][1:]
    names = {lines[0]: [line.split()[0] for line in lines[1:]] for lines in sections}
    assert next(iter(names.values())) == ["run", "check", "modes", "study", "studio"]
    assert sorted([*chain(*names.values())][: len(COMMANDS)]) == sorted(COMMANDS)
    assert "..." not in shown.partition("[ARGS]...")[2]
    assert max(map(len, shown.splitlines())) <= 80


def test_an_output_without_a_name_is_refused(tmp_path):
    """Which would else be the current folder; and a batch fills no folder that holds something else."""
    (tmp_path / "mine.txt").write_text("mine", encoding="utf-8")
    batch = ("batch", "spong1987", "--vary", "gear.stiffness=80:120:2", "--duration", "0.05", "--out")
    for line in (("run", "spong1987", "--out"), batch):
        assert "--out must be the name" in tmodes(*line, "", code=2, cwd=tmp_path).stderr
    assert "mine.txt" in tmodes(*batch, tmp_path, code=4).stderr
    assert [file.name for file in tmp_path.iterdir()] == ["mine.txt"]


def test_same_bytes_everywhere(tmp_path):
    """Time zone, locale, hash seed, threads and folder change no byte of the result."""
    threads = "OPENBLAS_NUM_THREADS"
    worlds = [
        {"TZ": "UTC", "LC_ALL": "C", "PYTHONHASHSEED": "1", threads: "1"},
        {"TZ": "Asia/Tokyo", "LC_ALL": "C.UTF-8", "PYTHONHASHSEED": "2", threads: "2", "TMODES_CACHE": ""},
    ]
    files = []
    for index, world in enumerate(worlds):
        out = tmp_path / f"{index} ü"
        tmodes("run", "spong1987", "--no-report", "--out", out, env=os.environ | world)
        files.append((out / "result.nc").read_bytes())
    assert files[0] == files[1]


def test_a_run_that_diverges(tmp_path):
    """Time, coordinate and reason are reported, what was done is kept, the exit code is not zero."""
    stiff = settings({"gear.stiffness": "4.7e9", "integration.method": "rk4", "integration.step": "1e-3"})
    done = tmodes("run", "filipovic2010", *stiff, "--out", tmp_path, code=3)
    for word in ("diverged at t = ", "coordinate", "dt*omega"):
        assert word in done.stderr
    from tmodes.result import Result

    kept = Result.load(tmp_path / "result.nc")
    assert kept.status == "diverged"
    assert kept.data.sizes["time"] >= 1
    assert "did not finish: diverged" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_robots_prints_a_sheet_that_runs(tmp_path):
    """A robot's sheet can be printed, edited and checked."""
    assert "filipovic2010" in tmodes("robots").stdout
    file = tmp_path / "my.yaml"
    file.write_text(tmodes("robots", "filipovic2010").stdout, encoding="utf-8")
    assert "filipovic2010: valid (" in tmodes("check", file).stdout
    file.write_text(file.read_text(encoding="utf-8").replace("mass: 0.5 ", "mass: -0.5 "), encoding="utf-8")
    line = file.read_text(encoding="utf-8").splitlines().index("  mass: -0.5                     # m     [kg]") + 1
    wrong = tmodes("check", file, code=2).stderr
    for word in (f"my.yaml:{line}", "payload.mass", "-0.5", "kg", "check sign"):
        assert word in wrong
    info = json.loads(tmodes("check", file, "--json", code=2).stdout)
    assert info["ok"] is False
    assert info["errors"][0]["which"] == "payload.mass"


def test_modes():
    """Frequencies of the actual robot and of the robot as known."""
    info = json.loads(tmodes("modes", "filipovic2010", "--json").stdout)
    undamped = [round(mode["undamped_frequency_Hz"], 2) for mode in info["nominal"]["locked"]]
    assert undamped == [6.66, 7.35, 26.17, 32.78, 235.82]
    assert "gear" in tmodes("modes", "filipovic2010", "--reading", "printed").stdout


@pytest.mark.parametrize("reading", ["printed", "consistent"])
@pytest.mark.parametrize("kind", ["free", "contact"])
def test_eval_equals_the_reference_states(tmp_path, reading, kind):
    """The door for other programs: their states in, our terms out, with their names."""
    records = json.loads(STATES.read_text())["readings"][reading][kind]
    file = tmp_path / "states.json"
    file.write_text(json.dumps([{key: record[key] for key in ("phi", "phid", "u")} for record in records]))
    touch = ["--contact"] if kind == "contact" else []
    found = json.loads(tmodes("eval", "filipovic2010", "--states", file, "--reading", reading, *touch, "--json").stdout)
    assert len(found) == len(records)
    for mine, theirs in zip(found, records, strict=True):
        for name in set(theirs) - {"phi", "phid", "u"}:
            scale = np.abs(theirs[name]).max() or 1.0
            assert np.abs(np.array(mine[name]) - np.array(theirs[name])).max() <= 1e-9 * scale, name
    assert "Accelerations" in tmodes("eval", "filipovic2010", "--states", file).stdout


def test_eval_where_the_equations_end(tmp_path):
    """The tip above the base: an error that names the state, not a NaN."""
    file = tmp_path / "states.json"
    up = [0, 0, 0, np.pi, -np.pi, 0]
    file.write_text(json.dumps([{"phi": [0] * 6, "phid": [0] * 6, "u": 0}, {"phi": up, "phid": [1e9] * 6, "u": 0}]))
    done = tmodes("eval", "filipovic2010", "--states", file, "--contact", "--set", "link.modes.1.length=0.6", code=3)
    assert "states[1]" in done.stderr


@pytest.mark.parametrize(
    ("line", "code", "words"),
    [
        (["run", "filipovic201"], 2, ["filipovic2010", "Did you mean"]),
        (["run", "nowhere.yaml"], 2, ["nowhere.yaml", "check the path"]),
        (["run", "filipovic2010", "--set", "gear.stifness=5"], 2, ["gear.stiffness"]),
        (["run", "filipovic2010", "--set", "gear.stiffness"], 2, ["--set must be PATH=VALUE, got 'gear.stiffness'"]),
        (["run", "filipovic2010", "--set", "gear.stiffness=0"], 2, ["gear.stiffness", "greater than 0", "check sign"]),
        (["run", "filipovic2010", "--set", "gear.stiffness=1e5 N"], 2, ["gear.stiffness"]),
        (["run", "filipovic2010", "--reading", "spatial"], 2, ["printed", "consistent"]),
        (["run", "filipovic2010", "--reading", "spatial"], 2, ["--reading must be one of", "got 'spatial'"]),
        (["run", "filipovic2010", "--duration", "abc"], 2, ["--duration must be a number, got 'abc'"]),
        (["eval", "filipovic2010", "--states", "nowhere.json"], 2, ["nowhere.json"]),
        (["modes", "filipovic2010", "--set", "integration.duration=-1"], 2, ["integration.duration"]),
        (["modes", "filipovic2010", "--angle", "nan"], 2, ["angle"]),
        (["run", "filipovic2010", "--out", "/dev/null/x"], 4, ["/dev/null"]),
        (["run", "filipovic2010", "--out", "x" * 300], 4, ["xxx"]),
        (["fly"], 2, ["fly"]),
    ],
)
def test_wrong_lines(line, code, words, tmp_path):
    """Which, got, expected, hint; the right exit code; nothing written."""
    done = tmodes(*line, code=code, cwd=tmp_path)
    for word in words:
        assert word in done.stderr
    assert not list(tmp_path.rglob("result.nc"))


def test_help_teaches():
    """Every command explains itself."""
    for command in ("run", "robots", "check", "modes", "eval", "schema"):
        assert command in tmodes("--help").stdout
        assert len(tmodes(command, "--help").stdout) > 300
    assert tmodes("--version").stdout.startswith("tmodes ")


def test_closed_pipe():
    """The reader goes away: no traceback."""
    with subprocess.Popen([*COMMAND, "schema"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == ""


SHORTER = LONG | {"integration.duration": "3000", "reference.duration": "3000", "integration.error_estimate": "false"}


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """The bytes of the result of such a run that nobody disturbs."""
    out = tmp_path_factory.mktemp("undisturbed")
    tmodes("run", "filipovic2010", "--no-report", *settings(SHORTER), "--out", out)
    return (out / "result.nc").read_bytes()


def test_interruption_leaves_a_valid_file_and_goes_on(tmp_path, undisturbed):
    """Ctrl-C, early and late: exit 130, a marked result; the same command then ends as if nobody had pressed it."""
    from tmodes.result import Result

    line = ["run", "filipovic2010", "--no-report", *settings(SHORTER)]
    for stage in ("reference", "real"):
        with running(line, tmp_path / "a", stage) as process:
            process.send_signal(signal.SIGINT)
            info = process.communicate(timeout=patience.LONG)[1]
        assert "Traceback" not in info
        assert process.returncode == 130
        first = Result.load(tmp_path / "a/result.nc")
        assert first.status == "interrupted"
        assert all(np.isfinite(v.values).all() for v in first.data.data_vars.values() if v.dtype.kind == "f")
    assert "continuing" in tmodes(*line, "--out", tmp_path / "a").stderr
    assert (tmp_path / "a/result.nc").read_bytes() == undisturbed


def test_a_run_whose_report_was_not_written_goes_on_there(tmp_path):
    """The same command draws what is missing, and does not compute again; another robot's is refused."""
    line = ["run", "filipovic2010", "--duration", "0.05", "--no-live", "--out", tmp_path]
    tmodes(*line, "--no-report")
    before = (tmp_path / "result.nc").stat().st_mtime_ns
    tmodes(*line, "--set", "payload.mass=0.4", code=4)
    assert "continuing" in tmodes(*line).stderr
    assert (tmp_path / "report.html").exists()
    assert (tmp_path / "result.nc").stat().st_mtime_ns == before
    tmodes(*line, code=4)


def test_killed_and_continued(tmp_path, undisturbed):
    """kill -9, twice; the third run ends with the same bytes as one that nobody disturbed."""
    line = ["run", "filipovic2010", "--no-report", *settings(SHORTER)]
    for stage in ("reference", "real"):
        with running(line, tmp_path / "a", stage) as process:
            process.kill()
    assert not (tmp_path / "a/result.nc").exists()
    assert "continuing" in tmodes(*line, "--out", tmp_path / "a").stderr
    assert (tmp_path / "a/result.nc").read_bytes() == undisturbed
    assert not list((tmp_path / "a").glob(".checkpoint*"))


def test_two_writers(tmp_path):
    """A second run into the same folder is refused before it touches anything."""
    line = ["run", "filipovic2010", "--no-report", *settings(LONG), "--out", str(tmp_path)]
    process = subprocess.Popen([*COMMAND, *line], stderr=subprocess.DEVNULL)
    try:
        until((tmp_path / ".tmodes.lock").exists)
        refused = tmodes("run", "filipovic2010", "--no-report", "--out", tmp_path, code=4)
        assert "held by process" in refused.stderr
        assert process.poll() is None
    finally:
        process.kill()
        process.wait()


def sheet(tmp_path, name):
    """The shipped robot under another name."""
    file = tmp_path / "named.yaml"
    text = tmodes("robots", "filipovic2010").stdout.replace("name: filipovic2010", f"name: {json.dumps(name)}")
    file.write_text(text, encoding="utf-8")
    return file


def test_names_are_text(tmp_path):
    """A name that looks like markup, or that the terminal cannot write, is reported as it is."""
    info = tmodes("modes", sheet(tmp_path, "[/b] Róbót"), env=os.environ | {"PYTHONIOENCODING": "ascii"}).stdout
    assert "[/b] R\\xf3b\\xf3t" in info
    assert "control characters" in tmodes("check", sheet(tmp_path, "a\x1b[31mb"), code=2).stderr


def test_output_that_cannot_be_written():
    """A full disk behind standard output, or none at all: a sentence, never a traceback."""
    if not Path("/dev/full").exists():
        pytest.skip("needs /dev/full")
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([*COMMAND, "schema"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        assert done.returncode == 4
        assert "free some space" in done.stderr
        quiet = subprocess.run([*COMMAND, "check", "nowhere.yaml"], stderr=full, check=False)
        assert quiet.returncode == 2
    assert subprocess.run([*COMMAND, "robots"], preexec_fn=lambda: os.close(1), check=False).returncode == 0


def test_places_of_the_wrong_kind_are_reported_before_the_run(tmp_path):
    """A file where the figures' folder belongs."""
    (tmp_path / "figures").touch()
    assert "remove it" in tmodes("run", "filipovic2010", "--out", tmp_path, code=4).stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["figures"]


def test_no_home_and_no_cache(tmp_path):
    """Without a home the code is compiled each time, and that is all."""
    bare = {key: value for key, value in os.environ.items() if key not in ("HOME", "TMODES_CACHE", "XDG_CACHE_HOME")}
    assert "gear" in tmodes("modes", "filipovic2010", env=bare | {"HOME": str(tmp_path / "nowhere/at/all")}).stdout


def test_no_warning_of_a_library_reaches_a_terminal(tmp_path):
    """Of this process or of one that it starts; a person who asks for them sees them."""
    noisy = "import subprocess, sys, warnings, numpy\nwarnings.warn('library')\nnumpy.float64(1e300) ** 2\n"
    there = "subprocess.run([sys.executable, '-c', 'import warnings; warnings.warn(1)'])\n"
    (file := tmp_path / "noisy.py").write_text(noisy + there, encoding="utf-8")
    line = [*COMMAND, "--use", str(file), "robots"]
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONWARNINGS"}
    done = subprocess.run(line, capture_output=True, text=True, check=True, env=environment)
    assert done.stderr == ""
    asked = subprocess.run(line, capture_output=True, text=True, check=True, env=environment | {"TMODES_DEBUG": "1"})
    assert "library" in asked.stderr
