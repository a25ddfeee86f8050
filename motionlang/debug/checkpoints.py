"""Checkpoints: copies of the process that wait at a statement, made by fork.

Problem. Stepping back means running again. That takes seconds with simulated motors, or with polling loops that run
next to other tasks.

Idea. During a run, its process forks every `INTERVAL` of real time. The copy waits at its statement. To step back, the
session hands its state to the last copy before the statement, and continues there. The copy first forks again, so that
the next step back also finds a copy there.

    front                        engine                       copy at statement 5000
    | <-- the copy's channel ---- fork ----------------------> waits
    | <-- "continue in it" ------ .back from 6000
    | --- the state ----------------------------------------> forks another copy
    |                             ends                        runs to 5999, is the engine

A copy waits for data on a channel whose other end only the front has. It exits when that end is closed, so no copy
outlives the front, however the front ends. An engine sends the other end of a new channel to the front and closes its
own, so no copy inherits the end of another one.

Real time determines only where the copies are. A copy continues like any replay, so the state at a stop does not depend
on them.
"""

from __future__ import annotations

import os
import socket
import struct
import sys
import threading
import warnings
from bisect import insort
from collections.abc import Callable, Iterable

# Real time between two copies, s, and how many of these times a run takes before there is a copy.
INTERVAL, SLOW = 0.1, 3
# If there are more copies, every second one ends.
MAX_COPIES = 32
_LENGTH = struct.Struct(">Q")


class HandOver(Exception):
    """Raised to continue the session in a copy.

    `key` is the number of the copy and `then` the remaining work.
    """

    def __init__(self, key: int, *then: object) -> None:
        super().__init__(key)
        self.key, self.then = key, then


class Ticks(threading.Thread):
    """Calls `action` every `INTERVAL` of real time until `end`."""

    def __init__(self, action: Callable[[], object]) -> None:
        super().__init__(name="ticks", daemon=True)
        self._action, self._over = action, threading.Event()

    def run(self) -> None:
        while not self._over.wait(INTERVAL):
            self._action()

    def end(self) -> None:
        self._over.set()


class Checkpoints:
    """The copies of an engine.

    `store` passes the channel of a copy to the front, and `drop` ends copies. `leave` is called in each new copy
    and closes the channel of the engine. `revive` is called in the copy that continues the session, with its
    channel and the state of the session.
    """

    def __init__(
        self,
        store: Callable[[int, socket.socket], None],
        drop: Callable[[Iterable[int]], None],
        leave: Callable[[], None],
        revive: Callable[[socket.socket, bytes], None],
    ) -> None:
        self._store, self._drop, self._leave, self._revive = store, drop, leave, revive
        # The number of the statement, its time and the key of each copy, in order.
        self.known: list[tuple[int, float, int]] = []
        self.last_key = 0

    def take(self, number: int, time: float) -> bool:
        """Fork at a statement; return True in the copy when it is to continue."""
        self.last_key += 1
        key = self.last_key
        near, far = socket.socketpair()
        if _fork():
            far.close()
            self._store(key, near)
            near.close()
            insort(self.known, (number, time, key))
            if len(self.known) > MAX_COPIES:
                self._forget(self.known[1::2])
            return False
        near.close()
        self._leave()
        self._sleep(key, far)
        return True

    def _sleep(self, key: int, channel: socket.socket) -> None:
        """Wait until this copy is to continue."""
        while True:
            state = receive(channel)
            if state is None:
                os._exit(0)
            near, far = socket.socketpair()
            if _fork():
                far.close()
                self._store(key, near)
                near.close()
                self._revive(channel, state)
                return
            near.close()
            channel.close()
            channel = far

    def before(self, number: int) -> int | None:
        """Return the key of the last copy at or before a statement."""
        return next((each[2] for each in reversed(self.known) if each[0] <= number), None)

    def before_time(self, time: float) -> int | None:
        """Return the key of the last copy before a time."""
        return next((each[2] for each in reversed(self.known) if each[1] < time), None)

    def forget_from(self, number: int) -> None:
        """End the copies from a statement on, because the run now continues differently."""
        self._forget([each for each in self.known if each[0] >= number])

    def _forget(self, copies: list[tuple[int, float, int]]) -> None:
        if copies:
            self.known = [each for each in self.known if each not in copies]
            self._drop([each[2] for each in copies])


def can_fork() -> bool:
    """True on systems on which a process with threads can fork safely."""
    return sys.platform == "linux"


def close_here(descriptor: int) -> None:
    """Close a file descriptor in this process only.

    Objects that still have its number then read end of file and discard writes.
    """
    nothing = os.open(os.devnull, os.O_RDWR)
    os.dup2(nothing, descriptor)
    os.close(nothing)


def _fork() -> int:
    with warnings.catch_warnings():
        # Only the thread of the run goes on in the copy. The locks of the others are made again when it continues.
        warnings.simplefilter("ignore", DeprecationWarning)
        return os.fork()


def send(channel: socket.socket, data: bytes) -> None:
    """Send bytes with their length."""
    channel.sendall(_LENGTH.pack(len(data)) + data)


def receive(channel: socket.socket) -> bytes | None:
    """Return the bytes of one `send`; None if the channel is closed."""
    head = _exactly(channel, _LENGTH.size)
    return None if head is None else _exactly(channel, _LENGTH.unpack(head)[0])


def _exactly(channel: socket.socket, length: int) -> bytes | None:
    found = b""
    while len(found) < length:
        try:
            more = channel.recv(length - len(found))
        except OSError:
            return None
        if not more:
            return None
        found += more
    return found
