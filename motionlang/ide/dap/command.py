"""`motionlang dap`: the debugger for editors."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, Refused, option
from motionlang.hosts.address import listen, parse, shown
from motionlang.ide.dap.server import serve_connection, serve_stdio
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
            serve_stdio()
            return 0
        try:
            listener = listen(*self.tcp)
        except OSError as error:
            message = f"cannot listen on {shown(*self.tcp)}: {error.strerror or error}"
            raise Refused([Diagnostic("file", message)], status=2) from None
        host, port = listener.getsockname()[:2]
        print(f"listening on {shown(host, port)}", file=sys.stderr, flush=True)
        serve_connection(listener)
        return 0
