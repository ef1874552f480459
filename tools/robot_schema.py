"""Writes docs/robot-schema.json, the data sheet's JSON Schema for editors: ``robot_schema.py [--check]``."""

from __future__ import annotations

import json
import sys

import generated
from tmodes.io.forms import json_schema

if __name__ == "__main__":
    text = json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"
    sys.exit(generated.main(generated.ROOT / "docs" / "robot-schema.json", text, "robot_schema"))
