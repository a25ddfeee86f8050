"""Commands and all that they print, in `transcripts.txt` and, by command, in `transcripts_*.txt`.

A section has a name after `== `, and commands after `$ `. Below each are its standard output, its standard error with
`! `, and its exit status if that is not 0. `< FILE` is its standard input; `cat FILE` prints a file, and `cat > FILE`
writes one with the lines below. Each section begins in a folder with the files below. `--update` rewrites what the
commands print.
"""

from __future__ import annotations

import io
import shlex
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from _pytest.mark.structures import ParameterSet

from motionlang import __version__
from tests.cli.programs import STROKE, Cell
from tests.generated.results import rounded

TRANSCRIPTS = sorted(Path(__file__).parent.glob("transcripts*.txt"))
LIMITS = "[axis.0.limits]\nspeed = 250\nacceleration = 1500\n"
# A sub with a move and a dwell, called twice; a loop that polls an input; a question; a computing loop.
CELL = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
OUT(1) = 1
For i = 1 To 2
  Lift(10 * i)
Next
While INX(2) = 0
  n = n + 1
Wend
PAUSE INX(3) = 1
OUT(1) = 0
Input "Way ", s
MOVER(0) = s : GO(0)
MOVER(1) = 1 : GO(1)
PAUSE IDLE(0) And IDLE(1)
For i = 1 To 3
  k = k + i
Next
Sub Lift(far As Float)
  MOVER(0) = far : GO(0)
  PAUSE IDLE(0)
  WAIT = 50
End Sub
"""
# A task that polls what another one does.
TASKS = """\
Dim ready
SPEED(0, 1) = 100; : ACCEL(0, 1) = 1000; : DECEL(0, 1) = 1000;
Run Feeder
PAUSE ready = 1
MOVER(0) = 20 : GO(0)
PAUSE IDLE(0)
PAUSE INX(1)
End
Task Feeder
  MOVER(1) = 10 : GO(1)
  PAUSE IDLE(1)
  WAIT = 30
  ready = 1
End Task
Event IN1
  OUT(2) = 1
End Event
"""
BOARD = """\
MD1,1MR100,1WS,WA0.1
1MN,2MN,1SV1000,1SA10000,1DS10000,2SV500,2SA5000,2DS5000
MC1
MD10,2MA50,2WS0.05
2MR200,2WS
AL3,AR9
WN2
MC10
"""
PATH = """\
SPEED(0, 1) = 100; : ACCEL(0, 1) = 1000; : DECEL(0, 1) = 1000;
VECTORR(0, 1) = 30, 40 : GO(0)
VECTORR(0, 1) = 30, 40 : GO(0)
VECTORR(0, 1) = 40, -30 : GO(0)
CIRCLER(0, 1) = 0, 10, 90 : GO(0)
PAUSE IDLE(0) And IDLE(1)
"""
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
    "half.mnt": f"{STROKE}MOVER(1) = 10 : GO(1) : PAUSE IDLE(1)\n",
    "half.machine.toml": LIMITS,
    "empty/readme.txt": "nothing\n",
    "limit.mnt": "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\n",
    "limit.machine.toml": "[axis.0]\ntravel = [-10, 50]\n",
    "handled.mnt": "LIMITMODE(0) = 0\nMOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\nEvent ONERROR\nEnd Event\n",
    "handled.machine.toml": "[axis.0]\ntravel = [-10, 50]\n",
    "fixable.mnt": "MOVER(3) = 5 : GO3\nPrint “x”\nPrint ‘y\n",
    "corner.mnt": "VECTORR(0, 1) = 0, 0 : GO(0) : PAUSE IDLE(0)\nVECTORR(0, 1) = 10, 0 : GO(0) : PAUSE IDLE(0)\n",
    "latched.mnt": "LATCHTRIGGERCHANNEL(0) = 3\nLATCHENABLE(0) = 1\nPAUSE LATCH(0)\n",
    "unarmed.mnt": "PAUSE LATCH(0)\n",
    "lost.mnt": "MR0 = 10 : GO0\nPAUSE IDLE(0)\n",
    "screen.mnt": 'PRINT "a";\nCLS\nLOCATE 3, 4\nPRINT "x"\n',
    "both.prg": "SPEED[0,1] = 100, 50\nACCEL[0,1] = 1000, 500\nMOVER[0,1] = 10, 20\nGO[0,1]\nPAUSE IDLE[0,1]\n",
    "shift.mnt": (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nLoop\n  OUTX(1) = 1\n  MOVER(0) = 50 : GO(0)\n"
        '  PAUSE IDLE(0)\n  OUTX(1) = 0\n  PRINT "done ", POS(0)\n  WAIT = 100\nEnd Loop\n'
    ),
    "shift.machine.toml": 'run.until = 5\n[[expect]]\nquantity = "cycle(4)"\nat_most = 0.6\n',
    "waits.mnt": "PAUSE INX(3)\nPRINT TIME\n",
    "banks.mnt": 'If IN(3) Then PRINT "on"\n',
    "idle.mnt": "GO3\nPRINT 1\n",
    "one.mnt": "Print “x”\n",
    "v4.mnt": "AUTO\nn = 8\nSPEED.0 = 10\n? n\n",
    "tiny.mnt": "Const size = 2\nDim n\nn = size\n",
    "spare.mnt": "Dim spare\nDim other\n",
    "macros.mcl": "1MN,1SV100,1SA1000,1DS1000\n1MR100,1WS\n",
    "old.prg": 'IF INX.4 = 0 THEN GOTO bad\nPAUSE INX.2\nINPUT "Way ", s\nEND\n#bad\n? "bad"\n',
    "asked.prg": "PAUSE INX.2\n",
    "unnamed.prg": "INPUT n\n",
    "cell.mnt": CELL,
    "tasks.mnt": TASKS,
    "boards.mcl": BOARD,
    "path.mnt": PATH,
    "turns.mnt": "SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100\nCIRCLER(0, 1) = 5, 0, 720\nGO(0)\nPAUSE IDLE(0)\n",
    "table.mnt": "POSWRAP(0) = 360\nSPEED(0) = 100 : MOVER(0) = 710 : GO(0) : PAUSE IDLE(0)\nPRINT POS(0)\n",
    "halted.mnt": "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 50\nMOVER(0) = 100 : GO(0)\nWAIT(2000)\nCANCEL(0)\n",
    "measured.csv": "time,x,y\n0,0,1\n0.5,50,1\n1,100,1\n",
    "points.csv": "position,velocity,time\n0,0,100\n1000,8000,100\n2000,0,0\n",
}


def sections(page: Path) -> dict[str, str]:
    """Return the transcripts of a page by their names."""
    texts = page.read_text(encoding="utf-8").removeprefix("== ").split("\n== ")
    return {name: text for name, _, text in (each.partition("\n") for each in texts)}


def replayed(transcript: str, cell: Cell) -> str:
    """Return a transcript as its commands now print it."""
    lines = []
    for block in transcript.removeprefix("$ ").split("\n$ "):
        command, _, below = block.partition("\n")
        verb, *rest = shlex.split(command)
        lines.append(f"$ {command}")
        if verb == "cat" and rest[0] == ">":
            cell.write(rest[1], below.rstrip("\n") + "\n")
            lines += below.rstrip("\n").split("\n")
            continue
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


def sections_of(pages: Sequence[Path]) -> list[ParameterSet]:
    """Return the sections of some pages as parameters: page and name."""
    return [
        pytest.param(page, name, id=f"{page.stem.partition('_')[2]} {name}".strip())
        for page in pages
        for name in sections(page)
    ]


@pytest.fixture
def compared(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> Callable[[Path, str], None]:
    """Return the comparison of a section of a page with what its commands print."""
    for path in cell.folder.glob("*.mcl"):
        path.unlink()
    for file, text in FILES.items():
        cell.write(file, text)
    monkeypatch.setattr(sys, "stdin", sys.stdin)
    monkeypatch.setenv("COLUMNS", "100")

    def compare(page: Path, name: str) -> None:
        recorded = sections(page)
        found = replayed(recorded[name], cell)
        if request.config.getoption("--update"):
            recorded[name] = found
            texts = [f"== {each}\n{text.rstrip()}\n" for each, text in recorded.items()]
            page.write_text("\n".join(texts), encoding="utf-8", newline="\n")
        assert rounded(found.rstrip()) == rounded(recorded[name].rstrip())

    return compare


@pytest.mark.parametrize(("page", "name"), sections_of(TRANSCRIPTS))
def test_a_transcript(page: Path, name: str, compared: Callable[[Path, str], None]) -> None:
    compared(page, name)
