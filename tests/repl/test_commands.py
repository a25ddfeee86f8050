"""Dot commands, completion and the state of the machine, with their boundaries."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.kernel import dialect
from motionlang.repl.commands import COMMANDS, GROUPS, is_command, without_dot
from motionlang.repl.complete import candidates
from motionlang.repl.session import Session
from motionlang.repl.status import number_text


def talk(*lines: str, language: str = "mint") -> str:
    """Return the answer to the last line."""
    session = Session(dialect(language))
    return [session.feed(line) for line in lines][-1]


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        (".time", "0 s\n"),
        (".run 1.5", "1.5 s\n"),
        (".RUN 0", "0 s\n"),
        (".run 28800", "28800 s\n"),
        (".run 28801", "error[range]: .run takes 0 to 28800 seconds, not 28801\n  hint: .run 0.5\n"),
        (".run -1", "error[range]: .run takes 0 to 28800 seconds, not -1\n  hint: .run 0.5\n"),
        (".run soon", "error[range]: .run takes 0 to 28800 seconds, not soon\n  hint: .run 0.5\n"),
        (".run", "error[values]: usage: .run S\n  hint: let S seconds of machine time pass\n"),
        (".time now", "error[values]: usage: .time\n  hint: show machine time and positions in one line\n"),
        (".axes", "8 axes, none moved yet\n"),
        (".tim", "error[unknown-word]: there is no command .tim\n  hint: did you mean .time?\n"),
        (".xyzzy", "error[unknown-word]: there is no command .xyzzy\n  hint: .help lists the commands\n"),
        (".help .run", ".run S  Let S seconds of machine time pass.\n"),
        (".help SPEE", "error[unknown-word]: SPEE is not a keyword\n  hint: did you mean SPEED?\n"),
        (".help .SPEED", "error[unknown-word]: .SPEED is not a keyword\n  hint: did you mean SPEED?\n"),
        (".live on", "error[not-simulated]: .live needs a terminal\n  hint: use .run S to let time pass\n"),
        (
            ".analog 0=200",
            "error[option]: value of [[analogue]] must be a percentage, -100 to 100, not 200.0\n"
            "  hint: the value in percent, such as 25\n",
        ),
        (".plot", "no axis has moved\n"),
        (".plot a.txt", "error[file]: a.txt is neither a .png nor a .svg file\n"),
        (".load nowhere.mnt", "error[file]: nowhere.mnt cannot be read: no such file or directory\n"),
        (".step", "error[values]: no program is stopped in the debugger\n  hint: .debug FILE begins one\n"),
        (".debug", "error[values]: no program is in the debugger\n  hint: .debug FILE begins one\n"),
    ],
)
def test_a_command(line: str, answer: str) -> None:
    assert talk(line) == answer


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("help", ".help"),
        ("HELP SPEED", ".help SPEED"),
        ("  exit ", ".quit"),
        ("bye", ".quit"),
        ("?", ".help"),
        ("run 5", ".run 5"),
        ("axes", ".axes"),
        ("axes 0", ""),
        ("exit now", ""),
        ("print 1", ""),
    ],
)
def test_a_line_that_means_a_command(line: str, meant: str) -> None:
    assert without_dot(line) == meant


@pytest.mark.parametrize(
    ("line", "is_one"),
    [
        (".go", True),
        ("  .go", True),
        (".x", True),
        (".", False),
        ("..a", False),
        (".5", False),
        ("a.b", False),
    ],
)
def test_a_dot_and_a_letter_begin_a_command(line: str, is_one: bool) -> None:
    assert is_command(line) is is_one


@pytest.mark.parametrize("width", [50, 80])
def test_help_fits_the_screen(width: int) -> None:
    """A screen has 24 lines; each command is in the help once, and its usage is not broken."""
    session = Session(dialect("mint"))
    session.width = width
    overview = session.feed(".help")
    assert len(overview.splitlines()) < 24
    assert [name for name, each in COMMANDS.items() if overview.count(each.usage) < 1] == []
    for word in (*GROUPS, "homing", "SPEED", "MOVEA"):
        assert [line for line in session.feed(f".help {word}").splitlines() if len(line) > width] == []


def test_help_on_a_group_and_the_keyword_of_its_name() -> None:
    text = talk(".help input")
    assert text.startswith(".input N=V@S   A digital input")
    assert "\nInput · Mint statement\n" in text
    assert talk(".help homing").startswith("Mint · 13 simulated, 0 known\n\nhoming\n  HOMETYPE ")


def test_live_mode_is_on_or_off() -> None:
    session = Session(dialect("mint"))
    session.live = False
    assert (session.feed(".live ON"), session.live) == ("", True)
    assert session.feed(".live maybe") == "error[range]: .live is on or off, not maybe\n"
    assert session.live is True
    assert (session.feed(".live off"), session.live) == ("", False)


def test_axes_in_every_state() -> None:
    """At rest, with a scale, and in motion without an end.

    Also with a move in the buffer, off, and with a fault.
    """
    lines = talk(
        "SPEED(0) = 50 : MOVER(0) = 100 : GO(0) : PAUSE IDLE(0)",
        "SCALE(1) = 2",
        "MOVER(2) = 5",
        "MOVER(3) = 5 : GO(3) : PAUSE IDLE(3) : DRIVEENABLE(3) = 0",
        "JOG(4) = 5 : WAIT(100)",
        ".axes",
    ).splitlines()
    assert lines[0] == "axis  position  velocity  target"
    found = {line.split()[0]: line.split(maxsplit=3)[1:] for line in lines[1:]}
    assert [found["0"][k] for k in (0, 1)] == ["100", "0"]
    assert found["0"][2].split() == ["100", "idle"]
    assert found["1"][2].split() == ["0", "idle"]
    assert found["2"][2].split() == ["0", "idle,", "1", "in", "the", "buffer"]
    assert found["3"][2].split() == ["5", "off"]
    assert found["4"][1:] == ["5", "-  moving"]
    assert list(found) == ["0", "1", "2", "3", "4"]
    assert len({line.index(line.split()[0]) for line in lines[1:]}) == 1


def test_the_bottom_bar() -> None:
    assert talk("SPEED(0) = 50 : MOVER(0) = 100 : GO(0)", ".settle").startswith("2.00")
    assert "   0: 100" in talk("MOVER(0) = 100 : GO(0)", ".settle")
    assert talk("JOG(0) = 5 : WAIT(1000)", ".time").endswith(" moving\n")


def test_motion_that_never_ends_cannot_be_settled() -> None:
    assert talk("JOG(0) = 5", ".settle") == (
        "error[never]: the command waits for axis 0 to be idle, which can never happen\n"
        "  hint: stop axis 0 first: it runs without an end\n"
    )


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (1e-13, "0"),
        (-1e-13, "0"),
        (1e-11, "0.00000000001"),
        (2.5, "2.5"),
        (1 / 3, "0.3333333333"),
    ],
)
def test_a_number_without_noise(value: float, text: str) -> None:
    assert number_text(value) == text


@pytest.mark.parametrize(
    ("text", "first", "replaced"),
    [
        (".", "help", 0),
        ("  .go", "go", 2),
        (".GOT", "goto", 3),
        ("SPEE", "SPEED", 4),
        ("spee", "speed", 4),
        ("a = SPEE", "SPEED", 4),
        ("Sub s\nSPEE", "SPEED", 4),
        ('Print "a", SPEE', "SPEED", 4),
        ("' SPEE", None, 0),
        ('Print "SPEE', None, 0),
        ("", None, 0),
        ("1 + ", None, 0),
        (".xyz", None, 0),
        ("QQQ", None, 0),
    ],
)
def test_the_first_completion(text: str, first: str | None, replaced: int) -> None:
    """Keywords are written as the user types them.

    There are none in a comment or an open text.
    """
    found = candidates(dialect("mint"), text)
    assert (found[0][:2] if found else (None, 0)) == (first, replaced)


def test_a_keyword_is_completed_from_its_short_form() -> None:
    assert "SPEED" in [name for name, _, _ in candidates(dialect("mint"), "SP")]
    assert ("MR", 1) in [(name, replaced) for name, replaced, _ in candidates(dialect("mccl"), "1TP,1M")]
    rows = candidates(dialect("mint"), "A")
    simulated = [not help.startswith("not simulated: ") for _, _, help in rows]
    assert simulated == sorted(simulated, reverse=True)


# ---------------------------------------------------------------------------------------------------- debugging

PROGRAM = """\
Dim n As Integer
n = 1
n = 2
SPEED(0) = 50 : MOVEA(0) = 100 : GO(0)
PAUSE IDLE(0)
Print n
"""


@pytest.fixture
def debugged(tmp_path: Path) -> Session:
    """A session with the program in the debugger, before its first statement."""
    path = tmp_path / "a.mnt"
    path.write_text(PROGRAM)
    session = Session(dialect("mint"))
    assert session.feed(f".debug {path}") == "0 s  line 2: n = 1\n"
    return session


@pytest.mark.parametrize(
    ("lines", "answer"),
    [
        ([".break"], "no breakpoints\n"),
        ([".break 3"], "3\n"),
        ([".break 3", ".break 6 if n > 1"], "3\n6 if n > 1\n"),
        ([".break 3", ".break off"], "no breakpoints\n"),
        ([".break 99"], "error[values]: there is no statement in line 99 or below\n"),
        ([".break 3 if"], "error[values]: 3 if has no condition\n  hint: 3 if n > 3\n"),
        ([".step"], "0.00001 s  line 3: n = 2\n"),
        ([".break 3", ".go"], "0.00001 s  line 3: n = 2\n"),
        ([".step", ".back"], "0 s  line 2: n = 1\n"),
        ([".back"], "-- this is the first statement\n0 s  line 2: n = 1\n"),
        ([".vars n"], "n = 0\n"),
        ([".vars n = 5", ".vars n + 1"], "n + 1 = 6\n"),
        ([".vars b = 5"], "error[values]: there is no variable b here\n"),
        ([".vars"], "n = 0\n"),
        ([".goto line 6", ".changed n"], "-- this statement changes n\n0.00001 s  line 3: n = 2\n"),
        ([".changed output 2"], "nothing has changed output 2 yet\n"),
        ([".change 9 x"], "error[values]: .change takes a line from 1 to 7 and its new text\n"),
        ([".change 1 Dim n As Float"], "0 s  line 2: n = 1\n"),
        ([".change 7 PRINT 7", ".goto line 7"], "2\n2.00056 s  line 7: PRINT 7\n"),
        ([".change 0 x"], "error[values]: .change takes a line from 1 to 7 and its new text\n"),
        ([".change 3 n = 7", ".goto line 4", ".vars n"], "n = 7\n"),
        ([".goto 1e9"], "error[values]: 1e9 is no time, such as 2.5, and no line, such as line 12\n"),
    ],
)
def test_a_command_of_the_debugger(debugged: Session, lines: list[str], answer: str) -> None:
    assert [debugged.feed(line) for line in lines][-1] == answer


def test_a_program_that_no_longer_compiles_is_shown_as_it_is_now(debugged: Session, tmp_path: Path) -> None:
    """The program that is stopped stays."""
    path = tmp_path / "a.mnt"
    path.write_text(PROGRAM.replace("n = 2", "n = +"))
    for command in (".debug", f".debug {path}"):
        assert debugged.feed(command) == (
            "error[syntax]: expected a value before the end of the line\n"
            " --> a.mnt:3:6\n  |\n3 | n = +\n  |      ^\n"
        )
    path.unlink()
    assert debugged.feed(".debug") == f"error[file]: {path} cannot be read: no such file or directory\n"
    assert debugged.feed(".step") == "0.00001 s  line 3: n = 2\n"


def test_an_axis_is_shown_once_it_has_moved(debugged: Session) -> None:
    """Below it is its motion at the moment of a motion breakpoint: 20 uu at 50 uu/s."""
    debugged.feed(".break position(0) > 20")
    assert debugged.feed(".go").startswith("-- position(0) > 20 holds at 0.4")
    text = debugged.feed(".vars")
    assert text.splitlines()[0] == "n = 2"
    now, then = [line for line in text.splitlines() if line.startswith("axis 0")]
    assert now == "axis 0: position 100, velocity 0, target 100, idle"
    assert then.startswith("axis 0 at 0.4")
    assert ": position 20" in then
    assert then.endswith(", velocity 50")
    assert "axis 1" not in text
    assert debugged.feed(".go").startswith("2\nended after 2.")


TASKS = """\
Dim n As Integer
Task t
  Dim m As Integer
  m = 1
  WAIT = 500
End Task
Run t
WAIT = 10
n = 2
PRINT n
"""


def test_another_task_is_shown_by_what_it_waits_for(tmp_path: Path) -> None:
    """At the end there is no task of the stop."""
    path = tmp_path / "a.mnt"
    path.write_text(TASKS)
    session = Session(dialect("mint"))
    session.feed(f".debug {path}")
    assert session.feed(".goto line 10") == "0.01003 s  line 10: PRINT n\n"
    assert session.feed(".vars") == "task t waits for 0.5 s\nn = 2\n"
    assert session.feed(".go") == "2\nended after 0.01004 s\n"
    assert session.feed(".vars") == "task t waits for 0.5 s\nn = 2\n"


def test_nothing_is_executed_after_quit() -> None:
    session = Session(dialect("mint"))
    assert session.feed("PRINT 1\n.quit\nPRINT 2") == "1\n"
    assert session.over
