"""The engine process: the adapter on a channel to the front, and its copies."""

from __future__ import annotations

import base64
import os
import pickle
import signal
import socket
import threading
from collections.abc import Iterable
from typing import NoReturn

from motionlang.dap.adapter import Adapter
from motionlang.dap.framing import Message, WrongMessage, read, written
from motionlang.debug.checkpoints import Checkpoints, close_here


class Engine:
    """An adapter whose client is at the other end of a channel.

    `announcements` carries the channels of new copies.
    """

    def __init__(self, channel: socket.socket, announcements: socket.socket) -> None:
        self._channel, self._announcements = channel, announcements
        self._is_current = True
        checkpoints = Checkpoints(self._store, self._drop, self._leave, self._revive)
        self._adapter = Adapter(self._send, checkpoints, self._hand_over)

    def serve(self) -> NoReturn:
        """Handle messages until the front closes the channel; then end the process."""
        with self._channel.makefile("rb") as stream:
            while True:
                try:
                    message = read(stream)
                except (OSError, WrongMessage):
                    message = None
                if message is None:
                    os._exit(0)
                self._adapter.handle(message)

    def _send(self, message: Message) -> None:
        if not self._is_current:
            return  # the copy answers
        if message["type"] == "handover":
            self._is_current = False
        try:
            self._channel.sendall(written(message))
        except OSError:
            os._exit(0)

    def _hand_over(self, key: int, state: object) -> Message:
        """Return the message that makes a copy the new engine."""
        text = base64.b64encode(pickle.dumps(state)).decode("ascii")
        return {"type": "handover", "key": key, "state": text}

    # -------------------------------------------------------------------------------------------- copies

    def _store(self, key: int, channel: socket.socket) -> None:
        socket.send_fds(self._announcements, [f"copy {key}".encode()], [channel.fileno()])

    def _drop(self, keys: Iterable[int]) -> None:
        self._announcements.send(" ".join(["drop", *map(str, keys)]).encode())

    def _leave(self) -> None:
        close_here(self._channel.fileno())  # else the front would not see the end of the engine

    def _revive(self, channel: socket.socket, state: bytes) -> None:
        """Become the engine, in a copy."""
        self._channel, self._is_current = channel, True
        self._adapter.revive(pickle.loads(state))
        threading.Thread(target=self.serve, name="reader", daemon=True).start()


def main(channel: socket.socket, announcements: socket.socket) -> NoReturn:
    """Run an engine: the main function of a process that has just been forked."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the front ends the session
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # copies that end leave nothing
    for number in (0, 1):
        close_here(number)
    Engine(channel, announcements).serve()
