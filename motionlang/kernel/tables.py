"""Writer of the tables of the grammars: `python -m motionlang.kernel.tables [FOLDER [PYTHON]]`."""

from __future__ import annotations

import sys

from motionlang.kernel.lang.syntax.grammar import GRAMMARS, PYTHON, store
from motionlang.kernel.mccl.syntax import parser as mccl
from motionlang.kernel.mint.syntax.build import Builder


def write(target: str = GRAMMARS, python: str = PYTHON) -> None:
    """Write the tables for the present Lark and a version of Python into a folder."""
    store("mint", Builder(), target, python)
    store("mccl", mccl.Builder(), target, python, **mccl.OPTIONS)


if __name__ == "__main__":
    write(*sys.argv[1:])
