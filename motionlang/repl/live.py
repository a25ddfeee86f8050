"""Live mode: machine time follows the clock on the wall, as at a real controller; off unless the user asks for it."""

from __future__ import annotations

import time

from motionlang.repl.session import Session

STEP = 0.02


class Live:
    """Lets the session's machine time catch up with the wall, and holds a running command back to it."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._wall = time.monotonic()

    def catch_up(self) -> None:
        """Let as much machine time pass as passed on the wall since the last call."""
        wall = time.monotonic()
        passed, self._wall = wall - self._wall, wall
        if self._session.live:
            self._session.runner.pass_time(passed)

    def begin(self) -> None:
        """A command begins: from here on its time is held to the wall."""
        self.catch_up()
        clock = self._session.machine.controller.clock
        zero = clock.now - self._wall

        def hold(machine_time: float) -> None:
            while (ahead := machine_time - zero - time.monotonic()) > 0 and not self._session.interrupted():
                time.sleep(min(ahead, STEP))

        self._session.pace = hold if self._session.live else None

    def end(self) -> None:
        """The command has ended."""
        self._session.pace = None
        self._wall = time.monotonic()
