"""`motionlang dap`: the debugger for editors."""

from __future__ import annotations

import socket
import sys
from dataclasses import dataclass
from typing import IO, ClassVar

from motionlang.cli.command import Command, Refused, option
from motionlang.hosts.address import listen, parse, shown
from motionlang.ide.dap.adapter import Adapter
from motionlang.ide.dap.framing import Message, WrongMessage, read, written
from motionlang.kernel import Diagnostic


@dataclass
class Dap(Command):
    """Debug a program from an editor, forward and back."""

    epilog: ClassVar[str] = """\
An editor starts this command and talks to it in the Debug Adapter Protocol. It
serves one session and ends with it. The program, its machine file and its
inputs are arguments of the editor's launch request.

examples:
  motionlang dap                       on standard input and output
  motionlang dap --tcp 127.0.0.1:4711  for an editor that connects
"""
    tcp: tuple[str, int] | None = option(
        "HOST:PORT",
        "listen on this address for one client; without HOST only this computer can connect, port 0 is any free port "
        "(default: standard input and output)",
        read=parse,
    )

    def run(self) -> int:
        """Serve one session; return 0."""
        if self.tcp is None:
            _serve_stdio()
            return 0
        try:
            listener = listen(*self.tcp)
        except OSError as error:
            message = f"cannot listen on {shown(*self.tcp)}: {error.strerror or error}"
            raise Refused([Diagnostic("file", message)], status=2) from None
        host, port = listener.getsockname()[:2]
        print(f"listening on {shown(host, port)}", file=sys.stderr, flush=True)
        _serve_connection(listener)
        return 0


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


def _serve_stdio() -> None:
    """Serve the client that has started this process."""
    output, sys.stdout = sys.stdout, sys.stderr  # nothing else may be written between the messages
    serve(sys.stdin.buffer, output.buffer)


def _serve_connection(listener: socket.socket) -> None:
    """Serve the first client that connects, and no other."""
    listener.setblocking(True)
    connection, _ = listener.accept()
    listener.close()
    connection.setblocking(True)
    with connection, connection.makefile("rb") as incoming, connection.makefile("wb") as outgoing:
        serve(incoming, outgoing)
