"""A hand for the tests of the panel: it acts, and waits for what the machine then shows."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from time import monotonic
from typing import Any

from motionlang.kernel import Program, ProgramError, Source, dialect_for, settings_next_to
from motionlang_explore.panel.play import Play
from motionlang_explore.panel.roles import Roles
from motionlang_explore.panel.session import Cursor, PanelSession

# Seconds of real time after which a test gives up.
PATIENCE = 30.0
State = Mapping[str, Any]
Explore = Callable[[Source, Mapping[str, object]], Roles]

# A press: START feeds a part, which a hand has put in; it is off again, or the press waits.
PRESS = """\
' IN 1 start  2 part in  3 guard open
' OUT 1 clamp
SCALE(0) = 100
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Dim n As Integer
Loop
  Pause INX(1)
  Pause INX(2)
  OUTX(1) = 1
  MOVER(0) = 20 : GO(0) : Pause IDLE(0)
  OUTX(1) = 0
  n = n + 1
  Print "part "; n
  If n = 3 Then Exit
  Pause INX(1) = 0
End Loop
Print "done"
"""


class Hand:
    """A person at a panel."""

    def __init__(self, session: PanelSession) -> None:
        self.session, self._cursor = session, Cursor()
        self.state: State = {}
        self.contents: State = {}
        self.text = self.notice = ""
        self.record: list[tuple[float, str]] = []
        self.rules: dict[int, str] = {}
        self.is_changed = False
        self._messages = 0

    def __call__(self, do: str, **request: object) -> None:
        """Ask for something, as a page does."""
        self.session.act({"do": do, **request})

    def set(self, number: int, value: float, table: str = "input") -> None:
        """Change an input, or an element of another table."""
        self("change", table=table, number=number, value=value)

    def reply(self, text: str) -> None:
        """Answer the present question."""
        self("reply", question=self.state["asks"], text=text)

    def press(self, *numbers: int, page: str = "one") -> None:
        """Press these buttons of a page, and no others."""
        self._messages += 1
        self("press", page=page, message=self._messages, numbers=numbers)

    def sees(self, holds: Callable[[State], object]) -> State:
        """Wait until a state has something."""
        end = monotonic() + PATIENCE
        while not self.state or not holds(self.state):
            assert monotonic() < end, f"{self.state} {self.notice}"
            self._read(1.0)
        return self.state

    def hears(self, words: str) -> str:
        """Wait for a notice."""
        end = monotonic() + PATIENCE
        while words not in self.notice:
            assert monotonic() < end, self.notice
            self._read(1.0)
        return self.notice

    def rests(self) -> State:
        """Go on to the next rest."""
        begin = self.state["t"]
        self("rest")
        over = ("ended", "fault", "asks")
        return self.sees(
            lambda state: state["mode"] in over or (state["t"] > begin and state["mode"] == "paused")
        )

    @contextmanager
    def busy(self) -> Iterator[None]:
        """Keep the run busy: it takes what it is asked for afterwards, all at once."""
        is_busy, is_free = threading.Event(), threading.Event()

        def work(play: Play) -> None:
            is_busy.set()
            is_free.wait(PATIENCE)

        self.session._actions.post(work)
        assert is_busy.wait(PATIENCE)
        try:
            yield
        finally:
            is_free.set()

    def _read(self, seconds: float) -> None:
        found = self.session.updates(self._cursor, seconds)
        if found is None:
            return
        self.contents = found.get("contents", self.contents)
        if found["begins"]:
            self.text = ""
        self.state = found["state"]
        if self.state["mode"] != "starts":
            assert len(self.state["axes"]) == len(self.contents["axes"])
        self.text += found["text"]
        self.record = found.get("record", self.record)
        self.rules = found.get("rules", self.rules)
        self.notice = found.get("notice", self.notice)
        self.is_changed = found["changed"]


@contextmanager
def operated(
    path: Path,
    text: str | None = None,
    overrides: Mapping[str, float | str] | None = None,
    *,
    explore: Explore | None = None,
) -> Iterator[Hand]:
    """Write a program, if one is given, and operate it; it is paused at power-up.

    `explore` is called in a thread, in place of a process.
    """
    if text is not None:
        path.write_text(text, encoding="utf-8")

    def load() -> tuple[Program, Mapping[str, object]]:
        source, settings = Source.read(path), settings_next_to(str(path))
        program = dialect_for(source, None).program(source, settings, is_debug=True)
        if program.errors:
            raise ProgramError(program.errors)
        return program, settings

    threads = ThreadPoolExecutor(1)
    session = PanelSession(
        load,
        str(path),
        [str(path)],
        overrides or {},
        explore and (lambda source, settings: threads.submit(explore, source, settings)),
    )
    hand = Hand(session)
    hand("pause")
    try:
        hand("back", time=0)
        hand.sees(lambda state: state["mode"] == "paused" and state["t"] == 0.0)
        yield hand
    finally:
        session.close()
        threads.shutdown()
