"""`motionlang lsp`: the language server, for editors."""

from __future__ import annotations

import argparse
import sys

from motionlang.cli.address import address
from motionlang.cli.complaints import complain
from motionlang.cli.parser import Commands, add_command
from motionlang.errors import Diagnostic, need
from motionlang.files import reason
from motionlang.serve.address import listen, shown

EPILOG = """\
An editor starts the server and talks to it on standard input and output. docs/editor.md has the settings for VS Code,
Neovim, Helix and Emacs, and shows what each feature does.

examples:
  motionlang lsp                                   what an editor starts
  motionlang lsp --tcp 127.0.0.1:5020              for one editor that connects to this address
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang lsp` and its options."""
    parser = add_command(commands, "lsp", summary, _serve, EPILOG)
    group = parser.add_mutually_exclusive_group()
    group.add_argument("--stdio", action="store_true", help="use standard input and output (default)")
    group.add_argument(
        "--tcp",
        type=address,
        metavar="HOST:PORT",
        help=(
            "wait for one editor at this address; without HOST only this computer can connect, port 0 is "
            "any free port"
        ),
    )


def _serve(arguments: argparse.Namespace) -> int:
    """Serve one editor; return 0, or 1 if it left without a shutdown request."""
    need("motionlang lsp", "pygls")
    from motionlang.lsp.server import Server
    from motionlang.lsp.workers import Process

    server = Server(Process())
    if arguments.tcp is None:
        return server.serve_streams()
    host, port = arguments.tcp
    try:
        listener = listen(host, port)
    except OSError as error:
        complain([Diagnostic("address", f"cannot listen at {shown(host, port)}: {reason(error)}")], None, "")
        return 1
    sys.stderr.write(f"waiting for an editor at {shown(host, listener.getsockname()[1])}\n")
    sys.stderr.flush()
    return server.serve_socket(listener)
