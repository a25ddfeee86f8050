"""The console blocks of a page: read, run and replaced.

`python -m tests.lab.copley.docs` replaces them. Only `motionlang pvt` is run; `cat FILE` creates the file that it
shows.
"""

from __future__ import annotations

import os
import re
import shlex
import tempfile
from contextlib import chdir
from pathlib import Path
from typing import TYPE_CHECKING

from tests.lab.copley.command import pvt

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "copley.md"
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def blocks(text: str) -> Iterator[list[tuple[str, str]]]:
    """Yield each block as pairs: a command, and its output on the page."""
    for match in BLOCK.finditer(text):
        chunks = re.split(r"^\$ (.*)\n", match[1], flags=re.MULTILINE)
        yield list(zip(chunks[1::2], chunks[2::2], strict=True))


def answer(command: str, shown: str) -> str:
    """Return the output of a command, standard error after standard output.

    `cat` creates its file from the shown text.
    """
    program, *words = shlex.split(command)
    if program == "cat":
        Path(words[0]).write_text(shown, encoding="utf-8")
        return shown
    assert (program, words[0]) == ("motionlang", "pvt"), command
    words = [str(ROOT / word) if word.startswith("scripts/") else word for word in words[1:]]
    result = pvt(*words)
    return result.out + result.err


def rewritten(text: str) -> str:
    """Return the page with all outputs replaced by the present ones."""

    def fresh(match: re.Match[str]) -> str:
        ((pairs),) = blocks(match[0])
        return "```console\n" + "".join(f"$ {c}\n{answer(c, shown)}" for c, shown in pairs) + "```"

    with tempfile.TemporaryDirectory() as folder, chdir(folder):
        return BLOCK.sub(fresh, text)


if __name__ == "__main__":
    os.environ.setdefault("PYTHONHASHSEED", "0")
    PAGE.write_text(rewritten(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
