"""One run of the debugger: its output, its answers, its changes and its pauses."""

from __future__ import annotations

import pytest

from motionlang.ide.debug import replay as module
from motionlang.ide.debug.breakpoints import Watched
from motionlang.ide.debug.journal import Assigned, Entered, Journal
from motionlang.ide.debug.replay import SessionOutput
from motionlang.kernel import Source
from tests.cases import cases
from tests.ide.debug.test_debugger import CALLS, at, mint, value
from tests.ide.debug.walks import go_to_number


@cases(
    "work, shown, count",
    [
        # Text that an earlier run has shown is not repeated, and a text may be partly new.
        ([("write", 0, "abc"), ("write", 3, "de")], "abc|de", 5),
        ([("write", 0, "abc"), ("write", 0, "abc")], "abc", 3),
        ([("write", 0, "abc"), ("write", 0, "abcde")], "abc|de", 5),
        ([("write", 0, "abc"), ("write", 2, "cde"), ("write", 4, "ef")], "abc|de|f", 6),
        # Text that is held is shown by the release, up to a length, and the rest is discarded.
        ([("hold",), ("write", 0, "abc")], "", 0),
        ([("hold",), ("write", 0, "abc"), ("write", 3, "de"), ("release", 5)], "abcde", 5),
        ([("hold",), ("write", 0, "abc"), ("write", 2, "cde"), ("release", 9)], "abcde", 5),
        ([("hold",), ("write", 0, "abc"), ("release", 2), ("write", 1, "bcd")], "ab|cd", 4),
        ([("write", 0, "ab"), ("hold",), ("write", 2, "cde"), ("release", 4), ("write", 4, "xy")], "ab|cd|xy", 6),
        ([("write", 0, "ab"), ("hold",), ("write", 2, "cde"), ("release", 1)], "ab", 2),
        ([("hold",), ("hold",), ("write", 0, "a"), ("release", 0), ("write", 0, "b")], "b", 1),
        # The output from a change on is shown again.
        ([("write", 0, "abc"), ("forget", 1), ("write", 0, "axy")], "abc|xy", 3),
        ([("write", 0, "abc"), ("forget", 5), ("write", 3, "d")], "abc|d", 4),
    ],
)  # fmt: skip
def test_output_is_shown_once(work: list[tuple[object, ...]], shown: str, count: int) -> None:
    texts: list[str] = []
    output = SessionOutput(texts.append)
    for name, *arguments in work:
        getattr(output, str(name))(*arguments)
    assert ("|".join(texts), output._shown) == (shown, count)


def test_the_journal_follows_one_run() -> None:
    """A change removes the changes after its statement, and the answers from it on."""
    journal = Journal()
    for number in (3, 5, 5, 8):
        journal.add(Assigned(number, ("module", "n"), number))
    journal.answer(4, "a", 0)
    journal.answer(5, "b", 1)
    assert [len(journal.at(number)) for number in range(2, 9)] == [0, 1, 0, 2, 0, 0, 1]
    assert [journal.following(number) for number in (0, 3, 4, 5, 7)] == [3, 5, 5, 8, 8]
    assert journal.following(8) == float("inf")
    journal.add(Entered(5, {}))
    assert [each.statement for each in journal.changes] == [3, 5, 5, 5]
    assert [each.text for each in journal.answers] == ["a"]
    journal.answer(4, "c", 0)
    assert [each.text for each in journal.answers] == ["c"]


ASKS = 'Dim n As Integer\nINPUT "a", n\nPRINT n\nINPUT "b", n\nPRINT n\nINPUT "c", n\nPRINT n\n'


def test_each_input_is_asked_for_once() -> None:
    """A change before the third INPUT makes it ask again."""
    prompts: list[str] = []

    def ask(prompt: str) -> str:
        prompts.append(prompt.strip())
        return str(len(prompts))

    shown: list[str] = []
    debugger = mint(ASKS, ask=ask, show=shown.append)
    debugger.start()
    assert debugger.go_on() is None
    for number in (2, 4, 5):
        go_to_number(debugger, number)
        assert value(debugger, "n") == number // 2
    assert len(prompts) == 3
    debugger.assign(("module", "n"), 9)
    assert value(debugger, "n") == 9
    shown.clear()
    assert debugger.go_on() is None
    assert [each.text for each in debugger.journal.answers] == ["1", "2", "4"]
    assert len(prompts) == 4
    assert [line for line in "".join(shown).splitlines() if line.isdigit()] == ["4"]


def test_a_session_that_ends_at_an_input_ends_its_run() -> None:
    debugger = mint(ASKS, ask=lambda prompt: None)
    debugger.start()
    with pytest.raises(module.Cancelled):
        debugger.go_on()
    assert debugger.go_on() is None


def test_changes_that_are_not_possible_any_more_are_reported_once() -> None:
    """`total` is gone, and `i` is an array."""
    shown: list[str] = []
    debugger = mint(
        "Dim total As Integer\nDim i As Integer\nDim n As Integer\ni = 1\nPrint n\n", show=shown.append
    )
    debugger.start()
    for name in ("total", "i", "n"):
        debugger.assign(("module", name), 5)
    debugger.restart(Source("a.mnt", "Dim i(2) As Integer\nDim n As Integer\nn = 1\nPrint n\n"))
    assert debugger.problems() == [
        "there is no variable total here any more",
        "there is no variable i here any more",
    ]
    assert debugger.problems() == []
    debugger.abandon()


def test_a_change_by_the_user_is_no_change_of_a_watched_variable() -> None:
    """The user sets 100; the program adds 2."""
    debugger = mint(CALLS)
    debugger.start()
    debugger.watched = [Watched(("module", "total"))]
    debugger.next()
    debugger.assign(("module", "total"), 100)
    stop = debugger.go_on()
    assert stop is not None
    assert stop.text == "total changes from 100 to 102 before line 9"
    debugger.reverse()
    stop = debugger.go_on()
    assert stop is not None
    assert stop.text == "total changes from 100 to 102 before line 9"
    debugger.abandon()


WAITS = "OUTX(1) = 1\nPAUSE INX(0)\nOUTX(2) = 1\nPAUSE INX(1)\nOUTX(2) = 0\n"


@pytest.mark.parametrize(
    ("rises", "lines"),
    [((1.0, 2.0), [3, 5]), ((2.0, 4.0), [3, 5]), ((3.0, 4.0), [2, 2]), ((2.0, 5.0), [3, 4])],
)
def test_a_pause_stops_within_two_advances_of_the_clock(
    rises: tuple[float, float], lines: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock advances to each second.

    At the third one, the pause ends the run and goes back to its last statement.
    """
    monkeypatch.setattr(module, "PAUSE", 2)
    inputs = [{"channel": 5, "at": float(each), "value": each % 2} for each in range(1, 9)]
    inputs += [{"channel": number, "at": time, "value": 1} for number, time in enumerate(rises)]
    debugger = mint(WAITS, {"input": inputs}, until=9.0)
    debugger.start()
    debugger.go_to_line(2)
    found = []
    for _ in range(2):
        debugger.pause()
        stop = debugger.go_on()
        assert stop is not None
        assert (stop.reason, stop.text) == ("pause", "")
        found.append(stop.line)
        if stop.line == 3:
            debugger.next()
    assert found == lines
    debugger.abandon()


def test_breakpoints_that_are_set_while_the_program_runs() -> None:
    """The program waits for a line when they are set."""

    def ask(prompt: str) -> str:
        debugger.set_breakpoints([at(debugger, 7)])
        return "5"

    debugger = mint(ASKS, ask=ask)
    debugger.set_breakpoints([at(debugger, 3, hits="2")])
    debugger.start()
    stop = debugger.go_on()
    assert stop is not None
    assert (stop.line, stop.reason) == (7, "breakpoint")
    debugger.abandon()
