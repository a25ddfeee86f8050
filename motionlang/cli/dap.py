"""`motionlang dap`: the debugger for editors."""

from __future__ import annotations

import argparse
import sys

from motionlang.cli.address import address
from motionlang.cli.complaints import complain
from motionlang.cli.parser import Commands, add_command
from motionlang.dap.server import serve_connection, serve_stdio
from motionlang.errors import Diagnostic
from motionlang.serve.address import listen, shown

EPILOG = """\
An editor starts this command and talks to it in the Debug Adapter Protocol. It serves one session and ends with it.
The program, its machine file and its inputs are arguments of the editor's launch request.

examples:
  motionlang dap                       on standard input and output
  motionlang dap --tcp 127.0.0.1:4711  for an editor that connects
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang dap` and its options."""
    parser = add_command(commands, "dap", summary, _dap, EPILOG)
    parser.add_argument(
        "--tcp",
        type=address,
        metavar="HOST:PORT",
        help=(
            "listen on this address for one client; without HOST only this computer can connect, port 0 is any free "
            "port (default: standard input and output)"
        ),
    )


def _dap(arguments: argparse.Namespace) -> int:
    if arguments.tcp is None:
        serve_stdio()
        return 0
    try:
        listener = listen(*arguments.tcp)
    except OSError as error:
        message = f"cannot listen on {shown(*arguments.tcp)}: {error.strerror or error}"
        complain([Diagnostic("file", message)], None, "")
        return 2
    host, port = listener.getsockname()[:2]
    print(f"listening on {shown(host, port)}", file=sys.stderr, flush=True)
    serve_connection(listener)
    return 0
