"""Where the command starts: light, so that Ctrl-C is heard in good manners also while the rest is loaded."""

from __future__ import annotations

import sys

__all__ = ["start"]


def start() -> None:
    """Load the command line and run it; ends the process."""
    try:
        from tmodes.cli.main import main

        main()
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    start()
