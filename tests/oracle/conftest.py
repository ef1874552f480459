"""The peers lie next to the package, not in it: the repository's root must be importable."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))
