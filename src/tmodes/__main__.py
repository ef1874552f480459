"""``python -m tmodes``: the same as the command ``tmodes``."""

from tmodes.cli.entry import start

if __name__ == "__main__":
    start()
