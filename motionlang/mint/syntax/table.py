"""Writer of the table of the grammar: `python -m motionlang.mint.syntax.table [FOLDER [PYTHON]]`."""

from __future__ import annotations

import sys

from motionlang.cache import GRAMMARS
from motionlang.lang.syntax.grammar import PYTHON, store
from motionlang.mint.syntax.build import Builder


def write(target: str = GRAMMARS, python: str = PYTHON) -> None:
    """Write the table for the present Lark and a version of Python into a folder."""
    store("mint", Builder(), target, python)


if __name__ == "__main__":
    write(*sys.argv[1:])
