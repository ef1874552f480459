"""One call of a user's Python function: a finite number or the reason why there is none, whatever the function does."""

from __future__ import annotations

import faulthandler
import io
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import chdir, contextmanager, redirect_stdout, suppress
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.errors import TmodesError, error_words
from tmodes.study.quantities.contract import MOST

__all__ = ["called"]

Own = Callable[[Any], float]


def called(function: Own, result: Any, timeout: float) -> float:
    """One finite number of a result; raises :class:`tmodes.errors.TmodesError` that says why there is none."""
    own = _own_view(result)
    try:
        with _limited(timeout), _descriptor_aside(), redirect_stdout(_Aside()), chdir(Path.cwd()):
            value = function(own)
    except _TooLongError:
        raise TmodesError(f"TimeoutError: took longer than {timeout:g} s") from None
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # what a library raises to end a task is an error here as any other
        raise TmodesError(error_words(error)) from error
    return _number(value)


def _number(value: Any) -> float:
    """What a function has returned, if that is one finite number."""
    try:
        found = np.asarray(float(value) if type(value) is int else value)
    except Exception as error:
        what = f"`{type(value).__name__}`, of which none can be made ({error_words(error)})"
        raise TmodesError(f"the function must return one number, got {what}") from error
    if found.shape or not (np.issubdtype(found.dtype, np.integer) or np.issubdtype(found.dtype, np.floating)):
        what = f"an array of shape {found.shape}" if found.shape else f"`{type(value).__name__}`"
        raise TmodesError(f"the function must return one number, got {what}")
    if not abs(float(found)) <= MOST:
        raise TmodesError(f"the function must return a finite number, got {float(found)!r}")
    return float(found)


class _Aside(io.TextIOBase):
    """Standard output while a function runs: what it prints goes to standard error; it may close this one."""

    def write(self, text: str, /) -> int:
        """Write on standard error."""
        return sys.stderr.write(text)


@contextmanager
def _descriptor_aside() -> Iterator[None]:
    """What compiled code writes, or a program that the function starts, goes there too; it may close the descriptor."""
    try:
        sys.stdout.flush()
        kept = os.dup(1)
    except (OSError, ValueError, AttributeError):  # a process without output
        yield
        return
    try:
        with suppress(OSError):
            os.dup2(2, 1)
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)


def _own_view(result: Any) -> Any:
    """The result with a dictionary of its own, over the same arrays, which cannot be written."""
    for variable in result.data.variables.values():
        variable.values.flags.writeable = False
    view = object.__new__(type(result))
    view.__dict__.update(result.__dict__, data=result.data.copy(deep=False))
    return view


class _TooLongError(BaseException):
    """The time is over: no ``except Exception`` of a function may hide it."""


_AGAIN = 0.5
"""Seconds after which one that has hidden it all the same is interrupted once more."""

_GRACE = 5.0
"""Seconds after twice its time, when a process that came back from no alarm is ended."""


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    """Raise _TooLongError in what takes longer; only in the main thread of a process of a system with alarms."""
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(*_: Any) -> None:
        raise _TooLongError

    before = signal.signal(signal.SIGALRM, stop)
    with _ended_after(2 * seconds + _GRACE):
        signal.setitimer(signal.ITIMER_REAL, seconds, _AGAIN)
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)


@contextmanager
def _ended_after(seconds: float) -> Iterator[None]:
    """End a process that computes results alone, where it hangs in code that no alarm interrupts."""
    if multiprocessing.parent_process() is None:
        yield
        return
    with Path(os.devnull).open("w", encoding="utf-8") as nowhere:
        faulthandler.dump_traceback_later(seconds, exit=True, file=nowhere)
        try:
            yield
        finally:
            faulthandler.cancel_dump_traceback_later()
