"""Live mode, in which machine time follows real time.

It is off unless the user turns it on.
"""

from __future__ import annotations

import time

from motionlang.repl.session import Session

STEP = 0.02


class Live:
    """Keeps the session's machine time equal to real time, also during a command."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._wall = time.monotonic()

    def catch_up(self) -> None:
        """Advance machine time by the real time that has passed since the last call."""
        wall = time.monotonic()
        passed, self._wall = wall - self._wall, wall
        if self._session.live:
            self._session.runner.pass_time(passed)

    def begin(self) -> None:
        """Begin a command, which then runs in real time."""
        self.catch_up()
        clock = self._session.machine.controller.clock
        zero = clock.now - self._wall

        def hold(machine_time: float) -> None:
            while (ahead := machine_time - zero - time.monotonic()) > 0 and not self._session.interrupted():
                time.sleep(min(ahead, STEP))

        self._session.pace = hold if self._session.live else None

    def end(self) -> None:
        """End the command."""
        self._session.pace = None
        self._wall = time.monotonic()
