"""Serve one client: on stdin and stdout, or on a TCP connection."""

from __future__ import annotations

import socket
import sys
from typing import IO

from motionlang.ide.dap.adapter import Adapter
from motionlang.ide.dap.framing import Message, WrongMessage, read, written


def serve(incoming: IO[bytes], outgoing: IO[bytes]) -> None:
    """Serve a client until it disconnects or its stream ends."""
    broken = False

    def send(message: Message) -> None:
        nonlocal broken
        if broken:
            return
        try:
            outgoing.write(written(message))
            outgoing.flush()
        except (OSError, ValueError):
            broken = True  # the client has gone; the end of its stream ends the session

    adapter = Adapter(send)
    try:
        while not adapter.is_over and not broken:
            try:
                message = read(incoming)
            except WrongMessage as error:
                adapter.output(f"{error}\n", "stderr")
                if error.is_fatal:
                    break
                continue
            except OSError:
                break
            if message is None:
                break
            adapter.handle(message)
    finally:
        adapter.close()


def serve_stdio() -> None:
    """Serve the client that has started this process."""
    output, sys.stdout = sys.stdout, sys.stderr  # nothing else may be written between the messages
    serve(sys.stdin.buffer, output.buffer)


def serve_connection(listener: socket.socket) -> None:
    """Serve the first client that connects, and no other."""
    listener.setblocking(True)
    connection, _ = listener.accept()
    listener.close()
    connection.setblocking(True)
    with connection, connection.makefile("rb") as incoming, connection.makefile("wb") as outgoing:
        serve(incoming, outgoing)
