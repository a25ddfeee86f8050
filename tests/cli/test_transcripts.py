"""Commands and all that they print, in `transcripts.txt`.

A section has a name after `== `, and commands after `$ `. Below each are its standard output, its standard error with
`! `, and its exit status if that is not 0. `< FILE` is its standard input; `cat FILE` prints a file. Each section
begins in a folder with the files below. `--update` rewrites what the commands print.
"""

from __future__ import annotations

import io
import re
import shlex
import sys
from pathlib import Path

import pytest

from motionlang import __version__
from tests.cli.programs import Cell

TRANSCRIPTS = Path(__file__).with_name("transcripts.txt")
STROKE = """\
Const rate = 1000
Const length = 100
SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate
MOVER(0) = length : GO(0) : PAUSE IDLE(0)
PRINT "there"
"""
LIMITS = "[axis.0.limits]\nspeed = 250\nacceleration = 1500\n"
FILES = {
    "stroke.mnt": STROKE,
    "limited/a.mnt": STROKE,
    "limited/a.machine.toml": LIMITS,
    "limited/b.mnt": STROKE.replace("1000", "1600"),
    "limited/b.machine.toml": LIMITS,
    **{f"limited/{number}.mnt": "Print 1\n" for number in range(5)},
    "many/a.mnt": STROKE,
    "many/a.machine.toml": LIMITS,
    **{f"many/{number}.mnt": "Print 1\n" for number in range(6)},
    "wrong/a.mnt": "Print 1 +\n",
    "wrong/b.mnt": "Print 1\n",
    "wrong/b.machine.toml": "[axis.0]\ntravvel = 3\n",
    "faulty/a.mnt": "Dim zero\nPrint 1 / zero\n",
    "faulty/a.machine.toml": LIMITS,
    "empty/readme.txt": "nothing\n",
    "limit.mnt": "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\n",
    "limit.machine.toml": "[axis.0]\ntravel = [-10, 50]\n",
    "handled.mnt": "LIMITMODE(0) = 0\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\nEvent ONERROR\nEnd Event\n",
    "handled.machine.toml": "[axis.0]\ntravel = [-10, 50]\n",
    "fixable.mnt": "GO3\nPrint “x”\nPrint ‘y\n",
    "one.mnt": "Print “x”\n",
    "tiny.mnt": "Const size = 2\nDim n\nn = size\n",
    "spare.mnt": "Dim spare\nDim other\n",
    "macros.mcl": "1MN,1SV100,1SA1000,1DS1000\n1MR100,1WS\n",
    "old.prg": 'IF INX.4 = 0 THEN GOTO bad\nPAUSE INX.2\nINPUT "Way ", s\nEND\n#bad\n? "bad"\n',
    "asked.prg": "PAUSE INX.2\n",
    "unnamed.prg": "INPUT n\n",
}


def sections() -> dict[str, str]:
    """Return the transcripts by their names."""
    texts = TRANSCRIPTS.read_text(encoding="utf-8").removeprefix("== ").split("\n== ")
    return {name: text for name, _, text in (each.partition("\n") for each in texts)}


def replayed(transcript: str, cell: Cell) -> str:
    """Return a transcript as its commands now print it."""
    lines = []
    for command in re.findall(r"^\$ (.*)", transcript, re.MULTILINE):
        verb, *rest = shlex.split(command)
        lines.append(f"$ {command}")
        if verb == "cat":
            lines += (cell.folder / rest[0]).read_text(encoding="utf-8").splitlines()
            continue
        if "<" in rest:
            sys.stdin = io.TextIOWrapper(io.BytesIO((cell.folder / rest.pop()).read_bytes()))
            rest.remove("<")
        ran = cell(verb, *rest)
        lines += [*ran.out.splitlines(), *(f"! {line}" for line in ran.err.splitlines())]
        lines += [f"exit status {ran.status}"] if ran.status else []
    return "\n".join([*lines, ""]).replace(f"motionlang {__version__}", "motionlang VERSION")


@pytest.mark.parametrize("name", sections())
def test_a_transcript(
    name: str, cell: Cell, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    for path in cell.folder.glob("*.mcl"):
        path.unlink()
    for file, text in FILES.items():
        (cell.folder / file).parent.mkdir(exist_ok=True)
        cell.write(file, text)
    monkeypatch.setattr(sys, "stdin", sys.stdin)
    monkeypatch.setenv("COLUMNS", "100")
    recorded = sections()
    found = replayed(recorded[name], cell)
    if request.config.getoption("--update"):
        recorded[name] = found
        texts = [f"== {each}\n{text.rstrip()}\n" for each, text in recorded.items()]
        TRANSCRIPTS.write_text("\n".join(texts), encoding="utf-8", newline="\n")
    assert found.rstrip() == recorded[name].rstrip()
