"""Names of channels, axes and registers in the comments of programs."""

from __future__ import annotations

from pathlib import Path

from motionlang.kernel import Source, dialect_for
from motionlang.kernel.lang import names_in_comments
from tests.cases import cases

HEADERS = Path(__file__).with_name("headers.txt").read_text().split("\n\n")[1:]


@cases("header", [each.strip("\n") for each in HEADERS])
def test_names_in_headers(header: str) -> None:
    lines = header.splitlines()
    text = "\n".join(each for each in lines if not each.startswith("="))
    wanted = ", ".join(each[2:].rstrip(",") for each in lines if each.startswith("=") and each[2:])
    source = Source("a.mcl" if text.startswith(";") else "a.prg", f"{text}\n")
    found = names_in_comments(source, dialect_for(source, None))
    assert ", ".join(f"{each.kind} {each.number} {each.name}" for each in found) == wanted
