"""The distributions of the folder extras that are installed, and the others; tests of the package need none."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from motionlang.extras import COMMANDS as EXTRAS

ROOT = Path(__file__).parent.parent
INSTALLED = [each for each in sorted((ROOT / "extras").glob("*")) if find_spec(f"motionlang_{each.name}")]
ABSENT = sorted({*EXTRAS} - {each.name for each in INSTALLED})
# The commands that these bring or extend.
MISSING = frozenset(command for name in ABSENT for command in EXTRAS[name])
