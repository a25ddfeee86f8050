"""`motionlang serve` for hosts on lines: addresses, output and the end."""

from __future__ import annotations

import signal
import sys
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.errors import Diagnostic
from motionlang.serve.address import is_loopback, shown

if TYPE_CHECKING:
    import argparse
    from types import FrameType
    from typing import TextIO

    from motionlang.copley.served import DriveServer
    from motionlang.serve import Server
    from motionlang.serve.server import MakeHost


def greet(args: argparse.Namespace, title: str, axes: int) -> None:
    """Print what is served, and the time scale."""
    time = "in lock step" if args.clock == "lockstep" else "in real time"
    if args.factor:
        time += f", {args.factor:.10g} × real time"
    say(f"{title}, {axes} axes, {time}; Ctrl-C ends it\n")


def open_lines(server: Server, args: argparse.Namespace) -> str | None:
    """Open the lines for hosts and return what to print; None if one cannot be opened."""
    opened = ""
    for host, port in args.tcp:
        line = listen(server, host, port, echo=bool(args.echo))
        if line is None:
            return None
        opened += line
    if args.pty:
        try:
            opened += f"serial device {server.device(echo=args.echo)}\n"
        except ImportError as error:
            cannot("this system has no pseudo-terminals; use --tcp", error)
            return None
        except OSError as error:
            cannot("cannot create a serial device", error)
            return None
    return opened


def listen(
    server: Server, host: str, port: int, *, echo: bool = False, make: MakeHost | None = None
) -> str | None:
    """Listen on an address and return what to print; None if it cannot be used."""
    try:
        found, port = server.listen(host, port, echo, make)
    except (OSError, UnicodeError) as error:
        cannot(f"cannot listen on {shown(host, port)}", error)
        return None
    if not is_loopback(found):
        warn(
            f"warning: any computer that can reach this one can connect to {shown(found, port)}; there is "
            "no password"
        )
    return f"listening on {shown(found, port)}{'' if make is None else ' for MCAPI'}\n"


def until_signal(server: Server | DriveServer) -> None:
    """Serve until Ctrl-C or SIGTERM; both are a normal end."""

    def stop(number: int, frame: FrameType | None) -> None:
        server.stop()

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        server.run()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def cannot(what: str, error: Exception, hint: str = "") -> None:
    """Report an address that cannot be served."""
    reason = getattr(error, "strerror", None) or str(error)
    complain([Diagnostic("address", f"{what}: {reason.lower()}", hint=hint)], None, "")


def say(text: str) -> None:
    """Write to standard output."""
    _write(sys.stdout, text)


def remark(text: str) -> None:
    """Write to standard error."""
    _write(sys.stderr, text)


def _write(stream: TextIO, text: str) -> None:
    """Write a text at once; ignore a closed pipe."""
    try:
        stream.write(text)
        stream.flush()
    except (OSError, ValueError):
        pass


def warn(text: str) -> None:
    """Write a remark of the command to standard error."""
    remark(f"motionlang serve: {text}\n")
