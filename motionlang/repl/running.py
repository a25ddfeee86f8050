"""The line below the output of a command that takes long: Ctrl-C ends it."""

from __future__ import annotations

import sys
from collections.abc import Callable

from motionlang.repl.session import Session
from motionlang.views.progress import Watcher, is_shown

LINE = "running; Ctrl-C ends it"


class Running:
    """`with running:` shows the line half a second after a command began, until it ends.

    The output of the session is written above the line. The line disappears while the session asks the user.
    """

    def __init__(self, session: Session) -> None:
        self._watcher: Watcher | None = None
        session.show, session.complain = self._above(session.show), self._above(session.complain)
        ask = session.ask

        def asked(begun: str) -> str | None:
            self.__exit__()
            try:
                return ask(begun)
            finally:
                self.__enter__()

        session.ask = asked

    @property
    def is_shown(self) -> bool:
        """True if the line is shown, or will be."""
        return self._watcher is not None

    def __enter__(self) -> None:
        if is_shown(sys.stderr):
            self._watcher = Watcher(sys.stderr, lambda: LINE)
            self._watcher.start()

    def __exit__(self, *_: object) -> None:
        if self._watcher is not None:
            self._watcher.stop()
            self._watcher = None

    def _above(self, write: Callable[[str], None] | None) -> Callable[[str], None] | None:
        if write is None:
            return None

        def show(text: str) -> None:
            if self._watcher is None:
                write(text)
            else:
                self._watcher.above(write, text)

        return show
