"""A progress line on a terminal, positioned by rich.

Nothing is imported or written before the work has taken a while, or if the stream is not a terminal.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from math import inf
from time import monotonic
from typing import TYPE_CHECKING, TextIO

from motionlang.views.formatting import clock_time
from motionlang.views.terminal import is_terminal, printable, wants_colour, width_of

if TYPE_CHECKING:
    from rich.console import Console
    from rich.live import Live
    from rich.progress import Progress as Bar
    from rich.text import Text

# Seconds before the line first appears, and between two updates.
PATIENCE = 0.5
PERIOD = 0.1
# The same for a run, whose line a thread writes.
RUN_PATIENCE, RUN_PERIOD = 0.5, 0.2


class Progress:
    """A progress line; call it with the completed fraction, 0 to 1, and what is done now."""

    def __init__(self, stream: TextIO, label: str) -> None:
        self._stream, self._label = stream, label
        self._next = monotonic() + PATIENCE if is_shown(stream) else inf
        self._bar: Bar | None = None

    def __call__(self, fraction: float, doing: str = "") -> None:
        if monotonic() < self._next:
            return
        self._next = monotonic() + PERIOD
        if self._bar is None:
            self._bar = _bar(self._stream, self._label)
        label = f"{self._label}: {printable(doing)}" if doing else self._label
        self._bar.update(self._bar.task_ids[0], description=label, completed=fraction, refresh=True)

    def done(self) -> None:
        """Remove the line for good."""
        self._next = inf
        if self._bar is not None:
            self._bar.stop()


def _bar(stream: TextIO, label: str) -> Bar:
    from rich.progress import BarColumn, TaskProgressColumn, TextColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}", markup=False), BarColumn(), TaskProgressColumn())
    bar = Bar(
        *columns,
        console=_screen(stream),
        auto_refresh=False,
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
    )
    bar.add_task(label, total=1.0)
    bar.start()
    return bar


class Watcher:
    """Shows the line that `describe` returns, from a separate thread.

    The thread only reads: it changes no data. All other output to the terminal is written through `above`. The
    line reappears when that output ends with a complete line.
    """

    def __init__(self, stream: TextIO, describe: Callable[[], str]) -> None:
        self._stream, self._describe = stream, describe
        self._live: Live | None = None
        # True if the cursor is behind unfinished text, such as a question and its answer: the line would
        # erase it.
        self._begun = False
        self._line = threading.Lock()  # held by the thread that writes
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._watch, name="progress", daemon=True)

    def start(self) -> None:
        """Start the thread; `stop` must follow."""
        self._thread.start()

    def stop(self) -> None:
        """Remove the line and end the thread."""
        self._stopped.set()
        self._thread.join()

    def above(self, write: Callable[[str], object], text: str) -> None:
        """Remove the progress line and let `write` write `text` in its position."""
        with self._line:
            self._erase()
            write(text)
            self._begun = not text.endswith("\n") if text else self._begun

    def show(self) -> None:
        """Write or update the progress line, unless the program's last line is unfinished."""
        with self._line:
            if self._begun:
                return
            if self._live is None:
                self._live = _live(self._stream)
                self._live.start()
            self._live.update(_one_line(self._describe()), refresh=True)

    def _watch(self) -> None:
        try:
            period = RUN_PATIENCE
            while not self._stopped.wait(period):
                self.show()
                period = RUN_PERIOD
        except OSError:
            pass  # the terminal has gone, and its user with it
        finally:
            with self._line:
                self._erase()

    def _erase(self) -> None:
        if self._live is not None:
            self._live.stop()
            self._live = None


def _one_line(text: str) -> Text:
    from rich.text import Text

    return Text(text, no_wrap=True, overflow="ellipsis")


def _live(stream: TextIO) -> Live:
    from rich.live import Live

    return Live(
        console=_screen(stream),
        auto_refresh=False,
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
        vertical_overflow="crop",
    )


def _screen(stream: TextIO) -> Console:
    from rich.console import Console

    return Console(
        file=stream,
        width=width_of(stream),
        force_terminal=True,
        no_color=not wants_colour(stream),
        markup=False,
        emoji=False,
        highlight=False,
    )


def is_shown(stream: TextIO) -> bool:
    """True if `stream` is a terminal that can erase a line."""
    return is_terminal(stream) and os.environ.get("TERM") != "dumb"


def run_line(
    time: float, end: float, cycle: str = "", *, is_endless: bool = False, is_computing: bool = False
) -> str:
    """Return the progress of a run: its cycle if known, the machine time, its end, and how to get a result.

    `is_endless` means that only the length of a shift ends the run. `is_computing` means that the machine time has not
    changed since the last line, because a loop advances the clock only when it waits.
    """
    now = time - time % 60.0 if time >= 3600.0 else round(time, 1)
    far = f"{_short(now)} of {_short(end)}" + (", computing" if is_computing else "")
    less = ", --until 60 a minute" if is_endless else ""
    return f"{f'cycle {cycle}, ' if cycle else ''}{far}; Ctrl-C shows the result so far{less}"


def _short(seconds: float) -> str:
    return clock_time(seconds).removesuffix(" 0 s").removesuffix(" 00 min")
