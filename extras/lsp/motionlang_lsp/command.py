"""`motionlang lsp`: the language server, for editors."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, flag, option
from motionlang.hosts.address import listen, parse, shown
from motionlang.kernel import Diagnostic
from motionlang.kernel.files import reason


@dataclass
class Lsp(Command):
    """Serve an editor: diagnostics, completion, names, simulated times."""

    epilog: ClassVar[str] = """\
An editor starts the server and talks to it on standard input and output.
docs/editor.md has the settings for VS Code, Neovim, Helix and Emacs, and shows
what each feature does.

examples:
  motionlang lsp                          what an editor starts
  motionlang lsp --tcp 127.0.0.1:5020     for one editor that connects
"""
    stdio: bool = flag("use standard input and output (default)")
    tcp: tuple[str, int] | None = option(
        "HOST:PORT",
        "wait for one editor at this address; without HOST only this computer can connect, port 0 is any free port",
        read=parse,
    )

    def check(self) -> None:
        super().check()
        if self.stdio and self.tcp is not None:
            raise WrongOption("give either --stdio or --tcp, not both")

    def run(self) -> int:
        """Serve one editor; return 0, or 1 if it left without a shutdown request."""
        from motionlang_lsp.server import EditorServer
        from motionlang_lsp.workers import WorkerProcess

        server = EditorServer(WorkerProcess())
        if self.tcp is None:
            return server.serve_streams()
        host, port = self.tcp
        try:
            listener = listen(host, port)
        except OSError as error:
            message = f"cannot listen at {shown(host, port)}: {reason(error)}"
            raise Refused([Diagnostic("address", message)]) from None
        sys.stderr.write(f"waiting for an editor at {shown(host, listener.getsockname()[1])}\n")
        sys.stderr.flush()
        return server.serve_socket(listener)
