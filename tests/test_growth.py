"""Each command takes twice the work for a program of twice the length: counted in calls, not in seconds.

A shape is a way to write a long program. The normal run gives each shape to one of the commands, at few lines; the slow
tests give all shapes to each command. `extras/explore` measures its commands in the same way.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.commands.check import check
from motionlang.kernel import Source, dialect_of
from tests.counted_calls import all_calls, lines_by_function


def _lines(text: str, count: int) -> str:
    """Return a text with `{i}` and `{k}` in it for each i below `count`, with a k that jumps about."""
    return "".join(text.replace("{i}", str(i)).replace("{k}", str(i * 7 % count)) for i in range(count))


# Each program by its file: its text has about as many lines as it is asked for.
SHAPES: dict[str, Callable[[int], str]] = {
    "flat.mnt": lambda n: _lines("MOVER(0) = 5 : GO(0) : PAUSE IDLE(0)\n", n),
    "subs.mnt": lambda n: (
        _lines("Sub s{i}()\nMOVER(0) = 5\nGO(0)\nPAUSE IDLE(0)\nEnd Sub\n", n // 6) + _lines("s{i}\n", n // 6)
    ),
    "labels.prg": lambda n: _lines("#L{i}\nx = {i}\n", n // 2) + "IF x = 1 THEN GOTO L5\n",
    "gotos.prg": lambda n: _lines("#L{i}\nx = x + 1\nIF x > {i} THEN GOTO L{k}\n", n // 3),
    "gosubs.prg": lambda n: (
        "#TOP\n"
        + _lines("GOSUB S{i}\n", n // 6)
        + "END\n"
        + _lines("#S{i}\nMOVER.0 = 1 : GO.0\nPAUSE IDLE.0\nIF INX.1 THEN GOTO TOP\nRETURN\n", n // 6)
    ),
    "ifs.mnt": lambda n: _lines("If INX(3) Then\nOUTX(1) = 1\nElse\nOUTX(1) = 0\nEnd If\n", n // 5),
    "blocks.mnt": lambda n: (
        "Dim x\n"
        + _lines(
            "While x < {i}\nIf x > 3 Then\nFor j = 1 To 3\nx = x + j\nNext\nEnd If\nx = x + 1\nEnd While\n",
            n // 8,
        )
    ),
    "select.mnt": lambda n: (
        "Dim k As Integer\nLoop\nPAUSE INX(1)\nSelect Case k\n"
        + _lines("Case {i}\nOUTX(1) = 1\nk = {k}\n", n // 3)
        + "End Select\nEnd Loop\n"
    ),
    "variables.mnt": lambda n: (
        _lines("Dim v{i} As Integer\n", n // 2) + _lines("v{i} = v{k} + 1\n", n // 2)
    ),
    "tasks.mnt": lambda n: (
        _lines("Run t{i}\n", n // 6)
        + "End\n"
        + _lines("Task t{i}\nMOVER(0) = 1\nGO(0)\nPAUSE IDLE(0)\nEnd Task\n", n // 6)
    ),
    "events.mnt": lambda n: (
        "Dim d\n"
        + _lines("Run t{i}\n", n // 6)
        + "End\n"
        + _lines("Event IN{i}\nd = {i}\nEnd Event\n", 16)
        + _lines("Task t{i}\nPAUSE INX(3)\nd = d + {i}\nOUTX(1) = d > 3\nEnd Task\n", n // 6)
    ),
    "lines.mcl": lambda n: "1SV100,1SA1000,1DS1000,1MN\n" + _lines("1MR100,1WS0\n", n),
    "macros.mcl": lambda n: (
        "1MN\n" + _lines("MD{i},1MR100,1WS0\nMC{i}\n", n // 2)
    ),
    "jumps.mcl": lambda n: "1MN\n" + "".join(f"MD{i},1MR100,MJ{i + 1}\n1WS0\n" for i in range(n // 2)) + "MC1\n",
    "calls.mcl": lambda n: "1MN\n" + "".join(f"MD{i},1MR100,MC{i + 1}\n1WS0\n" for i in range(n // 2)) + "MC1\n",
    "table.mcl": lambda n: (
        "1MN\n" + "".join(f"MD{i},WN1,WA.01,AL{i * 7 % n},AR40,MJ@40\n" for i in range(n)) + "MC1\n"
    ),
}  # fmt: skip
COMMANDS = ("check", "steps", "run", "diff", "edit")
UNTIL = ["--until", "0.001"]


def _work(command: str, name: str, text: str) -> None:
    """Carry out a command on a program; its file is in the current folder."""
    arguments = {
        "check": ["check", name],
        "steps": ["check", name, "--steps"],
        "run": ["run", name, *UNTIL],
        "diff": ["diff", name, f"old-{name}", *UNTIL],
    }
    if command == "edit":
        _edit(name, text)
    else:
        main(arguments[command])


def _edit(name: str, text: str) -> None:
    """Check a text, as an editor does when typing pauses."""
    language = dialect_of(name)
    assert language is not None
    check(language.program(Source(name, text), {}))


def measure(work: Callable[[str, str], None], shape: str, sizes: Sequence[int]) -> list[int]:
    """Return the calls that some work on a file and its text makes for a shape of each size."""
    found = []
    for size in (20, *sizes):  # the first one also imports and prepares
        text = SHAPES[shape](size)
        for name in (shape, f"old-{shape}"):
            Path(name).write_text(text, encoding="utf-8")
        found.append(all_calls(partial(work, shape, text)))
    return found[1:]


def is_linear(calls: list[int]) -> bool:
    """True if twice the length is twice the work."""
    return all(more <= 2.3 * less for less, more in pairwise(calls))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / ".cache"))


@pytest.mark.parametrize("shape", SHAPES)
def test_a_program_of_twice_the_length_is_twice_the_work(shape: str) -> None:
    command = COMMANDS[list(SHAPES).index(shape) % len(COMMANDS)]
    calls = measure(partial(_work, command), shape, (30, 60, 120))
    assert is_linear(calls), (command, calls)


# Long flat files in which a search through the whole file takes little of the time.
FLAT: dict[str, Callable[[int], str]] = {
    "gotos.prg": SHAPES["gotos.prg"],
    "gosubs.prg": SHAPES["gosubs.prg"],
    "blocks.mnt": SHAPES["blocks.mnt"],
    "settings.mnt": lambda n: _lines("SPEED(0) = 10\nACCEL(0) = 20\n", n // 2),
    "modes.mcl": lambda n: _lines("1VM,1GO\n", n // 2),
}


@pytest.mark.parametrize("shape", FLAT)
def test_no_function_of_check_does_more_than_twice_the_work(shape: str) -> None:
    """Counted in lines, each function by itself, so that a short one that grows is seen at small sizes."""
    _edit(shape, FLAT[shape](20))  # imports and prepares
    less, more = (lines_by_function(partial(_edit, shape, FLAT[shape](size))) for size in (48, 96))
    grown = {
        f"{code.co_filename}:{code.co_firstlineno} {code.co_name}": (less[code], count)
        for code, count in more.items()
        if count > max(250, 2.6 * less[code])
    }
    assert grown == {}


# The lengths of the tests that are slow, and of those that take minutes.
LONG = [
    pytest.param((150, 300, 600), marks=pytest.mark.slow),
    pytest.param((500, 1000, 2000), marks=pytest.mark.long),
]


@pytest.mark.parametrize("sizes", LONG, ids=str)
@pytest.mark.parametrize("command", COMMANDS)
def test_all_shapes_of_long_programs_are_twice_the_work(command: str, sizes: tuple[int, ...]) -> None:
    calls = {shape: measure(partial(_work, command), shape, sizes) for shape in SHAPES}
    assert [f"{shape}: {each}" for shape, each in calls.items() if not is_linear(each)] == []
