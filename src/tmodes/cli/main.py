"""The command ``tmodes``: parses the line, runs one command, and turns every error into a sentence and an exit code."""

from __future__ import annotations

import gc
import io
import os
import sys
import time as clock
from contextlib import suppress
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup

from tmodes.cli.memory import OUT_OF_MEMORY, lacks_memory, words
from tmodes.cli.terminal import Stages
from tmodes.errors import InputError, TmodesError, error_words

__all__ = ["COMMANDS", "app", "main"]

INTERRUPTED = 130
FAULT = 70

_GROUPS = {
    "First commands": {
        "run": ("run.run", "simulate a robot under control; the result as a page and a file"),
        "check": ("sheets.check", "check a data sheet: all errors at once, wrong units"),
        "modes": ("modes.modes", "natural frequencies, damping, mode shapes"),
        "study": ("study.study", "parameter studies: sweeps, tolerances, Monte Carlo"),
        "studio": ("studio.studio", "change a robot in the browser and see it move at once"),
    },
    "Robots": {
        "robots": ("sheets.robots", "list the published robots, print one to edit"),
        "describe": ("describe.describe", "masses, stiffness, link frequencies, sag"),
        "linear": ("linear.linear", "linearization: poles, zeros, state space, Bode"),
        "static": ("static.static", "static equilibrium under loads, and its stability"),
        "pose": ("pose.pose", "inverse kinematics with elastic deflection"),
        "hierarchy": ("describe.hierarchy", "compare link models: error and cost"),
        "outputs": ("names.outputs", "names, units and meaning of all outputs"),
        "parameters": ("names.parameters", "parameters of a data sheet: value, unit, bounds"),
        "schema": ("sheets.schema", "the JSON Schema of data sheets, for editors"),
    },
    "Motion": {
        "follow": ("follow.follow", "references for a tip path: line, arc, via points"),
        "shaper": ("shaper.shaper", "input shaping against residual vibration"),
        "motion": ("motion.motion", "rest-to-rest torques without residual vibration"),
        "learn": ("learn.learn", "iterative learning control of the setpoints"),
    },
    "Results": {
        "show": ("show.show", "a stored result, or study, in the terminal"),
        "view": ("show.view", "results in the browser, several side by side"),
        "figures": ("figures.figures", "draw the figures of a result, for print"),
    },
    "Many runs": {
        "compare": ("compare.compare", "rank controllers and references on one task"),
        "tune": ("tune.tune", "tune controller gains, nominal or worst case"),
        "batch": ("batch.batch", "vary parameters of one robot: grid or Monte Carlo"),
        "sensitivity": ("sensitivity.sensitivity", "global sensitivity: Sobol' indices, Morris"),
        "optimize": ("optimize.optimize", "design optimization under constraints"),
    },
    "Equations and code": {
        "eval": ("evaluate.evaluate", "mass matrix, bias, Jacobians at given states"),
        "export": ("export.export", "the equations and integrator as WebAssembly"),
        "cache": ("cache.cache", "show or clear the cache of compiled code"),
    },
}  # fmt: skip
"""The commands in groups: where the function of each is in this package, and what it does."""

COMMANDS = {name: home for group in _GROUPS.values() for name, (home, _) in group.items()}
"""The function of each command, by its module in this package; imported when the command is given."""

_OLD = {"ladder": "describe.ladder"}
"""Names that commands had: they still work."""

_PLAIN: Any = {"add_completion": False, "pretty_exceptions_enable": False, "rich_markup_mode": None}
"""No markup: its tables cut long words, and take units in brackets for markup."""


class _Command(TyperCommand):
    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Refuse ``--out ""``, which the library takes for the current folder."""
        if "--out=" in args or ("--out", "") in pairwise(args):
            raise InputError("--out", "no name", "the name of a folder or file", "write it; . is this folder")
        return super().parse_args(ctx, args)


class Commands(TyperGroup):
    """The commands by name, each imported and built when it is asked for."""

    def __init__(self, **given: Any) -> None:
        named: Any = given | {"commands": dict.fromkeys(COMMANDS)}
        super().__init__(**named)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:  # noqa: ARG002
        """The command of a name; None where there is none."""
        home = COMMANDS.get(cmd_name) or _OLD.get(cmd_name)
        if home is None:
            return None
        module, _, function = home.partition(".")
        single = typer.Typer(**_PLAIN)
        single.command(cmd_name, cls=_Command)(getattr(import_module(f"tmodes.cli.{module}"), function))
        return typer.main.get_command(single)

    def format_help_text(self, ctx: Any, formatter: Any) -> None:
        """What tmodes is, and its commands, the first ones first; none is imported."""
        super().format_help_text(ctx, formatter)
        for title, group in _GROUPS.items():
            with formatter.section(title):
                formatter.write_dl([(name, words) for name, (_, words) in group.items()], col_spacing=3)

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Nothing further: they stand before the options."""


app = typer.Typer(
    name="tmodes",
    cls=Commands,
    no_args_is_help=True,
    help="Model, simulate and control robots that bend: elastic gears, flexible links, a tip that touches the world.",
    epilog="""\b
    Start with:       tmodes run two_link_arm
    Your own robot:   tmodes robots two_link_arm > my.yaml; tmodes check my.yaml
    All of a command: tmodes COMMAND --help

    Exit codes: 0 done, 2 wrong input, 3 the run failed, 4 a file cannot be read or written, 5 compiler trouble,
    70 a fault of tmodes, 130 interrupted.""",
    **_PLAIN,
)


def _version(wanted: bool) -> None:
    if wanted:
        from tmodes import __version__

        typer.echo(f"tmodes {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
    use: Annotated[
        list[str] | None,
        typer.Option("--use", help="Kinds of your own: a Python file, a module, or an entry point; may be repeated."),
    ] = None,
) -> None:
    del version
    if use:
        from tmodes.kinds.outside import use as load_kinds

        load_kinds(*use)


def main() -> None:
    """Run the command line; ends the process with its exit code, never with a traceback for what a user can fix."""
    _prepare_streams()
    Stages.last_line = clock.monotonic()
    try:
        code = app(standalone_mode=False) or 0
        sys.stdout.flush()
    except TmodesError as error:
        _say(f"tmodes: {error}")
        code = error.exit_code
    except typer.TyperException as error:
        _explain(error)
        code = error.exit_code
    except (KeyboardInterrupt, typer.Abort):
        code = INTERRUPTED
    except BrokenPipeError:
        code = 0
    except Exception as error:
        code = _explained(error)
    except BaseException as error:
        code = _left(error)
    if code == INTERRUPTED:
        _say("tmodes: interrupted" + ("" if "batch" in sys.argv[1:2] else "; run the same command again to continue"))
    _leave(code)


def _left(error: BaseException) -> int:
    """Say what has ended the program, past all that handles errors; the exit code."""
    from tmodes.kinds.outside import own_place

    if isinstance(error.__context__, BrokenPipeError):
        return 0  # the reader of our output went away (| head), of which rich makes an exit: nothing to say, no fault
    got, expected = error_words(error), "code that leaves the program to tmodes"
    wrong = InputError("code of your own", got, expected, "raise an error, or return", own_place(error))
    _say(f"tmodes: {wrong}")
    return wrong.exit_code


def _explained(error: Exception) -> int:
    """Say what went wrong where no part of tmodes did; the exit code."""
    if lacks_memory(error):
        _say(f"tmodes: {words()}")
        return OUT_OF_MEMORY
    if isinstance(error, OSError) and error.strerror:
        _say(f"tmodes: the output cannot be written: {error.strerror}; free some space, or send it elsewhere")
        return 4
    if os.environ.get("TMODES_DEBUG"):
        raise error
    _say(f"tmodes: a fault of tmodes itself, please report it: {type(error).__name__}: {error}")
    _say("(TMODES_DEBUG=1 shows where)")
    return FAULT


def _explain(error: Any) -> None:
    """A misuse of the line: of an option's value that is none in our own words, else in those of the library."""
    from pydantic import ValidationError

    if not isinstance(error.__cause__, ValidationError):
        error.show()
        return
    found = error.__cause__.errors()[0]
    kinds = {"float_parsing": "a number", "int_parsing": "a whole number"}
    expected = kinds.get(found["type"]) or found["msg"].rpartition(" is not ")[2].removeprefix(
        "Input should be "
    ).rstrip(".")
    hint = f"see {error.ctx.command_path} --help"
    _say(f"tmodes: {InputError(error.param.opts[0], ascii(found['input']), expected, hint)}")


def _prepare_streams() -> None:
    """Closed streams lead nowhere; letters that a terminal does not know are given by their number."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w", encoding="utf-8"))  # noqa: SIM115
        stream = getattr(sys, name)
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def _leave(code: int) -> None:
    """End the process; what is still to be written to a stream that is gone or full is let go."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            with suppress(OSError):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    gc.freeze()  # Python ends by looking for circles among all objects, which is a fifth of a short command
    sys.exit(code)


def _say(text: str) -> None:
    with suppress(OSError):
        print(text, file=sys.stderr)


if __name__ == "__main__":
    main()
