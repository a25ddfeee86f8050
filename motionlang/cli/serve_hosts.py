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
        time += f", {args.factor:g} × real time"
    say(f"{title}, {axes} axes, {time}; Ctrl-C ends it\n")


def open_lines(server: Server, args: argparse.Namespace) -> bool:
    """Open and print the lines for hosts; False if one of them cannot be opened."""
    for host, port in args.tcp:
        if not listen(server, host, port, echo=bool(args.echo)):
            return False
    if args.pty:
        try:
            say(f"serial device {server.device(echo=args.echo)}\n")
        except ImportError as error:
            return cannot("this system has no pseudo-terminals; use --tcp", error)
        except OSError as error:
            return cannot("cannot create a serial device", error)
    return True


def listen(server: Server, host: str, port: int, *, echo: bool = False, make: MakeHost | None = None) -> bool:
    """Listen on an address and print it; False if it cannot be used."""
    try:
        found, port = server.listen(host, port, echo, make)
    except (OSError, UnicodeError) as error:
        return cannot(f"cannot listen on {shown(host, port)}", error)
    if not is_loopback(found):
        warn(
            f"warning: any computer that can reach this one can connect to {shown(found, port)}; there is "
            "no password"
        )
    say(f"listening on {shown(found, port)}{'' if make is None else ' for MCAPI'}\n")
    return True


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


def cannot(what: str, error: Exception, hint: str = "") -> bool:
    """Report an address that cannot be served; return False."""
    reason = getattr(error, "strerror", None) or str(error)
    complain([Diagnostic("address", f"{what}: {reason.lower()}", hint=hint)], None, "")
    return False


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
