"""Temporary lines on a terminal; they never appear elsewhere."""

from __future__ import annotations

import io
import re
import sys
import threading
from itertools import pairwise
from typing import Any

import pytest

from motionlang.views import progress
from motionlang.views.progress import Progress, Watcher, is_shown, run_line

# As the module has them; the fixture sets them to zero.
WAITS = progress.PATIENCE, progress.PERIOD, progress.RUN_PATIENCE, progress.RUN_PERIOD
HOME = "\r\x1b[1A\x1b[2K"
"""The sequence by which rich removes a line."""


class Terminal(io.StringIO):
    """A terminal that records everything written to it."""

    encoding = "utf-8"

    def isatty(self) -> bool:
        return True

    def words(self) -> list[str]:
        """Return the written text, without positioning sequences."""
        return [text for text in re.split(r"(?:\x1b\[[?\d;]*\w|[\r\n])+", self.getvalue()) if text]


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.setenv("NO_COLOR", "1")
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    monkeypatch.setattr(progress, "PERIOD", 0.0)


def test_a_bar_says_how_far_it_is_and_goes_away() -> None:
    terminal = Terminal()
    bar = Progress(terminal, "x[1].csv")
    for fraction in (0.0, 0.25, 1.0):
        bar(fraction)
    bar.done()
    text = terminal.getvalue()
    assert [re.sub(r"[━╸╺ ]+", " ", line) for line in terminal.words()] == [
        "x[1].csv 0%", "x[1].csv 0%", "x[1].csv 25%", "x[1].csv 100%", "x[1].csv 100%"]  # fmt: skip
    assert text.endswith("\x1b[?25h" + HOME)


def test_a_bar_says_what_is_done_now() -> None:
    terminal = Terminal()
    bar = Progress(terminal, "x.prg")
    bar(0.0)
    bar(0.5, "key \x1b")
    bar.done()
    bar(1.0, "more")
    assert [re.sub(r"[━╸╺ ]+", " ", line) for line in terminal.words()] == [
        "x.prg 0%", "x.prg 0%", "x.prg: key ␛ 50%", "x.prg: key ␛ 50%"]  # fmt: skip


@pytest.mark.parametrize("stream", [io.StringIO(), None])
def test_nothing_is_written_where_nobody_reads_or_before_it_takes_a_while(
    stream: io.StringIO | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    written = stream or Terminal()
    if stream is None:
        monkeypatch.setattr(progress, "PATIENCE", 1e9)
    bar = Progress(written, "x.csv")
    bar(0.5)
    bar.done()
    assert written.getvalue() == ""


def test_a_terminal_that_cannot_erase_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    assert is_shown(Terminal())
    monkeypatch.setenv("TERM", "dumb")
    assert not is_shown(Terminal())


def test_a_watcher_hides_for_what_else_is_written() -> None:
    terminal = Terminal()
    watcher = Watcher(terminal, lambda: "working [1]")
    watcher.above(terminal.write, "")
    watcher.show()
    watcher.above(terminal.write, "printed\n")
    assert terminal.words()[-2:] == ["working [1]", "printed"]
    assert HOME + "printed\n" in terminal.getvalue()
    watcher.show()
    watcher.above(terminal.write, "")
    assert terminal.getvalue().endswith(HOME)


def test_a_watcher_leaves_a_question_and_its_answer_alone() -> None:
    terminal = Terminal()
    watcher = Watcher(terminal, lambda: "working")
    for text in ("how many? ", "2", "", "1"):
        watcher.above(terminal.write, text)
        watcher.show()
    assert terminal.getvalue() == "how many? 21"
    watcher.above(terminal.write, "\n")
    watcher.show()
    assert terminal.words()[-1] == "working"
    watcher.above(terminal.write, "")


def test_its_thread_writes_by_itself_and_ends_on_request(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "RUN_PATIENCE", 0.0)
    monkeypatch.setattr(progress, "RUN_PERIOD", 0.0)
    terminal, seen, times = Terminal(), threading.Event(), 0

    def describe() -> str:
        nonlocal times
        times += 1
        if times == 3:
            seen.set()
        return f"line {times}"

    watcher = Watcher(terminal, describe)
    watcher.start()
    assert seen.wait(20)
    watcher.stop()
    assert terminal.words()[:2] == ["line 1", "line 2"]
    assert terminal.getvalue().endswith(HOME)


def test_a_line_that_is_too_long_is_cut_and_not_broken() -> None:
    terminal = Terminal()
    watcher = Watcher(terminal, lambda: "a word " * 30)
    watcher.show()
    assert terminal.words()[0] == ("a word " * 30)[:79] + "…"
    watcher.above(terminal.write, "")


def test_a_watcher_that_is_stopped_at_once_writes_nothing() -> None:
    terminal = Terminal()
    watcher = Watcher(terminal, lambda: "never")
    watcher.start()
    watcher.stop()
    assert terminal.getvalue() == ""


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        ((7815.0, 28_800.0, "3.6333 s"), "cycle 3.6333 s, 2 h 10 min of 8 h"),
        ((3599.96, 28_800.0), "1 h of 8 h"),
        ((119.96, 300.0), "2 min of 5 min"),
        ((9.96, 75.5), "10 s of 1 min 15.5 s"),
        ((0.0, 0.5), "0 s of 0.5 s"),
    ],
)
def test_how_far_a_run_has_come(arguments: tuple[float, float], line: str) -> None:
    assert run_line(*arguments) == f"{line}; Ctrl-C shows the result so far"
    assert run_line(*arguments, is_computing=True).startswith(f"{line}, computing; ")
    assert run_line(*arguments, is_endless=True).endswith("the result so far, --until 60 a minute")


def test_a_bar_appears_after_half_a_second_and_changes_ten_times_a_second(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A bar made at 7 s: calls at 7.5 and 7.6 s write it, a call just before does not."""
    now = 7.0
    monkeypatch.setattr(progress, "PATIENCE", WAITS[0])
    monkeypatch.setattr(progress, "PERIOD", WAITS[1])
    monkeypatch.setattr(progress, "monotonic", lambda: now)
    terminal = Terminal()
    bar, lengths = Progress(terminal, "x.csv"), [0]
    for now in (7.0, 7.499, 7.5, 7.599, 7.6001, 7.69):  # noqa: B007
        bar(0.5)
        lengths.append(len(terminal.getvalue()))
    bar.done()
    assert [after > before for before, after in pairwise(lengths)] == [False, False, True, False, True, False]


def test_the_line_of_a_run_appears_after_half_a_second_and_changes_five_times_a_second() -> None:
    """The thread waits for its end, and writes after each wait; the third is the last."""
    waits: list[float] = []

    class Stopped:
        def wait(self, timeout: float) -> bool:
            waits.append(timeout)
            return len(waits) == 3

    terminal = Terminal()
    watcher: Any = Watcher(terminal, lambda: f"line {len(waits)}")
    watcher._stopped = Stopped()
    watcher._watch()
    assert waits == [0.5, 0.2, 0.2]
    assert terminal.words()[0] == "line 1"
    assert terminal.words()[-1] == "line 2"


@pytest.mark.parametrize("kind", ["bar", "line"])
def test_a_line_leaves_the_streams_of_the_program_as_they_are(kind: str) -> None:
    """Output of the program is not redirected, and no further thread writes."""
    terminal, threads, streams = Terminal(), threading.active_count(), (sys.stdout, sys.stderr)
    bar, watcher = Progress(terminal, "x.csv"), Watcher(terminal, lambda: "working")
    if kind == "bar":
        bar(0.5)
    else:
        watcher.show()
    assert (sys.stdout, sys.stderr) == streams
    assert threading.active_count() == threads
    bar.done()
    watcher.above(terminal.write, "")


@pytest.mark.parametrize(
    ("environment", "has_colour"), [({"NO_COLOR": "1"}, False), ({"FORCE_COLOR": "1"}, True)]
)
def test_a_bar_has_colour_if_the_terminal_does(
    environment: dict[str, str], has_colour: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("NO_COLOR")
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    terminal = Terminal()
    bar = Progress(terminal, "x.csv")
    bar(0.5)
    bar.done()
    assert bool(re.search(r"\x1b\[[\d;]+m", terminal.getvalue())) is has_colour
