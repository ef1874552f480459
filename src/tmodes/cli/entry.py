"""Where the command starts: light, so that Ctrl-C is heard in good manners also while the rest is loaded."""

from __future__ import annotations

import gc
import os
import sys
import warnings

from tmodes.cli.memory import OUT_OF_MEMORY, lacks_memory, prepare, words

__all__ = ["start"]

_RARELY = 250_000, 20, 50
"""When Python looks for circles among objects; at its own 700, 10, 10 it spends a twentieth of a command on it.

What is loaded for one run of a small robot has fewer objects than the first number."""


def start() -> None:
    """Load the command line and run it; ends the process."""
    gc.set_threshold(*_RARELY)
    if not sys.warnoptions and "TMODES_DEBUG" not in os.environ:  # numbers out of range are answered where they matter
        warnings.simplefilter("ignore")
        os.environ["PYTHONWARNINGS"] = "ignore"  # for processes that are started
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # it would read the metadata of all that is installed
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only cost; batches have their own
    try:
        prepare()
        from tmodes.cli.main import main

        main()
    except KeyboardInterrupt:
        sys.exit(130)
    except Exception as error:  # while it is loaded
        if not lacks_memory(error):
            raise
        print(f"tmodes: {words()}", file=sys.stderr)
        sys.exit(OUT_OF_MEMORY)


if __name__ == "__main__":
    start()
